#pragma once
// Slab tests in float for rays of either precision: boxes are widened by the rounding error and the ray's origin is
// moved outward by its own, so that no hit is lost and a few misses pass.

#include "math/bounds.h"
#include "math/lanes.h"
#include "math/ray.h"

#include <cmath>
#include <limits>

namespace raywalk {

/// A float at least 7 float ulps above x; not below x where x is 0 or subnormal in float.
[[nodiscard]] inline float rounded_up(double x) {
  constexpr float most = std::numeric_limits<float>::max(), normal = std::numeric_limits<float>::min();
  if (x > static_cast<double>(most)) return infinity<float>;
  if (x < -static_cast<double>(most)) return -most;
  const float near = static_cast<float>(x);
  if (std::abs(near) >= normal) return near + 8 * std::numeric_limits<float>::epsilon() * std::abs(near);
  return static_cast<double>(near) < x ? std::nextafter(near, infinity<float>) : near;
}

/// A box in float that holds `box`, each plane moved outward by a millionth of its coordinate, see FloatSlabs.
template <class T>
[[nodiscard]] Bounds<float> rounded_out(const Bounds<T>& box) {
  Bounds<float> out;
  for (int axis = 0; axis < 3; ++axis) {
    out.min[axis] = -rounded_up(-static_cast<double>(box.min[axis]));
    out.max[axis] = rounded_up(static_cast<double>(box.max[axis]));
  }
  return out;
}

/// The terms of a ray for slab tests, x, y and z in lanes; the last lane means nothing.
template <class T>
struct FloatSlabs {
  explicit FloatSlabs(const Ray<T>& ray);

  bool held;                ///< whether the ray is within float's range; otherwise this must not be used
  unsigned negative;        ///< a bit for each axis along which the ray's direction, perhaps -0, is negative
  Lanes from_in, from_out;  ///< the origin relative to the planes through which the ray enters and leaves
  Lanes inverse;            ///< 1 / direction

 private:
  static constexpr float most = 1e18F;  ///< the largest origin and slope, and the inverse of the smallest slope

  static bool holds(const Ray<T>& ray) {
    for (int axis = 0; axis < 3; ++axis) {
      const T slope = std::abs(ray.direction[axis]);
      if (!(std::abs(ray.origin[axis]) < most && (slope == 0 || (slope > 1 / most && slope < most)))) return false;
    }
    return true;
  }
};

template <class T>
inline FloatSlabs<T>::FloatSlabs(const Ray<T>& ray) {
  constexpr float epsilon = std::numeric_limits<float>::epsilon(), least = std::numeric_limits<float>::min();
  const Lanes origin{static_cast<float>(ray.origin.x), static_cast<float>(ray.origin.y),
                     static_cast<float>(ray.origin.z), 0};
  const Lanes slope{static_cast<float>(ray.direction.x), static_cast<float>(ray.direction.y),
                    static_cast<float>(ray.direction.z), 1};
  const Lanes size = absolute(origin);
  inverse = all_lanes(1) / slope;
  constexpr unsigned all = 15;
  held = bits_of(size + absolute(slope) + absolute(inverse) < all_lanes(most)) == all || holds(ray);
  // Either end of a slab errs by four roundings at most, of the slope, its inverse, the difference and the product: in
  // all by 2 epsilon of the plane's and of the origin's coordinate. The boxes are widened by 8 of the former; the
  // origin, itself rounded to float or into object space, is moved outward by 16 of the latter. Rounding below the
  // smallest normal float is monotonic and so keeps the order.
  const Lanes slack = all_lanes(16 * epsilon * (size[0] + size[1] + size[2]) + least);
  const Lanes away = with_signs_of(slope, slack);
  from_in = origin + away, from_out = origin - away;
  negative = bits_of(reinterpret_cast<LaneMask>(slope));
}

}  // namespace raywalk
