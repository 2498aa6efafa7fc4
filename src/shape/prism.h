#pragma once

#include "math/exact.h"
#include "shape/intersection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raywalk {

/// A polygon of the plan, convex or concave, raised to a solid: its sides are vertical, its caps lie at z = -height/2
/// and z = +height/2. Parts: side i runs from corner i to the next one; after the sides come the top and the bottom.
template <class T>
struct Prism {
  std::vector<Vec2<T>> corners;  ///< at least 3, either orientation, edges that do not cross
  T height{1};                   ///< > 0
  friend bool operator==(const Prism&, const Prism&) = default;

  [[nodiscard]] int sides() const { return static_cast<int>(corners.size()); }
  [[nodiscard]] int top() const { return sides(); }
  [[nodiscard]] int bottom() const { return sides() + 1; }
  [[nodiscard]] const Vec2<T>& corner(int i) const { return corners[static_cast<std::size_t>(i)]; }
  [[nodiscard]] const Vec2<T>& corner_after(int i) const { return corner(i + 1 == sides() ? 0 : i + 1); }
  /// The vector along side i, from its first corner to its second.
  [[nodiscard]] Vec2<T> edge(int i) const { return corner_after(i) - corner(i); }

  /// Twice the area, positive when the corners turn counter-clockwise.
  [[nodiscard]] T twice_signed_area() const;
  [[nodiscard]] bool is_clockwise() const { return twice_signed_area() < 0; }
};

/// The nearest t in (0, t_max) at which the ray crosses the prism's surface.
///
/// The prism is an extrusion: along the ray it is the intersection of the polygon's intervals with the slab's. On which
/// side of the ray a corner lies is computed once and shared by both of its edges (half-open rule: an edge's end
/// belongs to one of the two). The number of edges crossed before the ray enters the slab tells whether it is inside
/// there, and so whether the next crossing leads out or in; one that leads the other way is a rounding artefact at a
/// corner and is skipped. Every decision is made in t alone, in double even for float rays, so no ray slips between two
/// faces; where error bounds leave a doubt, at corners and rims, exact arithmetic decides. The face that a ray departs
/// from is crossed at exactly t = 0 and tells whether the ray starts inside. A ray that starts inside always exits:
/// where rounding put its origin beyond a corner or a rim, at the smallest positive t.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Prism<T>& prism, const Ray<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {});

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Prism<T>& prism, const Ray<T>& ray, const Intersection<T>& intersection);

/// Sides: u runs along the edge, from its left end seen from outside, v up. Caps: x and y; the lower one -x, for it is
/// seen from below.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Prism<T>& prism, const SurfacePoint<T>& point, int part) {
  if (part >= prism.sides()) return on_cap(part == prism.top(), point.position);
  const Vec2<T>& left = prism.is_clockwise() ? prism.corner_after(part) : prism.corner(part);
  return {length(plan(point.position) - left), point.position.z};
}

template <class T>
[[nodiscard]] Vec3<T> normal_derivative(const Prism<T>& /*prism*/, const SurfacePoint<T>& /*point*/, int /*part*/,
                                        const Vec3<T>& /*along*/) {
  return Vec3<T>(0);
}

template <class T>
[[nodiscard]] Vec2<T> uv_derivative(const Prism<T>& prism, const SurfacePoint<T>& /*point*/, int part,
                                    const Vec3<T>& along) {
  if (part >= prism.sides()) return on_cap(part == prism.top(), along);
  const T forward = dot(plan(along), prism.edge(part)) / length(prism.edge(part));
  return {prism.is_clockwise() ? -forward : forward, along.z};
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Prism<T>& prism) {
  Bounds<T> box;
  for (const Vec2<T>& corner : prism.corners) {
    box.include(Vec3<T>(corner, -prism.height / 2));
    box.include(Vec3<T>(corner, prism.height / 2));
  }
  return box;
}

