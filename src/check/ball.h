#pragma once
// The oracle's filter: a number with a proven error bound, which decides most questions without rationals.

#include "math/double_double.h"

#include <cmath>
#include <limits>
#include <optional>

namespace raywalk::check {

/// Thrown where a Ball is too wide to decide; rationals then do.
struct Undecided {};

/// Some real number within `radius` of `middle`.
///
/// M. Joldes, J.-M. Muller and V. Popescu, "Tight and rigorous error bounds for basic building blocks of double-word
/// arithmetic", ACM TOMS 44(2), 2017: with u = 2^-53 the sum below errs by at most 3u^2/(1 - 4u) of itself and the
/// product by 5u^2; 2^-102 = 16u^2 is taken for both, and 2^-98 for quotients and roots. Those bounds hold far from
/// under- and overflow; elsewhere the radius is infinite.
struct Ball {
  DoubleDouble middle;
  double radius = 0;

  Ball() = default;
  Ball(double exact) : middle(exact) {}  // NOLINT(google-explicit-constructor): every double is exactly representable
  Ball(DoubleDouble value, double error) : middle(value), radius(error) {}
};

namespace detail {

constexpr double step = 0x1p-102, coarse_step = 0x1p-98;
constexpr double up = 1 + 0x1p-40;  ///< covers the rounding of the bound itself
constexpr double smallest = 0x1p-900, largest = 0x1p900;

/// The ball of a computed value, with the relative error `relative` plus the error `inherited`.
[[nodiscard]] inline Ball ball_of(DoubleDouble value, double relative, double inherited) {
  const double size = std::abs(value.hi);
  if (size == 0 && inherited == 0) return {};
  // A bound below `smallest` is raised to it, so that no bound underflows.
  const double error = (relative * size + inherited) * up + smallest;
  const bool safe = size < largest && error < largest;
  return {value, safe ? error : std::numeric_limits<double>::infinity()};
}

}  // namespace detail

[[nodiscard]] inline Ball operator-(const Ball& x) { return {-x.middle, x.radius}; }

[[nodiscard]] inline Ball operator+(const Ball& x, const Ball& y) {
  const DoubleDouble sum = x.middle + y.middle;
  // Sums of two doubles are exact.
  const bool exact = x.radius == 0 && y.radius == 0 && x.middle.lo == 0 && y.middle.lo == 0;
  if (exact && std::abs(sum.hi) < detail::largest) return {sum, 0};
  return detail::ball_of(sum, detail::step, x.radius + y.radius);
}

[[nodiscard]] inline Ball operator-(const Ball& x, const Ball& y) { return x + -y; }

[[nodiscard]] inline Ball operator*(const Ball& x, const Ball& y) {
  const double a = std::abs(x.middle.hi), b = std::abs(y.middle.hi);
  const bool no_error = x.radius == 0 && y.radius == 0;
  if (no_error && (a == 0 || b == 0)) return {};
  // Splitting overflows if the factors are too large; the low half of a product is lost if it is too small.
  const bool safe = a < detail::largest && b < detail::largest && a * b < detail::largest &&
                    (a == 0 || b == 0 || a * b > detail::smallest);
  if (!safe) return {x.middle * y.middle, std::numeric_limits<double>::infinity()};
  const DoubleDouble product = x.middle * y.middle;
  if (no_error && x.middle.lo == 0 && y.middle.lo == 0) return {product, 0};
  return detail::ball_of(product, detail::step, ((a * y.radius + b * x.radius) * detail::up + x.radius * y.radius));
}

/// -1, 0 or 1. Throws Undecided if the ball contains numbers of different signs.
[[nodiscard]] inline int sign(const Ball& x) {
  const double size = std::abs(x.middle.hi);
  if (size == 0 && x.radius == 0) return 0;
  if (!(size * (1 - 0x1p-50) > x.radius)) throw Undecided();
  return x.middle.hi > 0 ? 1 : -1;
}

[[nodiscard]] inline Ball operator/(const Ball& x, const Ball& y) {
  static_cast<void>(sign(y));  // the divisor must not contain 0
  if (x.middle.hi == 0 && x.radius == 0) return {};
  const DoubleDouble quotient = x.middle / y.middle;
  const double below = (std::abs(y.middle.hi) * (1 - 0x1p-50) - y.radius) * (1 - 0x1p-40);
  return detail::ball_of(quotient, detail::coarse_step,
                         (x.radius + std::abs(quotient.hi) * detail::up * y.radius) / below * detail::up);
}

/// Of a number that is not negative.
[[nodiscard]] inline Ball root(const Ball& x) {
  if (sign(x) == 0) return {};
  if (!(x.middle.hi > 0)) throw Undecided();
  const DoubleDouble value = raywalk::sqrt(x.middle);
  return detail::ball_of(value, detail::coarse_step, x.radius / (value.hi * (1 - 0x1p-40)) * detail::up);
}

/// |computed - exact| in units of `ulp`. Throws Undecided if the ball is too wide for a thousandth.
[[nodiscard]] inline double error_in_ulps(double computed, double ulp, const Ball& exact) {
  if (!(exact.radius < ulp * 1e-3) || !(ulp > detail::smallest)) throw Undecided();
  return std::abs(static_cast<double>(DoubleDouble(computed) - exact.middle)) / ulp;
}

/// The nearest double, approximately.
[[nodiscard]] inline double approximate(const Ball& x) { return x.middle.hi; }

}  // namespace raywalk::check
