#include "view/plan/pointer.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <algorithm>

namespace raywalk {

namespace {

constexpr double click_tremble = 3;  // pixels at scale 1
constexpr double least_zoom = 1e-6, max_zoom = 1e9, farthest = 1e12;
/// The smallest radius, width or distance by dragging, in pixels.
constexpr double smallest_drag = 2;

/// The selection when `target` is pressed: a handle's object, or a corner; in trace mode only whole things.
Target selection_of(const Target& target, Mode mode) {
  if (mode != Mode::move && target.kind == TargetKind::cell) return {};
  switch (target.kind) {
    case TargetKind::radius:
    case TargetKind::rotation:
    case TargetKind::edge:
      return {TargetKind::object, target.index};
    case TargetKind::light_radius:
      return {TargetKind::light, target.index};
    case TargetKind::cell:
      return {TargetKind::screen_distance};
    case TargetKind::ray:
      return {};
    case TargetKind::nothing:
    case TargetKind::eye:
    case TargetKind::view_direction:
    case TargetKind::screen_height:
    case TargetKind::screen_distance:
    case TargetKind::object:
    case TargetKind::corner:
    case TargetKind::light:
      return target;
  }
  return {};
}

/// The scene after a drag, if it is valid; else reports why not.
std::optional<Scene> checked(State& state, const Grip& grip) {
  std::optional<Scene> next = dragged(grip);
  if (!next) return std::nullopt;
  const int object = belongs_to_object(grip.target) ? grip.target.index : -1;
  const int light = belongs_to_light(grip.target) ? grip.target.index : -1;
  const std::string why = why_refused(*next, object, light);
  if (why.empty()) return next;
  complain(state, fill("notice.refused", state.appearance.language, {{"why", why}}));
  return std::nullopt;
}

Grip grip_of(const State& state, const Scene& before, const Target& target, const Vec2d& from, const Vec2d& to) {
  Grip grip{before, target, from, to};
  grip.grid = grid_step(state.plan.camera);
  grip.smallest = smallest_drag / state.plan.camera.pixels_per_unit;
  grip.sun_pivot = state.plan.camera.centre;
  return grip;
}

Vec2d clamped(const Vec2d& v) { return {std::clamp(v.x, -farthest, farthest), std::clamp(v.y, -farthest, farthest)}; }

/// Clamps to plausible pointer positions.
Vec2d near_pane(const Vec2d& at) { return {std::clamp(at.x, -1e6, 1e6), std::clamp(at.y, -1e6, 1e6)}; }

/// A press and a release in one place, `at` pixels.
void click(State& state, const Target& target, const Vec2d& at) {
  if (state.walk.mode != Mode::trace) return;
  if (const auto asked = prediction_asked(state); asked && asked->what == PredictionKind::end)
    return action::GuessEnd{body_at(state, at)}.apply(state);
  if (target.kind == TargetKind::cell) update(state, action::JumpToCell{target.index});
  if (target.kind == TargetKind::ray) update(state, action::JumpToRay{target.index});
}

}  // namespace

void refit(State& state) {
  if (state.plan.camera.fitted) state.plan.camera = fitted(state);
}

void hover(State& state) {
  state.plan.hovered = state.plan.pointer && !inks(state) ? pick(state, *state.plan.pointer) : Target{};
  state.plan.hovered_ray = state.plan.hovered.kind == TargetKind::ray ? state.plan.hovered.index : -1;
}

void action::PointerPressed::apply(State& state) const {
  if (state.plan.drag) return;
  const Vec2d pixel = near_pane(at);
  state.plan.pointer = pixel;
  hover(state);
  const bool left = button == Button::left;
  const Vec2d place = clamped(to_scene(state.plan.camera, state.plan.viewport, pixel));
  if (left && inks(state)) {
    state.plan.drag = Drag{{}, false, pixel, place, state.plan.camera};
    state.plan.drag->inks = true;
    return InkRoom::press(state, place, modifiers);
  }
  const Target target = left ? state.plan.hovered : Target{};
  if (left) state.plan.selected = selection_of(target, state.walk.mode);
  if (left && aim_origin(state)) {
    state.plan.drag = Drag{{}, false, pixel, place, state.plan.camera};
    state.plan.drag->aims = true;
    return GuessWay{place}.apply(state);
  }
  if (left && double_click && state.walk.mode == Mode::move && target.kind == TargetKind::edge)
    return InsertCorner{target.index, target.part, place}.apply(state);
  const bool pans = state.walk.mode != Mode::move || !target;
  state.plan.drag = Drag{target, pans, pixel, place, state.plan.camera};
}

void action::PointerMoved::apply(State& state) const {
  const Vec2d pixel = near_pane(at);
  state.plan.pointer = pixel;
  if (!state.plan.drag) {
    if (inks(state)) InkRoom::lead(state, clamped(to_scene(state.plan.camera, state.plan.viewport, pixel)), modifiers);
    return hover(state);
  }
  Drag& drag = *state.plan.drag;
  if (!drag.moved && length(pixel - drag.grabbed_px) < click_tremble * state.appearance.ui_scale) return;
  drag.moved = true;
  const Vec2d to = clamped(to_scene(state.plan.camera, state.plan.viewport, pixel));
  if (drag.aims) return GuessWay{to}.apply(state);
  if (drag.inks) return InkRoom::lead(state, to, modifiers);
  if (drag.pans) {
    state.plan.camera.centre = clamped(state.plan.camera.centre + drag.grabbed - to);
    state.plan.camera.fitted = false;
    return;
  }
  if (!drag.scene) drag.scene = std::make_shared<const Scene>(state.scene());
  Grip grip = grip_of(state, *drag.scene, drag.target, drag.grabbed, to);
  grip.constrain = modifiers.shift;
  grip.snap = modifiers.control;
  // If the scene would be invalid, it is not changed.
  std::optional<Scene> next = checked(state, grip);
  if (!next) return;
  forget_notice(state);
  if (*next != state.scene()) replace_scene(state, std::move(*next));
}

void action::PointerReleased::apply(State& state) const {
  if (!state.plan.drag) return;
  PointerMoved{at, modifiers}.apply(state);
  end_drag(state);
  hover(state);
}

void action::PointerLeft::apply(State& state) const {
  state.plan.pointer.reset();
  if (state.plan.drag) return;
  state.plan.hovered = {};
  state.plan.hovered_ray = -1;
}

void end_drag(State& state) {
  if (!state.plan.drag) return;
  Drag drag = std::move(*state.plan.drag);
  state.plan.drag.reset();
  if (drag.aims) return;
  if (drag.inks) return InkRoom::lift(state, drag.moved);
  if (drag.pans && !drag.moved) return click(state, drag.target, drag.grabbed_px);
  if (!drag.scene || *drag.scene == state.scene()) return;
  state.document.last_edit.reset();
  remember(state, *drag.scene);
}

void action::CancelDrag::apply(State& state) const {
  if (!state.plan.drag) return;
  Drag drag = std::move(*state.plan.drag);
  state.plan.drag.reset();
  if (drag.aims) {
    forget_aim(state);
  } else if (drag.inks) {
    InkRoom::drop(state);
  } else if (drag.pans) {
    state.plan.camera = drag.camera;
  } else if (drag.scene && *drag.scene != state.scene()) {
    replace_scene(state, *drag.scene);
  }
  hover(state);
}

void action::Zoom::apply(State& state) const {
  const Vec2d pixel = near_pane(at);
  const Vec2d kept = to_scene(state.plan.camera, state.plan.viewport, pixel);
  state.plan.camera.pixels_per_unit = std::clamp(state.plan.camera.pixels_per_unit * factor, least_zoom, max_zoom);
  state.plan.camera.fitted = false;
  state.plan.camera.centre =
      clamped(state.plan.camera.centre + kept - to_scene(state.plan.camera, state.plan.viewport, pixel));
}

void action::Pan::apply(State& state) const {
  const Vec2d units = Vec2d(by.x, -by.y) / state.plan.camera.pixels_per_unit;
  state.plan.camera.centre = clamped(state.plan.camera.centre - units);
  state.plan.camera.fitted = false;
}

void action::FitView::apply(State& state) const { state.plan.camera = fitted(state); }

void action::ResizePlan::apply(State& state) const {
  state.plan.viewport = {std::clamp(viewport.width, 1.0, 1e5), std::clamp(viewport.height, 1.0, 1e5)};
  refit(state);
}

void action::HoverRay::apply(State& state) const {
  state.plan.hovered_ray = exists(state, {TargetKind::ray, ray}) ? ray : -1;
}

void action::HoverLine::apply(State& state) const { state.plan.hovered_line = line; }

void action::Select::apply(State& state) const {
  if (exists(state, target)) state.plan.selected = target;
}

void action::Place::apply(State& state) const {
  if (!exists(state, target)) return;
  state.plan.selected = selection_of(target, state.walk.mode);
  const Vec2d from = place_of(state, target, state.plan.viewport);
  std::optional<Scene> next = checked(state, grip_of(state, state.scene(), target, from, clamped(at)));
  if (next) commit(state, std::move(*next));
}

void action::Nudge::apply(State& state) const {
  if (!state.plan.selected || !exists(state, state.plan.selected))
    return inform(state, std::string(text("notice.select_first", state.appearance.language)));
  const Vec2d from = place_of(state, state.plan.selected, state.plan.viewport);
  const double step = grid_step(state.plan.camera) * (coarse ? 1.0 : 0.1);
  const Vec2d towards = {std::clamp(direction.x, -1e3, 1e3), std::clamp(direction.y, -1e3, 1e3)};
  std::optional<Scene> next =
      checked(state, grip_of(state, state.scene(), state.plan.selected, from, from + step * towards));
  if (next) commit(state, std::move(*next), {Action(*this).kind(), state.plan.selected.index}, continues);
}

}  // namespace raywalk
