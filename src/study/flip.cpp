#include "study/flip.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace raywalk {

namespace {

// Linear RGB to XYZ, D65 (the paper's matrix), and back.
Vec3d xyz_of(const Rgbd& c) {
  return {(10135552 * c.x + 8788810 * c.y + 4435075 * c.z) / 24577794,
          (2613072 * c.x + 8788810 * c.y + 887015 * c.z) / 12288897,
          (1425312 * c.x + 8788810 * c.y + 70074185 * c.z) / 73733382};
}
Rgbd rgb_of(const Vec3d& c) {
  return {3.241003275 * c.x - 1.537398934 * c.y - 0.498615861 * c.z,
          -0.969224334 * c.x + 1.875930071 * c.y + 0.041554224 * c.z,
          0.055639423 * c.x - 0.204011202 * c.y + 1.057148933 * c.z};
}
const Vec3d white = xyz_of(Rgbd(1.0));

/// YCxCz, the opponent space that is linear in light.
Vec3d opponent_of(const Rgbd& rgb) {
  const Vec3d c = xyz_of(rgb) / white;
  return {116 * c.y - 16, 500 * (c.x - c.y), 200 * (c.y - c.z)};
}
Rgbd rgb_of_opponent(const Vec3d& c) {
  const double y = (c.x + 16) / 116;
  return rgb_of(Vec3d(y + c.y / 500, y, y - c.z / 200) * white);
}

/// L*a*b*, with less chroma where it is dark (R. Hunt).
Vec3d adjusted_lab_of(const Rgbd& rgb) {
  const Vec3d c = xyz_of(rgb) / white;
  const auto f = [](double t) {
    constexpr double delta = 6.0 / 29;
    return t > delta * delta * delta ? std::cbrt(t) : t / (3 * delta * delta) + 4.0 / 29;
  };
  const double x = f(c.x), y = f(c.y), z = f(c.z), l = 116 * y - 16;
  return {l, 0.01 * l * 500 * (x - y), 0.01 * l * 200 * (y - z)};
}

double hyab(const Vec3d& a, const Vec3d& b) { return std::abs(a.x - b.x) + std::hypot(a.y - b.y, a.z - b.z); }

/// One number for each pixel.
struct Channel {
  int width, height;
  std::vector<double> values;

  [[nodiscard]] double& at(int x, int y) {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
  [[nodiscard]] double at_nearest(int x, int y) const {
    x = std::clamp(x, 0, width - 1), y = std::clamp(y, 0, height - 1);
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
  }
};

/// Weights for -r..r.
using FilterKernel = std::vector<double>;

/// `across` along rows, `down` along columns; border pixels are repeated beyond the border.
Channel filtered(const Channel& in, const FilterKernel& across, const FilterKernel& down) {
  const auto pass = [](const Channel& from, const FilterKernel& kernel, int dx, int dy) {
    const int radius = static_cast<int>(kernel.size() / 2);
    Channel to{from.width, from.height, std::vector<double>(from.values.size())};
    for (int y = 0; y < from.height; ++y)
      for (int x = 0; x < from.width; ++x) {
        double sum = 0;
        for (int i = -radius; i <= radius; ++i)
          sum += kernel[static_cast<std::size_t>(i + radius)] * from.at_nearest(x + i * dx, y + i * dy);
        to.at(x, y) = sum;
      }
    return to;
  };
  return pass(pass(in, across, 1, 0), down, 0, 1);
}

FilterKernel scaled_to_one(FilterKernel kernel) {
  double sum = 0;
  for (const double weight : kernel) sum += weight;
  for (double& weight : kernel) weight /= sum;
  return kernel;
}

/// The contrast sensitivity function: a sum of Gaussians, each with an amplitude and a width.
struct Sensitivity {
  double a1, b1, a2, b2;
};
constexpr std::array<Sensitivity, 3> sensitivities{
    {{1, 0.0047, 0, 1e-5}, {1, 0.0053, 0, 1e-5}, {34.1, 0.04, 13.5, 0.025}}};

Channel seen(const Channel& in, const Sensitivity& s, double pixels_per_degree) {
  constexpr double pi = std::numbers::pi, widest = 0.04;
  const int radius = static_cast<int>(std::ceil(3 * std::sqrt(widest / (2 * pi * pi)) * pixels_per_degree));
  const auto gaussian = [&](double b) {
    FilterKernel kernel;
    for (int i = -radius; i <= radius; ++i) {
      const double x = i / pixels_per_degree;
      kernel.push_back(std::exp(-pi * pi * x * x / b));
    }
    return kernel;
  };
  const auto volume = [](const FilterKernel& kernel, double amplitude, double b) {
    double sum = 0;
    for (const double weight : kernel) sum += weight;
    return amplitude * std::sqrt(pi / b) * sum * sum;
  };
  const FilterKernel wide = gaussian(s.b1), narrow = gaussian(s.b2);
  const double of_wide = volume(wide, s.a1, s.b1), of_narrow = volume(narrow, s.a2, s.b2);
  Channel out = filtered(in, scaled_to_one(wide), scaled_to_one(wide));
  if (of_narrow == 0) return out;
  const Channel second = filtered(in, scaled_to_one(narrow), scaled_to_one(narrow));
  const double share = of_narrow / (of_wide + of_narrow);
  for (std::size_t i = 0; i < out.values.size(); ++i) out.values[i] += share * (second.values[i] - out.values[i]);
  return out;
}

/// The strength of an edge or a point at each pixel: first or second derivatives of a Gaussian as wide as the eye's
/// detectors.
std::vector<double> features(const Channel& y, bool points, double pixels_per_degree) {
  constexpr double width = 0.082;  // degrees, from peak to trough
  const double sd = 0.5 * width * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3 * sd));
  FilterKernel along, beside;
  double positive = 0, negative = 0;
  for (int i = -radius; i <= radius; ++i) {
    const double g = std::exp(-i * i / (2 * sd * sd)), weight = points ? (i * i / (sd * sd) - 1) * g : -i * g;
    beside.push_back(g), along.push_back(weight);
    (weight > 0 ? positive : negative) += std::abs(weight);
  }
  for (double& weight : along) weight /= weight > 0 ? positive : negative;
  beside = scaled_to_one(beside);
  const Channel dx = filtered(y, along, beside), dy = filtered(y, beside, along);
  std::vector<double> strength(y.values.size());
  for (std::size_t i = 0; i < strength.size(); ++i) strength[i] = std::hypot(dx.values[i], dy.values[i]);
  return strength;
}

