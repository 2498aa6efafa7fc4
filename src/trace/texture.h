#pragma once

#include "math/inlining.h"
#include "math/vec.h"
#include "scene/material.h"

#include <cmath>
#include <cstdint>

namespace raywalk {

/// The colour of a texture that repeats: one copy spans 0..1 in u (to the right) and in v (upwards). Bilinear between
/// the centres of the four nearest pixels.
template <class T>
[[nodiscard]] Rgb<T> texture_colour(const Image& texture, T u, T v) {
  if (!(std::isfinite(u) && std::isfinite(v))) return Rgb<T>(texture.pixels.front());  // too far for T
  // In pixels, from the centre of the top left one; wrapped while still relative to the copy, so that distant positions
  // keep their digits.
  const T x = (u - std::floor(u)) * static_cast<T>(texture.width) - T(0.5);
  const T y = (1 - (v - std::floor(v))) * static_cast<T>(texture.height) - T(0.5);
  const T left = std::floor(x), top = std::floor(y);
  const auto wrapped = [](T i, int size) {
    const int index = static_cast<int>(i) % size;
    return index < 0 ? index + size : index;
  };
  const int x0 = wrapped(left, texture.width), x1 = wrapped(left + 1, texture.width);
  const int y0 = wrapped(top, texture.height), y1 = wrapped(top + 1, texture.height);
  const auto pixel = [&](int column, int row) {
    return Rgb<T>(texture.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(texture.width) +
                                 static_cast<std::size_t>(column)]);
  };
  const T right = x - left, down = y - top;
  const Rgb<T> upper = pixel(x0, y0) + right * (pixel(x1, y0) - pixel(x0, y0));
  const Rgb<T> lower = pixel(x0, y1) + right * (pixel(x1, y1) - pixel(x0, y1));
  return upper + down * (lower - upper);
}

/// Whether a position lies in an even square of a checker. In integers, without branches: these would be mispredicted
/// half of the time.
template <class T>
[[nodiscard, RAYWALK_INLINE]] inline bool even_square(const Vec2<T>& uv, T size) {
  const auto square = [&](T along) -> std::int64_t {
    const T place = along / size;
    if (!(std::abs(place) < T(0x1p62))) return 0;  // this far out, T has only even numbers
    const auto cut = static_cast<std::int64_t>(place);
    return cut - static_cast<std::int64_t>(place < static_cast<T>(cut));
  };
  return ((square(uv.x) ^ square(uv.y)) & 1) == 0;
}

}  // namespace raywalk
