#pragma once
// A sky prepared for tracing: its radiance by direction, and a sampling of directions in proportion to it. In double
// for all scalars.

#include "math/vec.h"
#include "scene/sky.h"
#include "trace/clear_sky.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <variant>
#include <vector>

namespace raywalk {

/// How directions towards the sky are sampled. Uniformly is for studies.
enum class SkySampling { by_brightness, uniform };

/// All directions in cells of equal longitude and equal latitude, row 0 about +z, column 0 from the azimuth 180 degrees
/// clockwise; each sampled with a probability of its own, and uniformly inside.
class SkyCells {
 public:
  SkyCells() = default;
  /// `brightness`: the mean of each cell, row by row; not negative.
  SkyCells(int columns, int rows, const std::vector<double>& brightness);

  /// Whether all cells are black: then there is nothing to sample.
  [[nodiscard]] bool empty() const { return rows_cdf_.empty(); }
  struct Sample {
    Vec3d direction;  ///< of unit length
    double pdf;       ///< per steradian, > 0
  };
  [[nodiscard]] Sample sample(const Vec2d& unit) const;
  /// `direction`: of unit length.
  [[nodiscard]] double pdf(const Vec3d& direction) const;

 private:
  [[nodiscard]] double pdf_of(std::size_t column, std::size_t row) const;
  [[nodiscard]] const double* cdf_of(std::size_t row) const { return columns_cdf_.data() + row * columns_; }

  std::size_t columns_ = 0, rows_ = 0;
  std::vector<double> rows_cdf_;     ///< up to and including each row
  std::vector<double> columns_cdf_;  ///< within each row, up to and including each column
  std::vector<double> z_;            ///< of the borders of the rows, from 1 to -1
};

class SkyLight {
 public:
  /// `below`: the radiance of what is under the horizon of a sky that has no lower half of its own.
  SkyLight(const Sky& sky, const Rgbd& below);

  /// Of what a ray meets that goes in this direction; any length but 0.
  [[nodiscard]] Rgbd radiance(const Vec3d& direction) const;

  using Sample = SkyCells::Sample;
  /// A direction towards the sky. None where the sky is black.
  [[nodiscard]] std::optional<Sample> sample(const Vec2d& unit, SkySampling how = SkySampling::by_brightness) const;
  /// The pdf per steradian with which `sample` returns this direction; 0 where it never does. Any length but 0.
  [[nodiscard]] double pdf(const Vec3d& direction, SkySampling how = SkySampling::by_brightness) const;

  /// In degrees: above the horizon, and the angle from the sky's middle, counter-clockwise seen from the zenith.
  struct Place {
    double elevation, azimuth;
  };
  [[nodiscard]] Place place(const Vec3d& direction) const;

 private:
  /// Radiance linear in the sine of the elevation, above a horizon; the overcast sky is one, and so is a gradient. It
  /// is sampled exactly in proportion to the sum of its channels, below the horizon uniformly.
  struct Linear {
    Rgbd horizon, zenith, below;
    double at_horizon, at_zenith;  ///< sums of channels
    double above;                  ///< the probability of a direction above the horizon
    [[nodiscard]] std::optional<Sample> sample(const Vec2d& unit) const;
    [[nodiscard]] double pdf(double z) const;
  };
  struct Clear {
    ClearSkyRadiance radiance;
    Rgbd below;
    SkyCells cells;
  };
  struct Picture {
    std::shared_ptr<const Image> pixels;
    Rgbd strength;
    SkyCells cells;
    [[nodiscard]] Rgbd at(const Vec3d& direction) const;
  };
  using Prepared = std::variant<Linear, Clear, Picture>;

  static Prepared prepared(const GradientSky& sky, const Rgbd& below);
  static Prepared prepared(const OvercastSky& sky, const Rgbd& below);
  static Prepared prepared(const ClearSky& sky, const Rgbd& below);
  static Prepared prepared(const ImageSky& sky, const Rgbd& below);
  static Prepared linear(const Rgbd& horizon, const Rgbd& zenith, const Rgbd& below);

  /// Of unit length: x towards the sky's middle, z towards the zenith.
  [[nodiscard]] Vec3d to_sky(const Vec3d& direction) const;

  Vec3d x_, y_, z_;  ///< axes of the sky
  Prepared kind_;
};

}  // namespace raywalk
