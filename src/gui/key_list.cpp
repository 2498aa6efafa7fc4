#include "gui/key_list.h"

#include "gui/commands.h"
#include "gui/key_text.h"
#include "view/text.h"

namespace raywalk {

namespace {

struct KeyGroup {
  KeyText does;
  std::vector<Command> commands;
};

const std::vector<KeyGroup>& groups() {
  using enum Command;
  static const std::vector<KeyGroup> all{
      {KeyText::steps, {step, step_back}},
      {KeyText::rays, {step_ray, step_ray_back}},
      {KeyText::pixels, {step_pixel, step_pixel_back}},
      {KeyText::over, {step_over, step_back_over}},
      {KeyText::out, {step_out, step_back_out}},
      {KeyText::run, {run_on, run_back}},
      {KeyText::breaks, {break_here, breakpoints}},
      {KeyText::ends, {first, last}},
      {KeyText::auto_clear, {play, clear}},
      {KeyText::speed, {slower, faster}},
      {KeyText::grain, {grain_line, grain_ray, grain_pixel}},
      {KeyText::modes, {mode_move, mode_trace, mode_help}},
      {KeyText::lessons, {lessons}},
      {KeyText::bugs, {bugs, bug_surprise, bug_mark, bug_cure, bug_mend}},
      {KeyText::equation, {tab_equation}},
      {KeyText::tabs, {tab_image, tab_tree, tab_stack, tab_legend}},
      {KeyText::cost, {tab_cost, cost_knobs, cost_try, cost_ladder, cost_forget}},
      {KeyText::cost_views, {cost_next, cost_against, cost_kind, cost_axis, cost_split_left, cost_split_right}},
      {KeyText::cost_effects, {cost_page}},
      {KeyText::microscope, {tab_microscope, magnify, diminish, to_numbers, to_scene}},
      {KeyText::numerics, {numerics_naive, numerics_robust, precision_float, precision_double}},
      {KeyText::structure, {tab_structure, structure_kind, structure_page}},
      {KeyText::structure_steps, {structure_next, structure_back, structure_last, structure_first}},
      {KeyText::exchange, {exchange}},
      {KeyText::zoom, {fit, zoom_in, zoom_out}},
      {KeyText::lines, {lines, walk_strip}},
      {KeyText::ghosts, {ghosts}},
      {KeyText::tweens, {tweens}},
      {KeyText::predict, {predict, save_predictions}},
      {KeyText::turn, {turn_left, turn_right, turn_up, turn_down}},
      {KeyText::shift, {shift_left, shift_right, shift_up, shift_down}},
      {KeyText::approach, {approach, recede, reset_view}},
      {KeyText::image, {use_camera, image_settings, heat}},
      {KeyText::add, {add_solid_sphere, add_transparent_sphere, add_polygon, add_light}},
      {KeyText::select, {select_next, select_previous}},
      {KeyText::edit, {edit_properties, remove}},
      {KeyText::undo, {undo, redo}},
      {KeyText::files, {new_scene, open, save, save_as, export_walk, quit}},
      {KeyText::theme, {theme}},
      {KeyText::language, {language}},
      {KeyText::scale, {scale_up, scale_down, scale_reset}},
      {KeyText::menus, {menu, full_screen}},
  };
  return all;
}

}  // namespace

std::vector<KeyListRow> key_list(Language language) {
  const auto say = [&](KeyText id) { return std::string(text(id, language)); };
  std::vector<KeyListRow> rows;
  for (const KeyGroup& group : groups()) {
    KeyListRow row{{}, say(group.does)};
    for (const Command command : group.commands)
      row.keys += (row.keys.empty() ? "" : " \u00b7 ") + all_command_keys(command, language);
    rows.push_back(std::move(row));
  }
  rows.push_back({"\u2190, \u2192, \u2191, \u2193", say(KeyText::arrows)});
  rows.push_back({say(KeyText::name_while_dragging), say(KeyText::while_dragging)});
  rows.push_back({say(KeyText::name_wheel), say(KeyText::wheel)});
  rows.push_back({say(KeyText::name_mouse), say(KeyText::mouse)});
  rows.push_back({"Esc", say(KeyText::escape)});
  return rows;
}

}  // namespace raywalk