struct Prepared {
  std::vector<Vec3d> colours;  ///< adjusted L*a*b*
  std::vector<double> edges, points;
};

Prepared prepared(const Image& image, double pixels_per_degree) {
  std::array<Channel, 3> planes;
  for (Channel& plane : planes) plane = {image.width, image.height, {}};
  Channel light{image.width, image.height, {}};
  for (const Rgb<float>& pixel : image.pixels) {
    Rgbd c(pixel);
    for (int i = 0; i < 3; ++i) c[i] = std::clamp(c[i], 0.0, 1.0);
    const Vec3d opponent = opponent_of(c);
    for (int i = 0; i < 3; ++i) planes[static_cast<std::size_t>(i)].values.push_back(opponent[i]);
    light.values.push_back((opponent.x + 16) / 116);
  }
  for (std::size_t i = 0; i < 3; ++i) planes[i] = seen(planes[i], sensitivities[i], pixels_per_degree);
  Prepared out{{}, features(light, false, pixels_per_degree), features(light, true, pixels_per_degree)};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    Rgbd rgb = rgb_of_opponent({planes[0].values[i], planes[1].values[i], planes[2].values[i]});
    for (int k = 0; k < 3; ++k) rgb[k] = std::clamp(rgb[k], 0.0, 1.0);
    out.colours.push_back(adjusted_lab_of(rgb));
  }
  return out;
}

}  // namespace

std::vector<float> flip_map(const Image& reference, const Image& test, double pixels_per_degree) {
  constexpr double colour_exponent = 0.7, feature_exponent = 0.5;
  constexpr double pc = 0.4, pt = 0.95;  // errors up to 0.4 of the largest fill 0.95 of the range
  const double largest = std::pow(hyab(adjusted_lab_of({0, 1, 0}), adjusted_lab_of({0, 0, 1})), colour_exponent);
  const Prepared a = prepared(reference, pixels_per_degree), b = prepared(test, pixels_per_degree);
  std::vector<float> map;
  map.reserve(a.colours.size());
  for (std::size_t i = 0; i < a.colours.size(); ++i) {
    const double power = std::pow(hyab(a.colours[i], b.colours[i]), colour_exponent), knee = pc * largest;
    const double colour = power < knee ? pt / knee * power : pt + (power - knee) / (largest - knee) * (1 - pt);
    const double feature = std::max(std::abs(a.edges[i] - b.edges[i]), std::abs(a.points[i] - b.points[i]));
    const double stands_out = std::pow(feature / std::numbers::sqrt2, feature_exponent);
    map.push_back(static_cast<float>(std::pow(std::min(colour, 1.0), 1 - stands_out)));
  }
  return map;
}

}  // namespace raywalk
