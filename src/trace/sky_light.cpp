#include "trace/sky_light.h"

#include "math/elementary.h"
#include "math/overloaded.h"
#include "math/sampling.h"
#include "math/transform.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace raywalk {

namespace {

constexpr double pi = std::numbers::pi;

double brightness(const Rgbd& light) { return light.x + light.y + light.z; }

/// A direction by its z and the azimuth in radians.
Vec3d direction_at(double z, double azimuth) {
  const double radius = std::sqrt(std::max((1 - z) * (1 + z), 0.0));
  const auto [sin, cos] = portable::sin_cos(azimuth);
  return {radius * cos, radius * sin, z};
}

/// Where a direction lies in a picture of all longitudes and latitudes, in its columns from the left and rows from the
/// top.
Vec2d place_in(const Vec3d& direction, std::size_t columns, std::size_t rows) {
  const double azimuth = portable::atan2(direction.y, direction.x);
  const double from_zenith =
      portable::atan2(std::sqrt(direction.x * direction.x + direction.y * direction.y), direction.z);
  return {(pi - azimuth) / (2 * pi) * static_cast<double>(columns), from_zenith / pi * static_cast<double>(rows)};
}

/// The first element above u, of a cumulative distribution that ends at 1. One of no probability is never it.
std::size_t first_above(const double* cdf, std::size_t count, double u) {
  return std::min(static_cast<std::size_t>(std::upper_bound(cdf, cdf + count, u) - cdf), count - 1);
}
double before(const double* cdf, std::size_t i) { return i == 0 ? 0 : cdf[i - 1]; }

/// Makes cumulative sums a distribution; what rounding left at the end belongs to the last element with a share.
void normalize_cdf(double* cdf, std::size_t count) {
  const double sum = cdf[count - 1];
  std::size_t last = count - 1;
  while (last > 0 && cdf[last - 1] == sum) --last;
  for (std::size_t i = 0; i < count; ++i) cdf[i] = i < last ? cdf[i] / sum : 1;
}

}  // namespace

SkyCells::SkyCells(int columns, int rows, const std::vector<double>& brightness)
    : columns_(static_cast<std::size_t>(columns)), rows_(static_cast<std::size_t>(rows)) {
  for (std::size_t row = 0; row <= rows_; ++row) {
    // Symmetric, so that a border on the horizon lies exactly there.
    const double up = portable::sin(pi / 2 * (static_cast<double>(rows_) - 2 * static_cast<double>(row)) /
                                    static_cast<double>(rows_));
    z_.push_back(up);
  }
  columns_cdf_ = brightness;
  double sum = 0;
  for (std::size_t row = 0; row < rows_; ++row) {
    double* of_row = columns_cdf_.data() + row * columns_;
    for (std::size_t column = 1; column < columns_; ++column) of_row[column] += of_row[column - 1];
    sum += of_row[columns_ - 1] * (z_[row] - z_[row + 1]);
    rows_cdf_.push_back(sum);
    if (of_row[columns_ - 1] > 0) normalize_cdf(of_row, columns_);
  }
  if (sum > 0)
    normalize_cdf(rows_cdf_.data(), rows_);
  else
    rows_cdf_.clear();
}

double SkyCells::pdf_of(std::size_t column, std::size_t row) const {
  const double of_row = rows_cdf_[row] - before(rows_cdf_.data(), row);
  const double of_column = cdf_of(row)[column] - before(cdf_of(row), column);
  return of_row * of_column * static_cast<double>(columns_) / (2 * pi * (z_[row] - z_[row + 1]));
}

auto SkyCells::sample(const Vec2d& unit) const -> Sample {
  const std::size_t row = first_above(rows_cdf_.data(), rows_, unit.y);
  const std::size_t column = first_above(cdf_of(row), columns_, unit.x);
  const auto within = [](const double* cdf, std::size_t i, double u) {
    return (u - before(cdf, i)) / (cdf[i] - before(cdf, i));
  };
  const double down = within(rows_cdf_.data(), row, unit.y);
  const double right = static_cast<double>(column) + within(cdf_of(row), column, unit.x);
  const double z = z_[row] + down * (z_[row + 1] - z_[row]);
  return {direction_at(z, pi - 2 * pi * right / static_cast<double>(columns_)), pdf_of(column, row)};
}

