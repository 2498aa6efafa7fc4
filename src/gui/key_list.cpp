#include "gui/key_list.h"

#include "gui/commands.h"
#include "view/text.h"

namespace raywalk {

namespace {

struct KeyGroup {
  std::string_view does;
  std::vector<Command> commands;
};

const std::vector<KeyGroup>& groups() {
  using enum Command;
  static const std::vector<KeyGroup> all{
      {"keys.steps", {step, step_back}},
      {"keys.rays", {step_ray, step_ray_back}},
      {"keys.pixels", {step_pixel, step_pixel_back}},
      {"keys.over", {step_over, step_back_over}},
      {"keys.out", {step_out, step_back_out}},
      {"keys.run", {run_on, run_back}},
      {"keys.breaks", {break_here, breakpoints}},
      {"keys.ends", {first, last}},
      {"keys.auto_clear", {play, clear}},
      {"keys.speed", {slower, faster}},
      {"keys.grain", {grain_line, grain_ray, grain_pixel}},
      {"keys.modes", {mode_move, mode_trace, mode_help}},
      {"keys.lessons", {lessons}},
      {"keys.bugs", {bugs, bug_surprise, bug_mark, bug_cure, bug_mend}},
      {"keys.equation", {tab_equation}},
      {"keys.tabs", {tab_image, tab_tree, tab_stack, tab_legend}},
      {"keys.cost", {tab_cost, cost_knobs, cost_try, cost_ladder, cost_forget}},
      {"keys.cost_views", {cost_next, cost_against, cost_kind, cost_axis, cost_split_left, cost_split_right}},
      {"keys.cost_effects", {cost_page}},
      {"keys.microscope", {tab_microscope, magnify, diminish, to_numbers, to_scene}},
      {"keys.numerics", {numerics_naive, numerics_robust, precision_float, precision_double}},
      {"keys.structure", {tab_structure, structure_kind, structure_page}},
      {"keys.structure_steps", {structure_next, structure_back, structure_last, structure_first}},
      {"keys.exchange", {exchange}},
      {"keys.zoom", {fit, zoom_in, zoom_out}},
      {"keys.lines", {lines, walk_strip}},
      {"keys.ghosts", {ghosts}},
      {"keys.tweens", {tweens}},
      {"keys.predict", {predict, save_predictions}},
      {"keys.turn", {turn_left, turn_right, turn_up, turn_down}},
      {"keys.shift", {shift_left, shift_right, shift_up, shift_down}},
      {"keys.approach", {approach, recede, reset_view}},
      {"keys.image", {use_camera, image_settings, heat}},
      {"keys.add", {add_solid_sphere, add_transparent_sphere, add_polygon, add_light}},
      {"keys.select", {select_next, select_previous}},
      {"keys.edit", {edit_properties, remove}},
      {"keys.undo", {undo, redo}},
      {"keys.files", {new_scene, open, save, save_as, export_walk, quit}},
      {"keys.theme", {theme}},
      {"keys.language", {language}},
      {"keys.scale", {scale_up, scale_down, scale_reset}},
      {"keys.menus", {menu, full_screen}},
  };
  return all;
}

}  // namespace

std::vector<KeyListRow> key_list(Language language) {
  const auto say = [&](std::string_view id) { return std::string(text(id, language)); };
  std::vector<KeyListRow> rows;
  for (const KeyGroup& group : groups()) {
    KeyListRow row{{}, say(group.does)};
    for (const Command command : group.commands)
      row.keys += (row.keys.empty() ? "" : " \u00b7 ") + all_command_keys(command, language);
    rows.push_back(std::move(row));
  }
  rows.push_back({"\u2190, \u2192, \u2191, \u2193", say("keys.arrows")});
  rows.push_back({say("keys.name_while_dragging"), say("keys.while_dragging")});
  rows.push_back({say("keys.name_wheel"), say("keys.wheel")});
  rows.push_back({say("keys.name_mouse"), say("keys.mouse")});
  rows.push_back({"Esc", say("keys.escape")});
  return rows;
}

}  // namespace raywalk
