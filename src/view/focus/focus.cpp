#include "view/action.h"
#include "view/plan/plan_view.h"
#include "view/plan/pointer.h"
#include "view/walk/asked.h"

#include <optional>

namespace raywalk {

namespace {

/// Where the ray begins that the lesson's step asks about, if the step wants it large and the walk is there.
std::optional<Vec2d> place_in_question(const State& state) {
  const PlayedStep* step = state.lessons.shown ? state.lessons.at() : nullptr;
  const int position = state.walk.position;
  if (step == nullptr || !step->step->zoom || shows_lines(state) || state.walk.mode != Mode::trace) return std::nullopt;
  if (position != step->asked && position != step->shown) return std::nullopt;
  if (const std::optional<Vec2d> origin = guess_origin(state)) return origin;
  const int index = state.walk.timeline->current_ray(step->asked);
  if (index < 0) return std::nullopt;
  const RayRecord& ray = state.walk.timeline->rays()[static_cast<std::size_t>(index)];
  return plan(ray.found_at <= step->asked && ray.ending == Ending::hit ? ray.end : ray.origin);
}

void zoom_back(State& state) {
  if (!state.focus.zoomed) return;
  if (!state.plan.camera.fitted) state.plan.camera = state.focus.zoomed->own;
  state.focus.zoomed.reset();
  refit(state);
}

}  // namespace

void action::SetFocus::apply(State& state) const {
  state.focus.on = on;
  state.focus.tab = false;
}

void FocusRoom::follow(State& state, const Before&) {
  const std::optional<Vec2d> place = state.focus.on ? place_in_question(state) : std::nullopt;
  if (!place) return zoom_back(state);
  std::optional<Zoomed>& zoomed = state.focus.zoomed;
  // Once there, the plan can be zoomed and moved by hand.
  if (zoomed && zoomed->viewport == state.plan.viewport && zoomed->step == state.lessons.step) return;
  constexpr double larger = 2.5;
  zoomed = {zoomed && !state.plan.camera.fitted ? zoomed->own : state.plan.camera, state.plan.viewport,
            state.lessons.step};
  state.plan.camera = {*place, larger * fitted(state).pixels_per_unit, false};
}

void FocusRoom::close(State& state) { state.focus.zoomed.reset(); }

}  // namespace raywalk
