#pragma once
// Whether normals point where they should, and have length 1 (goal B).

#include "check/judge.h"

namespace raywalk::check {

/// The true direction of a shape's normal, of any length, at a stored point of its part `part`.
template <class N>
struct TrueNormal {
  Vec<N> direction;
  double slenderness = 1;  ///< how much more it turns than the corners that define it
  double bend = 0;         ///< how far it turns, in radians, per unit of length
};

template <class N, class T>
[[nodiscard]] TrueNormal<N> true_normal(const Sphere<T>& s, const Vec3<T>& place, int /*part*/) {
  return {exactly<N>(place) - exactly<N>(s.centre), 1, 1 / static_cast<double>(s.radius)};
}
template <class N, class T>
[[nodiscard]] TrueNormal<N> true_normal(const Plane<T>& s, const Vec3<T>& /*place*/, int /*part*/) {
  return {exactly<N>(s.normal)};
}
template <class N, class T>
[[nodiscard]] TrueNormal<N> true_normal(const Disk<T>& s, const Vec3<T>& /*place*/, int /*part*/) {
  return {exactly<N>(s.normal)};
}
template <class N, class T>
[[nodiscard]] TrueNormal<N> true_normal(const Box<T>& /*s*/, const Vec3<T>& /*place*/, int part) {
  const auto along = [&](int axis) { return N(part / 2 != axis ? 0.0 : part % 2 != 0 ? 1.0 : -1.0); };
  return {{along(0), along(1), along(2)}};
}
template <class N, class T>
[[nodiscard]] TrueNormal<N> true_normal(const Triangle<T>& s, const Vec3<T>& /*place*/, int /*part*/) {
  const Vec<N> a = exactly<N>(s.a);
  return {cross(exactly<N>(s.b) - a, exactly<N>(s.c) - a), slenderness(s)};
}
/// Newell's sum over the corners.
template <class N, class T>
[[nodiscard]] TrueNormal<N> true_normal(const Polygon<T>& s, const Vec3<T>& /*place*/, int /*part*/) {
  const Vec<N> first = exactly<N>(s.outline.front());
  Vec<N> sum{N(0.0), N(0.0), N(0.0)};
  double terms = 0;
  for (std::size_t i = 1; i + 1 < s.outline.size(); ++i) {
    const Vec<N> one = cross(exactly<N>(s.outline[i]) - first, exactly<N>(s.outline[i + 1]) - first);
    sum = sum + one;
    terms += length(Vec3d(s.outline[i]) - Vec3d(s.outline.front())) *
             length(Vec3d(s.outline[i + 1]) - Vec3d(s.outline.front()));
  }
  const Vec3d area(approximate(sum.x), approximate(sum.y), approximate(sum.z));
  return {sum, std::max(1.0, terms / length(area))};
}
template <class N, class T>
[[nodiscard]] TrueNormal<N> true_normal(const Prism<T>& s, const Vec3<T>& /*place*/, int part) {
  const N none(0.0), one(1.0);
  if (part == s.top()) return {{none, none, one}};
  if (part == s.bottom()) return {{none, none, N(-1.0)}};
  const Vec2<T> p = s.corner(part), q = s.corner_after(part);
  const N turn(s.twice_signed_area() < 0 ? -1.0 : 1.0);
  return {{N(turn * (exactly<N>(q.y) - exactly<N>(p.y))), N(turn * (exactly<N>(p.x) - exactly<N>(q.x))), none}};
}
template <class N, class T, QuadricKind Kind>
[[nodiscard]] TrueNormal<N> true_normal(const Quadric<T, Kind>& s, const Vec3<T>& place, int part) {
  const N none(0.0);
  if (part == s.low_cap) return {{none, none, N(-1.0)}};
  if (part == s.high_cap) return {{none, none, N(1.0)}};
  const QuadricForm<N> f = form_of<N>(s);
  const Vec<N> p = exactly<N>(place);
  return {{N(f.xx * p.x), N(f.yy * p.y), N(f.zz * p.z + f.linear * N(0.5))}};
}

/// The error of a unit normal, in direction or length, in ulps of 1; half a turn if it points the wrong way.
template <class T>
[[nodiscard]] double error_of_normal(const Vec3<T>& normal, const Vec<Ball>& truth) {
  const Vec<Ball> n = exactly<Ball>(normal), off = cross(n, truth);
  const auto size = [](const Vec<Ball>& v) {
    return length(Vec3d(approximate(v.x), approximate(v.y), approximate(v.z)));
  };
  const double turn = approximate(dot(n, truth)) > 0 ? size(off) / (size(n) * size(truth)) : std::acos(-1.0);
  const double length_off = std::abs(approximate(dot(n, n) - Ball(1.0)) / 2);
  return std::max(turn, length_off) / static_cast<double>(std::numeric_limits<T>::epsilon());
}

template <class S, class T>
[[nodiscard]] Tally try_normals(std::uint64_t seed, std::uint64_t first, std::uint64_t count) {
  using B = ShapeTraits<S>;
  Tally tally;
  for (std::uint64_t number = first; number < first + count; ++number) {
    Random random(seed, 62, number);
    const auto tried = aim<S, T>(static_cast<Stratum>(random.whole(0, stratum_count - 1)), random);
    if (!tried) continue;
    const auto hit = intersect(tried->shape, tried->ray, infinity<T>);
    if (!hit) continue;
    const SurfacePoint<T> point = surface_at(tried->shape, tried->ray, *hit);
    if (!is_finite(point.position)) continue;  // out of range of the type
    const TrueNormal<Ball> truth = true_normal<Ball>(tried->shape, point.position, hit->part);
    const Vec<Ball>& g = truth.direction;
    const double size = length(Vec3d(approximate(g.x), approximate(g.y), approximate(g.z)));
    if (!(size > 0x1p-400)) continue;  // an apex has none
    ++tally.rays;
    ++tally.hits;
    // The point is known to an ulp of each number that it is computed from.
    double moves = 0;
    for (int axis = 0; axis < 3; ++axis)
      moves += std::abs(static_cast<double>(tried->ray.origin[axis])) +
               std::abs(static_cast<double>(hit->t) * static_cast<double>(tried->ray.direction[axis])) +
               std::abs(static_cast<double>(point.position[axis])) + std::abs(B::centre(tried->shape)[axis]);
    const double ulps = error_of_normal(point.normal, g), condition = truth.slenderness + truth.bend * moves;
    tally.fast_ulps = std::max(tally.fast_ulps, ulps);
    tally.fast_ulps_by_condition = std::max(tally.fast_ulps_by_condition, ulps / condition);
  }
  return tally;
}

}  // namespace raywalk::check
