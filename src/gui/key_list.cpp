#include "gui/key_list.h"

#include "gui/commands.h"

namespace raywalk {

namespace {

struct KeyGroup {
  const char* does;
  std::vector<Command> commands;
};

const std::vector<KeyGroup>& groups() {
  using enum Command;
  static const std::vector<KeyGroup> all{
      {"one step on \u00b7 back", {step, step_back}},
      {"to the next ray \u00b7 the ray before", {step_ray, step_ray_back}},
      {"to the end of the pixel \u00b7 of the pixel before", {step_pixel, step_pixel_back}},
      {"over the SHADE that a line calls \u00b7 back over it", {step_over, step_back_over}},
      {"out of the SHADE under way \u00b7 back to before its call", {step_out, step_back_out}},
      {"on to the next breakpoint \u00b7 back to the one before", {run_on, run_back}},
      {"a breakpoint before the next line \u00b7 all breakpoints, and go to a step", {break_here, breakpoints}},
      {"to the start \u00b7 to the end", {first, last}},
      {"AUTO, and pause \u00b7 CLEAR", {play, clear}},
      {"AUTO slower \u00b7 faster", {slower, faster}},
      {"Trace: a step is a line \u00b7 a ray \u00b7 a pixel", {grain_line, grain_ray, grain_pixel}},
      {"Move \u00b7 Trace \u00b7 Help", {mode_move, mode_trace, mode_help}},
      {"the lessons", {lessons}},
      {"spot the bug: the list \u00b7 a surprise \u00b7 this line is at fault \u00b7 the cure \u00b7 mended or not",
       {bugs, bug_surprise, bug_mark, bug_cure, bug_mend}},
      {"the live equation: the numbers of the line that has just run", {tab_equation}},
      {"3-D image \u00b7 ray tree \u00b7 stack \u00b7 legend", {tab_image, tab_tree, tab_stack, tab_legend}},
      {"Cost \u00b7 its knobs \u00b7 try \u00b7 try a ladder \u00b7 forget",
       {tab_cost, cost_knobs, cost_try, cost_ladder, cost_forget}},
      {"Cost: next as A \u00b7 as B \u00b7 split or difference \u00b7 against what \u00b7 the split left \u00b7 right",
       {cost_next, cost_against, cost_kind, cost_axis, cost_split_left, cost_split_right}},
      {"Cost: what each effect adds, or the tries", {cost_page}},
      {"Microscope \u00b7 magnify \u00b7 less \u00b7 to single floats \u00b7 the whole scene",
       {tab_microscope, magnify, diminish, to_numbers, to_scene}},
      {"naive numerics \u00b7 robust ones \u00b7 float \u00b7 double",
       {numerics_naive, numerics_robust, precision_float, precision_double}},
      {"the plan and the pane change places", {exchange}},
      {"fit the whole scene in \u00b7 zoom in \u00b7 out", {fit, zoom_in, zoom_out}},
      {"lines in space, and the plan \u00b7 from a pixel of the picture back to SCREEN", {lines, walk_strip}},
      {"the rays that depth and threshold cut off", {ghosts}},
      {"the 3-D picture or the lines: turn left \u00b7 right \u00b7 up \u00b7 down",
       {turn_left, turn_right, turn_up, turn_down}},
      {"the same: move left \u00b7 right \u00b7 up \u00b7 down", {shift_left, shift_right, shift_up, shift_down}},
      {"the same: nearer \u00b7 farther \u00b7 as at first", {approach, recede, reset_view}},
      {"3-D picture: its camera for the scene \u00b7 settings \u00b7 heat maps", {use_camera, image_settings, heat}},
      {"Move: add a solid sphere \u00b7 a transparent sphere \u00b7 a polygon \u00b7 a light",
       {add_solid_sphere, add_transparent_sphere, add_polygon, add_light}},
      {"Move: select the next thing \u00b7 the one before", {select_next, select_previous}},
      {"Move: type its numbers \u00b7 remove it", {edit_properties, remove}},
      {"undo \u00b7 redo", {undo, redo}},
      {"new \u00b7 open \u00b7 save \u00b7 save as \u00b7 quit", {new_scene, open, save, save_as, quit}},
      {"dark theme or the projector's", {theme}},
      {"letters larger \u00b7 smaller \u00b7 as at first", {scale_up, scale_down, scale_reset}},
      {"the menus \u00b7 the full screen", {menu, full_screen}},
  };
  return all;
}

}  // namespace

std::vector<KeyListRow> key_list() {
  std::vector<KeyListRow> rows;
  for (const KeyGroup& group : groups()) {
    KeyListRow row{{}, group.does};
    for (const Command command : group.commands)
      row.keys += (row.keys.empty() ? "" : " \u00b7 ") + all_command_keys(command);
    rows.push_back(std::move(row));
  }
  rows.push_back({"\u2190, \u2192, \u2191, \u2193", "Move: nudge what is selected; with Shift in larger steps"});
  rows.push_back({"Shift \u00b7 Ctrl, while dragging", "along one axis, round lengths and angles \u00b7 on the grid"});
  rows.push_back({"mouse wheel", "zoom; drag the empty plan to move it"});
  rows.push_back(
      {"3-D: drag \u00b7 Shift or right button \u00b7 click", "turn \u00b7 move \u00b7 walk the rays of that pixel"});
  rows.push_back({"Esc", "takes a drag back, closes what is open, ends AUTO"});
  return rows;
}

}  // namespace raywalk
