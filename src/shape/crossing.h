#pragma once

#include "math/bounds.h"
#include "math/ray.h"

#include <optional>

namespace raywalk {

/// Where a ray crosses a shape: at `t`, on the shape's part number `part` (faces of a prism; else 0).
template <class T>
struct Crossing {
  T t;
  int part = 0;
};

/// A point of a surface. The normal has unit length and points outwards (a plane's: to its own front).
template <class T>
struct SurfacePoint {
  Vec3<T> position;
  Vec3<T> normal;
};

/// No part of a shape: the ray does not depart from it.
inline constexpr int no_part = -1;

/// Default for the last argument of every `intersect`: nobody asks for the numbers. An explainer that does has
/// `wanted = true` and the two members below; all numbers are handed over as double.
struct NoExplanation {
  static constexpr bool wanted = false;
  void quadratic(double /*a*/, double /*b*/, double /*c*/, double /*discriminant*/, double /*t0*/, double /*t1*/) {}
  void plane(double /*numerator*/, double /*denominator*/) {}
};

}  // namespace raywalk
