// The test of chi-square for directions that are drawn.
#pragma once

#include "math/sampler.h"
#include "math/sampling.h"
#include "support/effort.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace raywalk::test {

// How many standard deviations the counts of n directions are off their density, over cells of the whole sphere.
// `pdf`: of a direction. `draw`: from a pair of random numbers; none where it leads nowhere, which the density need
// not know of.
template <class Pdf, class Draw>
double chi_square_deviation(std::uint32_t n, const Pdf& pdf, const Draw& draw) {
  constexpr int bands = 48, sectors = 16, fine = sanitized ? 12 : 24;
  constexpr double least = 10;
  const auto cell_of = [](double z, double turn) {
    const int band = std::min(static_cast<int>((z + 1) / 2 * bands), bands - 1);
    const int sector = std::min(static_cast<int>((turn / (2 * pi_v<double>)+0.5) * sectors), sectors - 1);
    return static_cast<std::size_t>(band * sectors + sector);
  };
  std::vector<double> expected(bands * sectors), held(bands * sectors);
  for (int i = 0; i < bands * fine; ++i)
    for (int j = 0; j < sectors * fine; ++j) {
      const double z = (i + 0.5) / (bands * fine) * 2 - 1, sin = std::sqrt(1 - z * z);
      const double turn = ((j + 0.5) / (sectors * fine) - 0.5) * 2 * pi_v<double>;
      const double cell = 4 * pi_v<double> / (bands * fine * sectors * fine);
      expected[cell_of(z, turn)] += pdf(Vec3d(sin * std::cos(turn), sin * std::sin(turn), z)) * cell * n;
    }
  for (std::uint32_t i = 0; i < n; ++i) {
    RandomKey key{};
    key.sample = i;
    const std::optional<Vec3d> d = draw(draw_pair<double>(Sampler::random, key, Strata(n)));
    if (d) ++held[cell_of(d->z, std::atan2(d->y, d->x))];
  }
  double chi = 0, pooled_expected = 0, pooled_held = 0;
  int freedom = -1;  // what leads nowhere is not counted, but its share is not known either
  for (std::size_t c = 0; c < held.size(); ++c) {
    if (expected[c] < least) {
      pooled_expected += expected[c], pooled_held += held[c];
      continue;
    }
    chi += (held[c] - expected[c]) * (held[c] - expected[c]) / expected[c];
    ++freedom;
  }
  if (pooled_expected > least) {
    chi += (pooled_held - pooled_expected) * (pooled_held - pooled_expected) / pooled_expected;
    ++freedom;
  }
  // Wilson and Hilferty: the cube root of chi-square over its freedom is nearly normal.
  const double f = freedom;
  return (std::cbrt(chi / f) - (1 - 2 / (9 * f))) / std::sqrt(2 / (9 * f));
}

}  // namespace raywalk::test
