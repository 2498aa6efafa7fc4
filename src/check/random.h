#pragma once

#include "math/random.h"
#include "math/vec.h"

#include <cmath>
#include <cstdint>

namespace raywalk::check {

/// The random numbers of one test ray: a function of the seed, the test and the ray's number, so that any ray can be
/// reproduced alone, and a stopped run continued.
class Random {
 public:
  Random(std::uint64_t seed, std::uint64_t what, std::uint64_t number)
      : state_(raywalk::detail::mix(raywalk::detail::mix(raywalk::detail::mix(seed) ^ what) ^ number)) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    return raywalk::detail::mix(state_);
  }
  /// Uniform in [low, high).
  double real(double low = -1, double high = 1) {
    return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
  }
  /// Uniform in low..high.
  int whole(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1));
  }
  bool coin() { return bits() >> 63 != 0; }
  double sign() { return coin() ? 1.0 : -1.0; }
  /// 10 to a uniform power.
  double magnitude(double low_power, double high_power) { return std::pow(10.0, real(low_power, high_power)); }
  /// In the cube of half side `size`.
  Vec3d in_box(double size = 1) {
    const double x = real(-size, size), y = real(-size, size), z = real(-size, size);
    return {x, y, z};
  }
  /// Uniform on the unit sphere.
  Vec3d unit() {
    for (;;) {
      const Vec3d v = in_box();
      const double square = dot(v, v);
      if (square > 0.01 && square < 1) return v / std::sqrt(square);
    }
  }

 private:
  std::uint64_t state_;
};

}  // namespace raywalk::check
