// The English texts of the panels.

#include "view/text.h"

namespace raywalk {

std::string_view english(PanelText id) {
  switch (id) {
    case PanelText::depth_badge:
      return "DEPTH {0}";
    case PanelText::rays_badge:
      return "RAY {0}";
    case PanelText::percent_under:
      return "under {0}%";
    case PanelText::stack_main:
      return "MAIN ALGORITHM";
    case PanelText::stack_paths:
      return "PATH TRACING";
    case PanelText::stack_path:
      return "FOLLOW PATH (ray {0})";
    case PanelText::stack_shade:
      return "SHADE (DEPTH {0})";
    case PanelText::stack_returns:
      return "returns {0}";
    case PanelText::stack_primary_ray:
      return "primary ray of pixel {0}";
    case PanelText::stack_ray_from:
      return "{0} from {1}";
    case PanelText::waits_final:
      return "waits for the final shade";
    case PanelText::waits_refl:
      return "waits for REFLSHADE";
    case PanelText::waits_refr:
      return "waits for REFRSHADE";
    case PanelText::works_on:
      return "at: {0}";
    case PanelText::name_final:
      return "final";
    case PanelText::name_refl:
      return "REFLSHADE";
    case PanelText::name_refr:
      return "REFRSHADE";
    case PanelText::node_future:
      return "{0}: not reached yet";
    case PanelText::node_share:
      return "{0}: at most {1} of the pixel";
    case PanelText::node_under_way:
      return "what it meets is not known yet";
    case PanelText::tree_empty:
      return "The rays of a pixel will stand here as a tree. Press STEP.";
    case PanelText::stack_empty:
      return "Nothing is running yet. Press STEP.";
    case PanelText::image_waiting:
      return "Rendering...";
    case PanelText::image_row_marked:
      return "The marked row is SCREEN; click any pixel to walk it.";
    case PanelText::image_click:
      return "Click a pixel to walk its rays.";
    case PanelText::image_turned:
      return "Turned: O goes back to the scene's camera.";
    case PanelText::image_progress:
      return "{0}, {1} left";
    case PanelText::too_many_samples:
      return "Only {0} samples of each pixel are walked: more would be too many steps.";
    case PanelText::samples_mean:
      return "mean of {0} samples: {1} \u00b1 {2}";
    case PanelText::member_of:
      return "{0} of {1}";
    case PanelText::triangle_of:
      return "triangle {0} of {1}";
    case PanelText::ghosts_total:
      return "Dotted: what the limits cut off, so far {0} of this pixel";
    case PanelText::ghosts_none:
      return "Neither depth nor threshold cut anything off this pixel";
    case PanelText::heat_rays:
      return "{0} rays";
    case PanelText::heat_tests:
      return "{0} nodes and shapes tested";
    case PanelText::heat_time:
      return "{0} \u00b5s";
    case PanelText::heat_noise:
      return "{0} standard deviation";
    case PanelText::short_primary:
      return "primary";
    case PanelText::short_shadow:
      return "shadow";
    case PanelText::short_reflect:
      return "reflect";
    case PanelText::short_refract:
      return "refract";
    case PanelText::legend_primary:
      return "from EYE through a pixel of SCREEN";
    case PanelText::legend_shadow:
      return "from a surface to a light: does it arrive?";
    case PanelText::legend_reflect:
      return "mirrored at a surface";
    case PanelText::legend_refract:
      return "bent on its way into or out of a body";
    case PanelText::sign_hit:
      return "hit an object, which is shaded";
    case PanelText::sign_missed:
      return "left the scene: background";
    case PanelText::sign_blocked:
      return "blocked: the light does not arrive (a cross on the plan)";
    case PanelText::sign_reached_light:
      return "reached the light";
    case PanelText::sign_stub:
      return "not formed (a short piece with a bar on the plan)";
    case PanelText::sign_normal:
      return "thin arrow at a hit: the surface's normal";
    case PanelText::to_start:
      return "To the start";
    case PanelText::to_end:
      return "To the end";
    case PanelText::step_bar:
      return "Step";
    case PanelText::status:
      return "step {0} of {1} \u00b7 pixel {2} \u00b7 rays {3}";
    case PanelText::status_short:
      return "{0} / {1}";
    case PanelText::status_none:
      return "\u2013";
    case PanelText::first_step_trace:
      return "Press STEP to run the first line, or AUTO to let it walk by itself.";
    case PanelText::first_step_move:
      return "Drag the objects, the light and the eye; then choose Trace.";
    case PanelText::first_step_help:
      return "Choose Move to arrange the scene, or Trace to walk through it.";
    case PanelText::after_last_step:
      return "Every pixel of SCREEN has its final shade. CLEAR starts again.";
    case PanelText::after_last_step_of_pixel:
      return "This pixel is done: CLEAR starts it again, S goes back to SCREEN.";
    case PanelText::walk_stands_at_end:
      return "The walk stands at its end, also after a change; CLEAR starts it again.";
    case PanelText::walk_stands_at:
      return "The walk stands at step {0} of {1}.";
    case PanelText::objects_drawn:
      return "{0} of {1} objects are drawn";
    case PanelText::out_of_view:
      return "{0} is out of view: Fit (F) shows the whole scene.";
    case PanelText::shown_tiny:
      return "The scene is shown very small: Fit (F) shows it as large as it can be.";
  }
  return {};
}

}  // namespace raywalk
