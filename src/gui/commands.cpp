#include "gui/commands.h"

#include "gui/command_table.h"
#include "gui/words.h"

#include <algorithm>

namespace raywalk {

namespace {

const CommandRow& row_of(Command command) { return command_table[static_cast<std::size_t>(command)]; }

// What Tab goes through, in this order.
std::vector<Target> selectable(const Scene& scene) {
  std::vector<Target> targets;
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) targets.push_back({TargetKind::object, i});
  for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) targets.push_back({TargetKind::light, i});
  targets.push_back({TargetKind::eye});
  return targets;
}

void select_along(const Ui& ui, int direction) {
  const std::vector<Target> targets = selectable(ui.state.scene());
  const auto same = [&](const Target& t) {
    return t.kind == ui.state.selected.kind && (t.kind == TargetKind::eye || t.index == ui.state.selected.index);
  };
  const auto at = std::find_if(targets.begin(), targets.end(), same);
  const int count = static_cast<int>(targets.size());
  int next = direction > 0 ? 0 : count - 1;
  if (at != targets.end()) next = (static_cast<int>(at - targets.begin()) + direction + count) % count;
  ui.act(action::Select{targets[static_cast<std::size_t>(next)]});
}

void zoom(const Ui& ui, double factor) {
  const Viewport& pane = ui.state.viewport;
  ui.act(action::Zoom{{pane.width / 2, pane.height / 2}, factor});
}

constexpr double scale_step = 0.25;
constexpr double turn_step = 3.14159265358979323846 / 24;  // radians
constexpr double shift_step = 0.05;                        // of the view's width

// What keys turn: the lines, where they are shown and were turned last, else the picture.
SpaceView view_in_hand(const State& state) { return shows_lines(state) ? state.turned_last : SpaceView::image; }

void next_heat(const Ui& ui) {
  ImageSettings settings = ui.state.image;
  const auto now =
      static_cast<std::size_t>(std::find(all_heats.begin(), all_heats.end(), settings.heat) - all_heats.begin());
  settings.heat = all_heats[(now + 1) % all_heats.size()];
  ui.act(action::SetImageSettings{settings});
  ui.act(action::SetTab{Tab::image});
}

}  // namespace

std::string_view command_name(Command command) { return row_of(command).name; }

std::string command_label(Command command, const State& state) {
  if (command == Command::play && state.playing) return std::string(text(TextId::button_pause));
  if (command == Command::theme) {
    const TextId now = state.theme == Theme::dark ? TextId::theme_dark : TextId::theme_projector;
    return std::string(text(TextId::theme)) + ": " + std::string(text(now));
  }
  if (command == Command::lines && shows_lines(state)) return std::string(words::plan);
  const CommandRow& row = row_of(command);
  return row.label ? std::string(text(*row.label)) : row.label_text;
}

std::string short_label(Command command, const State& state) {
  constexpr std::array in_short{std::pair{Command::add_solid_sphere, TextId::short_solid_sphere},
                                std::pair{Command::add_transparent_sphere, TextId::short_transparent_sphere},
                                std::pair{Command::add_polygon, TextId::short_polygon},
                                std::pair{Command::add_light, TextId::short_light_source}};
  for (const auto& [of, id] : in_short)
    if (of == command) return std::string(text(id));
  if (command == Command::tab_image) return std::string(words::short_image);
  if (command == Command::tab_tree) return std::string(words::short_tree);
  return command_label(command, state);
}

std::string command_hint(Command command) { return row_of(command).hint; }

bool enabled(Command command, const State& state) {
  const bool at_start = state.position == 0, at_end = state.position >= state.timeline->steps();
  switch (command) {
    case Command::undo:
      return !state.undo.empty();
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
    case Command::walk_strip:
      return state.walk.has_value();
    case Command::use_camera:
      return state.image_camera.has_value();
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
    case Command::tab_equation:
    case Command::zoom_in:
    case Command::zoom_out:
    case Command::fit:
    case Command::lines:
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
    case Command::exchange:
    case Command::full_screen:
    case Command::lessons:
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
    case Command::tab_equation:
      return state.tab == Tab::equation;
    case Command::lessons:
      return state.lessons.shown;
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
    case Command::lines:
    case Command::walk_strip:
    case Command::reset_view:
    case Command::use_camera:
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
    case Command::scale_reset:
    case Command::exchange:
    case Command::full_screen:
    case Command::menu:
      return false;
  }
  return false;
}

