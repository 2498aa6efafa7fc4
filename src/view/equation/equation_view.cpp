// For a refracted or reflected ray, the angles of both to the normal; beside the equation also the numbers of any hit:
// t along the ray, and its angle.

#include "view/plan/painter.h"
#include "view/walk/equation.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace raywalk {

namespace {

/// Its unit direction in the plan; 0 if it is vertical.
Vec2d on_screen(const Vec3d& direction) {
  const Vec2d flat(direction.x, -direction.y);
  const double size = length(flat);
  return size > 1e-6 ? flat / size : Vec2d(0.0);
}

/// An arc from one direction to another at a point, and its angle as text.
struct Angle {
  Vec2d at, from, to;  ///< directions of unit length
  std::string words;
  double room = 0;                       ///< pixels, of the ray: the arc is well inside of it
  static constexpr double narrow = 0.7;  ///< radians: the arc is farther out, the text beside it

  [[nodiscard]] double begin() const { return std::atan2(from.y, from.x); }
  [[nodiscard]] double turn() const { return std::atan2(from.x * to.y - from.y * to.x, dot(from, to)); }
  [[nodiscard]] double radius(double unit) const {
    return std::min((std::abs(turn()) > narrow ? 20 : 30) * unit, 0.45 * room);
  }
};

void draw_arc(Painter& painter, const Angle& angle) {
  const double turn = angle.turn(), first = turn < 0 ? angle.begin() + turn : angle.begin();
  const double radius = angle.radius(painter.sizes.unit);
  painter.add(ArcItem{angle.at, radius, first, first + std::abs(turn), painter.stroke(painter.colours.normal, 1.4)});
  painter.prominent.push_back({angle.at + radius * angle.from, angle.at + radius * angle.to});
}

/// Outside of the arc's middle; of a narrow one beside its beginning, away from its end.
void say_angle(Painter& painter, const Angle& angle) {
  constexpr double aside = 0.9;  // radians
  const double turn = angle.turn(), radius = angle.radius(painter.sizes.unit);
  const bool fits = std::abs(turn) > Angle::narrow;
  const double out = angle.begin() + (fits ? turn / 2 : 0), towards = out - (fits ? 0 : std::copysign(aside, turn));
  painter.note_beside(angle.at + radius * Vec2d(std::cos(out), std::sin(out)), {std::cos(towards), std::sin(towards)},
                      angle.words);
}

/// The normal on both sides of the surface: all angles are relative to it.
void draw_normal(Painter& painter, const Vec2d& at, const Vec2d& normal) {
  const double reach = 62 * painter.sizes.unit;
  Stroke thin = painter.stroke(painter.colours.normal, 1.2);
  thin.dash = painter.scaled({{4, 4}, 2});
  painter.add_clipped({at - reach * normal, at + reach * normal, thin});
  painter.leaders.push_back({at - reach * normal, at + reach * normal});
}

void draw_bend(Painter& painter, const BendNotes& notes) {
  const Vec2d at = painter.pixels(plan(notes.at)), normal = on_screen(notes.normal), back = on_screen(notes.back),
              out = on_screen(notes.out);
  if (normal == Vec2d(0.0) || back == Vec2d(0.0)) return;
  draw_normal(painter, at, normal);
  std::vector<Angle> angles{{at, back, normal, notes.angle_in, painter.pixels(notes.in_length)}};
  const double facing = dot(notes.normal, notes.back) < 0 ? -1 : 1;  // a fixed normal may face away
  if (!notes.angle_out.empty() && out != Vec2d(0.0))
    angles.push_back(
        {at, out, facing * dot(out, normal) < 0 ? -normal : normal, notes.angle_out, painter.pixels(notes.out_length)});
  for (const Angle& angle : angles) draw_arc(painter, angle);
  for (const Angle& angle : angles) say_angle(painter, angle);
}

}  // namespace

void EquationRoom::draw_in_plan(Painter& painter) {
  const State& state = painter.state;
  if (state.walk.mode != Mode::trace) return;
  if (const std::optional<BendNotes> bend = bend_notes(state)) return draw_bend(painter, *bend);
  if (state.appearance.tab != EquationRoom::tab) return;
  const HitNotes notes = hit_notes(state);
  if (notes.t.empty()) return;
  const RayRecord& ray =
      state.walk.timeline->rays()[static_cast<std::size_t>(state.walk.timeline->current_ray(state.walk.position))];
  const Vec2d hit = painter.pixels(plan(ray.end)), from = painter.pixels(plan(ray.origin));
  const double size = length(hit - from);
  if (!(size > 0)) return;
  const Vec2d back = (from - hit) / size;
  const Vec2d normal = on_screen(ray.shaded.shading);
  if (!notes.angle.empty() && normal != Vec2d(0.0)) {
    draw_normal(painter, hit, normal);
    const Angle angle{hit, back, normal, notes.angle, size};
    draw_arc(painter, angle);
    say_angle(painter, angle);
  }
  painter.note_along(from, hit, notes.t);
}

}  // namespace raywalk
