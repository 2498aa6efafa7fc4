#pragma once

#include "math/ray.h"

namespace raywalk {

/// Axis-aligned box, min <= max in each component; empty when min > max. Unbounded sides are infinite.
template <class T>
struct Bounds {
  Vec3<T> min{infinity<T>};
  Vec3<T> max{-infinity<T>};

  [[nodiscard]] bool empty() const { return !(min.x <= max.x && min.y <= max.y && min.z <= max.z); }
  [[nodiscard]] bool bounded() const { return is_finite(min) && is_finite(max); }

  void include(const Vec3<T>& p) {
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] < min[axis]) min[axis] = p[axis];
      if (p[axis] > max[axis]) max[axis] = p[axis];
    }
  }
  /// An empty box adds nothing.
  void include(const Bounds& other) {
    if (other.empty()) return;
    include(other.min);
    include(other.max);
  }
};

/// The size of the largest coordinate along each axis.
template <class T>
[[nodiscard]] Vec3<T> largest_coordinates(const Bounds<T>& box) {
  const Vec3<T> a = absolute(box.min), b = absolute(box.max);
  return {std::fmax(a.x, b.x), std::fmax(a.y, b.y), std::fmax(a.z, b.z)};
}

/// Half the surface, to which the chance of a ray that crosses it is proportional.
template <class T>
[[nodiscard]] T half_area(const Bounds<T>& box) {
  if (box.empty()) return 0;
  const Vec3<T> size = box.max - box.min;
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

}  // namespace raywalk
