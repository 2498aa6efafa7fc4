#pragma once

#include "math/bounds.h"
#include "math/ray.h"

#include <cmath>
#include <optional>

namespace raywalk {

/// Where a ray crosses a shape: at `t`, on the shape's part number `part` (faces of a prism; else 0).
///
/// The alignment makes an optional of it too large for two registers: a smaller one, as float's would be, is stored in
/// pieces and loaded whole, which stalls the processor at each test (a third of a float render).
template <class T>
struct alignas(16) Crossing {
  T t;
  int part = 0;
};

namespace detail {

/// The only crossing with what is flat, worked out in double; none where it is NaN.
template <class T>
[[nodiscard]] std::optional<Crossing<T>> crossing_ahead(double computed, T t_max) {
  const T t = static_cast<T>(computed);
  if (!(t > 0 && t < t_max)) return std::nullopt;
  return Crossing<T>{t};
}

}  // namespace detail

/// A point of a surface. The normal has unit length and points outwards (a plane's: to its own front).
template <class T>
struct SurfacePoint {
  Vec3<T> position;
  Vec3<T> normal;
};

/// Two unit directions at right angles in a plane, the same for a normal and its opposite.
template <class T>
struct Frame {
  Vec3<T> u, v;
};

/// For a level plane u and v are x and y; for an upright one u is level and v is z, and which way u runs changes where
/// the normal is at right angles to a direction that few walls face: rounding of the normal must not decide it.
template <class T>
[[nodiscard]] Frame<T> frame_of(const Vec3<T>& unit_normal) {
  const bool level = std::abs(unit_normal.z) >= T(0.5);
  const Vec3<T> guide = level ? Vec3<T>(1, 0, 0) : Vec3<T>(0, 0, 1);
  const Vec3<T> along = normalize(guide - dot(guide, unit_normal) * unit_normal);
  const T facing = level ? unit_normal.z : T(0.38) * unit_normal.x - T(0.92) * unit_normal.y;
  const bool front = facing > 0 || (facing == 0 && unit_normal.x > 0);
  const Vec3<T> side = cross(front ? unit_normal : -unit_normal, along);
  return level ? Frame<T>{along, side} : Frame<T>{-side, along};
}

/// A place of a plane as seen from another, `offset` away, along the plane's own two directions.
template <class T>
[[nodiscard]] Vec2<T> in_plane(const Vec3<T>& offset, const Vec3<T>& unit_normal) {
  if (std::abs(unit_normal.z) == 1) return {offset.x, offset.y};  // what follows comes to, for most floors
  const Frame<T> frame = frame_of(unit_normal);
  return {dot(offset, frame.u), dot(offset, frame.v)};
}

/// No part of a shape: the ray does not depart from it.
inline constexpr int no_part = -1;

/// Default for the last argument of every `intersect`: nobody asks for the numbers. An explainer that does has
/// `wanted = true` and the two members below; all numbers are handed over as double.
struct NoExplanation {
  static constexpr bool wanted = false;
  void quadratic(double /*a*/, double /*b*/, double /*c*/, double /*discriminant*/, double /*t0*/, double /*t1*/) {}
  void plane(double /*numerator*/, double /*denominator*/) {}
};

/// Tells an explainer that has a member `exact` that the fast arithmetic could not decide and the exact one has to.
template <class Explain>
void note_exact(Explain& explain) {
  if constexpr (requires { explain.exact(); }) explain.exact();
}

}  // namespace raywalk
