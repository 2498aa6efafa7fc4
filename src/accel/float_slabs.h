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
  Lanes origin, slope;      ///< of the ray, in float
  Lanes from_in, from_out;  ///< the origin relative to the planes through which the ray enters and leaves
  Lanes inverse;            ///< 1 / direction
};

namespace detail {

inline constexpr float most_held = 1e18F;  ///< the largest origin and slope, and the inverse of the smallest slope

/// Whether a ray is within float's range, as `surely_held` says of most without asking axis by axis.
template <class T>
[[nodiscard]] bool is_held(const Ray<T>& ray) {
  for (int axis = 0; axis < 3; ++axis) {
    const T slope = std::abs(ray.direction[axis]);
    const bool is_slope = slope == 0 || (slope > 1 / most_held && slope < most_held);
    if (!(std::abs(ray.origin[axis]) < most_held && is_slope)) return false;
  }
  return true;
}
[[nodiscard]] inline LaneMask surely_held(Lanes origin, Lanes slope, Lanes inverse) {
  return absolute(origin) + absolute(slope) + absolute(inverse) < all_lanes(most_held);
}

/// By how much an origin is moved outward whose coordinates, without their signs, have this sum. Either end of a slab
/// errs by four roundings at most, of the slope, its inverse, the difference and the product: in all by 2 epsilon of
/// the plane's and of the origin's coordinate. The boxes are widened by 8 of the former; the origin, itself rounded to
/// float or into object space, is moved outward by 16 of the latter. Rounding below the smallest normal float is
/// monotonic and so keeps the order.
template <class Float>
[[nodiscard]] Float slack_of(Float sum) {
  return 16 * std::numeric_limits<float>::epsilon() * sum + std::numeric_limits<float>::min();
}

}  // namespace detail

template <class T>
inline FloatSlabs<T>::FloatSlabs(const Ray<T>& ray)
    : origin{static_cast<float>(ray.origin.x), static_cast<float>(ray.origin.y), static_cast<float>(ray.origin.z), 0},
      slope{static_cast<float>(ray.direction.x), static_cast<float>(ray.direction.y),
            static_cast<float>(ray.direction.z), 1} {
  const Lanes size = absolute(origin);
  inverse = all_lanes(1) / slope;
  constexpr unsigned all = 15;
  held = bits_of(detail::surely_held(origin, slope, inverse)) == all || detail::is_held(ray);
  const Lanes away = with_signs_of(slope, all_lanes(detail::slack_of(size[0] + size[1] + size[2])));
  from_in = origin + away, from_out = origin - away;
  negative = bits_of(reinterpret_cast<LaneMask>(slope));
}

}  // namespace raywalk
