#pragma once
// Quadratics along a ray: their roots in double with error bounds, and by exact arithmetic.

#include "math/exact.h"
#include "math/inlining.h"

#include <algorithm>
#include <cmath>

namespace raywalk::detail {

/// x^2 xx + y^2 yy + z^2 zz + z linear + constant: negative inside.
struct QuadricEquation {
  double xx, yy, zz, linear, constant;
};

/// The same times the squares of the radii: without division and without any rounding.
struct ExactEquation {
  Expansion xx, yy, zz, linear, constant;
};

/// The roots of a t^2 + 2 b t + c, near <= far, and whether it is negative between them (else outside). A root at
/// infinity is infinite. Without roots, near and far are NaN and `inside_everywhere` tells the sign.
struct QuadraticRoots {
  double near = NAN, far = NAN;
  bool inside_between = true, inside_everywhere = false;

  [[nodiscard]] bool inside(double t) const {
    if (std::isnan(near)) return inside_everywhere;
    return inside_between ? near <= t && t <= far : t <= near || far <= t;
  }
};

/// Real is double or DoubleDouble; `discriminant` is b^2 - a c.
template <class Real>
[[nodiscard, RAYWALK_INLINE]] inline QuadraticRoots roots_of(Real a, Real b, Real c, Real discriminant) {
  using std::sqrt;
  const double a_hi = static_cast<double>(a), b_hi = static_cast<double>(b);
  if (static_cast<double>(discriminant) < 0) return {NAN, NAN, true, a_hi < 0};
  const Real root = sqrt(discriminant);
  const Real q = b_hi > 0 ? -(b + root) : root - b;
  if (static_cast<double>(q) == 0) {
    if (a_hi == 0) return {NAN, NAN, true, static_cast<double>(c) < 0};
    return {0, 0, a_hi > 0, false};
  }
  const double t0 = a_hi == 0 ? static_cast<double>(q) / a_hi : static_cast<double>(q / a);
  const double t1 = static_cast<double>(c / q);
  return {std::min(t0, t1), std::max(t0, t1), !std::signbit(a_hi), false};
}

/// The equation along the ray and its roots; `error` bounds the roots' relative error, and `sure` tells whether the
/// signs of a, c and the discriminant are certain.
struct QuadricRoots {
  double a, b, c, discriminant;
  QuadraticRoots roots;
  double error = 0;
  bool sure = false;

