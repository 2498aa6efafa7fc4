#pragma once
// Unevaluated sums of two doubles: about 106 bits, for the few rays whose fast arithmetic cannot decide.
// T. J. Dekker, "A floating-point technique for extending the available precision", 1971; D. E. Knuth, TAOCP 2, 4.2.2.
// Needs round-to-nearest and no contraction or reassociation by the compiler (see the build flags).

#include <cmath>
#include <type_traits>

namespace raywalk {

struct DoubleDouble {
  double hi = 0, lo = 0;  ///< value hi + lo, |lo| <= ulp(hi) / 2

  DoubleDouble() = default;
  constexpr DoubleDouble(double value)
      : hi(value) {}  // NOLINT(google-explicit-constructor): every double is exactly
                      // representable
  constexpr DoubleDouble(double high, double low) : hi(high), lo(low) {}
  constexpr explicit operator double() const { return hi + lo; }
};

/// a + b exactly.
[[nodiscard]] constexpr DoubleDouble two_sum(double a, double b) {
  const double sum = a + b;
  const double b_part = sum - a;
  const double a_part = sum - b_part;
  return {sum, (a - a_part) + (b - b_part)};
}

/// a * b exactly, barring over- and underflow: by Dekker's splitting, or by a fused multiply-add where the target has
/// one. Only such a target can contract, and there neither the split nor the product may be fused with anything else.
[[nodiscard]] constexpr DoubleDouble two_product(double a, double b) {
#if defined(__FMA__) && defined(__x86_64__)
  if (!std::is_constant_evaluated()) {
    double product = a * b;
    asm("" : "+x"(product));  // rounded here
    return {product, std::fma(a, b, -product)};
  }
#endif
  constexpr double splitter = 134217729.0;  // 2^27 + 1
  const double a_big = splitter * a, b_big = splitter * b;
  const double a_hi = a_big - (a_big - a), b_hi = b_big - (b_big - b);
  const double a_lo = a - a_hi, b_lo = b - b_hi;
  const double product = a * b;
  return {product, ((a_hi * b_hi - product) + a_hi * b_lo + a_lo * b_hi) + a_lo * b_lo};
}

[[nodiscard]] constexpr DoubleDouble operator-(DoubleDouble x) { return {-x.hi, -x.lo}; }

[[nodiscard]] constexpr DoubleDouble operator+(DoubleDouble x, DoubleDouble y) {
  DoubleDouble high = two_sum(x.hi, y.hi);
  const DoubleDouble low = two_sum(x.lo, y.lo);
  high = two_sum(high.hi, high.lo + low.hi);
  return two_sum(high.hi, high.lo + low.lo);
}

[[nodiscard]] constexpr DoubleDouble operator-(DoubleDouble x, DoubleDouble y) { return x + -y; }

[[nodiscard]] constexpr DoubleDouble operator*(DoubleDouble x, DoubleDouble y) {
  const DoubleDouble product = two_product(x.hi, y.hi);
  return two_sum(product.hi, product.lo + (x.hi * y.lo + x.lo * y.hi));
}

[[nodiscard]] constexpr DoubleDouble operator/(DoubleDouble x, DoubleDouble y) {
  const double q0 = x.hi / y.hi;
  DoubleDouble rest = x - y * DoubleDouble(q0);
  const double q1 = rest.hi / y.hi;
  rest = rest - y * DoubleDouble(q1);
  return two_sum(q0, q1) + DoubleDouble(rest.hi / y.hi);
}

/// Square root of x >= 0: one Newton step from the double root (Karp and Markstein 1997).
[[nodiscard]] inline DoubleDouble sqrt(DoubleDouble x) {
  if (x.hi <= 0) return {};
  const double root = std::sqrt(x.hi);
  const DoubleDouble rest = x - two_product(root, root);
  return two_sum(root, rest.hi / (2 * root));
}

}  // namespace raywalk
