// The arrow of a lesson's prediction, in the plan.

#include "view/lesson_panel.h"
#include "view/painter.h"

namespace raywalk::detail {

void draw_guess(Painter& painter) {
  const State& state = painter.state;
  const std::optional<Vec2d> asked_from = arrow_origin(state);
  if (asked_from) {
    // Where to take hold: a ring that breathes room around the hit.
    const double ring = 11 * painter.sizes.unit;
    painter.add(CircleItem{painter.pixels(*asked_from), ring, {}, painter.stroke(painter.colours.selected, 1.6)});
  }
  const std::optional<Vec2d> from = guess_origin(state);
  if (!from || !state.lessons.guess.arrow) return;
  const Vec2d& arrow = *state.lessons.guess.arrow;
  const Vec2d along = Vec2d(arrow.x, -arrow.y) / length(arrow);
  const Vec2d at = painter.pixels(*from);
  const double reach = 150 * painter.sizes.unit;
  Stroke stroke = painter.stroke(painter.colours.selected, 2.4);
  stroke.dash = painter.scaled({{3, 4, 0, 0}, 2});
  painter.add_clipped({at, at + reach * along, stroke, 14 * painter.sizes.unit});
}

}  // namespace raywalk::detail
