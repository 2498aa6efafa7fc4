#include "trace/clear_sky.h"

#include "math/elementary.h"
#include "trace/clear_sky_data.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <type_traits>

namespace raywalk {

namespace {

/// Numbers of at most seven digits, as a whole number in two parts and how many of its digits follow the point: of the
/// bytes of doubles, which everybody who opens the page waits for, half. One division gives the double nearest to what
/// was written.
template <std::size_t n>
class Decimals {
 public:
  constexpr double operator[](std::size_t i) const {
    const double size = (high_[i] * 0x10000 + low_[i]) / powers[places_[i] % below_0];
    return places_[i] < below_0 ? size : -size;
  }

  constexpr void set(std::size_t i, double value) {
    places_[i] = value < 0 ? below_0 : 0;
    for (;; ++places_[i]) {  // beyond the last power the compiler stops
      const double scaled = (value < 0 ? -value : value) * powers[places_[i] % below_0];
      if (scaled > 1e7) throw "more than seven digits";
      const auto whole = static_cast<unsigned>(scaled + 0.5);
      low_[i] = static_cast<std::uint16_t>(whole % 0x10000);
      high_[i] = static_cast<std::uint8_t>(whole / 0x10000);
      if ((*this)[i] == value) return;
    }
  }

 private:
  // Plain arrays, for a compiler counts the steps that it takes here.
  static constexpr double powers[14]{1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13};
  static constexpr std::uint8_t below_0 = 0x80;

  std::uint16_t low_[n]{};
  std::uint8_t high_[n]{}, places_[n]{};
};

template <std::size_t n>
constexpr void set_all(Decimals<n>& decimals, std::size_t& next, const auto& values) {
  if constexpr (std::is_array_v<std::remove_cvref_t<decltype(values)>>)
    for (const auto& part : values) set_all(decimals, next, part);
  else
    decimals.set(next++, values);
}

template <class Table>
consteval auto decimals_of(const Table& table) {
  Decimals<sizeof table / sizeof(double)> decimals;
  std::size_t next = 0;
  set_all(decimals, next, table);
  return decimals;
}

constexpr auto shapes = decimals_of(detail::clear_sky_shape);
constexpr auto radiances = decimals_of(detail::clear_sky_radiance);

/// A quintic Bezier curve at t in 0..1; `point(i)`: its control points.
template <class Point>
double bezier(double t, Point point) {
  const double s = 1 - t;
  const double s2 = s * s, t2 = t * t;
  return s2 * s2 * s * point(0) + 5 * s2 * s2 * t * point(1) + 10 * s2 * s * t2 * point(2) +
         10 * s2 * t2 * t * point(3) + 5 * s * t2 * t2 * point(4) + t2 * t2 * t * point(5);
}

}  // namespace

ClearSkyRadiance::ClearSkyRadiance(const ClearSky& sky) : strength_(sky.strength) {
  const double elevation = sky.elevation * (std::numbers::pi / 180);
  const auto [sin, cos] = portable::sin_cos(elevation);
  sun_ = {cos, 0, sin};
  // Linear in albedo and between whole turbidities, smooth in the cube root of the sun's elevation.
  const double t = portable::pow(sky.elevation / 90, 1.0 / 3);
  const double clearer = std::min(std::floor(sky.turbidity), 9.0), hazier = sky.turbidity - clearer;
  const auto index = static_cast<std::size_t>(clearer) - 1;
  const auto between = [&](auto value) {
    double sum = 0;
    for (const std::size_t ground : {0U, 1U})
      sum += (ground == 1 ? sky.albedo : 1 - sky.albedo) *
             ((1 - hazier) * value(ground, index) + hazier * value(ground, index + 1));
    return sum;
  };
  for (std::size_t c = 0; c < channels_.size(); ++c) {
    for (std::size_t i = 0; i < channels_[c].shape.size(); ++i)
      channels_[c].shape[i] = between([&](std::size_t ground, std::size_t haze) {
        return bezier(t,
                      [&](std::size_t point) { return shapes[(((c * 2 + ground) * 10 + haze) * 6 + point) * 9 + i]; });
      });
    channels_[c].radiance = between([&](std::size_t ground, std::size_t haze) {
      return bezier(t, [&](std::size_t point) { return radiances[((c * 2 + ground) * 10 + haze) * 6 + point]; });
    });
  }
}

Vec3d ClearSkyRadiance::xyz(const Vec3d& direction) const {
  const double cos_theta = std::clamp(direction.z, 0.0, 1.0);  // from the zenith
  const double cos_gamma = std::clamp(dot(direction, sun_), -1.0, 1.0);
  const double gamma = portable::atan2(length(cross(direction, sun_)), cos_gamma);  // from the sun
  Vec3d all(0.0);
  for (int c = 0; c < 3; ++c) {
    const auto& [shape, radiance] = channels_[static_cast<std::size_t>(c)];
    const auto [a, b, cc, d, e, f, g, i, h] = shape;
    const double base = std::max(1 + h * h - 2 * h * cos_gamma, 1e-9);
    const double aureole = (1 + cos_gamma * cos_gamma) / (base * std::sqrt(base));
    all[c] = radiance * (1 + a * portable::exp(b / (cos_theta + 0.01))) *
             (cc + d * portable::exp(e * gamma) + f * cos_gamma * cos_gamma + g * aureole + i * std::sqrt(cos_theta));
  }
  return all;
}

Rgbd ClearSkyRadiance::operator()(const Vec3d& direction) const {
  const Vec3d x = xyz(direction);
  // IEC 61966-2-1.
  const Rgbd rgb{3.2406 * x.x - 1.5372 * x.y - 0.4986 * x.z, -0.9689 * x.x + 1.8758 * x.y + 0.0415 * x.z,
                 0.0557 * x.x - 0.2040 * x.y + 1.0570 * x.z};
  return strength_ * Rgbd(std::max(rgb.x, 0.0), std::max(rgb.y, 0.0), std::max(rgb.z, 0.0));
}

}  // namespace raywalk
