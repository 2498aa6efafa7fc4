#pragma once

#include "math/sampling.h"

#include <numbers>

namespace raywalk {

/// 1 - cos of the half angle of a lobe, given in degrees.
template <class T>
[[nodiscard]] T lobe_width(double degrees) {
  return static_cast<T>(one_minus_cos_of(degrees * (std::numbers::pi / 180)));
}

}  // namespace raywalk
