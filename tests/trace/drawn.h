// Random pairs for the tests of what is drawn.
#pragma once

#include "math/sampler.h"

namespace raywalk::test {

// The pair of a sample in [0, 1)^2, by Sobol's points, which many samples fill evenly.
inline Vec2d drawn(std::uint32_t sample, std::uint32_t dimension = 0) {
  RandomKey key{};
  key.seed = 23;
  key.sample = sample;
  key.dimension = dimension;
  return draw_pair<double>(Sampler::sobol, key, Strata(1u << 20));
}

}  // namespace raywalk::test
