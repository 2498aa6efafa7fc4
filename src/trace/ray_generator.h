#pragma once

#include "math/random.h"
#include "math/ray.h"
#include "scene/effects.h"
#include "scene/scene.h"

namespace raywalk {

/// One sample of one pixel. Column 0 is the left one, row 0 the top one.
struct Pixel {
  int column = 0, row = 0;
  int sample = 0;
};

/// How the samples of a pixel are placed.
struct Sampling {
  int per_pixel = 1;  ///< 1: the centre. More: jittered in a k x k grid, what is left over anywhere in the pixel
  std::uint64_t seed = 0;
  /// Rays through the corners of the pixels instead of their centres: what is formed is one column and one row larger
  /// than the image, and each pixel is the mean of its four corners. Takes no other samples: per_pixel = 1.
  bool corners = false;
  friend bool operator==(const Sampling&, const Sampling&) = default;
};

/// Forms camera rays for an image, or for a strip of it.
///
/// Coordinates come from centred integers by one division, (2i + 1 - W) / W: the middle row's height is then exactly 0,
/// and the cells of a strip W / k wide equal every k-th column bit for bit when k is odd (both divide the same number).
template <class T>
class RayGenerator {
 public:
  /// `size`: what is rendered. `whole`: the image that it is, or is a strip of; only its aspect matters, and only for a
  /// camera that states its angle along y. With `sampling.corners`, `size` is that of the corners.
  RayGenerator(const Camera& camera, ImageSize size, ImageSize whole, Sampling sampling = {})
      : size_(size), sampling_(sampling), eye_(camera.eye) {
    const Vec3d forward = normalize(camera.look_at - camera.eye);
    const Vec3d right = normalize(cross(forward, camera.up));
    const double aspect = static_cast<double>(whole.width) / whole.height;
    const double half_width = camera.half_extent() * (camera.extent_axis() == FovAxis::y ? aspect : 1);
    forward_ = Vec3<T>(forward);
    right_ = Vec3<T>(half_width * right);
    up_ = Vec3<T>(half_width * cross(right, forward));
    while ((strata_ + 1) * (strata_ + 1) <= sampling.per_pixel) ++strata_;
  }

  /// The ray of a sample: from the eye, of unit length. Counts what it draws.
  [[nodiscard]] Ray<T> primary_ray(const Pixel& pixel, std::uint64_t& random_draws) const {
    T across = static_cast<T>(2 * pixel.column + 1 - size_.width);
    T upwards = static_cast<T>(size_.height - 1 - 2 * pixel.row);
    if (sampling_.per_pixel > 1) {
      const Vec2<T> moved = offset(pixel);
      across += moved.x;
      upwards += moved.y;
      random_draws += 2;
    }
    const T width = static_cast<T>(sampling_.corners ? size_.width - 1 : size_.width);
    return {eye_, normalize(forward_ + (across / width) * right_ + (upwards / width) * up_)};
  }

  [[nodiscard]] ImageSize size() const { return size_; }

 private:
  /// From the pixel's centre, in half pixels, each in [-1, 1).
  [[nodiscard]] Vec2<T> offset(const Pixel& pixel) const {
    RandomKey key{sampling_.seed, 2 * pixel.column + 1 - size_.width, 2 * pixel.row + 1 - size_.height,
                  static_cast<std::uint32_t>(pixel.sample), static_cast<std::uint32_t>(Effect::antialiasing)};
    const T u = random_unit<T>(key);
    key.dimension = 1;
    const T v = random_unit<T>(key);
    if (pixel.sample >= strata_ * strata_) return {2 * u - 1, 2 * v - 1};
    const T cells = static_cast<T>(strata_);
    const int column = pixel.sample % strata_;
    const int row = pixel.sample / strata_;
    const T x = (static_cast<T>(column) + u) / cells;
    const T y = (static_cast<T>(row) + v) / cells;
    return {2 * x - 1, 2 * y - 1};
  }

  ImageSize size_;
  Sampling sampling_;
  int strata_ = 1;
  Vec3<T> eye_, forward_, right_, up_;  ///< right and up as long as half the image's width at distance 1
};

}  // namespace raywalk