/// Why these corners do not make a polygon, in words; empty when they do: at least three, finite, no two neighbours
/// equal, no edge that crosses or touches another. Takes time quadratic in the number of corners.
[[nodiscard]] std::string why_not_polygon(const std::vector<Vec2d>& corners);

// ---------------------------------------------------------------------------------------------------------------------

template <class T>
T Prism<T>::twice_signed_area() const {
  T area{0};
  for (int i = 1; i + 1 < sides(); ++i) area += cross(corner(i) - corner(0), corner(i + 1) - corner(0));
  return area;
}

namespace detail {

/// The interval of a ray between the planes of a prism's caps, and the caps that bound it.
struct Slab {
  double in = -infinity<double>, out = infinity<double>;
  int in_part, out_part;
};

template <class T>
Slab slab_along(const Prism<T>& prism, const Ray<T>& ray, int departed_part) {
  const double half = static_cast<double>(prism.height) / 2;
  const double z = static_cast<double>(ray.origin.z), slope = static_cast<double>(ray.direction.z);
  Slab slab{-infinity<double>, infinity<double>, prism.bottom(), prism.top()};
  if (slope != 0) {
    slab.in = departed_part == prism.bottom() ? 0 : (-half - z) / slope;
    slab.out = departed_part == prism.top() ? 0 : (half - z) / slope;
  } else if (!(-half <= z && z <= half)) {
    slab.out = -infinity<double>;
  }
  if (slope < 0) {
    std::swap(slab.in, slab.out);
    std::swap(slab.in_part, slab.out_part);
  }
  return slab;
}

/// A face crossed at t = numerator / denominator; infinite when there is none.
struct FaceCrossing {
  double t = infinity<double>;
  int part = no_part;
  double numerator = 0, denominator = 0;
};

/// How a line of the plan crosses a polygon: whether it is inside at `start`, the first edges after it that lead into
/// the polygon and out of it, and the last one before it that leads out.
struct SideCrossings {
  bool inside = false;
  FaceCrossing in, out, out_before{-infinity<double>, no_part, 0, 0};
  double in_error = 0, out_error = 0;  ///< bounds on the errors of in.t and out.t
  bool sure = true;  ///< no rounding error can have changed on which side of the line a corner lies, or on which
                     ///< side of `start` an edge is crossed
};

template <class T>
SideCrossings cross_sides(const Prism<T>& prism, const Vec2d& o, const Vec2d& d, double start, int departed_part) {
  SideCrossings crossings;
  // The nearest edges that lead to the line's right (0) and to its left (1).
  FaceCrossing after[2], before[2] = {crossings.out_before, crossings.out_before};
  double after_error[2] = {0, 0};
  const double steps = 1 / dot(d, d);  // t of a point is its position along d, times this
  Vec2d corner = Vec2d(prism.corner(0)) - o;
  const auto size_of_cross = [](const Vec2d& a, const Vec2d& b) { return std::abs(a.x * b.y) + std::abs(a.y * b.x); };
  const auto side_of = [&](const Vec2d& to) {
    const double side = cross(d, to);
    crossings.sure = crossings.sure && !(std::abs(side) < 4 * half_ulp * size_of_cross(d, to));
    return side;
  };
  double side = side_of(corner);
  for (int i = 0; i < prism.sides(); ++i) {
    const Vec2d next = Vec2d(prism.corner_after(i)) - o;
    const double next_side = side_of(next);
    if ((side >= 0) != (next_side >= 0)) {
      // The rate at which the line approaches the edge's is computed from the edge itself: the difference of its ends'
      // sides loses digits when the edge is short and far. Its sign, though, is that of the difference. However
      // inaccurate the quotient, where the two are nearly parallel, the crossing lies between the ends.
      const Vec2d edge = Vec2d(prism.corner_after(i)) - Vec2d(prism.corner(i));
      const double rate = cross(d, edge), difference = next_side - side;
      const bool agree = rate != 0 && (rate > 0) == (difference > 0);
      const double above = cross(corner, edge), below = agree ? rate : difference;
      const auto [from, to] = std::minmax({dot(d, corner) * steps, dot(d, next) * steps});
      const double t = departed_part == i ? 0 : std::clamp(above / below, from, to);
      const double above_error = 4 * half_ulp * size_of_cross(corner, edge);
      const double below_error = 4 * half_ulp * size_of_cross(d, edge), least_below = std::abs(below) - below_error;
      const double error =
          agree && least_below > 0 ? (above_error + std::abs(t) * below_error) / least_below : infinity<double>;
      crossings.sure = crossings.sure && std::abs(t - start) > error + 4 * half_ulp * start;
      if (t <= start) {
        crossings.inside = !crossings.inside;
        if (i != departed_part && t > before[below > 0].t) before[below > 0] = {t, i, above, below};
      } else if (t < after[below > 0].t) {
        after[below > 0] = {t, i, above, below};
        after_error[below > 0] = error;
      }
    }
    corner = next;
    side = next_side;
  }
  // Around a counter-clockwise polygon the edges lead to the left where the line exits.
  const bool none =
      after[0].part == no_part && after[1].part == no_part && before[0].part == no_part && before[1].part == no_part;
  const int out = none || prism.twice_signed_area() > 0 ? 1 : 0;
  crossings.in = after[1 - out];
  crossings.in_error = after_error[1 - out];
  crossings.out = after[out];
  crossings.out_error = after_error[out];
  crossings.out_before = before[out];
  return crossings;
}

/// The side other than `departed_part` that a point at the end of one, or on a rim, is nearest to.
template <class T>
int neighbouring_side(const Prism<T>& prism, const Vec2<T>& p, int departed_part) {
  int nearest = 0;
  for (int i = 1; i < prism.sides(); ++i)
    if (length(prism.corner(i) - p) < length(prism.corner(nearest) - p)) nearest = i;
  return nearest != departed_part ? nearest : nearest == 0 ? prism.sides() - 1 : nearest - 1;
}

/// Whether a ray that departs from a part of the prism starts inwards.
template <class T>
bool departs_inwards(const Prism<T>& prism, const Vec3<T>& direction, int part) {
  if (part == prism.top()) return direction.z < 0;
  if (part == prism.bottom()) return direction.z > 0;
  const Vec2d edge = Vec2d(prism.corner_after(part)) - Vec2d(prism.corner(part));
  return (cross(Vec2d(plan(direction)), edge) < 0) == (prism.twice_signed_area() > 0);
}

/// t = numerator / denominator, exactly; the denominator is above 0.
struct ExactTime {
  Expansion numerator, denominator = 1.0;
  ExactTime() = default;
  ExactTime(const Expansion& above, const Expansion& below)
      : numerator(below.sign() < 0 ? -above : above), denominator(below.sign() < 0 ? -below : below) {}
  [[nodiscard]] int compared_to(const ExactTime& other) const {
    return (numerator * other.denominator - other.numerator * denominator).sign();
  }
};

/// The result of `intersect` for a ray that does not depart from the prism, by exact signs alone.
template <class T>
[[gnu::noinline, gnu::cold]] std::optional<Intersection<T>> intersect_exactly(const Prism<T>& prism, const Ray<T>& ray,
                                                                              T t_max) {
  const Vec3d o(ray.origin), d(ray.direction);
  const double half = static_cast<double>(prism.height) / 2;
  const bool level = d.z == 0, upright = d.x == 0 && d.y == 0, rising = d.z > 0;
  if (level && !(-half <= o.z && o.z <= half)) return std::nullopt;
  ExactTime in, out;
  if (!level) {
    in = ExactTime(Expansion(rising ? -half : half) - o.z, d.z);
    out = ExactTime(Expansion(rising ? half : -half) - o.z, d.z);
    if (out.numerator.sign() <= 0) return std::nullopt;
  }
  const bool enters = !level && in.numerator.sign() > 0;
  const ExactTime start = enters && !upright ? in : ExactTime();
  const Vec2d along = upright ? Vec2d(1, 0) : Vec2d(d.x, d.y);
  bool inside = false;
  // The nearest sides that lead to the line's right (0) and to its left (1): at a corner that is touched, the one that
  // leads in comes first.
  std::optional<ExactTime> nearest[2];
  int nearest_part[2] = {no_part, no_part};
  for (int i = 0; i < prism.sides(); ++i) {
    const Vec2d p(prism.corner(i)), q(prism.corner_after(i));
    const Expansion px = Expansion(p.x) - o.x, py = Expansion(p.y) - o.y, qx = Expansion(q.x) - o.x,
                    qy = Expansion(q.y) - o.y;
    if (((py * along.x - px * along.y).sign() >= 0) == ((qy * along.x - qx * along.y).sign() >= 0)) continue;
    const Expansion ex = qx - px, ey = qy - py;
    const Expansion below = ey * along.x - ex * along.y;
    const ExactTime t(px * ey - py * ex, below);
    const int turn = below.sign() > 0;
    if (t.compared_to(start) <= 0)
      inside = !inside;
    else if (!nearest[turn] || t.compared_to(*nearest[turn]) < 0)
      nearest[turn] = t, nearest_part[turn] = i;
  }
  const int leads_out = prism.twice_signed_area() > 0 ? 1 : 0, turn = inside ? leads_out : 1 - leads_out;
  const std::optional<ExactTime>& first = nearest[turn];
  const int first_part = nearest_part[turn];
  const auto intersection = [&](const ExactTime& t, int part) -> std::optional<Intersection<T>> {
    const double wide = static_cast<double>(t.numerator.rounded() / t.denominator.rounded());
    const T rounded = std::max(static_cast<T>(wide), std::numeric_limits<T>::min());
    if (!(rounded < t_max)) return std::nullopt;
    return Intersection<T>{rounded, part};
  };
  if (inside && enters) return intersection(in, rising ? prism.bottom() : prism.top());
  const int out_part = rising ? prism.top() : prism.bottom();
  if (upright) return inside ? intersection(out, out_part) : std::nullopt;
  const bool side_first = first && (level || first->compared_to(out) < 0);
  if (side_first) return intersection(*first, first_part);
  return inside && !level ? intersection(out, out_part) : std::nullopt;
}

}  // namespace detail