  /// Whether it is certain on which side of t the roots lie.
  [[nodiscard, gnu::always_inline]] bool sure_about(double t) const {
    const auto clear = [&](double root) {
      return std::isnan(root) || std::isinf(root) || std::isinf(t) ||
             std::abs(root - t) > error * std::abs(root) + 4 * half_ulp * std::abs(t);
    };
    return clear(roots.near) && clear(roots.far);
  }
  [[nodiscard]] double refined(const QuadricEquation& e, const Vec3d& o, const Vec3d& d, double t) const;
};

/// Newton's method from the root t. Where a, b and c each lost digits that the root depends on (far out near the
/// asymptotes), the equation evaluated at the point itself, a small number near the surface, has kept them. One step
/// suffices, unless two roots are so close that it only doubles the correct digits.
inline double QuadricRoots::refined(const QuadricEquation& e, const Vec3d& o, const Vec3d& d, double t) const {
  double best = t;
  for (int step = 0; step < 4; ++step) {
    const Vec3d p = o + best * d;
    const double off = e.xx * p.x * p.x + e.yy * p.y * p.y + (e.zz * p.z + e.linear) * p.z + e.constant;
    const double better = best - off / (2 * (b + a * best));
    if (!(std::abs(better - t) <= error * std::abs(t))) return best;
    const bool settled = std::abs(better - best) <= 64 * half_ulp * std::abs(t);
    best = better;
    if (settled) break;
  }
  return best;
}

[[nodiscard, RAYWALK_INLINE]] inline QuadricRoots quadric_roots(const QuadricEquation& e, const Vec3d& o,
                                                                const Vec3d& d, bool on_wall) {
  const double axx = e.xx * d.x * d.x, ayy = e.yy * d.y * d.y, azz = e.zz * d.z * d.z;
  const double bxx = e.xx * o.x * d.x, byy = e.yy * o.y * d.y, bzz = e.zz * o.z * d.z, bl = e.linear * d.z / 2;
  const double cxx = e.xx * o.x * o.x, cyy = e.yy * o.y * o.y, czz = e.zz * o.z * o.z, cl = e.linear * o.z;
  const double a = axx + ayy + azz, b = bxx + byy + bzz + bl;
  const double c = on_wall ? 0 : cxx + cyy + czz + cl + e.constant;
  // Each sum errs by a few ulps of its terms.
  const double a_error = 8 * half_ulp * (axx + ayy + std::abs(azz));
  const double b_error = 8 * half_ulp * (std::abs(bxx) + std::abs(byy) + std::abs(bzz) + std::abs(bl));
  const double c_error = on_wall ? 0 : 8 * half_ulp * (cxx + cyy + std::abs(czz) + std::abs(cl) + std::abs(e.constant));
  double discriminant = b * b, discriminant_error = 2 * b_error * std::abs(b) + b_error * b_error;
  if (!on_wall) {
    // b^2 - a c by the moments of the line: terms that are large in both products cancel out beforehand.
    const Vec3d m = cross(o, d);
    const Vec3d size(std::abs(o.y * d.z) + std::abs(o.z * d.y), std::abs(o.z * d.x) + std::abs(o.x * d.z),
                     std::abs(o.x * d.y) + std::abs(o.y * d.x));
    const Vec3d weight(e.yy * e.zz, e.zz * e.xx, e.xx * e.yy);
    const double tilt_x = e.linear * e.yy * d.y, tilt_y = -e.linear * e.xx * d.x;
    discriminant = tilt_x * m.x + tilt_y * m.y + bl * bl - a * e.constant -
                   (weight.x * m.x * m.x + weight.y * m.y * m.y + weight.z * m.z * m.z);
    discriminant_error = 8 * half_ulp * (std::abs(tilt_x) * size.x + std::abs(tilt_y) * size.y + bl * bl) +
                         a_error * std::abs(e.constant) + 8 * half_ulp * std::abs(a * e.constant);
    for (int axis = 0; axis < 3; ++axis) {
      const double m_error = 4 * half_ulp * size[axis];
      discriminant_error += std::abs(weight[axis]) *
                            ((2 * m_error + 12 * half_ulp * std::abs(m[axis])) * std::abs(m[axis]) + m_error * m_error);
    }
  }
  QuadricRoots found{a, b, c, discriminant, roots_of(a, b, c, discriminant)};
  // c must keep half of its digits: a short t depends on it.
  constexpr double digits = 1e-8;
  found.sure = std::abs(discriminant) > 2 * discriminant_error && std::abs(a) > 2 * a_error &&
               (on_wall || std::abs(c) * 8 * half_ulp > digits * c_error);
  if (discriminant > 0) {
    const double root = std::sqrt(discriminant), q = std::abs(b) + root;
    const double error = (b_error + discriminant_error / root) / q +
                         std::max(a_error / std::abs(a), on_wall ? 0 : c_error / std::abs(c)) + 4 * half_ulp;
    found.error = error < 1 ? error / (1 - error) : INFINITY;  // of quotients, whose divisors err too
  }
  return found;
}

/// The equation along the ray without rounding; a >= 0.
struct ExactQuadratic {
  Expansion a, b, c, discriminant;
  bool flipped;  ///< all signs were flipped

  /// How many roots lie below t = distance / slope, and how many at it; slope > 0.
  struct RootCounts {
    int below, at;
  };
  [[nodiscard]] int count() const {
    if (a.sign() == 0) return b.sign() == 0 ? 0 : 1;
    return discriminant.sign() + 1;
  }
  [[nodiscard]] int value_sign(const Expansion& distance, double slope) const {
    return (a * distance * distance + b * distance * (2 * slope) + c * slope * slope).sign();
  }
  [[nodiscard]] RootCounts place(const Expansion& distance, double slope) const {
    if (count() == 0) return {0, 0};
    const int value = value_sign(distance, slope);
    if (a.sign() == 0) return value == 0 ? RootCounts{0, 1} : RootCounts{value == b.sign() ? 1 : 0, 0};
    if (value < 0) return {1, 0};
    const bool beyond_middle = (a * distance + b * slope).sign() > 0;
    if (value == 0) return {beyond_middle && count() == 2 ? 1 : 0, 1};
    return {beyond_middle ? count() : 0, 0};
  }
  [[nodiscard]] double root(int i) const {
    const DoubleDouble wide_b = b.rounded(), wide_c = c.rounded();
    if (a.sign() == 0) return static_cast<double>(-wide_c / (wide_b + wide_b));
    if (count() == 1) return static_cast<double>(-wide_b / a.rounded());
    const QuadraticRoots roots = roots_of(a.rounded(), wide_b, wide_c, discriminant.rounded());
    return i == 0 ? roots.near : roots.far;
  }
};

[[nodiscard]] inline ExactQuadratic exact_quadratic(const ExactEquation& e, const Vec3d& o, const Vec3d& d,
                                                    bool on_wall) {
  Expansion a = e.xx * d.x * d.x + e.yy * d.y * d.y + e.zz * d.z * d.z;
  Expansion b = e.xx * o.x * d.x + e.yy * o.y * d.y + e.zz * o.z * d.z + e.linear * d.z * 0.5;
  Expansion c;
  if (!on_wall) c = e.xx * o.x * o.x + e.yy * o.y * o.y + e.zz * o.z * o.z + e.linear * o.z + e.constant;
  const bool flip = a.sign() < 0;
  if (flip) a = -a, b = -b, c = -c;
  return {a, b, c, b * b - a * c, flip};
}

}  // namespace raywalk::detail
