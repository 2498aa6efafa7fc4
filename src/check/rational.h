#pragma once
// The oracle itself: GMP rationals, which never round.

#include <gmpxx.h>

#include <cmath>

namespace raywalk::check {

using Rational = mpq_class;

/// Enough bits that the rounding of a root is far below any ulp; its exponents neither over- nor underflow.
constexpr unsigned root_bits = 320;

[[nodiscard]] inline int sign(const Rational& x) { return sgn(x); }

/// The square root of a non-negative number, to 320 bits: a rational again, so that everything else stays exact.
[[nodiscard]] inline Rational root(const Rational& x) { return Rational(mpf_class(sqrt(mpf_class(x, root_bits)))); }

/// |computed - exact| in units of `ulp`.
[[nodiscard]] inline double error_in_ulps(double computed, double ulp, const Rational& exact) {
  const Rational error = (Rational(computed) - exact) / Rational(ulp);
  return std::abs(error.get_d());
}

[[nodiscard]] inline double approximate(const Rational& x) { return x.get_d(); }

}  // namespace raywalk::check
