#pragma once
// Signs that are right: a rounded value where it settles the sign, the exact one where it does not.

#include "math/expansion.h"
#include "math/vec.h"

#include <cmath>

namespace raywalk {

/// A value that is right in sign, a bound of its error, and whether only exact arithmetic could tell.
struct Certain {
  double value, error;
  bool exact = false;
};

namespace detail {

constexpr double half_ulp = 1.1102230246251565e-16;

[[nodiscard]] inline Certain rounded(const Expansion& exact) {
  const double value = static_cast<double>(exact.rounded());
  return {value, half_ulp * std::abs(value), true};
}

[[nodiscard]] inline Expansion exact_dot(const Vec3d& n, const Vec3d& d) {
  return Expansion(n.x) * d.x + Expansion(n.y) * d.y + Expansion(n.z) * d.z;
}
[[nodiscard]] inline Expansion exact_dot_of_difference(const Vec3d& n, const Vec3d& p, const Vec3d& o) {
  return Expansion(n.x) * (Expansion(p.x) - o.x) + Expansion(n.y) * (Expansion(p.y) - o.y) +
         Expansion(n.z) * (Expansion(p.z) - o.z);
}

}  // namespace detail

/// n . d
[[nodiscard]] inline Certain certain_dot(const Vec3d& n, const Vec3d& d) {
  const double x = n.x * d.x, y = n.y * d.y, z = n.z * d.z;
  const double sum = x + y + z, error = 4 * detail::half_ulp * (std::abs(x) + std::abs(y) + std::abs(z));
  // Both 0: nothing to cancel.
  return std::abs(sum) >= 2 * error ? Certain{sum, error} : detail::rounded(detail::exact_dot(n, d));
}

/// n . (p - o)
[[nodiscard]] inline Certain certain_dot_of_difference(const Vec3d& n, const Vec3d& p, const Vec3d& o) {
  const double x = n.x * (p.x - o.x), y = n.y * (p.y - o.y), z = n.z * (p.z - o.z);
  const double sum = x + y + z, error = 5 * detail::half_ulp * (std::abs(x) + std::abs(y) + std::abs(z));
  return std::abs(sum) >= 2 * error ? Certain{sum, error} : detail::rounded(detail::exact_dot_of_difference(n, p, o));
}

/// Where a line meets the plane through p across n: at t = numerator / denominator, each right in sign. Where one of
/// them had to be exact both are, and t is rounded once; parallel to the plane it is no number.
struct PlaneMeeting {
  Certain numerator, denominator;
  double t;
  [[nodiscard]] bool exact() const { return numerator.exact; }
  /// A bound of t's relative error.
  [[nodiscard]] double error() const {
    return 1.5 * (numerator.error / std::abs(numerator.value) + denominator.error / std::abs(denominator.value)) +
           2 * detail::half_ulp;
  }
};

[[nodiscard]] inline PlaneMeeting meet_plane_exactly(const Vec3d& n, const Vec3d& p, const Vec3d& o, const Vec3d& d) {
  const Expansion numerator = detail::exact_dot_of_difference(n, p, o), denominator = detail::exact_dot(n, d);
  const double t = denominator.sign() == 0 ? NAN : static_cast<double>(numerator.rounded() / denominator.rounded());
  return {detail::rounded(numerator), detail::rounded(denominator), t};
}
[[nodiscard]] inline PlaneMeeting meet_plane(const Vec3d& n, const Vec3d& p, const Vec3d& o, const Vec3d& d) {
  const Certain numerator = certain_dot_of_difference(n, p, o), denominator = certain_dot(n, d);
  if (numerator.exact || denominator.exact) return meet_plane_exactly(n, p, o, d);
  return {numerator, denominator, numerator.value / denominator.value};
}

}  // namespace raywalk
