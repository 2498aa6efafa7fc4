// The numbers of the live equation beside the hit: t along the ray, its angle to the normal; for a refracted or
// reflected ray, the angles of both.

#include "view/plan/painter.h"
#include "view/walk/equation.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

/// Its unit direction in the plan; 0 if it is vertical.
Vec2d on_screen(const Vec3d& direction) {
  const Vec2d flat(direction.x, -direction.y);
  const double size = length(flat);
  return size > 1e-6 ? flat / size : Vec2d(0.0);
}

/// The arc from one direction to another, with its angle as text: between the two if there is room; else past the
/// first, away from the second.
void add_angle(Painter& painter, const Vec2d& at, const Vec2d& from, const Vec2d& to, const std::string& words) {
  const double unit = painter.sizes.unit, begin = std::atan2(from.y, from.x);
  const double turn = std::atan2(from.x * to.y - from.y * to.x, dot(from, to));
  const double first = turn < 0 ? begin + turn : begin;
  painter.add(ArcItem{at, 20 * unit, first, first + std::abs(turn), painter.stroke(painter.colours.normal, 1.4)});
  constexpr double narrow = 0.7, aside = 0.6;  // radians
  const double towards = std::abs(turn) > narrow ? begin + turn / 2 : begin - (turn < 0 ? -aside : aside);
  const Vec2d middle(std::cos(towards), std::sin(towards));
  painter.note_beside(at + 20 * unit * middle, middle, words);
}

void draw_bend(Painter& painter, const BendNotes& notes) {
  const Vec2d at = painter.pixels(plan(notes.at)), normal = on_screen(notes.normal), back = on_screen(notes.back),
              out = on_screen(notes.out);
  if (normal == Vec2d(0.0) || back == Vec2d(0.0) || out == Vec2d(0.0)) return;
  const double unit = painter.sizes.unit;
  // The normal on both sides of the surface: all angles are relative to it.
  Stroke thin = painter.stroke(painter.colours.normal, 1.2);
  thin.dash = painter.scaled({{4, 4}, 2});
  painter.add_clipped({at - 62 * unit * normal, at + 62 * unit * normal, thin});
  painter.prominent.push_back({at - 62 * unit * normal, at + 62 * unit * normal});
  add_angle(painter, at, back, normal, notes.angle_in);
  add_angle(painter, at, out, dot(out, normal) < 0 ? -normal : normal, notes.angle_out);
}

}  // namespace

void EquationRoom::draw_in_plan(Painter& painter) {
  const State& state = painter.state;
  if (state.walk.mode != Mode::trace || state.appearance.tab != EquationRoom::tab) return;
  if (const std::optional<BendNotes> bend = bend_notes(state)) return draw_bend(painter, *bend);
  const HitNotes notes = hit_notes(state);
  if (notes.t.empty()) return;
  const RayRecord& ray =
      state.walk.timeline->rays()[static_cast<std::size_t>(state.walk.timeline->current_ray(state.walk.position))];
  const Vec2d hit = painter.pixels(plan(ray.end)), from = painter.pixels(plan(ray.origin));
  const double size = length(hit - from);
  if (!(size > 0)) return;
  const Vec2d back = (from - hit) / size;
  const double facing = dot(ray.normal, ray.direction) > 0 ? -1 : 1;
  const Vec2d normal = on_screen(facing * ray.normal);
  if (!notes.angle.empty() && normal != Vec2d(0.0)) add_angle(painter, hit, back, normal, notes.angle);
  painter.note_along(from, hit, notes.t);
}

}  // namespace raywalk
