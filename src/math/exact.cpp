#include "math/exact.h"

namespace raywalk {

namespace detail {

Expansion exact_dot(const Vec3d& n, const Vec3d& d) {
  return Expansion(n.x) * d.x + Expansion(n.y) * d.y + Expansion(n.z) * d.z;
}
Expansion exact_dot_of_difference(const Vec3d& n, const Vec3d& p, const Vec3d& o) {
  return Expansion(n.x) * (Expansion(p.x) - o.x) + Expansion(n.y) * (Expansion(p.y) - o.y) +
         Expansion(n.z) * (Expansion(p.z) - o.z);
}

}  // namespace detail

PlaneIntersection intersect_plane_exactly(const Vec3d& n, const Vec3d& p, const Vec3d& o, const Vec3d& d) {
  const Expansion numerator = detail::exact_dot_of_difference(n, p, o), denominator = detail::exact_dot(n, d);
  const auto rounded = [](const Expansion& exact) {
    const double value = static_cast<double>(exact.rounded());
    return RoundedSum{value, detail::half_ulp * std::abs(value)};
  };
  const double t = denominator.sign() == 0 ? NAN : static_cast<double>(numerator.rounded() / denominator.rounded());
  return {rounded(numerator), rounded(denominator), t, true};
}

}  // namespace raywalk
