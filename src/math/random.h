#pragma once

#include <cstdint>

namespace raywalk {

/// Identifies a random number. The number is a pure function of this key, so no draw depends on the order, the thread
/// or the number of other draws.
struct RandomKey {
  std::uint64_t seed = 0;
  std::int32_t pixel_x = 0, pixel_y = 0;  ///< the pixel's position relative to the image's centre
                                          ///< (trace/ray_generator.h)
  std::uint32_t sample = 0;
  std::uint32_t effect = 0;     ///< which effect draws
  std::uint64_t path = 0;       ///< place in the ray tree
  std::uint32_t dimension = 0;  ///< which of the draws of that effect there

  /// Another draw for the same sample.
  [[nodiscard]] constexpr RandomKey at(std::uint32_t of_effect, std::uint64_t of_path,
                                       std::uint32_t of_dimension) const {
    RandomKey key = *this;
    key.effect = of_effect, key.path = of_path, key.dimension = of_dimension;
    return key;
  }
};

namespace detail {

/// The finalizer of SplitMix64 (G. Steele, D. Lea and C. Flood 2014): a bijection that mixes every bit into every
/// other.
[[nodiscard]] constexpr std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15u;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
  return x ^ (x >> 31);
}

/// The bits common to all draws of a pixel. The odd factor separates the pixels of different seeds.
[[nodiscard]] constexpr std::uint64_t pixel_bits(const RandomKey& key) {
  return mix(key.seed * 0xd1342543de82ef95u ^
             (static_cast<std::uint64_t>(static_cast<std::uint32_t>(key.pixel_x)) << 32 |
              static_cast<std::uint32_t>(key.pixel_y)));
}
/// The bits common to the draws that differ only in sample and dimension. Paths count up or are already mixed: the odd
/// factor keeps even small ones from colliding with samples, dimensions and effects.
[[nodiscard]] constexpr std::uint64_t branch_bits(const RandomKey& key) {
  return pixel_bits(key) ^ key.path * 0x9fb21c651e98df25u ^ key.effect;
}
/// The bits common to the draws of a branch that differ only in dimension.
[[nodiscard]] constexpr std::uint64_t common_bits(std::uint64_t branch, std::uint32_t sample) {
  return mix(branch ^ static_cast<std::uint64_t>(sample) << 32);
}
[[nodiscard]] constexpr std::uint64_t common_bits(const RandomKey& key) {
  return common_bits(branch_bits(key), key.sample);
}
[[nodiscard]] constexpr std::uint64_t random_64(std::uint64_t common, std::uint32_t dimension) {
  return mix(common ^ dimension);
}
/// Uniform in [0, 2^24).
[[nodiscard]] constexpr std::uint32_t random_24(std::uint64_t common, std::uint32_t dimension) {
  return static_cast<std::uint32_t>(random_64(common, dimension) >> 40);
}

}  // namespace detail

/// The `path` of the `branch`-th ray spawned where the ray with `path` ends: distinct branches draw independently, and
/// no draw depends on how many others there are. A primary ray's path is 0.
[[nodiscard]] constexpr std::uint64_t child_path(std::uint64_t path, std::uint32_t branch) {
  return detail::mix(detail::mix(path) + branch);
}

/// Uniform in [0, 1), a multiple of 2^-24, so that float and double runs draw the same numbers.
template <class T>
[[nodiscard]] constexpr T random_unit(const RandomKey& key) {
  return static_cast<T>(detail::random_24(detail::common_bits(key), key.dimension)) * static_cast<T>(1.0 / 16777216.0);
}

}  // namespace raywalk
