#pragma once
// Correct signs: the rounded value where it settles the sign, the exact value where it does not.

#include "math/expansion.h"
#include "math/vec.h"

#include <cmath>

namespace raywalk {

/// A rounded sum of products and a bound on its error.
struct RoundedSum {
  double value, error;
  /// Whether the value's sign is certain. (Both 0: nothing cancelled.)
  [[nodiscard]] bool certain() const { return std::abs(value) >= 2 * error; }
};

namespace detail {

constexpr double half_ulp = 1.1102230246251565e-16;

/// n . d and n . (p - o)
[[nodiscard, gnu::cold]] Expansion exact_dot(const Vec3d& n, const Vec3d& d);
[[nodiscard, gnu::cold]] Expansion exact_dot_of_difference(const Vec3d& n, const Vec3d& p, const Vec3d& o);

/// The unit vector along (b - a) x (c - a), however short that is; 0 only where it is exactly 0.
[[nodiscard, gnu::cold]] Vec3d exact_normal(const Vec3d& a, const Vec3d& b, const Vec3d& c);

}  // namespace detail

/// n . d
[[nodiscard]] inline RoundedSum estimate_dot(const Vec3d& n, const Vec3d& d) {
  const double x = n.x * d.x, y = n.y * d.y, z = n.z * d.z;
  return {x + y + z, 4 * detail::half_ulp * (std::abs(x) + std::abs(y) + std::abs(z))};
}

/// n . (p - o)
[[nodiscard]] inline RoundedSum estimate_dot_of_difference(const Vec3d& n, const Vec3d& p, const Vec3d& o) {
  const double x = n.x * (p.x - o.x), y = n.y * (p.y - o.y), z = n.z * (p.z - o.z);
  return {x + y + z, 5 * detail::half_ulp * (std::abs(x) + std::abs(y) + std::abs(z))};
}

/// Where a line intersects the plane through p with normal n: at t = numerator / denominator, both of correct sign. If
/// one of them had to be computed exactly, both are, and t is rounded once; NaN when parallel to the plane.
struct PlaneIntersection {
  RoundedSum numerator, denominator;
  double t;
  bool exact = false;
  /// A bound on t's relative error.
  [[nodiscard]] double error() const {
    return 1.5 * (numerator.error / std::abs(numerator.value) + denominator.error / std::abs(denominator.value)) +
           2 * detail::half_ulp;
  }
};

[[nodiscard, gnu::cold]] PlaneIntersection intersect_plane_exactly(const Vec3d& n, const Vec3d& p, const Vec3d& o,
                                                                   const Vec3d& d);
[[nodiscard]] inline PlaneIntersection intersect_plane(const Vec3d& n, const Vec3d& p, const Vec3d& o, const Vec3d& d) {
  const RoundedSum numerator = estimate_dot_of_difference(n, p, o), denominator = estimate_dot(n, d);
  if (!(numerator.certain() && denominator.certain())) return intersect_plane_exactly(n, p, o, d);
  return {numerator, denominator, numerator.value / denominator.value};
}

}  // namespace raywalk
