#pragma once
// Signs that are right: a rounded value where it settles the sign, the exact one where it does not.

#include "math/double_double.h"

#include <cmath>

namespace raywalk {

/// a b - c d, correct in sign (short of underflow) and to a few ulps in value, whatever cancels.
[[nodiscard]] inline double difference_of_products(double a, double b, double c, double d) {
  const double left = a * b, right = c * d;
  const double difference = left - right;
  constexpr double bound = 4 * 1.1102230246251565e-16;
  if (std::abs(difference) > bound * (std::abs(left) + std::abs(right))) return difference;
  const DoubleDouble exact = two_product(a, b) - two_product(c, d);
  return exact.hi;
}

/// For float arguments the products are exact in double, and one rounding keeps the sign.
[[nodiscard]] inline double difference_of_products(float a, float b, float c, float d) {
  return static_cast<double>(a) * static_cast<double>(b) - static_cast<double>(c) * static_cast<double>(d);
}

}  // namespace raywalk
