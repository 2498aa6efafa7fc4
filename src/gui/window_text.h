#pragma once
// The words of the window itself that the panels of `view` do not have: a family of view/text.h.

#include <string_view>

namespace raywalk {

enum class WindowText {
  menu_walk,
  menu_panels,
  plan,
  keys,
  image_settings,
  settings,
  settings_hint,
  integrator,
  accelerator,
  cost_knobs,
  cost_reference,
  cost_split,
  cost_difference,
  cost_rays,
  cost_tests,
  cost_seconds,
  sampler,
  light_grid,
  tolerance,
  samples,
  precision,
  numerics,
  epsilon,
  cost_effects,
  cost_tries,
  magnification_hint,
  double_,
  single,
  heat,
  walk_samples,
  heat_none,
  heat_rays,
  heat_tests,
  heat_time,
  heat_noise,
  image_hint,
  scrub_hint,
  speed_hint,
  scene_settings,
  folder_up,
  folder_up_hint,
  no_scene_here,
  folder_unreadable,
  export_slides,  ///< what an export may be, and what that is
  export_slides_hint,
  export_picture,
  export_picture_hint,
  export_film,
  export_film_hint,
  export_plan,
  export_plan_hint,
  export_transcript,
  export_transcript_hint,
  export_steps,
  export_steps_hint,
  export_script,
  export_script_hint,
  swatch_hint,
  breakpoints,
  breakpoints_hint,
  breakpoint_hint,
  mark_hint,
  breakpoints_off,
  at_depth,
  at_pixel,
  at_object,
  at_total,
  nowhere,
  remove_breakpoints,
  go_to_step,
  status_hint,
  equation_empty,
  short_image,
  short_tree,
  short_microscope,
  short_structure,
  corners_hint,
  key_space,
  reading_scene,  ///< {0} file
  key_other,      ///< {0} number
  export_as,      ///< {0} the name of a file, with the ending of its kind
  film_progress,  ///< {0} frame, {1} of so many
};

[[nodiscard]] std::string_view english(WindowText id);
[[nodiscard]] std::string_view portuguese(WindowText id);

}  // namespace raywalk
