#pragma once

#include "math/elementary.h"

#include <cstdint>
#include <optional>

namespace raywalk {

/// The exponent (>= 0) as an integer, if it is one and small enough that repeated multiplication is faster.
template <class T>
[[nodiscard]] std::optional<std::uint32_t> small_whole(T exponent) {
  if (!(exponent < 4096)) return std::nullopt;
  const auto whole = static_cast<std::uint32_t>(exponent);
  return static_cast<T>(whole) == exponent ? std::optional(whole) : std::nullopt;
}

/// base^exponent by one or two multiplications per binary digit: the accumulated rounding, less than half an ulp times
/// the exponent, is no larger than what the power makes of the base's own rounding error.
template <class T>
[[nodiscard]] T whole_power(T base, std::uint32_t exponent) {
  T result = (exponent & 1) != 0 ? base : T(1);
  while ((exponent >>= 1) != 0) {
    base *= base;
    if ((exponent & 1) != 0) result *= base;
  }
  return result;
}

/// base^exponent, both >= 0.
template <class T>
[[nodiscard]] T power(T base, T exponent) {
  const auto whole = small_whole(exponent);
  return whole ? whole_power(base, *whole) : portable::pow(base, exponent);
}

}  // namespace raywalk
