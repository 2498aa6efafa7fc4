#pragma once
// Everything that a person reads, by id. Each family of ids has two exhaustive switches, english(id) and
// portuguese(id), in files of their own, *_english.cpp and *_portuguese.cpp: the compiler finds what one of them lacks.

#include "lesson/language.h"
#include "scene/scene.h"
#include "timeline/message.h"
#include "timeline/timeline.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The text of an id: of TextId, PanelText, MessageId, RayKind and Ending below, and of every other family that has its
/// english(id) and portuguese(id).
template <class Id>
[[nodiscard]] auto text(Id id, Language language) {
  switch (language) {
    case Language::english:
      return english(id);
    case Language::portuguese:
      return portuguese(id);
  }
  return decltype(english(id)){};
}

/// {0}, {1}, ... in a text stand for arguments.
[[nodiscard]] std::string fill(std::string_view pattern, const std::vector<std::string>& arguments);
/// A text with its arguments filled in.
template <class Id>
[[nodiscard]] std::string fill(Id id, Language language, const std::vector<std::string>& arguments) {
  return fill(text(id, language), arguments);
}

enum class TextId {
  // The four kinds, EYE and SCREEN, and what dragging them does.
  solid_sphere,
  transparent_sphere,
  polygon,
  light_source,
  short_solid_sphere,  ///< where there is little room
  short_transparent_sphere,
  short_polygon,
  short_light_source,
  plane,
  eye,
  screen,
  untitled,
  new_scene_title,
  drag_move,
  drag_eye,
  drag_view_direction,
  drag_screen_height,
  drag_screen_distance,
  drag_radius,
  drag_corner,
  drag_edge,
  drag_rotation,
  cell_number,      ///< {0} cell
  cell_with_shade,  ///< {0} cell, {1} colour
  ray_from,         ///< {0} ray kind, {1} object
  ray_of_cell,      ///< {0} ray kind, {1} cell
  ray_of_pixel,     ///< {0} ray kind

  // Modes, tabs, buttons.
  mode_move,
  mode_trace,
  mode_help,
  tab_image,
  tab_tree,
  tab_stack,
  tab_legend,
  tab_cost,
  button_step,
  button_back,
  button_auto,
  button_pause,
  button_clear,
  button_fit,
  button_undo,
  button_redo,
  button_add,
  button_remove,
  button_close,
  grain,
  grain_line,
  grain_ray,
  grain_pixel,
  speed,
  speed_unit,
  theme,
  theme_dark,
  theme_projector,
  ui_scale,
  language,

  // Menus and dialogs.
  menu_file,
  menu_edit,
  menu_view,
  menu_new,
  menu_open,
  menu_recent,
  menu_save,
  menu_save_as,
  menu_quit,
  path_label,
  answer_save,
  answer_discard,
  answer_recover,
  answer_throw_away,
  answer_later,
  answer_overwrite,
  answer_cancel,
  ask_unsaved_new,   ///< {0} file
  ask_unsaved_open,  ///< {0} file, {1} the file to open
  ask_unsaved_quit,  ///< {0} file
  ask_unsaved_lesson,
  ask_recover,        ///< {0} file, {1} when
  ask_recover_other,  ///< {0} file, {1} when, {2} the file that is open now
  ask_overwrite,      ///< {0} file

  // Properties.
  properties,
  nothing_selected,
  name,
  material,
  ambient,
  diffuse,
  specular,
  shininess,
  reflection,
  transmission,
  ior,
  dielectric,
  priority,
  filtered_shadow,
  emission,
  checker,
  position,
  direction,
  centre,
  radius,
  height,
  corner,  ///< {0} number from 1
  radii,
  lowest,
  highest,
  capped,
  smooth,
  normal,
  strength,
  attenuation,
  view_angle,
  look_at,
  screen_distance,
  screen_width,
  screen_cells,
  background,
  ambient_light,
  depth_limit,
  threshold,

  // Notices.
  saved_as,        ///< {0} file
  opened,          ///< {0} file
  recovered,       ///< {0} file
  refused,         ///< {0} why
  refused_number,  ///< {0} least, {1} most
  refused_name_empty,
  refused_name_taken,  ///< {0} name
  refused_last_corners,
  camera_is_the_scenes,
  camera_taken,
  nothing_to_undo,
  nothing_to_redo,
  select_first,
  too_many_steps,
  export_endings,   ///< {0} file
  too_many_slides,  ///< {0} most
  save_elsewhere,   ///< a scene that comes with Raywalk
  autosave_failed,  ///< {0} why
};

