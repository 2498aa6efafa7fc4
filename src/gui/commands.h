#pragma once
// All commands of buttons, menu entries and keys, each described once: its label, its action, its keys, and when it is
// enabled.

#include "gui/ui.h"
#include "gui/window.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace raywalk {

enum class Command {
  new_scene,
  open,
  save,
  save_as,
  quit,
  undo,
  redo,
  remove,
  deselect,
  select_next,
  select_previous,
  edit_properties,
  add_solid_sphere,
  add_transparent_sphere,
  add_polygon,
  add_light,
  mode_move,
  mode_trace,
  mode_help,
  step,
  step_back,
  step_ray,
  step_ray_back,
  step_pixel,
  step_pixel_back,
  step_over,
  step_back_over,
  step_out,
  step_back_out,
  run_on,
  run_back,
  break_here,
  breakpoints,
  play,
  clear,
  first,
  last,
  slower,
  faster,
  grain_line,
  grain_ray,
  grain_pixel,
  tab_image,
  tab_tree,
  tab_stack,
  tab_legend,
  tab_cost,
  tab_equation,
  zoom_in,
  zoom_out,
  fit,
  lines,
  ghosts,
  tweens,
  predict,
  save_predictions,
  export_walk,
  walk_strip,
  reset_view,
  use_camera,
  image_settings,
  heat,
  cost_knobs,
  cost_try,
  cost_ladder,
  cost_forget,
  cost_next,
  cost_against,
  cost_kind,
  cost_axis,
  cost_split_left,
  cost_split_right,
  cost_page,
  tab_microscope,
  magnify,
  diminish,
  to_numbers,
  to_scene,
  numerics_robust,
  numerics_naive,
  precision_double,
  precision_float,
  tab_structure,
  structure_next,
  structure_back,
  structure_last,
  structure_first,
  structure_kind,
  structure_page,
  turn_left,
  turn_right,
  turn_up,
  turn_down,
  shift_left,
  shift_right,
  shift_up,
  shift_down,
  approach,
  recede,
  theme,
  language,
  scale_up,
  scale_down,
  scale_reset,
  exchange,
  full_screen,
  lessons,
  bugs,
  bug_surprise,
  bug_mark,
  bug_cure,
  bug_mend,
  menu,
};
inline constexpr int command_count = static_cast<int>(Command::menu) + 1;

/// Unique, for tests and for ImGui: "step-back".
[[nodiscard]] std::string_view command_name(Command command);
/// The label of its button: "STEP". May depend on the state (AUTO or PAUSE).
[[nodiscard]] std::string command_label(Command command, const State& state);
/// A short label for little room; the label itself if that is short.
[[nodiscard]] std::string short_label(Command command, const State& state);
/// What it does, in one clause, without the key.
[[nodiscard]] std::string command_hint(Command command, Language language);
/// The key shown in menus and tooltips: "Ctrl+Shift+S"; empty if none.
[[nodiscard]] std::string command_key(Command command, Language language);
/// All of them: "Space, \u2192, Page Down".
[[nodiscard]] std::string all_command_keys(Command command, Language language);

[[nodiscard]] bool enabled(Command command, const State& state);
/// For choices: whether it is the current one.
[[nodiscard]] bool chosen(Command command, const State& state);
/// Performs it, if enabled.
void perform(Command command, const Ui& ui);

/// The view that keys turn: the lines, if they are shown and were turned last, else the picture.
[[nodiscard]] SpaceView view_in_hand(const State& state);

/// The command of a key press in this state, if any.
[[nodiscard]] std::optional<Command> command_of(const KeyPress& press, const State& state);
/// The number of commands bound to a key press: at most one, if the table is consistent.
[[nodiscard]] int commands_on(const KeyPress& press, Mode mode);
/// Turns a key press into actions: a command's, or nudging by arrows in Move mode, or Escape. Returns whether it had a
/// meaning.
bool press_key(const KeyPress& press, const Ui& ui);

}  // namespace raywalk