double SkyCells::pdf(const Vec3d& direction) const {
  if (empty()) return 0;
  const Vec2d place = place_in(direction, columns_, rows_);
  const auto cell = [](double at, std::size_t count) {
    return std::min(static_cast<std::size_t>(std::max(at, 0.0)), count - 1);
  };
  return pdf_of(cell(place.x, columns_), cell(place.y, rows_));
}

std::optional<SkyCells::Sample> SkyLight::Linear::sample(const Vec2d& unit) const {
  const double azimuth = 2 * pi * unit.y;
  double z = 0;
  if (unit.x < above) {
    // The area under a + b z from 0 to z, as a share of that from 0 to 1, is u: solved without cancellation.
    const double u = unit.x / above, slope = at_zenith - at_horizon, area = (at_horizon + at_zenith) / 2;
    const double root = at_horizon + std::sqrt(std::max(at_horizon * at_horizon + 2 * slope * area * u, 0.0));
    z = root > 0 ? std::min(2 * area * u / root, 1.0) : 0;
  } else {
    if (!(above < 1)) return std::nullopt;
    z = (unit.x - above) / (1 - above) - 1;
  }
  const double chance = pdf(z);
  if (!(chance > 0)) return std::nullopt;
  return Sample{direction_at(z, azimuth), chance};
}

double SkyLight::Linear::pdf(double z) const {
  if (z < 0) return (1 - above) / (2 * pi);
  const double area = (at_horizon + at_zenith) / 2;
  return area > 0 ? above * (at_horizon + z * (at_zenith - at_horizon)) / (2 * pi * area) : 0;
}

/// Bilinear between the centres of the pixels: around in longitude, up to the poles in latitude.
Rgbd SkyLight::Picture::at(const Vec3d& direction) const {
  if (!pixels) return strength;
  const auto columns = static_cast<std::size_t>(pixels->width), rows = static_cast<std::size_t>(pixels->height);
  const Vec2d place = place_in(direction, columns, rows) - Vec2d(0.5);
  const double left = std::floor(place.x), top = std::floor(place.y);
  const auto column = [&](double i) {
    const int at = static_cast<int>(i);
    return at < 0 ? at + pixels->width : at % pixels->width;
  };
  const auto row = [&](double i) { return std::clamp(static_cast<int>(i), 0, pixels->height - 1); };
  const auto pixel = [&](double x, double y) { return Rgbd(pixels->at(column(x), row(y))); };
  const double right = place.x - left, down = place.y - top;
  const Rgbd upper = pixel(left, top) + right * (pixel(left + 1, top) - pixel(left, top));
  const Rgbd lower = pixel(left, top + 1) + right * (pixel(left + 1, top + 1) - pixel(left, top + 1));
  return strength * (upper + down * (lower - upper));
}

auto SkyLight::linear(const Rgbd& horizon, const Rgbd& zenith, const Rgbd& below) -> Prepared {
  Linear sky{horizon, zenith, below, brightness(horizon), brightness(zenith), 0};
  const double upper = (sky.at_horizon + sky.at_zenith) / 2, lower = brightness(below);
  sky.above = upper + lower > 0 ? upper / (upper + lower) : 1;
  return sky;
}

auto SkyLight::prepared(const GradientSky& sky, const Rgbd& below) -> Prepared {
  return linear(sky.horizon, sky.zenith, below);
}

auto SkyLight::prepared(const OvercastSky& sky, const Rgbd& below) -> Prepared {
  return linear(sky.zenith / 3.0, sky.zenith, below);
}

/// Its cells are as bright as their middle, which is above 0 wherever the sky is.
auto SkyLight::prepared(const ClearSky& sky, const Rgbd& below) -> Prepared {
  constexpr int columns = 128, rows = 64;
  Clear clear{ClearSkyRadiance(sky), below, {}};
  std::vector<double> bright;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const Vec3d middle = direction_at(portable::cos(pi * (row + 0.5) / rows), pi - 2 * pi * (column + 0.5) / columns);
      bright.push_back(brightness(middle.z > 0 ? clear.radiance(middle) : below));
    }
  clear.cells = SkyCells(columns, rows, bright);
  return clear;
}

