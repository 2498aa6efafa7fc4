// Images made of numbers, for tests of maps.
#pragma once

#include "image/image.h"

#include <memory>
#include <utility>
#include <vector>

namespace raywalk::test {

// Row by row from the top.
inline std::shared_ptr<const Image> pixels_of(int width, int height, const std::vector<Rgbd>& pixels) {
  Image image{width, height, {}};
  for (const Rgbd& each : pixels) image.pixels.emplace_back(each);
  return std::make_shared<const Image>(std::move(image));
}

// `of(u, v)`: at the centres of the pixels, u to the right and v upward in 0..1.
template <class Of>
std::shared_ptr<const Image> image_of(int width, int height, const Of& of) {
  std::vector<Rgbd> pixels;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column)
      pixels.push_back(of((column + 0.5) / width, 1 - (row + 0.5) / height));
  return pixels_of(width, height, pixels);
}

inline std::shared_ptr<const Image> uniform(const Rgbd& colour) {
  return pixels_of(2, 2, {colour, colour, colour, colour});
}

// Of one normal, as normal maps code it.
inline Rgbd coded(const Vec3d& normal) { return (normal + Vec3d(1.0)) / 2.0; }

}  // namespace raywalk::test