void perform(Command command, const Ui& ui) {
  const State& state = ui.state;
  if (!enabled(command, state)) return;
  switch (command) {
    case Command::new_scene:
      return ui.act(action::New{});
    case Command::open:
      return ui.act(action::AskOpen{});
    case Command::save:
      return ui.act(action::Save{});
    case Command::save_as:
      return ui.act(action::AskSaveAs{});
    case Command::quit:
      return ui.act(action::Quit{});
    case Command::undo:
      return ui.act(action::Undo{});
    case Command::redo:
      return ui.act(action::Redo{});
    case Command::remove:
      return ui.act(action::RemoveSelected{});
    case Command::deselect:
      return ui.act(action::Select{});
    case Command::select_next:
      return select_along(ui, 1);
    case Command::select_previous:
      return select_along(ui, -1);
    case Command::edit_properties:
      return ui.wish(WindowWish::properties);
    case Command::add_solid_sphere:
      return ui.act(action::AddObject{action::ObjectKind::solid_sphere});
    case Command::add_transparent_sphere:
      return ui.act(action::AddObject{action::ObjectKind::transparent_sphere});
    case Command::add_polygon:
      return ui.act(action::AddObject{action::ObjectKind::polygon});
    case Command::add_light:
      return ui.act(action::AddObject{action::ObjectKind::light});
    case Command::mode_move:
      return ui.act(action::SetMode{Mode::move});
    case Command::mode_trace:
      return ui.act(action::SetMode{Mode::trace});
    case Command::mode_help:
      return ui.act(action::SetMode{Mode::help});
    case Command::step:
      return ui.act(action::Step{true});
    case Command::step_back:
      return ui.act(action::Step{false});
    case Command::step_ray:
      return ui.act(action::Step{true, Grain::ray});
    case Command::step_ray_back:
      return ui.act(action::Step{false, Grain::ray});
    case Command::step_pixel:
      return ui.act(action::Step{true, Grain::pixel});
    case Command::step_pixel_back:
      return ui.act(action::Step{false, Grain::pixel});
    case Command::step_over:
      return ui.act(action::Step{true, Grain::over});
    case Command::step_back_over:
      return ui.act(action::Step{false, Grain::over});
    case Command::step_out:
      return ui.act(action::Step{true, Grain::out});
    case Command::step_back_out:
      return ui.act(action::Step{false, Grain::out});
    case Command::run_on:
      return ui.act(action::RunOn{true});
    case Command::run_back:
      return ui.act(action::RunOn{false});
    case Command::break_here:
      return ui.act(action::ToggleBreakpoint{state.timeline->next(state.position)->line});
    case Command::breakpoints:
      return ui.wish(WindowWish::breakpoints);
    case Command::play:
      return ui.act(action::PlayPause{});
    case Command::clear:
      return ui.act(action::Clear{});
    case Command::first:
      return ui.act(action::Jump{0});
    case Command::last:
      return ui.act(action::Jump{state.timeline->steps()});
    case Command::slower:
      return ui.act(action::SetSpeed{state.lines_per_second / 2});
    case Command::faster:
      return ui.act(action::SetSpeed{state.lines_per_second * 2});
    case Command::grain_line:
      return ui.act(action::SetGrain{Grain::line});
    case Command::grain_ray:
      return ui.act(action::SetGrain{Grain::ray});
    case Command::grain_pixel:
      return ui.act(action::SetGrain{Grain::pixel});
    case Command::tab_image:
      return ui.act(action::SetTab{Tab::image});
    case Command::tab_tree:
      return ui.act(action::SetTab{Tab::tree});
    case Command::tab_stack:
      return ui.act(action::SetTab{Tab::stack});
    case Command::tab_legend:
      return ui.act(action::SetTab{Tab::legend});
    case Command::tab_equation:
      return ui.act(action::SetTab{Tab::equation});
    case Command::zoom_in:
      return zoom(ui, 1.25);
    case Command::zoom_out:
      return zoom(ui, 1 / 1.25);
    case Command::fit:
      return ui.act(action::FitView{});
    case Command::lines:
      return ui.act(action::ShowLines{!shows_lines(state)});
    case Command::walk_strip:
      return ui.act(action::WalkStrip{});
    case Command::reset_view:
      return ui.act(action::ResetView{view_in_hand(state)});
    case Command::use_camera:
      return ui.act(action::UseImageCamera{});
    case Command::image_settings:
      return ui.wish(WindowWish::image_settings);
    case Command::heat:
      return next_heat(ui);
    case Command::turn_left:
      return ui.act(action::Orbit{view_in_hand(state), {-turn_step, 0}});
    case Command::turn_right:
      return ui.act(action::Orbit{view_in_hand(state), {turn_step, 0}});
    case Command::turn_up:
      return ui.act(action::Orbit{view_in_hand(state), {0, -turn_step}});
    case Command::turn_down:
      return ui.act(action::Orbit{view_in_hand(state), {0, turn_step}});
    case Command::shift_left:
      return ui.act(action::Shift{view_in_hand(state), {-shift_step, 0}});
    case Command::shift_right:
      return ui.act(action::Shift{view_in_hand(state), {shift_step, 0}});
    case Command::shift_up:
      return ui.act(action::Shift{view_in_hand(state), {0, -shift_step}});
    case Command::shift_down:
      return ui.act(action::Shift{view_in_hand(state), {0, shift_step}});
    case Command::approach:
      return ui.act(action::Approach{view_in_hand(state), 1.15});
    case Command::recede:
      return ui.act(action::Approach{view_in_hand(state), 1 / 1.15});
    case Command::theme:
      return ui.act(action::SetTheme{state.theme == Theme::dark ? Theme::projector : Theme::dark});
    case Command::scale_up:
      return ui.act(action::SetUiScale{state.ui_scale + scale_step});
    case Command::scale_down:
      return ui.act(action::SetUiScale{state.ui_scale - scale_step});
    case Command::scale_reset:
      return ui.act(action::SetUiScale{1});
    case Command::exchange:
      return ui.wish(WindowWish::exchange);
    case Command::full_screen:
      return ui.wish(WindowWish::full_screen);
    case Command::lessons:
      return ui.act(action::ShowLessons{!state.lessons.shown});
    case Command::menu:
      return ui.wish(WindowWish::menu);
  }
}

}  // namespace raywalk
