#pragma once
// What the quick evaluations of the elementary functions have in common.
//
// Beside doubles they have numbers of two parts: the head has 26 bits, so that the product of two heads is exact; the
// tail has the 53 bits that follow. What is small beside a result is computed in one double: a relative error of 2^-53
// in something 2^-20 as large is one of 2^-73.

#include "math/double_double.h"
#include "math/elementary/big_float.h"

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace raywalk::portable {

/// The value is head + tail.
struct Parts {
  double head, tail;
  [[nodiscard]] constexpr double value() const { return head + tail; }
  friend constexpr Parts operator-(const Parts& p) { return {-p.head, -p.tail}; }
};

/// The first 26 bits.
[[nodiscard]] constexpr double head_of(double x) {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) & ~((std::uint64_t{1} << 27) - 1));
}
[[nodiscard]] constexpr Parts parts(double high, double low = 0) {
  const double head = head_of(high);
  return {head, (high - head) + low};
}
[[nodiscard]] constexpr Parts parts(const DoubleDouble& x) { return parts(x.hi, x.lo); }

/// a + b exactly, for |a| >= |b| or a = 0.
[[nodiscard]] constexpr DoubleDouble ordered_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// The whole number nearest to |x| < 2^51.
[[nodiscard]] constexpr double nearest_whole(double x) { return (x + 0x1.8p52) - 0x1.8p52; }

/// 2^power, for -1022..1023.
[[nodiscard]] constexpr double power_of_two(int power) {
  return std::bit_cast<double>(static_cast<std::uint64_t>(power + 1023) << 52);
}

/// terms[0] + terms[1] x + terms[2] x^2...
template <std::size_t N>
[[nodiscard]] constexpr double polynomial(double x, const double (&terms)[N]) {
  double sum = terms[N - 1];
  for (std::size_t i = N - 1; i-- > 0;) sum = sum * x + terms[i];
  return sum;
}

/// z + s z^3 / 3 + z^5 / 5 + s z^7 / 7... for |z| < 0.01: atan(z) for s = -1, the hyperbolic one for s = 1.
[[nodiscard]] constexpr DoubleDouble arc_series(const DoubleDouble& z, double s) {
  const DoubleDouble square = z * z * s;
  DoubleDouble sum;
  for (int divisor = 15; divisor > 0; divisor -= 2) sum = sum * square + z / divisor;
  return sum;
}

// The rounding test. A quick evaluation, right up to `error`, decides if both ends of the interval that holds the value
// round to the same number; `slow` is asked otherwise.

template <class Slow>
[[nodiscard]] inline double round_or(double high, double low, double error, const Slow& slow) {
  const double rounded = high + (low + error);
  if (rounded == high + (low - error)) [[likely]]
    return rounded;
  return slow();
}
template <class Slow>
[[nodiscard]] inline float round_or(double value, double error, const Slow& slow) {
  const float rounded = static_cast<float>(value + error);
  if (rounded == static_cast<float>(value - error)) [[likely]]
    return rounded;
  return slow();
}

}  // namespace raywalk::portable
