#include "math/exact.h"

#include <array>

namespace raywalk {

namespace detail {

Expansion exact_dot(const Vec3d& n, const Vec3d& d) {
  return Expansion(n.x) * d.x + Expansion(n.y) * d.y + Expansion(n.z) * d.z;
}
Expansion exact_dot_of_difference(const Vec3d& n, const Vec3d& p, const Vec3d& o) {
  return Expansion(n.x) * (Expansion(p.x) - o.x) + Expansion(n.y) * (Expansion(p.y) - o.y) +
         Expansion(n.z) * (Expansion(p.z) - o.z);
}

Vec3d exact_normal(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  // Each edge scaled by a power of two, which is exact, to about 1: no product over- or underflows.
  const auto edge = [&](const Vec3d& to) {
    const Vec3d rounded = absolute(to - a);
    const double size = max_component(rounded);
    const int exponent = size > 0 && std::isfinite(size) ? -std::ilogb(size) : 0;
    const auto along = [&](int axis) {
      const DoubleDouble exact = two_sum(to[axis], -a[axis]);
      return Expansion(std::scalbn(exact.hi, exponent)) + std::scalbn(exact.lo, exponent);
    };
    return std::array{along(0), along(1), along(2)};
  };
  const auto ab = edge(b), ac = edge(c);
  const auto along = [&](std::size_t i, std::size_t j) {
    return static_cast<double>((ab[i] * ac[j] - ab[j] * ac[i]).rounded());
  };
  const Vec3d normal(along(1, 2), along(2, 0), along(0, 1));
  return normal == Vec3d(0.0) ? normal : normalize_any_length(normal);
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
