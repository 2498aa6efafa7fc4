// Performs the commands.

#include "gui/choices.h"
#include "gui/commands.h"
#include "gui/cost_commands.h"
#include "gui/structure_commands.h"
#include "view/bug_panel.h"

#include <algorithm>
#include <random>

namespace raywalk {

namespace {

// The targets of Tab, in order.
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

void set_precision(const Ui& ui, bool single) {
  ImageSettings settings = ui.state.image;
  settings.single_precision = single;
  ui.act(action::SetImageSettings{settings});
}

constexpr double scale_step = 0.25;
constexpr double magnify_step = 0.05;
constexpr double turn_step = 3.14159265358979323846 / 24;  // radians
constexpr double shift_step = 0.05;                        // of the view's width

// Marks the line that has just run; if one is marked already, judges it.
void mark(const Ui& ui) {
  const State& state = ui.state;
  if (state.bugs.hunt && state.bugs.hunt->marked) return ui.act(action::JudgeLine{});
  if (const Event* just_run = state.timeline->just_run(state.position)) ui.act(action::MarkLine{just_run->line});
}

void next_heat(const Ui& ui) {
  ImageSettings settings = ui.state.image;
  settings.heat = next_among(all_heats, settings.heat);
  ui.act(action::SetImageSettings{settings});
  ui.act(action::SetTab{Tab::image});
}

}  // namespace

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
    case Command::tab_cost:
      return ui.act(action::SetTab{Tab::cost});
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
    case Command::ghosts:
      return ui.act(action::ShowGhosts{!state.shows_ghosts});
    case Command::tweens:
      return ui.act(action::SetTweens{!state.tweens});
    case Command::predict:
      return ui.act(action::SetPredictions{!state.predictions.on});
    case Command::save_predictions:
      return ui.act(action::AskSavePredictions{});
    case Command::export_walk:
      return ui.act(action::AskExport{});
    case Command::walk_strip:
      return ui.act(action::WalkStrip{});
    case Command::reset_view:
      return ui.act(action::ResetView{view_in_hand(state)});
    case Command::use_camera:
      return ui.act(action::UseImageCamera{});
    case Command::image_settings:
      return ui.wish(WindowWish::image_settings);
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
      return perform_cost(command, ui);
    case Command::tab_microscope:
      return ui.act(action::SetTab{Tab::microscope});
    case Command::magnify:
      return ui.act(action::Magnify{state.magnified + magnify_step});
    case Command::diminish:
      return ui.act(action::Magnify{state.magnified - magnify_step});
    case Command::to_numbers:
      return ui.act(action::Magnify{1});
    case Command::to_scene:
      return ui.act(action::Magnify{0});
    case Command::numerics_robust:
      return ui.act(action::SetNumerics{Numerics::robust, state.scene().render.epsilon});
    case Command::numerics_naive:
      return ui.act(action::SetNumerics{Numerics::naive, state.scene().render.epsilon});
    case Command::precision_double:
      return set_precision(ui, false);
    case Command::precision_float:
      return set_precision(ui, true);
    case Command::tab_structure:
      return ui.act(action::SetTab{Tab::structure});
    case Command::structure_next:
    case Command::structure_back:
    case Command::structure_last:
    case Command::structure_first:
    case Command::structure_kind:
    case Command::structure_page:
      return perform_structure(command, ui);
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
    case Command::language:
      return ui.act(action::SetLanguage{std::string(state.language.next().code())});
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
    case Command::bugs:
      return ui.act(action::ShowBugs{!state.bugs.shown});
    case Command::bug_surprise:
      return ui.act(action::HuntBug{surprising_bug(state.bugs, std::random_device{}()), true});
    case Command::bug_mark:
      return mark(ui);
    case Command::bug_cure:
      return ui.act(action::ShowCure{});
    case Command::bug_mend:
      return ui.act(action::MendBug{!state.bug->mended});
    case Command::menu:
      return ui.wish(WindowWish::menu);
  }
}

}  // namespace raywalk