/// What the panels, the legend, the drawings and the line of counts say.
enum class PanelText {
  depth_badge,    ///< {0} depth
  rays_badge,     ///< {0} rays of the path so far
  percent_under,  ///< {0} percent
  stack_main,
  stack_paths,  ///< instead of MAIN ALGORITHM, when paths are traced
  stack_path,
  stack_shade,    ///< {0} depth
  stack_returns,  ///< {0} RTNSHADE
  stack_primary_ray,
  stack_ray_from,  ///< {0} ray kind, {1} object
  waits_final,     ///< MAIN ALGORITHM waits for a SHADE
  waits_refl,
  waits_refr,
  works_on,    ///< {0} the line's text
  name_final,  ///< what calls return, as the pseudocode calls it
  name_refl,
  name_refr,
  node_future,     ///< {0} ray kind
  node_share,      ///< {0} ray kind, {1} share
  node_under_way,  ///< its end is not known yet
  tree_empty,
  stack_empty,
  image_waiting,
  image_row_marked,
  image_click,       ///< what a click does, in a picture without a marked row
  image_turned,      ///< the picture is not as the scene's camera sees it
  image_progress,    ///< {0} percent, {1} time left
  too_many_samples,  ///< {0} how many are walked
  samples_mean,      ///< {0} samples, {1} the mean of their grey, {2} half the 95% interval
  member_of,         ///< {0} member, {1} group
  triangle_of,       ///< {0} number, {1} mesh
  ghosts_total,      ///< {0} percent
  ghosts_none,
  heat_rays,  ///< {0} the number that the last colour stands for
  heat_tests,
  heat_time,
  heat_noise,
  short_primary,  ///< rays, where there is little room
  short_shadow,
  short_reflect,
  short_refract,
  legend_primary,
  legend_shadow,
  legend_reflect,
  legend_refract,
  sign_hit,  ///< each with its meaning
  sign_missed,
  sign_blocked,
  sign_reached_light,
  sign_stub,
  sign_normal,
  to_start,  ///< of a page of slides
  to_end,
  step_bar,
  status,        ///< {0} position, {1} steps, {2} pixel, {3} rays
  status_short,  ///< {0} position, {1} steps
  status_none,   ///< in place of a pixel's number
  first_step_trace,
  first_step_move,
  first_step_help,
  after_last_step,
  after_last_step_of_pixel,
  walk_stands_at_end,  ///< said in Move: after a change the walk stays at its end
  walk_stands_at,      ///< {0} position, {1} steps
  objects_drawn,       ///< {0} how many, {1} of how many
  out_of_view,         ///< {0} what
  shown_tiny,
};

[[nodiscard]] std::string_view english(TextId id);
[[nodiscard]] std::string_view english(PanelText id);
/// The sentence of a message.
[[nodiscard]] std::string_view english(MessageId id);
[[nodiscard]] std::string_view english(RayKind kind);   ///< "reflect ray"
[[nodiscard]] std::string_view english(Ending ending);  ///< a clause: "left the scene"
[[nodiscard]] std::string_view portuguese(TextId id);
[[nodiscard]] std::string_view portuguese(PanelText id);
[[nodiscard]] std::string_view portuguese(MessageId id);
[[nodiscard]] std::string_view portuguese(RayKind kind);
[[nodiscard]] std::string_view portuguese(Ending ending);

[[nodiscard]] std::string_view symbol(Ending ending);  ///< one or two characters for the tree

// Numbers as the language writes them.
/// Digits as they are printed: with the language's mark for the point, with a minus that is as wide as a plus.
[[nodiscard]] std::string typeset_number(std::string digits, Language language);
[[nodiscard]] std::string number_text(double value, Language language);   ///< 3 significant digits, no trailing zeros
[[nodiscard]] std::string percent_text(double share, Language language);  ///< "45%", "0.2%"
/// "(0.2, 0.5, 1)", in Portuguese "(0,2; 0,5; 1)", or one number when it is a grey.
[[nodiscard]] std::string colour_text(const Rgbd& c, Language language);

/// A message of the timeline as one sentence.
[[nodiscard]] std::string sentence_of(const Message& message, Language language);

/// The step that leads to `position`, 1 <= position <= steps(), as one line of a transcript: number, indentation by
/// depth, the line of pseudocode and its sentence.
[[nodiscard]] std::string step_text(const Scene& scene, const Timeline& timeline, int position, Language language);
/// All steps, one a line.
[[nodiscard]] std::string transcript(const Scene& scene, const Timeline& timeline, Language language);

// ---- Properties -----------------------------------------------------------------------------------------------------

/// What a property is, for who does not know its name.
struct Explanation {
  TextId property;
  std::string_view text;
};
[[nodiscard]] std::span<const Explanation> explanations(Language language);
[[nodiscard]] std::span<const Explanation> english_explanations();
[[nodiscard]] std::span<const Explanation> portuguese_explanations();
/// That of one property; empty for those that need none.
[[nodiscard]] std::string_view explanation(TextId property, Language language);

// ---- Help -----------------------------------------------------------------------------------------------------------

struct HelpEntry {
  std::string term;  ///< a button, a key, an object; empty for a paragraph
  std::string text;
};
struct HelpSection {
  std::string title;
  std::vector<HelpEntry> entries;
};
/// The text of help mode.
[[nodiscard]] std::vector<HelpSection> help(Language language);
[[nodiscard]] std::vector<HelpSection> english_help();
[[nodiscard]] std::vector<HelpSection> portuguese_help();

}  // namespace raywalk
