// The text of help mode.

#include "view/text.h"

namespace raywalk {

namespace {

HelpSection numbers() {
  HelpSection section{"Materials, lights and limits", {}};
  for (const Explanation& e : english_explanations())
    section.entries.push_back({std::string(english(e.property)), std::string(e.text)});
  return section;
}

}  // namespace

std::vector<HelpSection> english_help() {
  return {
      {"What this is",
       {{"",
         "A ray tracer finds the colour of a pixel by asking which light comes back along a ray from the eye. Here "
         "it works on a plan, seen from above, and runs one line at a time. Every ray is drawn when its line forms "
         "it. The same program draws the 3-D picture: the column of pixels is that picture's middle row."}}},
      {"What stands in the plan",
       {{"EYE", "Where all primary rays start."},
        {"SCREEN",
         "A column of pixels in front of EYE. One ray goes through the middle of each; a pixel fills with its "
         "final shade when that is known."},
        {"Solid Sphere", "Mirrors a part of its surroundings and lets nothing through."},
        {"Transparent Sphere", "Glass: one ray is mirrored, another is bent and goes on inside."},
        {"Polygon", "A block with straight sides. Its corners can be moved, added and removed."},
        {"Light Source", "A shadow ray to it tells whether its light arrives at a point."}}},
      {"Modes",
       {{"Move",
         "Arrange the scene. Drag bodies to move them, and the small circles to change radius, corners, "
         "rotation, the direction of the view, and the length and distance of SCREEN. Everything can be undone. "
         "Rays are left out so that they are not in the way."},
        {"Trace",
         "Walk through the algorithm. The highlighted line has just run; the outlined one runs next. Click on a "
         "pixel or a ray to go to the step where it began."},
        {"Help", "This page."}}},
      {"Buttons",
       {{"STEP",
         "Runs one line and draws the ray that it forms. With \"a ray\" or \"a pixel\" chosen it runs up to the "
         "next ray or to the end of the pixel."},
        {"BACK", "Takes the last step back. STEP and BACK go faster and faster while they are held down."},
        {"AUTO", "Steps by itself at the chosen speed, until PAUSE or the last pixel."},
        {"CLEAR", "Wipes rays and pixels and starts again with the first line."},
        {"The bar", "Drag along it to see any moment of the walk. A click on the numbers beside it goes to a step."},
        {"Over, out", "The Walk menu steps over the SHADE that a line calls, and out of the one under way."},
        {"Predict",
         "Ctrl+P. Before each ray drag an arrow where it will go, or click what it will meet; STEP shows how far off "
         "you were. AUTO rests wherever an arrow is asked for."},
        {"Structure",
         "Ctrl+T. How a ray is searched for in a BVH, a grid, an octree or a kd-tree: box by box, with what was "
         "skipped and why, and how many tests that spares; the other page shows how each of them is built."},
        {"Breakpoints",
         "A click left of a line of code lets the walk rest before it; the Walk menu has more places to rest: a DEPTH, "
         "a pixel, a hit of an object, total internal reflection."}}},
      {"Lessons",
       {{"",
         "F2 opens them. Each step shows a place in the walk and asks what comes next: choose by click or digit, type "
         "a "
         "number, or drag an arrow from the ring in the plan. Reveal shows the true answer beside yours. A lesson "
         "opens "
         "when the one before is done; Unlock all is for teachers, as is Presenter, which adds the script and "
         "notes."}}},
      {"Spot the bug",
       {{"",
         "Shift+F2 opens a list of tracers that have a bug each. Look at the picture, step through, and click the line "
         "at "
         "fault in the code, or let it run and press Enter; Enter once more tells whether it is the one. Then the "
         "right "
         "rays stand beside the wrong ones, dotted, and Alt+Enter mends the bug and brings it back. Your own scene "
         "waits and "
         "comes back as it was."}}},
      {"Panels",
       {{"Code",
         "MAIN ALGORITHM and SHADE. DEPTH counts how many SHADEs are open. Click on a line to run on until it has "
         "run again."},
        {"3-D image",
         "The same scene as a picture. The marked row is SCREEN; the marked pixel is being traced. Click any pixel to "
         "walk its rays. Drag to turn the picture, with Shift or the right button to move it, turn the wheel to come "
         "nearer; O goes back, U puts the scene's camera there. Settings: how it is made, and heat maps of what each "
         "pixel costs and how noisy it is."},
        {"Lines in space",
         "In the plan's place, for pixels off SCREEN and for scenes that are not flat: the outlines of all bodies, the "
         "pyramid that EYE sees, and the rays. Turn it as the picture; V changes to the plan and back, S goes back to "
         "SCREEN."},
        {"Ray tree",
         "All rays of the pixel: each stands below the ray at whose hit it was formed. Point at one to see it "
         "in the plan and in the code; click to go to it."},
        {"Equation",
         "What the line that has just run has computed, with the numbers of this ray: which root was taken, the angles "
         "of Snell's law, each term of the shade with its colour."},
        {"Microscope",
         "The hit of the ray in hand, from the whole scene down to single numbers of the computer: the true surface, "
         "the points that naive and robust numerics find, and where each lets the next rays start. Robust and Naive "
         "choose what the scene is traced with, Double and Float how many digits there are. Try naive with epsilon 0 "
         "in float, and look at the picture too."},
        {"Stack", "The SHADEs that wait for others to return, the innermost on top."},
        {"Legend", "What the colours, dashes and signs mean."},
        {"Cost",
         "Try traces the picture with the knobs as they stand; each try is a mark in a plot of error against cost. The "
         "page Effects measures what each effect adds to the scene, and what all of them would cost regardless."}}},
      numbers(),
      {"Why rays end",
       {{"hit", "It met an object; that point is shaded."},
        {"left the scene", "It met nothing and brings the background."},
        {"blocked", "A shadow ray met something before the light: a cross marks where."},
        {"reached the light", "A shadow ray met nothing before it."},
        {"depth limit",
         "SHADE may not call itself deeper than this, so the ray was not formed; a short piece with a bar "
         "shows where it would have gone. N shows the rest of it, dotted, and what it would have brought."},
        {"share too small", "It could have changed the pixel by less than the threshold, so it was not formed."},
        {"total internal reflection",
         "Light inside glass meets the surface at so flat an angle that nothing gets out: "
         "no refract ray exists, and all of it is mirrored."},
        {"faces away", "The light is behind the surface and cannot reach it, so no shadow ray is formed."}}},
  };
}

}  // namespace raywalk
