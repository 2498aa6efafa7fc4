#include "view/action.h"
#include "view/plan/painter.h"
#include "view/walk/asked.h"

#include <algorithm>

namespace raywalk {

void action::SetLiveRays::apply(State& state) const {
  state.live.rays = rays;
  state.live.shown = rays != LiveRays::off && state.walk.mode == Mode::move;
}

void action::ChooseLiveCell::apply(State& state) const {
  if (!exists(state, {TargetKind::cell, cell})) return;
  state.live.cell = cell;
  state.live.shown = state.live.rays != LiveRays::off && state.walk.mode == Mode::move;
}

void LiveRoom::follow(State& state, const Before& before) {
  LiveRoom& live = state.live;
  // An open question would be answered by its rays.
  if (state.walk.mode != Mode::move || live.rays == LiveRays::off || withholds_answer(state))
    live.shown = false;
  else if (state.walk.timeline != before.timeline && state.document.dirty)
    live.shown = true;
}

void LiveRoom::close(State& state) {
  state.live.cell = -1;
  state.live.shown = false;
}

void LiveRoom::draw_in_plan(Painter& painter) {
  const State& state = painter.state;
  if (!state.live.shown) return;
  const Timeline& timeline = *state.walk.timeline;
  const auto& pixels = timeline.pixels();
  const auto chosen = std::find_if(pixels.begin(), pixels.end(), [&](const PixelRecord& pixel) {
    return !timeline.of_strip() || pixel.column == live_cell(state);
  });
  const int pixel = chosen == pixels.end() ? -1 : static_cast<int>(chosen - pixels.begin());
  draw_rays(painter, {.position = timeline.steps(),
                      .pixel = pixel,
                      .others = state.live.rays == LiveRays::strip ? Earlier::shown : Earlier::hidden,
                      .pointed_at = false});
}

}  // namespace raywalk
