// The English texts about bugs.

#include "view/bug_text.h"

namespace raywalk {

std::string_view english(BugText id) {
  switch (id) {
    case BugText::title:
      return "Spot the bug";
    case BugText::intro:
      return "Each of these tracers has one broken line. Look at the picture, step through the code, and find the "
             "line. Your own scene waits as you left it.";
    case BugText::surprise:
      return "Surprise me";
    case BugText::surprise_title:
      return "A surprise";
    case BugText::number:
      return "Bug {0}";
    case BugText::found:
      return "found";
    case BugText::given_up:
      return "looked up";
    case BugText::tally:
      return "{0} of {1} found";
    case BugText::banner:
      return "This tracer has a bug";
    case BugText::banner_mended:
      return "The bug is mended";
    case BugText::seen:
      return "What is seen";
    case BugText::task:
      return "Pixel {0} of SCREEN shows it: the walk stands there. Step on, then click the line at fault in the code; "
             "or let it run and press Enter.";
    case BugText::task_of_lesson:
      return "Click the line at fault in the code";
    case BugText::no_line_marked:
      return "No line is marked yet.";
    case BugText::line_marked:
      return "Marked: {0}";
    case BugText::mark:
      return "Mark this line";
    case BugText::judge:
      return "Is it this line?";
    case BugText::give_up:
      return "See the cure";
    case BugText::right:
      return "Right: {0}";
    case BugText::not_right:
      return "Not this line: {0}, and so it did.";
    case BugText::was:
      return "It was: {0}";
    case BugText::hint:
      return "A hint";
    case BugText::wrong:
      return "What was wrong";
    case BugText::cure:
      return "The cure";
    case BugText::mend:
      return "Mend it";
    case BugText::break_again:
      return "Break it again";
    case BugText::other_rays_whole:
      return "Dotted in the plan: the rays that a tracer without the bug forms for this pixel.";
    case BugText::other_rays_broken:
      return "Dotted in the plan: the rays that the bug made of them.";
    case BugText::all_bugs:
      return "All bugs";
    case BugText::leave:
      return "Back to my scene";
  }
  return {};
}

namespace {

/// What is known about one fault.
struct Known {
  std::string_view symptom, hint, wrong, cure;
};

Known known(Fault fault) {
  switch (fault) {
    case Fault::shadow_ray_misaimed:
      return {"Shadows fall the wrong way, and surfaces that face the light stay dark.",
              "Follow the shadow rays to their ends. What should stand there?",
              "The line took the light's position for the direction of the ray. That points at the light from the "
              "origin of the plan, and past it from everywhere else.",
              "direction = light − hit: the way from one point to another is their difference."};
    case Fault::reflection_flipped:
      return {
          "Mirrors show nothing of what stands before them.",
          "Look at a reflect ray where it leaves the surface. On which side does it go on?",
          "The line added the normal with the wrong sign: r = d − 2 cos θ n. That drives the ray into the body in "
          "place of throwing it back.",
          "r = d + 2 cos θ n, where n faces the ray and cos θ = −d · n. Turn the normal to the ray before it is used."};
    case Fault::refraction_inverted:
      return {
          "What is seen through glass is in the wrong place.",
          "Follow a ray into the glass. To which side of its old direction does it bend, and to which side should it?",
          "The line divided the indices the wrong way round: n₂ / n₁. It bent light that goes into glass as if it came "
          "out of it.",
          "sin θ₂ = (n₁ / n₂) sin θ₁, where n₁ belongs to the side that the ray comes from. Into glass it bends "
          "towards the normal."};
    case Fault::attenuation_forgotten:
      return {"Surfaces far from a light are as bright as those close to it.",
              "Every ray goes where it should. Compare numbers: what does a light bring to a near hit, and to a far "
              "one? (Equation, E)",
              "The line added each light in full and never asked how far it had come.",
              "A light counts L / (c + l r + q r²), where r is the length of its shadow ray."};
    case Fault::depth_not_counted:
      return {
          "Some pixels take far more rays than the depth limit should allow.",
          "Watch DEPTH beside the heading of SHADE, or the stack (K). When does it grow, and when does it stay?",
          "The line handed its own DEPTH on and forgot the + 1. The limit was never reached; only an emergency stop "
          "ended the recursion.",
          "Each SHADE that is called gets DEPTH + 1. Then the limit ends what the mirrors would go on with for ever."};
    case Fault::epsilon_wrong_side:
      return {
          "Mirrors are dull: they seem to show only themselves.",
          "Look how far the reflect rays get, and what they meet.",
          "The line started the ray a hair below the surface. The first thing that it met from there was the surface "
          "that it had just left.",
          "Start at hit + ε n, where n faces the side on which the ray goes on. With the other sign it starts inside."};
    case Fault::second_root_dropped:
      return {"What is seen through a glass ball is wrong, though every ray bends as it should where it goes in.",
              "Follow a ray inside the ball. Where should it have come out?",
              "The line looked at the nearer root of the quadratic only. From inside a sphere that one lies behind the "
              "start, so the way out was never found.",
              "Of the two roots take the smallest that is above 0: the first from outside, the second from inside."};
    case Fault::epsilon_too_small:
      return {
          "Lit surfaces are sprinkled with dark dots.",
          "Find a shadow ray that is blocked where nothing stands before the light. What blocks it, and at which t?",
          "The line started the ray on the surface itself. The hit is rounded, so here and there it lies just below "
          "the surface, which then hides its own light.",
          "Start the ray above the surface, by more than rounding errs. Raywalk's own rays need no epsilon: they know "
          "the surface that they leave."};
  }
  return {};
}

}  // namespace

std::string_view english(FaultTextOf of) {
  const Known all = known(of.fault);
  switch (of.id) {
    case FaultText::symptom:
      return all.symptom;
    case FaultText::hint:
      return all.hint;
    case FaultText::wrong:
      return all.wrong;
    case FaultText::cure:
      return all.cure;
  }
  return {};
}

std::string_view english(DutyOf of) {
  switch (of.line) {
    case Line::for_each_pixel:
      return "it takes one pixel after the other";
    case Line::form_primary_ray:
      return "it aims from EYE through the middle of the pixel";
    case Line::find_closest_intersection:
      return "it finds the nearest thing on the primary ray";
    case Line::if_intersect_something:
      return "it asks whether anything was met";
    case Line::shade_final:
      return "it calls SHADE with DEPTH 1";
    case Line::put_final_shade:
      return "it stores the shade that it is given";
    case Line::form_shadow_ray:
      return "it aims from the hit at the light, and starts just off the surface";
    case Line::find_intersection:
      return "it asks whether something stands on the shadow ray";
    case Line::if_reflective:
      return "it asks whether the material mirrors";
    case Line::form_reflect_ray:
      return "it mirrors the ray, and starts just off the surface";
    case Line::find_reflect_intersect:
      return "it finds the nearest thing on the reflect ray";
    case Line::shade_reflect:
      return "it calls SHADE with one DEPTH more";
    case Line::if_transparent:
      return "it asks whether the material lets light through";
    case Line::form_refract_ray:
      return "it bends the ray by Snell's law";
    case Line::find_refract_intersect:
      return "it finds the nearest thing on the refract ray";
    case Line::shade_refract:
      return "it calls SHADE with one DEPTH more";
    case Line::compute_rtnshade:
      return "it adds up what the lights and the other rays bring";
    case Line::path_for_each_pixel:
    case Line::path_form_primary_ray:
    case Line::follow_path:
    case Line::path_put_final_shade:
    case Line::while_ray:
    case Line::path_find_closest_intersection:
    case Line::if_intersect_nothing:
    case Line::add_background:
    case Line::add_emission:
    case Line::path_form_shadow_ray:
    case Line::path_find_intersection:
    case Line::add_light:
    case Line::choose_direction:
    case Line::if_path_survives:
    case Line::form_next_ray:
      break;  // paths are never broken
  }
  return {};
}

}  // namespace raywalk
