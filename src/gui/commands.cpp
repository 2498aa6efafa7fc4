#include "gui/commands.h"

#include "gui/command_table.h"
#include "gui/cost_commands.h"
#include "gui/structure_commands.h"
#include "view/text.h"

#include <array>

namespace raywalk {

namespace {

const CommandRow& row_of(Command command) { return command_table[static_cast<std::size_t>(command)]; }

/// One of its two texts, command.step_back.label and command.step_back.hint.
std::string said(Command command, std::string_view what, Language language) {
  return std::string(family_text("command", std::string(row_of(command).name) + "." + std::string(what), language));
}

}  // namespace

std::string_view command_name(Command command) { return row_of(command).name; }

std::string command_label(Command command, const State& state) {
  const auto say = [&](std::string_view id) { return std::string(text(id, state.language)); };
  if (command == Command::play && state.playing) return say("transport.pause");
  if (command == Command::theme)
    return say("command.theme.label") + ": " + say(state.theme == Theme::dark ? "theme.dark" : "theme.projector");
  if (command == Command::language) return say("command.language.label") + ": " + std::string(state.language.name());
  if (command == Command::lines && shows_lines(state)) return say("plan.name");
  if (const std::optional<std::string_view> now = cost_label(command, state)) return say(*now);
  return said(command, "label", state.language);
}

std::string short_label(Command command, const State& state) {
  const auto say = [&](std::string_view id) { return std::string(text(id, state.language)); };
  constexpr std::array in_short{std::pair{Command::add_solid_sphere, "object.short_solid_sphere"},
                                std::pair{Command::add_transparent_sphere, "object.short_transparent_sphere"},
                                std::pair{Command::add_polygon, "object.short_polygon"},
                                std::pair{Command::add_light, "object.short_light_source"}};
  for (const auto& [of, id] : in_short)
    if (of == command) return say(id);
  if (command == Command::language) return std::string(state.language.next().sign());
  if (command == Command::tab_image) return say("tab.short_image");
  if (command == Command::tab_tree) return say("tab.short_tree");
  if (command == Command::tab_microscope) return say("tab.short_microscope");
  if (command == Command::tab_structure) return say("tab.short_structure");
  return command_label(command, state);
}

std::string command_hint(Command command, Language language) { return said(command, "hint", language); }

SpaceView view_in_hand(const State& state) { return shows_lines(state) ? state.turned_last : SpaceView::image; }

bool enabled(Command command, const State& state) {
  const bool at_start = state.position == 0, at_end = state.position >= state.timeline->steps();
  switch (command) {
    case Command::undo:
      return !state.undo.empty() || state.bugs.hunt;
    case Command::redo:
      return !state.redo.empty();
    case Command::remove:
      return state.mode == Mode::move &&
             (state.selected.kind == TargetKind::object || state.selected.kind == TargetKind::light ||
              state.selected.kind == TargetKind::corner);
    case Command::deselect:
      return static_cast<bool>(state.selected);
    case Command::edit_properties:
      return state.mode == Mode::move && static_cast<bool>(state.selected);
    case Command::select_next:
    case Command::select_previous:
    case Command::add_solid_sphere:
    case Command::add_transparent_sphere:
    case Command::add_polygon:
    case Command::add_light:
      return state.mode == Mode::move;
    case Command::step:
    case Command::step_ray:
    case Command::step_pixel:
    case Command::step_over:
    case Command::step_out:
    case Command::run_on:
    case Command::break_here:
    case Command::last:
      return !at_end;
    case Command::play:
      return !at_end || state.playing;
    case Command::step_back:
    case Command::step_ray_back:
    case Command::step_pixel_back:
    case Command::step_back_over:
    case Command::step_back_out:
    case Command::run_back:
    case Command::first:
    case Command::clear:
      return !at_start || state.playing;
    case Command::slower:
      return state.lines_per_second > min_speed;
    case Command::faster:
      return state.lines_per_second < max_speed;
    case Command::scale_up:
      return state.ui_scale < max_ui_scale;
    case Command::scale_down:
      return state.ui_scale > min_ui_scale;
    case Command::scale_reset:
      return state.ui_scale != 1;
    case Command::cost_forget:
    case Command::cost_next:
    case Command::cost_against:
    case Command::cost_kind:
    case Command::cost_axis:
    case Command::cost_split_left:
    case Command::cost_split_right:
      return state.tab == Tab::cost && state.cost.page == CostPage::tries && !state.cost.tried.empty();
    case Command::magnify:
    case Command::to_numbers:
      return state.tab == Tab::microscope && state.magnified < 1;
    case Command::diminish:
    case Command::to_scene:
      return state.tab == Tab::microscope && state.magnified > 0;
    case Command::structure_next:
    case Command::structure_back:
    case Command::structure_last:
    case Command::structure_first:
    case Command::structure_kind:
    case Command::structure_page:
      return structure_enabled(command, state);
    case Command::walk_strip:
      return state.walk.has_value();
    case Command::use_camera:
      return state.image_camera.has_value();
    case Command::bug_mark:
      return asks_for_line(state) && (marked_line(state) || !at_start);
    case Command::bug_cure:
      return state.bugs.hunt && state.bugs.hunt->end == BugEnd::open;
    case Command::bug_mend:
      return state.bug && state.bug->known;
    case Command::reset_view:
      return view_in_hand(state) == SpaceView::image ? state.image_camera.has_value() : state.lines_camera.has_value();
    case Command::new_scene:
    case Command::open:
    case Command::save:
    case Command::save_as:
    case Command::quit:
    case Command::mode_move:
    case Command::mode_trace:
    case Command::mode_help:
    case Command::breakpoints:
    case Command::grain_line:
    case Command::grain_ray:
    case Command::grain_pixel:
    case Command::tab_image:
    case Command::tab_tree:
    case Command::tab_stack:
    case Command::tab_legend:
    case Command::tab_cost:
    case Command::cost_knobs:
    case Command::cost_try:
    case Command::cost_ladder:
    case Command::cost_page:
    case Command::tab_equation:
    case Command::tab_microscope:
    case Command::tab_structure:
    case Command::numerics_robust:
    case Command::numerics_naive:
    case Command::precision_double:
    case Command::precision_float:
    case Command::zoom_in:
    case Command::zoom_out:
    case Command::fit:
    case Command::lines:
    case Command::ghosts:
    case Command::tweens:
    case Command::predict:
    case Command::save_predictions:
    case Command::export_walk:
    case Command::image_settings:
    case Command::heat:
    case Command::turn_left:
    case Command::turn_right:
    case Command::turn_up:
    case Command::turn_down:
    case Command::shift_left:
    case Command::shift_right:
    case Command::shift_up:
    case Command::shift_down:
    case Command::approach:
    case Command::recede:
    case Command::theme:
    case Command::language:
    case Command::exchange:
    case Command::full_screen:
    case Command::lessons:
    case Command::bugs:
    case Command::bug_surprise:
    case Command::menu:
      return true;
  }
  return false;
}

bool chosen(Command command, const State& state) {
  switch (command) {
    case Command::mode_move:
      return state.mode == Mode::move;
    case Command::mode_trace:
      return state.mode == Mode::trace;
    case Command::mode_help:
      return state.mode == Mode::help;
    case Command::play:
      return state.playing;
    case Command::ghosts:
      return state.shows_ghosts;
    case Command::tweens:
      return state.tweens;
    case Command::predict:
      return state.predictions.on;
    case Command::grain_line:
      return state.grain == Grain::line;
    case Command::grain_ray:
      return state.grain == Grain::ray;
    case Command::grain_pixel:
      return state.grain == Grain::pixel;
    case Command::tab_image:
      return state.tab == Tab::image;
    case Command::tab_tree:
      return state.tab == Tab::tree;
    case Command::tab_stack:
      return state.tab == Tab::stack;
    case Command::tab_legend:
      return state.tab == Tab::legend;
    case Command::tab_cost:
      return state.tab == Tab::cost;
    case Command::tab_equation:
      return state.tab == Tab::equation;
    case Command::tab_microscope:
      return state.tab == Tab::microscope;
    case Command::tab_structure:
      return state.tab == Tab::structure;
    case Command::numerics_robust:
      return state.scene().render.numerics == Numerics::robust;
    case Command::numerics_naive:
      return state.scene().render.numerics == Numerics::naive;
    case Command::precision_double:
      return !state.image.single_precision;
    case Command::precision_float:
      return state.image.single_precision;
    case Command::lessons:
      return state.lessons.shown;
    case Command::bugs:
      return state.bugs.shown;
    case Command::bug_mend:
      return state.bug && state.bug->mended;
    case Command::break_here:
      return state.timeline->next(state.position) != nullptr &&
             state.breakpoints.is_before(state.timeline->next(state.position)->line);
    case Command::breakpoints:
      return state.breakpoints.any();
    case Command::step_over:
    case Command::step_back_over:
    case Command::step_out:
    case Command::step_back_out:
    case Command::run_on:
    case Command::run_back:
    case Command::new_scene:
    case Command::open:
    case Command::save:
    case Command::save_as:
    case Command::quit:
    case Command::undo:
    case Command::redo:
    case Command::remove:
    case Command::deselect:
    case Command::select_next:
    case Command::select_previous:
    case Command::edit_properties:
    case Command::add_solid_sphere:
    case Command::add_transparent_sphere:
    case Command::add_polygon:
    case Command::add_light:
    case Command::step:
    case Command::step_back:
    case Command::step_ray:
    case Command::step_ray_back:
    case Command::step_pixel:
    case Command::step_pixel_back:
    case Command::clear:
    case Command::first:
    case Command::last:
    case Command::slower:
    case Command::faster:
    case Command::zoom_in:
    case Command::zoom_out:
    case Command::fit:
    case Command::scale_up:
    case Command::scale_down:
    case Command::save_predictions:
    case Command::export_walk:
    case Command::lines:
    case Command::walk_strip:
    case Command::reset_view:
    case Command::use_camera:
    case Command::image_settings:
    case Command::heat:
    case Command::cost_knobs:
    case Command::cost_try:
    case Command::cost_ladder:
    case Command::cost_forget:
    case Command::cost_next:
    case Command::cost_against:
    case Command::cost_kind:
    case Command::cost_axis:
    case Command::cost_split_left:
    case Command::cost_split_right:
    case Command::cost_page:
    case Command::magnify:
    case Command::diminish:
    case Command::to_numbers:
    case Command::to_scene:
    case Command::structure_next:
    case Command::structure_back:
    case Command::structure_last:
    case Command::structure_first:
    case Command::structure_kind:
    case Command::structure_page:
    case Command::turn_left:
    case Command::turn_right:
    case Command::turn_up:
    case Command::turn_down:
    case Command::shift_left:
    case Command::shift_right:
    case Command::shift_up:
    case Command::shift_down:
    case Command::approach:
    case Command::recede:
    case Command::theme:
    case Command::language:
    case Command::scale_reset:
    case Command::exchange:
    case Command::full_screen:
    case Command::bug_surprise:
    case Command::bug_mark:
    case Command::bug_cure:
    case Command::menu:
      return false;
  }
  return false;
}

}  // namespace raywalk
