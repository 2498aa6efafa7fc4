#pragma once

#include "math/elementary.h"
#include "math/words.h"

#include <cstdint>

namespace raywalk {

/// How linear light becomes the 8 bits of a picture. Both clamp to 0..1.
enum class Encoding {
  srgb,       ///< the sRGB curve, rounded
  truncated,  ///< no curve, floor(255 c): as course scenes want it
};
template <>
inline constexpr Word<Encoding> words_of<Encoding>[] = {{Encoding::srgb, "srgb"}, {Encoding::truncated, "truncated"}};

/// Linear light to the sRGB signal (IEC 61966-2-1), both 1 at white. Not clamped.
[[nodiscard]] inline double srgb_encode(double linear) {
  return linear <= 0.0031308 ? 12.92 * linear : 1.055 * portable::pow(linear, 1 / 2.4) - 0.055;
}

/// The sRGB signal to linear light.
[[nodiscard]] inline double srgb_decode(double signal) {
  return signal <= 0.04045 ? signal / 12.92 : portable::pow((signal + 0.055) / 1.055, 2.4);
}

/// Linear light as a byte of a picture: clamped to 0..1, encoded, rounded. `linear` must not be NaN.
[[nodiscard]] std::uint8_t to_srgb8(float linear);
/// The same in the encoding that a scene asks for.
[[nodiscard]] std::uint8_t to_byte(float linear, Encoding encoding);

}  // namespace raywalk
