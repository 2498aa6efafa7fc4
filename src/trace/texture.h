#pragma once

#include "math/inlining.h"
#include "math/vec.h"
#include "scene/material.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace raywalk {

/// A place along an image, of which the first copy spans 0..1, where the image is the same and near that copy, so that
/// distant places keep their digits.
template <class T>
[[nodiscard]] T near_first_copy(T along, ImageWrap wrap) {
  switch (wrap) {
    case ImageWrap::repeat:
      return along - std::floor(along);
    case ImageWrap::clamp:
      return std::clamp(along, T(-1), T(2));
    case ImageWrap::mirror:
      return along - 2 * std::floor(along / 2);
  }
  return along;
}

/// The row or column, of `size`, that is there where these are counted on beyond the first copy.
[[nodiscard]] inline int wrapped_index(int i, int size, ImageWrap wrap) {
  if (0 <= i && i < size) return i;
  const auto rest = [i](int period) {
    const int index = i % period;
    return index < 0 ? index + period : index;
  };
  switch (wrap) {
    case ImageWrap::repeat:
      return rest(size);
    case ImageWrap::clamp:
      return std::clamp(i, 0, size - 1);
    case ImageWrap::mirror: {
      const int index = rest(2 * size);
      return index < size ? index : 2 * size - 1 - index;
    }
  }
  return 0;
}

/// The colour of a texture, of which the first copy spans 0..1 in u (to the right) and in v (upwards). Bilinear between
/// the centres of the four nearest pixels.
template <class T>
[[nodiscard]] Rgb<T> texture_colour(const Image& texture, T u, T v, ImageWraps wraps = {}) {
  if (!(std::isfinite(u) && std::isfinite(v))) return Rgb<T>(texture.pixels.front());  // too far for T
  // In pixels, from the centre of the top left one.
  const T x = near_first_copy(u, wraps.u) * static_cast<T>(texture.width) - T(0.5);
  const T y = (1 - near_first_copy(v, wraps.v)) * static_cast<T>(texture.height) - T(0.5);
  const T left = std::floor(x), top = std::floor(y);
  const auto column = [&](T i) { return wrapped_index(static_cast<int>(i), texture.width, wraps.u); };
  const auto row = [&](T i) { return wrapped_index(static_cast<int>(i), texture.height, wraps.v); };
  const int x0 = column(left), x1 = column(left + 1), y0 = row(top), y1 = row(top + 1);
  const auto pixel = [&](int i, int k) {
    return Rgb<T>(texture.pixels[static_cast<std::size_t>(k) * static_cast<std::size_t>(texture.width) +
                                 static_cast<std::size_t>(i)]);
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
