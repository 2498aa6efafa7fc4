// Numbers and vectors to test with, the same on every machine (the distributions of the standard library are not).
#pragma once

#include <cmath>
#include <cstdint>
#include <random>

#include "math/vec.h"

namespace raywalk::test {

class Numbers {
 public:
  explicit Numbers(std::uint64_t seed) : engine_(seed) {}

  // Uniform in [low, high).
  double real(double low = -1, double high = 1) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
  }
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  template <class T>
  Vec3<T> in_box(double size = 1) {
    const double x = real(-size, size), y = real(-size, size), z = real(-size, size);
    return Vec3<T>(Vec3d(x, y, z));
  }
  template <class T>
  Vec3<T> unit() {
    for (;;) {
      const Vec3d v = in_box<double>();
      const double square = dot(v, v);
      if (square > 0.01 && square < 1) return normalize(Vec3<T>(v));
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace raywalk::test
