#pragma once
// Integrals over the facets that an eye sees, for the albedos of rough surfaces.

#include "math/sampling.h"
#include "trace/microfacets.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace raywalk::detail {

/// The integral of `f` from a to b by Simpson's rule, whose halves are halved again where they differ from the whole.
/// `f_mid`: in the middle.
template <class F>
double simpson(const F& f, double a, double b, double f_a, double f_mid, double f_b, double tolerance, int depth) {
  const double mid = (a + b) / 2, left = f((a + mid) / 2), right = f((mid + b) / 2), size = (b - a) / 6;
  const double whole = size * (f_a + 4 * f_mid + f_b);
  const double halves = size / 2 * (f_a + 4 * left + 2 * f_mid + 4 * right + f_b);
  if (depth == 0 || std::abs(halves - whole) < tolerance) return halves + (halves - whole) / 15;
  return simpson(f, a, mid, f_a, left, f_mid, tolerance / 2, depth - 1) +
         simpson(f, mid, b, f_mid, right, f_b, tolerance / 2, depth - 1);
}
/// How `integral` begins, and how often it halves at most.
constexpr int integral_parts = 4, integral_halvings = 8;
/// Over the parts of 0..1.
template <class F>
double integral(const F& f, double tolerance) {
  double sum = 0, f_from = f(0.0);
  for (int i = 0; i < integral_parts; ++i) {
    const double from = static_cast<double>(i) / integral_parts, to = static_cast<double>(i + 1) / integral_parts,
                 f_to = f(to);
    sum += simpson(f, from, to, f_from, f((from + to) / 2), f_to, tolerance / integral_parts, integral_halvings);
    f_from = f_to;
  }
  return sum;
}

/// Of a share of half a turn that `integral` asks for.
inline const portable::SineCosine<double>& sin_cos_of_half_turn(double share) {
  constexpr int places = integral_parts << (integral_halvings + 2);  // quarters of the smallest interval
  static const auto table = [] {
    std::array<portable::SineCosine<double>, places + 1> all{};
    for (std::size_t i = 0; i <= places; ++i)
      all[i] = portable::sin_cos(pi_v<double> * (static_cast<double>(i) / places));
    return all;
  }();
  return table[static_cast<std::size_t>(share * places)];
}

/// The mean of `f` over the normals that the eye sees of GGX: over a cap of the sphere, whose height is evenly
/// distributed. `f`: of a normal, in the frame where to_eye = (sin, 0, cos) and the surface's normal is +z; left and
/// right are alike. It may jump, where a facet sends light to the other side of the surface: hence Simpson's rule.
template <class F>
double mean_over_facets(double alpha, double cos, double tolerance, const F& f) {
  const Vec3d to_eye(std::sqrt(1 - cos * cos), 0, cos), eye = normalize(Vec3d(alpha * to_eye.x, 0, to_eye.z));
  const auto at_height = [&](double height) {
    const double z = height * (1 + eye.z) - eye.z, radius = std::sqrt(std::max(1 - z * z, 0.0));
    const auto at_half_turn = [&](double share) {
      const auto [sin, cosine] = sin_cos_of_half_turn(share);
      return f(to_eye,
               normalize(Vec3d(alpha * (radius * cosine + eye.x), alpha * radius * sin, std::max(z + eye.z, 1e-12))));
    };
    return integral(at_half_turn, tolerance);
  };
  return integral(at_height, tolerance);
}

}  // namespace raywalk::detail