template <class T, class Explain>
std::optional<Intersection<T>> intersect(const Prism<T>& prism, const Ray<T>& ray, T t_max, int departed_part,
                                         Explain&& explain) {
  constexpr T at_once = std::numeric_limits<T>::min();
  const bool departs = departed_part != no_part;
  const bool departs_in = departs && detail::departs_inwards(prism, ray.direction, departed_part);
  auto slab = detail::slab_along(prism, ray, departed_part);
  if (departs_in && slab.out <= 0) slab.out = static_cast<double>(at_once);
  if (!(slab.in <= slab.out && slab.out > 0)) return std::nullopt;

  // A vertical ray is a point in the plan: any line through that point tells whether it is inside.
  const bool upright = ray.direction.x == 0 && ray.direction.y == 0;
  const double start = upright ? 0 : std::max(slab.in, 0.0);
  const auto sides = detail::cross_sides(prism, Vec2d(plan(ray.origin)),
                                         upright ? Vec2d(1, 0) : Vec2d(plan(ray.direction)), start, departed_part);
  const bool inside = departs ? departs_in : sides.inside;
  // Which comes first where the ray exits, or might enter: a side or the far cap?
  const auto told_from_cap = [&](const detail::FaceCrossing& side, double error) {
    return slab.out == infinity<double> || std::abs(side.t - slab.out) > error + 4 * detail::half_ulp * slab.out;
  };
  const bool sure = sides.sure && (upright || (!inside ? told_from_cap(sides.in, sides.in_error)
                                                       : slab.in > 0 || told_from_cap(sides.out, sides.out_error)));
  if (!departs && !sure) {
    note_exact(explain);
    const auto exact = detail::intersect_exactly(prism, ray, t_max);
    if constexpr (std::decay_t<Explain>::wanted) explain.plane(exact ? static_cast<double>(exact->t) : NAN, 1);
    return exact;
  }

  detail::FaceCrossing next;
  const auto meet_cap = [&](double t, int part) {
    const double slope = static_cast<double>(ray.direction.z);
    next = {t, part, t * slope, slope};
  };
  if (inside && slab.in > 0) {
    meet_cap(slab.in, slab.in_part);
  } else if (inside && upright) {
    meet_cap(slab.out, slab.out_part);
  } else if (inside) {
    next = sides.out.part != no_part || departs ? sides.out : sides.in;
    // A departing ray that is outside has either exited already, at a corner, or is about to enter there: the nearer of
    // the two crossings is the one at the corner.
    const bool left_already = departs && !sides.inside && -sides.out_before.t < sides.in.t;
    if (left_already || next.part == no_part) {
      const int part =
          left_already ? sides.out_before.part : detail::neighbouring_side(prism, plan(ray.origin), departed_part);
      next = {static_cast<double>(at_once), part, static_cast<double>(at_once), 1};
    }
    if (slab.out < next.t) meet_cap(slab.out, slab.out_part);
  } else if (!upright && sides.in.t < slab.out) {
    next = sides.in;
  }
  if constexpr (std::decay_t<Explain>::wanted) explain.plane(next.numerator, next.denominator);
  const T t = std::max(static_cast<T>(next.t), at_once);
  if (!(t < t_max)) return std::nullopt;
  return Intersection<T>{t, next.part};
}

