#pragma once

#include "math/bounds.h"
#include "math/ray.h"

#include <cmath>
#include <optional>

namespace raywalk {

/// Where a ray crosses a shape: at `t`, on the shape's part number `part` (faces of a prism; else 0).
///
/// The alignment makes its std::optional too large for two registers: a smaller one, as for float, is stored in pieces
/// and loaded as a whole, which stalls the processor at each test (a third of a float render).
template <class T>
struct alignas(16) Intersection {
  T t;
  int part = 0;
};

namespace detail {

/// The single intersection with a flat shape, computed in double; none where it is NaN.
template <class T>
[[nodiscard]] std::optional<Intersection<T>> intersection_ahead(double computed, T t_max) {
  const T t = static_cast<T>(computed);
  if (!(t > 0 && t < t_max)) return std::nullopt;
  return Intersection<T>{t};
}

}  // namespace detail

/// A point of a surface with its geometric normal: unit length, outward (of a plane: towards its front).
template <class T>
struct SurfacePoint {
  Vec3<T> position;
  Vec3<T> normal;
};

/// The coordinates of a place or a step on a level cap: x and y; on one that is seen from below -x, so that what is
/// drawn there is read from left to right, too.
template <class T>
[[nodiscard]] Vec2<T> on_cap(bool high, const Vec3<T>& of) {
  return {high ? of.x : -of.x, of.y};
}

/// Two orthonormal directions in a plane, the same for a normal and its opposite.
template <class T>
struct PlaneAxes {
  Vec3<T> u, v;
};

/// For a level plane u and v are x and y; for an upright one u is level and v is z. The sign of u flips where the
/// normal is perpendicular to a direction that few walls face, so that rounding of the normal does not decide it.
template <class T>
[[nodiscard]] PlaneAxes<T> plane_axes(const Vec3<T>& unit_normal) {
  const bool level = std::abs(unit_normal.z) >= T(0.5);
  const Vec3<T> guide = level ? Vec3<T>(1, 0, 0) : Vec3<T>(0, 0, 1);
  const Vec3<T> along = normalize(guide - dot(guide, unit_normal) * unit_normal);
  const T facing = level ? unit_normal.z : T(0.38) * unit_normal.x - T(0.92) * unit_normal.y;
  const bool front = facing > 0 || (facing == 0 && unit_normal.x > 0);
  const Vec3<T> side = cross(front ? unit_normal : -unit_normal, along);
  return level ? PlaneAxes<T>{along, side} : PlaneAxes<T>{-side, along};
}

/// The coordinates of an offset within a plane, along the plane's own two axes.
template <class T>
[[nodiscard, gnu::always_inline]] inline Vec2<T> in_plane(const Vec3<T>& offset, const Vec3<T>& unit_normal) {
  if (std::abs(unit_normal.z) == 1) return {offset.x, offset.y};  // what the rest computes for most floors
  const PlaneAxes<T> frame = plane_axes(unit_normal);
  return {dot(offset, frame.u), dot(offset, frame.v)};
}

/// No part: the ray does not depart from this shape.
inline constexpr int no_part = -1;

/// Default for the last argument of every `intersect`: the numbers are not wanted. An explainer that wants them has
/// `wanted = true` and the two members below; all numbers are passed as double.
struct NoExplanation {
  static constexpr bool wanted = false;
  void quadratic(double /*a*/, double /*b*/, double /*c*/, double /*discriminant*/, double /*t0*/, double /*t1*/) {}
  void plane(double /*numerator*/, double /*denominator*/) {}
};

/// Tells an explainer with a member `exact` that fast arithmetic could not decide and exact arithmetic has to.
template <class Explain>
void note_exact(Explain& explain) {
  if constexpr (requires { explain.exact(); }) explain.exact();
}

}  // namespace raywalk
