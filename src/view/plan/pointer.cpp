#include "view/plan/pointer.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"

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
  const int light = grip.target.kind == TargetKind::light ? grip.target.index : -1;
  const std::string why = why_refused(*next, object, light);
  if (why.empty()) return next;
  complain(state, fill("notice.refused", state.language, {{"why", why}}));
  return std::nullopt;
}

Grip grip_of(const State& state, const Scene& before, const Target& target, const Vec2d& from, const Vec2d& to) {
  Grip grip{before, target, from, to};
  grip.grid = grid_step(state.camera);
  grip.smallest = smallest_drag / state.camera.pixels_per_unit;
  grip.sun_pivot = state.camera.centre;
  return grip;
}

Vec2d clamped(const Vec2d& v) { return {std::clamp(v.x, -farthest, farthest), std::clamp(v.y, -farthest, farthest)}; }

/// Clamps to plausible pointer positions.
Vec2d near_pane(const Vec2d& at) { return {std::clamp(at.x, -1e6, 1e6), std::clamp(at.y, -1e6, 1e6)}; }

/// A press and a release in one place.
void click(State& state, const Target& target) {
  if (state.mode != Mode::trace) return;
  if (const auto asked = prediction_asked(state); asked && asked->what == PredictionKind::end)
    return action::GuessEnd{body_at(state, *state.pointer)}.apply(state);
  if (target.kind == TargetKind::cell) update(state, action::JumpToCell{target.index});
  if (target.kind == TargetKind::ray) update(state, action::JumpToRay{target.index});
}

}  // namespace

void refit(State& state) {
  if (state.camera.fitted) state.camera = fitted(state);
}

void hover(State& state) {
  state.hovered = state.pointer ? pick(state, *state.pointer) : Target{};
  state.hovered_ray = state.hovered.kind == TargetKind::ray ? state.hovered.index : -1;
}

void action::PointerPressed::apply(State& state) const {
  if (state.drag) return;
  const Vec2d pixel = near_pane(at);
  state.pointer = pixel;
  hover(state);
  const bool left = button == Button::left;
  const Target target = left ? state.hovered : Target{};
  if (left) state.selected = selection_of(target, state.mode);
  const Vec2d place = clamped(to_scene(state.camera, state.viewport, pixel));
  if (left && aim_origin(state)) {
    state.drag = Drag{{}, false, pixel, place, state.camera};
    state.drag->aims = true;
    return GuessWay{place}.apply(state);
  }
  if (left && double_click && state.mode == Mode::move && target.kind == TargetKind::edge)
    return InsertCorner{target.index, target.part, place}.apply(state);
  const bool pans = state.mode != Mode::move || !target;
  state.drag = Drag{target, pans, pixel, place, state.camera};
}

void action::PointerMoved::apply(State& state) const {
  const Vec2d pixel = near_pane(at);
  state.pointer = pixel;
  if (!state.drag) return hover(state);
  Drag& drag = *state.drag;
  if (!drag.moved && length(pixel - drag.grabbed_px) < click_tremble * state.ui_scale) return;
  drag.moved = true;
  const Vec2d to = clamped(to_scene(state.camera, state.viewport, pixel));
  if (drag.aims) return GuessWay{to}.apply(state);
  if (drag.pans) {
    state.camera.centre = clamped(state.camera.centre + drag.grabbed - to);
    state.camera.fitted = false;
    return;
  }
  if (!drag.scene) drag.scene = std::make_shared<const Scene>(state.scene());
  Grip grip = grip_of(state, *drag.scene, drag.target, drag.grabbed, to);
  grip.constrain = modifiers.shift;
  grip.snap = modifiers.control;
  // If the scene would be invalid, it is not changed.
  std::optional<Scene> next = checked(state, grip);
  if (!next) return;
  state.notice.reset();
  if (*next != state.scene()) replace_scene(state, std::move(*next));
}

void action::PointerReleased::apply(State& state) const {
  if (!state.drag) return;
  PointerMoved{at, modifiers}.apply(state);
  end_drag(state);
  hover(state);
}

void action::PointerLeft::apply(State& state) const {
  state.pointer.reset();
  if (state.drag) return;
  state.hovered = {};
  state.hovered_ray = -1;
}

void end_drag(State& state) {
  if (!state.drag) return;
  Drag drag = std::move(*state.drag);
  state.drag.reset();
  if (drag.aims) return;
  if (drag.pans && !drag.moved) return click(state, drag.target);
  if (!drag.scene || *drag.scene == state.scene()) return;
  state.last_edit.reset();
  remember(state, *drag.scene);
}

void action::CancelDrag::apply(State& state) const {
  if (!state.drag) return;
  Drag drag = std::move(*state.drag);
  state.drag.reset();
  if (drag.aims) {
    forget_aim(state);
  } else if (drag.pans) {
    state.camera = drag.camera;
  } else if (drag.scene && *drag.scene != state.scene()) {
    replace_scene(state, *drag.scene);
  }
  hover(state);
}

void action::Zoom::apply(State& state) const {
  const Vec2d pixel = near_pane(at);
  const Vec2d kept = to_scene(state.camera, state.viewport, pixel);
  state.camera.pixels_per_unit = std::clamp(state.camera.pixels_per_unit * factor, least_zoom, max_zoom);
  state.camera.fitted = false;
  state.camera.centre = clamped(state.camera.centre + kept - to_scene(state.camera, state.viewport, pixel));
}

void action::Pan::apply(State& state) const {
  const Vec2d units = Vec2d(by.x, -by.y) / state.camera.pixels_per_unit;
  state.camera.centre = clamped(state.camera.centre - units);
  state.camera.fitted = false;
}

void action::FitView::apply(State& state) const { state.camera = fitted(state); }

void action::ResizePlan::apply(State& state) const {
  state.viewport = {std::clamp(viewport.width, 1.0, 1e5), std::clamp(viewport.height, 1.0, 1e5)};
  refit(state);
}

void action::HoverRay::apply(State& state) const {
  state.hovered_ray = exists(state, {TargetKind::ray, ray}) ? ray : -1;
}

void action::HoverLine::apply(State& state) const { state.hovered_line = line; }

void action::Select::apply(State& state) const {
  if (exists(state, target)) state.selected = target;
}

void action::Nudge::apply(State& state) const {
  if (!state.selected || !exists(state, state.selected))
    return inform(state, std::string(text("notice.select_first", state.language)));
  const Vec2d from = place_of(state, state.selected, state.viewport);
  const double step = grid_step(state.camera) * (coarse ? 1.0 : 0.1);
  const Vec2d towards = {std::clamp(direction.x, -1e3, 1e3), std::clamp(direction.y, -1e3, 1e3)};
  std::optional<Scene> next =
      checked(state, grip_of(state, state.scene(), state.selected, from, from + step * towards));
  if (next) commit(state, std::move(*next));
}

}  // namespace raywalk
