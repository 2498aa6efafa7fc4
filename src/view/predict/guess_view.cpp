// Guesses in the plan, beside the truth: of a lesson's question, and of predictions on any walk.

#include "view/plan/painter.h"
#include "view/predict/predict.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <cmath>

namespace raywalk {

namespace {

/// Dotted, unlike rays. Returns its tip, in pixels.
Vec2d draw_arrow(Painter& painter, const Vec2d& from, const Vec2d& arrow) {
  const Vec2d along = Vec2d(arrow.x, -arrow.y) / length(arrow);
  const Vec2d at = painter.pixels(from), tip = at + 150 * painter.sizes.unit * along;
  Stroke stroke = painter.stroke(painter.colours.selected, 2.4);
  stroke.dash = painter.scaled({{3, 4, 0, 0}, 2});
  painter.add_clipped({at, tip, stroke, 14 * painter.sizes.unit});
  return tip;
}

void draw_predictions(Painter& painter) {
  const State& state = painter.state;
  if (!state.predictions.on) return;
  const auto& rays = state.walk.timeline->rays();
  const auto origin = [&](const Prediction& one) { return plan(rays[static_cast<std::size_t>(one.of.ray)].origin); };
  const int pixel = state.walk.timeline->current_pixel(state.walk.position);
  for (const Prediction& one : state.predictions.judged) {
    const RayRecord& ray = rays[static_cast<std::size_t>(one.of.ray)];
    if (one.of.what != PredictionKind::way || ray.pixel != pixel || ray.formed_at > state.walk.position) continue;
    const Vec2d tip = draw_arrow(painter, origin(one), one.arrow);
    painter.note_beside(tip, Vec2d(0, -1), number_text(std::round(one.degrees), state.appearance.language) + "\u00b0");
  }
  if (state.predictions.open && state.predictions.open->of.what == PredictionKind::way)
    draw_arrow(painter, origin(*state.predictions.open), state.predictions.open->arrow);
}

}  // namespace

void PredictRoom::draw_in_plan(Painter& painter) {
  const State& state = painter.state;
  if (const std::optional<Vec2d> asked_from = aim_origin(state)) {
    // The handle: a ring with some room around the hit.
    const double ring = 11 * painter.sizes.unit;
    painter.add(CircleItem{painter.pixels(*asked_from), ring, {}, painter.stroke(painter.colours.selected, 1.6)});
  }
  const std::optional<Vec2d> from = guess_origin(state);
  if (from && state.lessons.guess.arrow) draw_arrow(painter, *from, *state.lessons.guess.arrow);
  draw_predictions(painter);
}

}  // namespace raywalk
