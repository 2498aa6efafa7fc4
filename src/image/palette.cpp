#include "image/palette.h"

#include "image/srgb.h"
#include "math/elementary.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>
#include <utility>

namespace raywalk {

namespace {

/// A colour of the image.
struct Shade {
  Rgb24 colour = 0;
  std::uint32_t count = 0;  ///< pixels that have it
  float weight = 0;
  Lab lab{};
};

float squared_distance(const Lab& a, const Lab& b) {
  const float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
  return x * x + y * y + z * z;
}

std::vector<Shade> shades_of(std::vector<Rgb24> pixels) {
  std::sort(pixels.begin(), pixels.end());
  std::vector<Shade> shades;
  for (auto from = pixels.begin(); from != pixels.end();) {
    const auto to = std::upper_bound(from, pixels.end(), *from);
    const auto count = static_cast<std::uint32_t>(to - from);
    // The root gives thin lines and small highlights more weight than their few pixels.
    shades.push_back({*from, count, std::sqrt(static_cast<float>(count)), lab_of(*from)});
    from = to;
  }
  return shades;
}

/// The mean of shades, their principal axis, and their variance along it.
struct ColourSpread {
  std::array<double, 3> mean{}, axis{};
  double error = 0;  ///< weight times squared distance along the axis
};

ColourSpread spread_of(std::span<const Shade> shades) {
  double weight = 0;
  ColourSpread spread;
  for (const Shade& shade : shades) {
    weight += shade.weight;
    for (std::size_t i = 0; i < 3; ++i) spread.mean[i] += shade.weight * shade.lab[i];
  }
  for (double& m : spread.mean) m /= weight;
  std::array<std::array<double, 3>, 3> moments{};
  for (const Shade& shade : shades)
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        moments[i][j] += shade.weight * (shade.lab[i] - spread.mean[i]) * (shade.lab[j] - spread.mean[j]);
  // The principal eigenvector, by power iteration from the largest column.
  const auto largest = [&](std::size_t a, std::size_t b) { return moments[a][a] < moments[b][b] ? b : a; };
  spread.axis = moments[largest(0, largest(1, 2))];
  constexpr int rounds = 8;
  for (int round = 0; round < rounds; ++round) {
    std::array<double, 3> next{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) next[i] += moments[i][j] * spread.axis[j];
    const double length = std::sqrt(next[0] * next[0] + next[1] * next[1] + next[2] * next[2]);
    if (!(length > 0)) break;
    for (double& x : next) x /= length;
    spread.axis = next;
    spread.error = length;
  }
  return spread;
}

/// Splits the cluster of largest variance until there are `most`, and returns their means (M. Orchard and C. Bouman,
/// "Color quantization of images", 1991). Reorders the shades.
std::vector<Lab> clusters(std::span<Shade> shades, std::size_t most) {
  struct Cluster {
    std::span<Shade> shades;
    ColourSpread spread;
  };
  if (shades.empty()) return {};
  std::vector<Cluster> all{{shades, spread_of(shades)}};
  while (all.size() < most) {
    Cluster& widest = *std::max_element(
        all.begin(), all.end(), [](const Cluster& a, const Cluster& b) { return a.spread.error < b.spread.error; });
    const auto middle = std::partition(widest.shades.begin(), widest.shades.end(), [&](const Shade& shade) {
      double along = 0;
      for (std::size_t i = 0; i < 3; ++i) along += (shade.lab[i] - widest.spread.mean[i]) * widest.spread.axis[i];
      return along < 0;
    });
    const std::span<Shade> low(widest.shades.begin(), middle), high(middle, widest.shades.end());
    if (low.empty() || high.empty()) break;
    widest = {low, spread_of(low)};
    all.push_back({high, spread_of(high)});
  }
  std::vector<Lab> means;
  for (const Cluster& cluster : all) {
    const auto& mean = cluster.spread.mean;
    means.push_back({static_cast<float>(mean[0]), static_cast<float>(mean[1]), static_cast<float>(mean[2])});
  }
  return means;
}

std::size_t nearest(std::span<const Lab> labs, const Lab& to) {
  std::size_t best = 0;
  float least = squared_distance(labs[0], to);
  for (std::size_t i = 1; i < labs.size(); ++i) {
    const float distance = squared_distance(labs[i], to);
    if (distance < least) least = distance, best = i;
  }
  return best;
}

/// Moves each of `labs` from the `fixed`th on to the mean of the shades that are nearest to it, a few times (S. Lloyd,
/// "Least squares quantization in PCM", 1982), and then to the nearest shade.
void settle(std::vector<Lab>& labs, std::size_t fixed, std::span<const Shade> shades) {
  constexpr int rounds = 4;
  for (int round = 0; round < rounds; ++round) {
    std::vector<std::array<float, 4>> sums(labs.size());
    for (const Shade& shade : shades) {
      std::array<float, 4>& sum = sums[nearest(labs, shade.lab)];
      for (std::size_t i = 0; i < 3; ++i) sum[i] += shade.weight * shade.lab[i];
      sum[3] += shade.weight;
    }
    for (std::size_t i = fixed; i < labs.size(); ++i)
      if (sums[i][3] > 0) labs[i] = {sums[i][0] / sums[i][3], sums[i][1] / sums[i][3], sums[i][2] / sums[i][3]};
  }
}

}  // namespace

Lab lab_of(Rgb24 colour) {
  static const std::array<double, 256> linear = [] {
    std::array<double, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = srgb_decode(static_cast<double>(i) / 255);
    return table;
  }();
  const double r = linear[(colour >> 16) & 255U], g = linear[(colour >> 8) & 255U], b = linear[colour & 255U];
  const auto cube_root = [](double x) { return portable::pow(x, 1.0 / 3); };
  const double l = cube_root(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = cube_root(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = cube_root(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {static_cast<float>(0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s),
          static_cast<float>(1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s),
          static_cast<float>(0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s)};
}

FramePalette::FramePalette(std::vector<Rgb24> pixels, int most) {
  const std::size_t pixel_count = pixels.size(), room = static_cast<std::size_t>(most);
  std::vector<Shade> shades = shades_of(std::move(pixels));
  mixture_of_.reserve(shades.size());

  // Colours that cover much come first, and are kept exactly.
  std::vector<Lab> labs;
  if (shades.size() <= room) {
    for (const Shade& shade : shades) colours_.push_back(shade.colour), labs.push_back(shade.lab);
  } else {
    const std::size_t least = pixel_count / 1000 + 1, pinned_most = room / 2;
    std::stable_sort(shades.begin(), shades.end(), [](const Shade& a, const Shade& b) { return a.count > b.count; });
    std::size_t pinned = 0;
    while (pinned < pinned_most && shades[pinned].count >= least) labs.push_back(shades[pinned++].lab);
    const std::span<Shade> rest = std::span(shades).subspan(pinned);
    for (const Lab& lab : clusters(rest, room - pinned)) labs.push_back(lab);
    settle(labs, pinned, rest);
    // Colours of the image.
    std::vector<std::pair<float, Rgb24>> best(labs.size(), {INFINITY, 0});
    for (const Shade& shade : shades) {
      const std::size_t at = nearest(labs, shade.lab);
      best[at] = std::min(best[at], {squared_distance(labs[at], shade.lab), shade.colour});
    }
    labs.clear();
    for (const auto& [distance, colour] : best)
      if (distance < INFINITY) colours_.push_back(colour), labs.push_back(lab_of(colour));
  }

  // Mixtures of a colour of the palette with its neighbours (T. Knoll's pattern dithering, US patent 6606166, expired).
  constexpr float unseen = 0.004f;
  constexpr std::size_t neighbours_most = 8;
  const std::size_t near_count = std::min(neighbours_most, labs.size());
  std::vector<std::vector<std::uint8_t>> neighbours(labs.size());
  const auto neighbours_of = [&](std::size_t of) -> const std::vector<std::uint8_t>& {
    std::vector<std::uint8_t>& found = neighbours[of];
    if (found.empty()) {
      found.resize(labs.size());
      std::iota(found.begin(), found.end(), std::uint8_t{0});
      std::partial_sort(found.begin(), found.begin() + static_cast<std::ptrdiff_t>(near_count), found.end(),
                        [&](std::uint8_t a, std::uint8_t b) {
                          return squared_distance(labs[a], labs[of]) < squared_distance(labs[b], labs[of]);
                        });
      found.resize(near_count);
    }
    return found;
  };
  for (const Shade& shade : shades) {
    const std::size_t base = nearest(labs, shade.lab);
    Mixture mixture;
    mixture.fill(static_cast<std::uint8_t>(base));
    if (squared_distance(labs[base], shade.lab) > unseen * unseen) {
      Lab owed{};
      for (std::uint8_t& part : mixture) {
        Lab wanted = shade.lab;
        for (std::size_t i = 0; i < 3; ++i) wanted[i] += owed[i];
        const std::vector<std::uint8_t>& around = neighbours_of(base);
        part = *std::min_element(around.begin(), around.end(), [&](std::uint8_t a, std::uint8_t b) {
          return squared_distance(labs[a], wanted) < squared_distance(labs[b], wanted);
        });
        for (std::size_t i = 0; i < 3; ++i) owed[i] += shade.lab[i] - labs[part][i];
      }
      std::sort(mixture.begin(), mixture.end(),
                [&](std::uint8_t a, std::uint8_t b) { return labs[a][0] < labs[b][0]; });
    }
    mixture_of_.emplace(shade.colour, static_cast<std::uint32_t>(mixtures_.size()));
    mixtures_.push_back(mixture);
  }
}

std::uint8_t FramePalette::index(Rgb24 colour, int column, int row) const {
  // Even, without a visible pattern: the fractional parts of multiples of 1/g and 1/g^2, g the root of g^3 = g + 1, in
  // 32 bits (M. Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018).
  const std::uint32_t threshold =
      static_cast<std::uint32_t>(column) * 3242174889U + static_cast<std::uint32_t>(row) * 2447445414U;
  return mixtures_[mixture_of_.at(colour)][threshold >> 28];
}

}  // namespace raywalk
