// The numbers of the live equation beside the hit itself: t along the ray, the angle between ray and normal.

#include "view/equation.h"
#include "view/painter.h"

#include <algorithm>
#include <cmath>

namespace raywalk::detail {

void draw_hit_notes(Painter& painter) {
  const State& state = painter.state;
  if (state.mode != Mode::trace || state.tab != Tab::equation) return;
  const HitNotes notes = hit_notes(state);
  if (notes.t.empty()) return;
  const RayRecord& ray = state.timeline->rays()[static_cast<std::size_t>(state.timeline->current_ray(state.position))];
  const Vec2d hit = painter.pixels(plan(ray.end)), from = painter.pixels(plan(ray.origin));
  const double size = length(hit - from), unit = painter.sizes.unit;
  if (!(size > 0)) return;
  const Vec2d back = (from - hit) / size, across(-back.y, back.x);
  // Beside the middle of the ray, on the side where there is more room above it.
  const double side = across.y > 0 ? -1 : 1;
  painter.note(painter.seen_middle(from, hit) + side * 18 * unit * across, notes.t);
  if (notes.angle.empty()) return;
  const double facing = dot(ray.normal, ray.direction) > 0 ? -1 : 1;
  const Vec2d normal = facing * Vec2d(ray.normal.x, -ray.normal.y);
  if (!(length(normal) > 1e-6)) return;
  // The arc from the ray to the normal, and its angle beyond.
  const Vec2d n = normal / length(normal);
  const double begin = std::atan2(back.y, back.x), turn = std::atan2(back.x * n.y - back.y * n.x, dot(back, n));
  const double first = turn < 0 ? begin + turn : begin;
  painter.add(ArcItem{hit, 20 * unit, first, first + std::abs(turn), painter.stroke(painter.colours.normal, 1.4)});
  // Between the two where there is room; else beyond the ray, on the side away from the normal.
  constexpr double narrow = 0.7, aside = 0.6;  // radians
  const double towards = std::abs(turn) > narrow ? begin + turn / 2 : begin - (turn < 0 ? -aside : aside);
  const Vec2d middle(std::cos(towards), std::sin(towards));
  painter.note(hit + 52 * unit * middle, notes.angle);
}

}  // namespace raywalk::detail
