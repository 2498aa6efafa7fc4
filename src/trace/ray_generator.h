#pragma once

#include "math/ray.h"
#include "math/sampler.h"
#include "math/sampling.h"
#include "scene/effects.h"
#include "scene/scene.h"
#include "trace/ray_differential.h"
#include "trace/statistics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

namespace raywalk {

/// One sample of one pixel. Column 0 is the left one, row 0 the top one.
struct Pixel {
  int column = 0, row = 0;
  int sample = 0;
  int until = 0;  ///< samples before this one are requested next, in order, and may be drawn together; 0: only this one
};

/// How many samples a pixel takes, and where.
struct Sampling {
  int per_pixel = 1;  ///< 1: the centre. More: distributed over the pixel by the scene's sampler
  std::uint64_t seed = 0;
  /// Rays through the corners of the pixels instead of their centres: the traced image is one column and one row
  /// larger, and each pixel is the mean of its four corners. No other samples are taken: per_pixel = 1.
  bool corners = false;
  friend bool operator==(const Sampling&, const Sampling&) = default;
};

/// Which of a pixel's edge x edge cells, row by row, a sample without random numbers takes, 0 <= sample < edge * edge.
/// Any `edge` consecutive samples lie in all columns, and about evenly in the rows: adaptive sampling may stop after
/// some of them, which then represent the pixel.
[[nodiscard]] int cell_of_sample(int sample, int edge);

/// Forms camera rays for an image, or for a strip of it: at a point of the pixel, through a point of the lens, at a
/// time.
///
/// Coordinates come from centred integers by one division, (2i + 1 - W) / W: the middle row's height is then exactly 0,
/// and the cells of a strip W / k wide equal every k-th column bit for bit when k is odd (both divide the same number).
/// The random numbers of a pixel depend on that same fraction, so they are equal for both too.
template <class T>
class RayGenerator {
 public:
  /// `size`: of what is rendered. `whole`: of the image that it is, or is a strip of; its aspect ratio
  /// matters for a camera that states its angle along y, its width for differentials. With `sampling.corners`, `size`
  /// is that of the corners, and `whole` that of the picture.
  RayGenerator(const Scene& scene, ImageSize size, ImageSize whole, Sampling sampling = {})
      : RayGenerator(scene.camera, size, whole, sampling) {
    const Effects effects = effects_of(scene, sampling.per_pixel);
    draws_ = draws_random(integrator_of(scene, sampling.per_pixel));
    sampler_ = scene.render.sampler;
    if (effects.used(Effect::depth_of_field)) lens_radius_ = static_cast<T>(scene.camera.aperture);
    moves_ = effects.used(Effect::motion_blur);
    is_sampled_ = is_sampled_ || lens_radius_ > 0 || moves_;
  }
  /// As a pinhole camera without motion blur, with jittered samples.
  RayGenerator(const Camera& camera, ImageSize size, ImageSize whole, Sampling sampling = {})
      : size_(size), sampling_(sampling), strata_(static_cast<std::uint32_t>(sampling.per_pixel)), eye_(camera.eye) {
    const Vec3d forward = normalize(camera.look_at - camera.eye);
    const Vec3d right = normalize(cross(forward, camera.up)), up = cross(right, forward);
    const double aspect = static_cast<double>(whole.width) / whole.height;
    const double half_width = camera.half_extent() * (camera.extent_axis() == FovAxis::y ? aspect : 1);
    forward_ = Vec3<T>(forward);
    right_ = Vec3<T>(half_width * right);
    up_ = Vec3<T>(half_width * up);
    width_ = static_cast<T>(sampling.corners ? size.width - 1 : size.width);
    const int pixels = sampling.corners ? size.width - 1 : size.width;
    for (int i = 0; i < size.width; ++i) column_keys_.push_back(fraction_key(2 * i + 1 - size.width, pixels));
    for (int i = 0; i < size.height; ++i) row_keys_.push_back(fraction_key(size.height - 1 - 2 * i, pixels));
    lens_right_ = Vec3<T>(right);
    lens_up_ = Vec3<T>(up);
    focus_ = static_cast<T>(camera.focus_distance());
    shutter_open_ = static_cast<T>(camera.shutter_open);
    shutter_close_ = static_cast<T>(camera.shutter_close);
    is_sampled_ = sampling.per_pixel > 1;
    spacing_ = 1 / std::sqrt(static_cast<T>(sampling.per_pixel));
    const T step = 2 * spacing_ / static_cast<T>(whole.width);
    sample_right_ = step * right_;
    sample_up_ = step * up_;
  }

  /// The random numbers for several samples of a pixel, drawn ahead so that no sample waits for them; kept by the
  /// caller who requests the samples in turn.
  struct PixelDraws {
    static constexpr int most = 16;
    int column = -1, row = -1;
    int first = 0, end = 0;             ///< samples
    std::array<Vec2<T>, most> offsets;  ///< of each, from the pixel's centre, in half pixels, each in [-1, 1)
    SamplePairs lens;

    [[nodiscard]] bool hold(const Pixel& pixel) const {
      return pixel.column == column && pixel.row == row && first <= pixel.sample && pixel.sample < end;
    }
  };

  /// The ray of a sample, of unit length. Counts its draws.
  [[nodiscard]] Ray<T> primary_ray(const Pixel& pixel, PixelDraws& draws, Statistics& statistics) const {
    const Vec2<T> centre{static_cast<T>(2 * pixel.column + 1 - size_.width),
                         static_cast<T>(size_.height - 1 - 2 * pixel.row)};
    if (is_sampled_) return sampled_ray(pixel, centre, draws, statistics);
    return {eye_, normalize(through(centre)), {}, shutter_open_};
  }
  [[nodiscard]] Ray<T> primary_ray(const Pixel& pixel, Statistics& statistics) const {
    PixelDraws draws;
    return primary_ray(pixel, draws, statistics);
  }

