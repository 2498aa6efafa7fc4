#pragma once
// Samplers: how the n samples of one pixel are distributed. Each number is a pure function of its key and of n, so
// neither order nor threads nor other draws can change it.

#include "math/random.h"
#include "math/vec.h"
#include "math/words.h"

#include <vector>

namespace raywalk {

enum class Sampler {
  random,    ///< independent samples
  jittered,  ///< pairs: one in each cell of a k x k grid, k the square root of n rounded down, the rest anywhere;
             ///< single numbers: one in each of n cells. Every key has an order of its own
  sobol,     ///< a (0, 2)-sequence: every 2^m samples from a multiple of 2^m on have one in each elementary interval
};
template <>
inline constexpr Word<Sampler> words_of<Sampler>[] = {
    {Sampler::random, "random"}, {Sampler::jittered, "jittered"}, {Sampler::sobol, "sobol"}};

/// The number of samples to distribute, and what follows from it: computed once for the many draws of a picture.
class Strata {
 public:
  explicit Strata(std::uint32_t count);  ///< count >= 1

  [[nodiscard]] std::uint32_t count() const { return count_; }
  /// The square root of the count, rounded down: there are edge x edge cells; further samples lie anywhere.
  [[nodiscard]] std::uint32_t edge() const { return edge_; }
  /// Where the cells along an edge begin, in steps of 2^-24; the one after the last is the end.
  [[nodiscard]] std::uint32_t begin_of(std::uint32_t cell) const { return begins_[cell]; }

  /// A permutation of the cells.
  class Order {
   public:
    /// The cell of a sample < edge * edge. Each order holds every cell once; over all choices of bits, every sample
    /// falls into all cells equally often, and any two samples into all pairs of cells equally often up to 2%.
    [[nodiscard]] std::uint32_t cell_of(std::uint32_t sample) const {
      return first_ == nullptr ? permuted(sample) : turned(second_[turned(first_[sample], first_turn_)], second_turn_);
    }

   private:
    friend class Strata;
    [[nodiscard]] std::uint32_t permuted(std::uint32_t sample) const;
    [[nodiscard]] std::uint32_t turned(std::uint32_t cell, std::uint32_t turn) const {
      return cell + turn < cells_ ? cell + turn : cell + turn - cells_;
    }
    const std::uint8_t *first_ = nullptr, *second_ = nullptr;  ///< two of the precomputed orders, composed; or null
    std::uint32_t first_turn_ = 0, second_turn_ = 0;           ///< the rotation of each
    std::uint32_t cells_ = 1, seed_ = 0;
  };
  /// The order chosen by random bits.
  [[nodiscard]] Order order(std::uint64_t bits) const;

 private:
  static constexpr std::uint32_t orders = 256, max_listed = 256;
  std::uint32_t count_, edge_;
  std::vector<std::uint32_t> begins_;
  /// The precomputed orders for this edge, one after the other; null where there are too many cells.
  const std::vector<std::uint8_t>* listed_ = nullptr;
};

namespace detail {

/// Numbers in [0, 2^24): the interval [0, 1) in steps of 2^-24.
struct DrawnPair {
  std::uint32_t u, v;
};
[[nodiscard]] inline DrawnPair draw_random_pair(std::uint64_t common, std::uint32_t dimension) {
  const std::uint64_t bits = random_64(common, dimension);
  return {static_cast<std::uint32_t>(bits >> 40), static_cast<std::uint32_t>(bits >> 16 & 0xffffff)};
}
[[nodiscard]] std::uint32_t draw_jittered(const RandomKey& key, std::uint32_t count);
[[nodiscard]] std::uint32_t draw_sobol(const RandomKey& key);
[[nodiscard]] DrawnPair draw_sobol_pair(const RandomKey& key);

/// The pairs of Sampler::sobol for one key: what its samples have in common is computed once.
class SobolPairs {
 public:
  SobolPairs() = default;
  explicit SobolPairs(const RandomKey& key);
  [[nodiscard]] DrawnPair drawn(std::uint32_t sample) const;

 private:
  std::uint32_t shuffle_ = 0, scramble_u_ = 0, scramble_v_ = 0;
};

template <class T>
[[nodiscard]] constexpr T unit_of(std::uint32_t drawn) {
  return static_cast<T>(drawn) * static_cast<T>(1.0 / 16777216.0);
}
template <class T>
[[nodiscard]] constexpr Vec2<T> units_of(const DrawnPair& drawn) {
  return {unit_of<T>(drawn.u), unit_of<T>(drawn.v)};
}

}  // namespace detail

/// Sample `key.sample` of `count` (>= 1) in [0, 1), a multiple of 2^-24, the same for float and double. Uniform for
/// each key; keys that differ in more than the sample are independent of each other.
template <class T>
[[nodiscard]] T draw(Sampler sampler, const RandomKey& key, std::uint32_t count) {
  switch (sampler) {
    case Sampler::random:
      break;
    case Sampler::jittered:
      return detail::unit_of<T>(detail::draw_jittered(key, count));
    case Sampler::sobol:
      return detail::unit_of<T>(detail::draw_sobol(key));
  }
  return random_unit<T>(key);
}

/// strata.count() pairs that fill the unit square evenly, one for each sample (the key's own sample is ignored). What
/// they have in common is computed once. Uses dimensions `key.dimension` and the one after it.
class SamplePairs {
 public:
  SamplePairs() = default;
  /// `strata` must outlive this.
  SamplePairs(Sampler sampler, const RandomKey& key, const Strata& strata);

  template <class T>
  [[nodiscard]] Vec2<T> draw(std::uint32_t sample) const {
    return detail::units_of<T>(drawn(sample));
  }

 private:
  [[nodiscard]] detail::DrawnPair drawn(std::uint32_t sample) const;

  Sampler sampler_ = Sampler::random;
  std::uint32_t dimension_ = 0;
  std::uint64_t branch_ = 0;
  detail::SobolPairs sobol_;
  const Strata* strata_ = nullptr;
  Strata::Order order_;
};

/// A single pair. Always inlined: otherwise it would depend on what else a kernel's file holds.
template <class T>
[[nodiscard, gnu::always_inline]] inline Vec2<T> draw_pair(Sampler sampler, const RandomKey& key,
                                                           const Strata& strata) {
  if (sampler == Sampler::sobol) return detail::units_of<T>(detail::draw_sobol_pair(key));
  return SamplePairs(sampler, key, strata).draw<T>(key.sample);
}

/// The pairs of Sampler::random for one key in any dimension: what they have in common is computed once.
class RandomPairs {
 public:
  RandomPairs() = default;
  explicit RandomPairs(const RandomKey& key) : common_(detail::common_bits(key)) {}

  /// As draw_pair of the key with this dimension.
  template <class T>
  [[nodiscard]] Vec2<T> draw(std::uint32_t dimension) const {
    return detail::units_of<T>(detail::draw_random_pair(common_, dimension));
  }

 private:
  std::uint64_t common_ = 0;
};

}  // namespace raywalk
