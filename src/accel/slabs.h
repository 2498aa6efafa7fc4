#pragma once
// When a box can be skipped: where a ray is inside of it, one box at a time in the ray's precision; accel/lane_tests.h
// and accel/box_lanes.h test several in float.

#include "accel/primitives.h"
#include "math/bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raywalk {

/// The terms of a ray that all slab tests share, computed once per ray.
template <class T>
struct SlabRay {
  /// With `mapped`, boxes are treated as a few ulps of the origin larger: where a primitive transforms the ray into
  /// object space, the origin is rounded.
  explicit SlabRay(const Ray<T>& ray, bool mapped = false)
      : from_in(ray.origin), from_out(ray.origin), inverse(T(1) / ray.direction) {
    for (int axis = 0; axis < 3; ++axis) {
      negative[axis] = std::signbit(ray.direction[axis]);
      if (std::isinf(inverse[axis]) && ray.direction[axis] != 0) inverse[axis] = std::numeric_limits<T>::quiet_NaN();
    }
    if (!mapped) return;
    const T size = std::abs(ray.origin.x) + std::abs(ray.origin.y) + std::abs(ray.origin.z);
    move_out(Vec3<T>(16 * std::numeric_limits<T>::epsilon() * size));
  }
  /// Treats boxes as larger by `slack` along each axis.
  void move_out(const Vec3<T>& slack) {
    for (int axis = 0; axis < 3; ++axis) {
      const T away = negative[axis] ? -slack[axis] : slack[axis];
      from_in[axis] += away;
      from_out[axis] -= away;
    }
  }
  Vec3<T> from_in, from_out;  ///< the origin relative to the faces through which the ray enters and leaves
  /// 1 / +-0 is +-infinity: the ray is inside the slab for all t or for none. NaN, which no slab limits, where a slope
  /// is so small that its inverse overflows.
  Vec3<T> inverse;
  bool negative[3];
};

/// How far the ray may be off along an axis, and more.
template <class T>
[[nodiscard]] T slack_along(const SlabRay<T>& ray, int axis) {
  return std::abs(ray.from_in[axis] - ray.from_out[axis]);
}

/// An interval of t along a ray; empty when !(in <= out).
template <class T>
struct RayInterval {
  T in, out;
  [[nodiscard]] bool empty() const { return !(in <= out); }
};

/// The part of `within` inside the box, rounded outward: never empty when the ray hits the box.
///
/// T. Ize, "Robust BVH Ray Traversal", JCGT 2(2), 2013: slabs are chosen by the sign of the direction, the far side is
/// padded by two ulps, and the comparisons let the NaN of 0 * infinity (an origin in a face's plane, no slope) pass.
template <class T>
[[nodiscard]] RayInterval<T> clip(const SlabRay<T>& ray, const Bounds<T>& box, RayInterval<T> within) {
  constexpr T pad = 1 + 4 * std::numeric_limits<T>::epsilon();
  for (int axis = 0; axis < 3; ++axis) {
    const bool negative = ray.negative[axis];
    const T in = ((negative ? box.max : box.min)[axis] - ray.from_in[axis]) * ray.inverse[axis];
    const T out = ((negative ? box.min : box.max)[axis] - ray.from_out[axis]) * ray.inverse[axis] * pad;
    if (in > within.in) within.in = in;
    if (out < within.out) within.out = out;
  }
  return within;
}

/// The terms of a ray for slab tests.
template <class T>
[[nodiscard]] SlabRay<T> slabs_of(const Ray<T>& ray, const Primitives<T>& primitives) {
  return SlabRay<T>(ray, primitives.maps_rays());
}

/// Slabs as textbooks give them: what 0 * infinity and rounding do to them is part of the lesson.
template <class T>
struct NaiveSlabRay {
  Vec3<T> origin, inverse;
  bool negative[3];
};
template <class T>
[[nodiscard]] NaiveSlabRay<T> slabs_of(const NaiveRay<T>& ray, const Primitives<T>& /*primitives*/) {
  return {ray.origin, T(1) / ray.direction, {ray.direction.x < 0, ray.direction.y < 0, ray.direction.z < 0}};
}
template <class T>
[[nodiscard]] T slack_along(const NaiveSlabRay<T>& /*ray*/, int /*axis*/) {
  return 0;
}
template <class T>
[[nodiscard]] RayInterval<T> clip(const NaiveSlabRay<T>& ray, const Bounds<T>& box, RayInterval<T> within) {
  for (int axis = 0; axis < 3; ++axis) {
    const T t0 = (box.min[axis] - ray.origin[axis]) * ray.inverse[axis];
    const T t1 = (box.max[axis] - ray.origin[axis]) * ray.inverse[axis];
    within.in = std::max(within.in, std::min(t0, t1));
    within.out = std::min(within.out, std::max(t0, t1));
  }
  return within;
}

}  // namespace raywalk