template <class T>
SurfacePoint<T> surface_at(const Prism<T>& prism, const Ray<T>& ray, const Intersection<T>& intersection) {
  const T half = prism.height / 2;
  const Vec3<T> reached = ray.at(intersection.t);
  if (intersection.part >= prism.sides()) {
    const T up = intersection.part == prism.top() ? T(1) : T(-1);
    return {{plan(reached), up * half}, {0, 0, up}};
  }
  // The computed point is projected back onto the face, even where rounding took it past an edge.
  const Vec2<T> first = prism.corner(intersection.part), edge = prism.edge(intersection.part);
  const T size = length(edge);
  const Vec2<T> along = edge / size;
  const T turn = prism.is_clockwise() ? T(-1) : T(1);
  const Vec2<T> offset = (plan(ray.origin) - first) + intersection.t * plan(ray.direction);
  const Vec2<T> onto = first + std::clamp(dot(offset, along), T(0), size) * along;
  return {{onto, std::clamp(reached.z, -half, half)}, {turn * along.y, turn * -along.x, 0}};
}

template <class T>
[[nodiscard]] constexpr bool has_inside(const Prism<T>& /*shape*/) {
  return true;
}

template <class Cutter>
void cut(Cutter& to, const Prism<double>& prism) {
  const bool clockwise = prism.is_clockwise();
  const double low = -prism.height / 2, high = prism.height / 2;
  std::vector<Vec3d> top, bottom;
  for (int i = 0; i < prism.sides(); ++i) {
    Vec2d a = prism.corner(i), b = prism.corner_after(i);
    if (clockwise) std::swap(a, b);
    to.quad(i, {a.x, a.y, low}, {b.x, b.y, low}, {b.x, b.y, high}, {a.x, a.y, high});
    top.push_back({prism.corner(i), high});
    bottom.push_back({prism.corner(i), low});
  }
  to.polygon(prism.top(), {top}, {1, 0, 0}, {0, 1, 0});
  to.polygon(prism.bottom(), {bottom}, {0, 1, 0}, {1, 0, 0});
}

}  // namespace raywalk
