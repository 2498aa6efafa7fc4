#include "math/sampler.h"

#include <array>
#include <cmath>
#include <utility>

namespace raywalk {

namespace detail {

namespace {

constexpr int unit_bits = 24;
constexpr std::uint32_t unit = 1u << unit_bits;

/// The bits common to all samples of a key; `salt` distinguishes what is derived from them.
std::uint64_t wide_stream(const RandomKey& key, std::uint32_t salt) {
  constexpr std::uint64_t apart = 0x5bd1e995cc9e2d51u;  // independent of random_unit's numbers
  return mix(branch_bits(key) ^ apart ^ (static_cast<std::uint64_t>(key.dimension) << 32 | salt << 16));
}
std::uint32_t stream(const RandomKey& key, std::uint32_t salt) {
  return static_cast<std::uint32_t>(wide_stream(key, salt) >> 32);
}

/// Place of `i` in a permutation of 0..count-1 that `seed` chooses: a bijection of the next power of two, walked until
/// it comes back in range (A. Kensler, "Correlated Multi-Jittered Sampling", Pixar 2013). i < count.
std::uint32_t permuted(std::uint32_t i, std::uint32_t count, std::uint32_t seed) {
  std::uint32_t mask = count - 1;
  for (int shift = 1; shift < 32; shift *= 2) mask |= mask >> shift;
  do {
    i ^= seed;
    i *= 0xe170893du;
    i ^= seed >> 16;
    i ^= (i & mask) >> 4;
    i ^= seed >> 8;
    i *= 0x0929eb3fu;
    i ^= seed >> 23;
    i ^= (i & mask) >> 1;
    i *= 1 | seed >> 27;
    i *= 0x6935fa69u;
    i ^= (i & mask) >> 11;
    i *= 0x74dcb303u;
    i ^= (i & mask) >> 2;
    i *= 0x9e501cc3u;
    i ^= (i & mask) >> 2;
    i *= 0xc860a3dfu;
    i &= mask;
    i ^= i >> 5;
  } while (i >= count);
  const std::uint32_t turned = i + seed % count;
  return turned < count && turned >= i ? turned : turned - count;
}

/// The given number of permutations of edge * edge cells, one after the other. They are the same for every picture:
/// made on first use.
template <std::uint32_t orders, std::uint32_t edge>
const std::vector<std::uint8_t>& orders_of_edge() {
  static const std::vector<std::uint8_t> listed = [] {
    std::vector<std::uint8_t> all;
    for (std::uint32_t order = 0; order < orders; ++order)
      for (std::uint32_t i = 0; i < edge * edge; ++i)
        all.push_back(
            static_cast<std::uint8_t>(permuted(i, edge * edge, static_cast<std::uint32_t>(mix(order) >> 32))));
    return all;
  }();
  return listed;
}
template <std::uint32_t orders, std::uint32_t... edges>
const std::vector<std::uint8_t>& listed_orders(std::uint32_t edge,
                                               std::integer_sequence<std::uint32_t, edges...> /*known*/) {
  constexpr std::array of_edge{&orders_of_edge<orders, edges>...};
  return of_edge[edge]();
}

/// i * unit / cells, rounded up: where cell i of `cells` equal ones begins. Quotients of integers below 2^48 and 2^24
/// are further from the next integer than a double's rounding, and floating point divides faster than integers do.
std::uint32_t cell_begin(std::uint32_t i, std::uint32_t cells) {
  const std::int64_t whole = std::int64_t{i} * unit;
  const auto below = static_cast<std::int64_t>(static_cast<double>(whole) / cells);
  return static_cast<std::uint32_t>(below + (below * cells != whole));
}

/// A step of 2^-24 between two, by a random one of the whole interval. In integers, so that rounding moves nothing into
/// a neighbouring cell.
std::uint32_t between(std::uint32_t begin, std::uint32_t end, std::uint32_t random) {
  return begin + static_cast<std::uint32_t>(std::uint64_t{end - begin} * random >> unit_bits);
}

std::uint32_t reversed(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = (x & 0x0f0f0f0fu) << 4 | (x & 0xf0f0f0f0u) >> 4;
  x = (x & 0x33333333u) << 2 | (x & 0xccccccccu) >> 2;
  return (x & 0x55555555u) << 1 | (x & 0xaaaaaaaau) >> 1;
}

/// Owen's nested uniform scramble of the binary digits, the first digit being bit 0: each digit flips or not by a hash
/// of `seed` and the digits before it (S. Laine and T. Karras, "Stratified Sampling for Stochastic Transparency", EGSR
/// 2011; with N. Vegdahl's constants, 2021, which flip all digits evenly).
std::uint32_t owen_scrambled(std::uint32_t digits, std::uint32_t seed) {
  digits ^= digits * 0x3d20adeau;
  digits += seed;
  digits *= seed >> 16 | 1;
  digits ^= digits * 0x05526c56u;
  digits ^= digits * 0x53a22864u;
  return digits;
}

/// The second coordinate's digits from the index, both with the first at bit 0: digit j is the sum of those index bits
/// i for which the binomial (i over j) is odd. That is Sobol' with S. Joe and F. Kuo's direction numbers (2008) of the
/// polynomial x + 1 with m = 1. By E. Lucas (1878) the binomial is odd where the bits of j are among those of i, so
/// that one bit of i at a time will do (A. Ahmed, "An Implementation Algorithm of 2D Sobol Sequence", EGSR 2024). The
/// first coordinate's digits are the index itself.
std::uint32_t second_digits(std::uint32_t index) {
  index ^= index >> 1 & 0x55555555u;
  index ^= index >> 2 & 0x33333333u;
  index ^= index >> 4 & 0x0f0f0f0fu;
  index ^= index >> 8 & 0x00ff00ffu;
  return index ^ index >> 16;
}

/// The index of a sample's point: shuffled, so that dimension pairs are uncorrelated, while aligned blocks of 2^m stay
/// together (B. Burley, "Practical Hash-based Owen Scrambling", JCGT 9(4), 2020).
std::uint32_t shuffled_index(std::uint32_t sample, std::uint32_t seed) {
  return reversed(owen_scrambled(reversed(sample), seed));
}

}  // namespace

std::uint32_t draw_jittered(const RandomKey& key, std::uint32_t count) {
  const std::uint32_t random = random_24(common_bits(key), key.dimension);
  if (key.sample >= count || count > unit) return random;
  const std::uint32_t cell = permuted(key.sample, count, stream(key, 0));
  return between(cell_begin(cell, count), cell_begin(cell + 1, count), random);
}

std::uint32_t draw_sobol(const RandomKey& key) {
  return reversed(owen_scrambled(shuffled_index(key.sample, stream(key, 1)), stream(key, 2))) >> (32 - unit_bits);
}

SobolPairs::SobolPairs(const RandomKey& key)
    : shuffle_(stream(key, 1)), scramble_u_(stream(key, 2)), scramble_v_(stream(key, 3)) {}

DrawnPair draw_sobol_pair(const RandomKey& key) { return SobolPairs(key).drawn(key.sample); }

DrawnPair SobolPairs::drawn(std::uint32_t sample) const {
  const std::uint32_t index = shuffled_index(sample, shuffle_);
  const std::uint32_t u = owen_scrambled(index, scramble_u_), v = owen_scrambled(second_digits(index), scramble_v_);
  return {reversed(u) >> (32 - unit_bits), reversed(v) >> (32 - unit_bits)};
}

}  // namespace detail

Strata::Strata(std::uint32_t count)
    : count_(count), edge_(static_cast<std::uint32_t>(std::sqrt(static_cast<double>(count)))) {  // sqrt rounds
                                                                                                 // correctly: exact
  for (std::uint32_t i = 0; i <= edge_; ++i) begins_.push_back(detail::cell_begin(i, edge_));
  if (edge_ == 1 || edge_ * edge_ > max_listed) return;
  static_assert(max_listed == 16 * 16);
  listed_ = &detail::listed_orders<orders>(edge_, std::make_integer_sequence<std::uint32_t, 17>{});
}

std::uint32_t Strata::Order::permuted(std::uint32_t sample) const { return detail::permuted(sample, cells_, seed_); }

Strata::Order Strata::order(std::uint64_t bits) const {
  Order order;
  order.cells_ = edge_ * edge_;
  if (listed_ == nullptr) {
    order.seed_ = static_cast<std::uint32_t>(bits >> 32);
    return order;
  }
  // Two of the precomputed orders, composed: 256 alone would be so few that correlations between samples show.
  const auto chosen = [&](std::uint64_t which) { return listed_->data() + which % orders * order.cells_; };
  const auto turn = [&](std::uint64_t by) { return static_cast<std::uint32_t>(by % (1u << 24) * order.cells_ >> 24); };
  order.first_ = chosen(bits), order.first_turn_ = turn(bits >> 16);
  order.second_ = chosen(bits >> 8), order.second_turn_ = turn(bits >> 40);
  return order;
}

SamplePairs::SamplePairs(Sampler sampler, const RandomKey& key, const Strata& strata)
    : sampler_(sampler), dimension_(key.dimension), branch_(detail::branch_bits(key)), strata_(&strata) {
  if (sampler == Sampler::jittered) order_ = strata.order(detail::wide_stream(key, 0));
  if (sampler == Sampler::sobol) sobol_ = detail::SobolPairs(key);
}

detail::DrawnPair SamplePairs::drawn(std::uint32_t sample) const {
  if (sampler_ == Sampler::sobol) return sobol_.drawn(sample);
  const auto [u, v] = detail::draw_random_pair(detail::common_bits(branch_, sample), dimension_);
  if (sampler_ == Sampler::random) return {u, v};
  const std::uint32_t edge = strata_->edge();
  if (sample >= edge * edge) return {u, v};
  const std::uint32_t cell = order_.cell_of(sample), row = cell / edge, column = cell - row * edge;
  return {detail::between(strata_->begin_of(column), strata_->begin_of(column + 1), u),
          detail::between(strata_->begin_of(row), strata_->begin_of(row + 1), v)};
}

}  // namespace raywalk
