#pragma once
// Everything that can be asked for by a button, a menu entry or a key, each described once: what it is called, what it
// does, which keys ask for it, when it can be asked for and what comes of it.

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
/// As on its button: "STEP". What it shows may depend on the state (AUTO or PAUSE).
[[nodiscard]] std::string command_label(Command command, const State& state);
/// The same where there is little room; the label itself where that is short.
[[nodiscard]] std::string short_label(Command command, const State& state);
/// What it does, in one clause, without the key.
[[nodiscard]] std::string command_hint(Command command, Language language);
/// The key that stands in menus and tooltips: "Ctrl+Shift+S"; empty when there is none.
[[nodiscard]] std::string command_key(Command command, Language language);
/// All of them: "Space, \u2192, Page Down".
[[nodiscard]] std::string all_command_keys(Command command, Language language);

[[nodiscard]] bool enabled(Command command, const State& state);
/// Whether it is what is chosen now, for those that choose.
[[nodiscard]] bool chosen(Command command, const State& state);
/// Asks for it; nothing happens when it is not enabled.
void perform(Command command, const Ui& ui);

/// What keys turn: the lines, where they are shown and were turned last, else the picture.
[[nodiscard]] SpaceView view_in_hand(const State& state);

/// What a key press means in this state; nothing when it means nothing.
[[nodiscard]] std::optional<Command> command_of(const KeyPress& press, const State& state);
/// How many commands a key press asks for: at most one, if the table is sound.
[[nodiscard]] int commands_on(const KeyPress& press, Mode mode);
/// Turns a key press into actions: a command's, or the arrows that nudge in Move mode, or Escape. Whether it meant
/// anything.
bool press_key(const KeyPress& press, const Ui& ui);

}  // namespace raywalk
