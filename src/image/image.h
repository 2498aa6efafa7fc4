#pragma once

#include "math/vec.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace raywalk {

/// In pixels; by default, of a scene that states none.
struct ImageSize {
  int width = 441, height = 331;
  friend bool operator==(const ImageSize&, const ImageSize&) = default;
};

/// The most pixels of a picture that is made or read, such as 16384 x 16384: what the PNG encoder can take.
inline constexpr std::int64_t max_image_pixels = std::int64_t{1} << 28;
[[nodiscard]] constexpr bool has_too_many_pixels(const ImageSize& size) {
  return std::int64_t{size.width} * size.height > max_image_pixels;
}

/// A picture in linear RGB. Row 0 is the top one; rows follow each other without gaps.
struct Image {
  int width = 0, height = 0;
  std::vector<Rgb<float>> pixels;  ///< width * height of them
  friend bool operator==(const Image&, const Image&) = default;

  [[nodiscard]] const Rgb<float>& at(int column, int row) const { return pixels[index(column, row)]; }
  [[nodiscard]] Rgb<float>& at(int column, int row) { return pixels[index(column, row)]; }

 private:
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
  }
};

/// A picture's rows, from the top.
struct ImageRows {
  int width = 0, height = 0;
  int begun = 0;  ///< those below are black
  /// The pixels of a row that is begun; valid until the next call.
  std::function<const Rgb<float>*(int row)> row{};
};

}  // namespace raywalk
