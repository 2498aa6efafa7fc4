#include "image/srgb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace raywalk {

namespace {

std::uint8_t to_srgb8_by_formula(float linear) {
  const double clamped = std::clamp(static_cast<double>(linear), 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(255 * srgb_encode(clamped)));
}

/// For each byte but 0, the smallest float that is mapped to it. A power takes about 30 ns, a search in this table 5.
std::array<float, 255> smallest_of_each_byte() {
  std::array<float, 255> smallest{};
  for (std::size_t byte = 1; byte <= 255; ++byte) {
    float below = 0, reaches = 1;
    for (;;) {
      const float middle = below + (reaches - below) / 2;
      if (middle == below || middle == reaches) break;
      (to_srgb8_by_formula(middle) >= byte ? reaches : below) = middle;
    }
    smallest[byte - 1] = reaches;
  }
  return smallest;
}

}  // namespace

std::uint8_t to_srgb8(float linear) {
  static const std::array<float, 255> smallest = smallest_of_each_byte();
  return static_cast<std::uint8_t>(std::upper_bound(smallest.begin(), smallest.end(), linear) - smallest.begin());
}

std::uint8_t to_byte(float linear, Encoding encoding) {
  switch (encoding) {
    case Encoding::srgb:
      return to_srgb8(linear);
    case Encoding::truncated:
      return static_cast<std::uint8_t>(255 * static_cast<double>(std::clamp(linear, 0.0F, 1.0F)));
  }
  return 0;
}

}  // namespace raywalk
