// The English words of the window.

#include "gui/window_text.h"

namespace raywalk {

std::string_view english(WindowText id) {
  switch (id) {
    case WindowText::menu_walk:
      return "Walk";
    case WindowText::menu_panels:
      return "Panels";
    case WindowText::plan:
      return "Plan";
    case WindowText::keys:
      return "Keys";
    case WindowText::image_settings:
      return "The 3-D picture";
    case WindowText::settings:
      return "Settings";
    case WindowText::settings_hint:
      return "How the picture is made; heat maps of what it costs and how noisy it is";
    case WindowText::integrator:
      return "Integrator";
    case WindowText::accelerator:
      return "Accelerator";
    case WindowText::cost_knobs:
      return "What to try";
    case WindowText::cost_reference:
      return "reference";
    case WindowText::cost_split:
      return "Split";
    case WindowText::cost_difference:
      return "Difference";
    case WindowText::cost_rays:
      return "Against rays";
    case WindowText::cost_tests:
      return "Against tests";
    case WindowText::cost_seconds:
      return "Against time";
    case WindowText::sampler:
      return "Sampler";
    case WindowText::light_grid:
      return "Rays to a light: n x n";
    case WindowText::tolerance:
      return "Tolerance";
    case WindowText::samples:
      return "Samples of a pixel";
    case WindowText::precision:
      return "Precision";
    case WindowText::numerics:
      return "Numerics";
    case WindowText::epsilon:
      return "Epsilon";
    case WindowText::cost_effects:
      return "Effects";
    case WindowText::cost_tries:
      return "Tries";
    case WindowText::magnification_hint:
      return "How close; the wheel over the drawing does the same";
    case WindowText::double_:
      return "double";
    case WindowText::single:
      return "float";
    case WindowText::heat:
      return "Heat map";
    case WindowText::walk_samples:
      return "Samples walked";
    case WindowText::heat_none:
      return "none";
    case WindowText::heat_rays:
      return "rays of each pixel";
    case WindowText::heat_tests:
      return "nodes and shapes tested";
    case WindowText::heat_time:
      return "time";
    case WindowText::heat_noise:
      return "noise of its samples";
    case WindowText::image_hint:
      return "Drag to turn, with Shift or the right button to move, wheel to zoom; click a pixel to walk its rays";
    case WindowText::scrub_hint:
      return "Where the walk stands; drag to go anywhere";
    case WindowText::speed_hint:
      return "How fast AUTO goes; it may be changed while it runs";
    case WindowText::scene_settings:
      return "Scene";
    case WindowText::folder_up:
      return "Up";
    case WindowText::folder_up_hint:
      return "Go to the folder that holds this one";
    case WindowText::no_scene_here:
      return "No scene (*.toml, *.nff, *.test) in this folder";
    case WindowText::folder_unreadable:
      return "This folder cannot be read";
    case WindowText::export_slides:
      return "Slides";
    case WindowText::export_slides_hint:
      return "A web page that steps through the walk, without a network";
    case WindowText::export_picture:
      return "Picture";
    case WindowText::export_picture_hint:
      return "The window as it stands";
    case WindowText::export_film:
      return "Film";
    case WindowText::export_film_hint:
      return "The window step by step, to the end of the pixel";
    case WindowText::export_plan:
      return "Plan";
    case WindowText::export_plan_hint:
      return "The plan as a drawing of lines, sharp at any size";
    case WindowText::export_transcript:
      return "Text";
    case WindowText::export_transcript_hint:
      return "Every step as a sentence, for reading aloud";
    case WindowText::export_script:
      return "Script";
    case WindowText::export_script_hint:
      return "The lesson for its presenter, to print or to read apart from the class";
    case WindowText::export_steps:
      return "Data";
    case WindowText::export_steps_hint:
      return "Every step with its numbers, for programs";
    case WindowText::swatch_hint:
      return "Choose the colour";
    case WindowText::breakpoints:
      return "Where to come to rest";
    case WindowText::breakpoints_hint:
      return "Before lines of code: click left of a line, or press Ctrl+B. AUTO, Run on and steps longer than a line "
             "stop "
             "there.";
    case WindowText::breakpoint_hint:
      return "Come to rest before this line, or no longer";
    case WindowText::mark_hint:
      return "Mark this line as the one at fault";
    case WindowText::breakpoints_off:
      return "This step of the lesson passes all breakpoints.";
    case WindowText::at_depth:
      return "At DEPTH (0: none)";
    case WindowText::at_pixel:
      return "At pixel (-1: none)";
    case WindowText::at_object:
      return "At a hit of";
    case WindowText::at_total:
      return "Total reflection";
    case WindowText::nowhere:
      return "nowhere";
    case WindowText::remove_breakpoints:
      return "Remove all";
    case WindowText::go_to_step:
      return "Go to step";
    case WindowText::status_hint:
      return "Go to a step by its number";
    case WindowText::equation_empty:
      return "Take a step: here stands what the line computes, with the numbers of the ray.";
    case WindowText::short_image:
      return "3-D";
    case WindowText::short_tree:
      return "Tree";
    case WindowText::short_microscope:
      return "Scope";
    case WindowText::short_structure:
      return "Boxes";
    case WindowText::corners_hint:
      return "Corners are dragged in the plan";
    case WindowText::key_space:
      return "Space";
    case WindowText::reading_scene:
      return "Reading {0} \u2026";
    case WindowText::key_other:
      return "key {0}";
    case WindowText::export_as:
      return "Will be written as {0}";
    case WindowText::film_progress:
      return "Film: frame {0} of {1}, Esc ends it here";
  }
  return {};
}

}  // namespace raywalk