  /// From the eye through the left edge of a column, at the middle of a row; column = width: the picture's right edge.
  [[nodiscard]] Vec3<T> edge(int column, int row) const {
    return through({static_cast<T>(2 * column - size_.width), static_cast<T>(size_.height - 1 - 2 * row)});
  }
  [[nodiscard]] const Vec3<T>& eye() const { return eye_; }
  /// The directions from the eye to the picture: corner + x right + y down, x and y in pixels from the place `from`,
  /// and that from the picture's upper left corner.
  struct Window {
    Vec3<T> corner, right, down;
  };
  [[nodiscard]] Window window(const Vec2<T>& from) const {
    return {through({2 * from.x - static_cast<T>(size_.width), static_cast<T>(size_.height) - 2 * from.y}),
            2 / width_ * right_, -2 / width_ * up_};
  }

  /// Of a ray with this unit direction: through the lens as through a pinhole, for both lie at one distance from the
  /// plane in focus, to which d of the paper leads. A pixel is one of the whole image, also in a cell of its strip.
  [[nodiscard]] RayDifferential<T> differential(const Vec3<T>& direction) const {
    const T per_length = dot(direction, forward_);
    return {from_eye(direction, per_length, sample_right_), from_eye(direction, per_length, sample_up_)};
  }
  /// The same, transferred to the hit at t, where the normal is N.
  [[nodiscard]] RayDifferential<T> differential_at_hit(const Vec3<T>& direction, T t, const Vec3<T>& N) const {
    const T per_length = dot(direction, forward_);
    const auto along = [&](const Vec3<T>& right) -> RayDerivative<T> {
      return {from_eye_to_hit(direction, per_length, right, t, N), from_eye(direction, per_length, right).dD};
    };
    return {along(sample_right_), along(sample_up_)};
  }
  /// The distance of a pixel's samples from each other, in pixels: 1 / sqrt(n).
  [[nodiscard]] T spacing() const { return spacing_; }

  [[nodiscard]] ImageSize size() const { return size_; }
  [[nodiscard]] const Sampling& sampling() const { return sampling_; }
  [[nodiscard]] Sampler sampler() const { return sampler_; }
  [[nodiscard]] T shutter_open() const { return shutter_open_; }
  /// Whether something moves while the shutter is open, and the time at which this share of that is over.
  [[nodiscard]] bool moves() const { return moves_; }
  [[nodiscard]] T time_after(T share) const { return shutter_open_ + share * (shutter_close_ - shutter_open_); }
  /// The stratification of the samples of a pixel.
  [[nodiscard]] const Strata& strata() const { return strata_; }
  [[nodiscard]] std::uint32_t count() const { return strata_.count(); }

  /// The key of all draws for a sample of a pixel, for an effect at the primary hit.
  [[nodiscard]] RandomKey key(const Pixel& pixel, Effect effect) const {
    return {sampling_.seed, column_keys_[static_cast<std::size_t>(pixel.column)],
            row_keys_[static_cast<std::size_t>(pixel.row)], static_cast<std::uint32_t>(pixel.sample),
            static_cast<std::uint32_t>(effect)};
  }

 private:
  /// A key for the fraction, the same for equal ones: a cell of the strip and the pixel that it equals draw the same
  /// numbers. Distinct for all pictures up to 32768 x 32768.
  [[nodiscard]] static std::int32_t fraction_key(int numerator, int denominator) {
    const int divisor = std::max(std::gcd(numerator, denominator), 1);
    const auto above = static_cast<std::uint32_t>(numerator / divisor);
    return static_cast<std::int32_t>(above << 16 ^ static_cast<std::uint32_t>(denominator / divisor));
  }

  /// From the eye to the plane at distance 1; `place`: in half pixels from the centre of the image.
  [[nodiscard]] Vec3<T> through(const Vec2<T>& place) const {
    return forward_ + (place.x / width_) * right_ + (place.y / width_) * up_;
  }

  /// Separate, so that it costs a single test for a pinhole camera at one sample per pixel without motion.
  [[nodiscard]] Ray<T> sampled_ray(const Pixel& pixel, Vec2<T> place, PixelDraws& draws, Statistics& statistics) const;
  void draw_ahead(const Pixel& pixel, PixelDraws& draws) const;
  [[nodiscard]] Vec2<T> fixed_place(int sample) const;

  ImageSize size_;
  Sampling sampling_;
  Strata strata_;
  Sampler sampler_ = Sampler::jittered;
  bool draws_ = true, moves_ = false;
  bool is_sampled_ = false;  ///< rays differ from: from the eye, through the pixel's centre, when the shutter opens
  std::vector<std::int32_t> column_keys_, row_keys_;
  T width_;                             ///< pixels across the picture
  Vec3<T> eye_, forward_, right_, up_;  ///< right and up have half the image's width at distance 1 as their length
  T lens_radius_ = 0, focus_;           ///< radius 0: nothing is drawn for the lens
  Vec3<T> lens_right_, lens_up_;        ///< unit length
  T shutter_open_, shutter_close_;
  T spacing_;
  Vec3<T> sample_right_, sample_up_;  ///< from sample to sample, at distance 1
};

extern template class RayGenerator<float>;
extern template class RayGenerator<double>;

}  // namespace raywalk