/// A cell for each pixel. The mean of the bilinear interpolation over a pixel is 6/8 of it and 1/8 of each neighbour,
/// in both directions: above 0 wherever the interpolation is.
auto SkyLight::prepared(const ImageSky& sky, const Rgbd& /*below*/) -> Prepared {
  Picture picture{sky.pixels, sky.strength, {}};
  if (!sky.pixels) {
    picture.cells = SkyCells(2, 1, std::vector<double>(2, brightness(sky.strength)));
    return picture;
  }
  const Image& pixels = *sky.pixels;
  const auto at = [&](int column, int row) {
    const int x = (column + pixels.width) % pixels.width, y = std::clamp(row, 0, pixels.height - 1);
    return brightness(sky.strength * Rgbd(pixels.at(x, y)));
  };
  std::vector<double> bright;
  bright.reserve(pixels.pixels.size());
  for (int row = 0; row < pixels.height; ++row)
    for (int column = 0; column < pixels.width; ++column) {
      const auto across = [&](int y) { return (at(column - 1, y) + 6 * at(column, y) + at(column + 1, y)) / 8; };
      bright.push_back((across(row - 1) + 6 * across(row) + across(row + 1)) / 8);
    }
  picture.cells = SkyCells(pixels.width, pixels.height, bright);
  return picture;
}

SkyLight::SkyLight(const Sky& sky, const Rgbd& below)
    : z_(normalize(sky.up)), kind_(std::visit([&](const auto& kind) { return prepared(kind, below); }, sky.kind)) {
  // The azimuth 0 is the x axis, made perpendicular to up; the y axis where up lies along x.
  const Vec3d level = Vec3d(1, 0, 0) - z_.x * z_;
  const Vec3d zero = length(level) > 0 ? normalize(level) : Vec3d(0, 1, 0);
  x_ = rotation(z_, sky.rotation).direction(zero);
  y_ = cross(z_, x_);
}

Vec3d SkyLight::to_sky(const Vec3d& direction) const {
  const Vec3d unit = normalize(direction);
  return {dot(unit, x_), dot(unit, y_), dot(unit, z_)};
}

Rgbd SkyLight::radiance(const Vec3d& direction) const {
  const Vec3d d = to_sky(direction);
  return std::visit(Overloaded{[&](const Linear& sky) {
                                 return d.z < 0 ? sky.below : sky.horizon + d.z * (sky.zenith - sky.horizon);
                               },
                               [&](const Clear& sky) { return d.z < 0 ? sky.below : sky.radiance(d); },
                               [&](const Picture& sky) { return sky.at(d); }},
                    kind_);
}

auto SkyLight::sample(const Vec2d& unit, SkySampling how) const -> std::optional<Sample> {
  std::optional<Sample> sample =
      std::visit(Overloaded{[&](const Linear& sky) { return sky.sample(unit); },
                            [&](const auto& sky) {
                              return sky.cells.empty() ? std::nullopt : std::optional<Sample>(sky.cells.sample(unit));
                            }},
                 kind_);
  if (how == SkySampling::uniform) sample = Sample{sample_uniform_sphere(unit), 1 / (4 * pi)};
  if (!sample) return std::nullopt;
  const Vec3d& d = sample->direction;
  sample->direction = d.x * x_ + d.y * y_ + d.z * z_;
  return sample;
}

double SkyLight::pdf(const Vec3d& direction, SkySampling how) const {
  if (how == SkySampling::uniform) return 1 / (4 * pi);
  const Vec3d d = to_sky(direction);
  return std::visit(
      Overloaded{[&](const Linear& sky) { return sky.pdf(d.z); }, [&](const auto& sky) { return sky.cells.pdf(d); }},
      kind_);
}

auto SkyLight::place(const Vec3d& direction) const -> Place {
  const Vec3d d = to_sky(direction);
  const double flat = std::sqrt(d.x * d.x + d.y * d.y);
  return {portable::atan2(d.z, flat) * (180 / pi), portable::atan2(d.y, d.x) * (180 / pi)};
}

}  // namespace raywalk
