#include "view/plan_geometry.h"
#include "view/plan_view.h"
#include "view/text.h"
#include "view/update_parts.h"

#include <algorithm>

namespace raywalk::detail {

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
    return guess_end(state, body_at(state, *state.pointer));
  if (target.kind == TargetKind::cell) update(state, action::JumpToCell{target.index});
  if (target.kind == TargetKind::ray) update(state, action::JumpToRay{target.index});
}

}  // namespace

void hover(State& state) {
  state.hovered = state.pointer ? pick(state, *state.pointer) : Target{};
  state.hovered_ray = state.hovered.kind == TargetKind::ray ? state.hovered.index : -1;
}

void pointer_pressed(State& state, const action::PointerPressed& pressed) {
  if (state.drag) return;
  const Vec2d at = near_pane(pressed.at);
  state.pointer = at;
  hover(state);
  const bool left = pressed.button == action::Button::left;
  const Target target = left ? state.hovered : Target{};
  if (left) state.selected = selection_of(target, state.mode);
  const Vec2d place = clamped(to_scene(state.camera, state.viewport, at));
  if (left && aim_origin(state)) {
    state.drag = Drag{{}, false, at, place, state.camera};
    state.drag->aims = true;
    return guess_way(state, place);
  }
  if (left && pressed.double_click && state.mode == Mode::move && target.kind == TargetKind::edge)
    return insert_corner(state, {target.index, target.part, place});
  const bool pans = state.mode != Mode::move || !target;
  state.drag = Drag{target, pans, at, place, state.camera};
}

void pointer_moved(State& state, const action::PointerMoved& moved) {
  const Vec2d at = near_pane(moved.at);
  state.pointer = at;
  if (!state.drag) return hover(state);
  Drag& drag = *state.drag;
  if (!drag.moved && length(at - drag.grabbed_px) < click_tremble * state.ui_scale) return;
  drag.moved = true;
  const Vec2d to = clamped(to_scene(state.camera, state.viewport, at));
  if (drag.aims) return guess_way(state, to);
  if (drag.pans) {
    state.camera.centre = clamped(state.camera.centre + drag.grabbed - to);
    state.camera.fitted = false;
    return;
  }
  if (!drag.scene) drag.scene = std::make_shared<const Scene>(state.scene());
  Grip grip = grip_of(state, *drag.scene, drag.target, drag.grabbed, to);
  grip.constrain = moved.modifiers.shift;
  grip.snap = moved.modifiers.control;
  // If the scene would be invalid, it is not changed.
  std::optional<Scene> next = checked(state, grip);
  if (!next) return;
  state.notice.reset();
  if (*next != state.scene()) replace_scene(state, std::move(*next));
}

void pointer_released(State& state, const action::PointerReleased& released) {
  if (!state.drag) return;
  pointer_moved(state, {released.at, released.modifiers});
  end_drag(state);
  hover(state);
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

void cancel_drag(State& state) {
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

void zoom(State& state, const Vec2d& where, double factor) {
  const Vec2d at = near_pane(where);
  const Vec2d kept = to_scene(state.camera, state.viewport, at);
  state.camera.pixels_per_unit = std::clamp(state.camera.pixels_per_unit * factor, least_zoom, max_zoom);
  state.camera.fitted = false;
  state.camera.centre = clamped(state.camera.centre + kept - to_scene(state.camera, state.viewport, at));
}

void pan(State& state, const Vec2d& by) {
  const Vec2d units = Vec2d(by.x, -by.y) / state.camera.pixels_per_unit;
  state.camera.centre = clamped(state.camera.centre - units);
  state.camera.fitted = false;
}

void nudge(State& state, const action::Nudge& nudge) {
  if (!state.selected || !exists(state, state.selected))
    return inform(state, std::string(text("notice.select_first", state.language)));
  const Vec2d from = place_of(state, state.selected, state.viewport);
  const double step = grid_step(state.camera) * (nudge.coarse ? 1.0 : 0.1);
  const Vec2d direction = {std::clamp(nudge.direction.x, -1e3, 1e3), std::clamp(nudge.direction.y, -1e3, 1e3)};
  std::optional<Scene> next =
      checked(state, grip_of(state, state.scene(), state.selected, from, from + step * direction));
  if (next) commit(state, std::move(*next));
}

}  // namespace raywalk::detail
