#include "math/random.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <set>
#include <vector>

#include "support/catch.h"

using namespace raywalk;

namespace {

// Chi-square of counts against equal expectations. For k cells it has mean k - 1 and deviation sqrt(2 (k - 1)).
template <class Counts>
double chi_square(const Counts& counts) {
  double total = 0, sum = 0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

// Every way to step through keys: one field runs, the others stand still.
RandomKey key_along(int field, std::uint32_t i) {
  RandomKey key{7, 3, -5, 2, 1, 11, 4};
  switch (field) {
    case 0:
      key.seed = i;
      break;
    case 1:
      key.pixel_x = static_cast<std::int32_t>(2 * i) - 50000;
      break;
    case 2:
      key.pixel_y = static_cast<std::int32_t>(2 * i) - 50000;
      break;
    case 3:
      key.sample = i;
      break;
    case 4:
      key.effect = i;
      break;
    case 5:
      key.path = i;
      break;
    case 6:
      key.dimension = i;
      break;
  }
  return key;
}
constexpr int fields = 7;

}  // namespace

TEST_CASE("a random number is a pure function of its key, known on every machine") {
  // Were these to change, every picture with random samples would.
  CHECK(detail::mix(0) == 0xe220a8397b1dcdafu);  // SplitMix64's first output from seed 0
  constexpr RandomKey key{1, -2, 3, 4, 5, 6, 7};
  static_assert(random_unit<double>(key) * 0x1p24 == 14689196);  // as computed by a program in another language
  for (int again = 0; again < 3; ++again) {
    CHECK(random_unit<double>(key) * 0x1p24 == 14689196);
    CHECK(random_unit<double>(RandomKey{}) != random_unit<double>(key));
  }
}

TEST_CASE("float and double runs draw the same numbers, in [0, 1)") {
  for (std::uint32_t i = 0; i < 20000; ++i) {
    const RandomKey key = key_along(static_cast<int>(i % fields), i);
    const double u = random_unit<double>(key);
    if (!(u >= 0 && u < 1)) FAIL("not in [0, 1): " << u);
    if (static_cast<double>(random_unit<float>(key)) != u) FAIL("float draws another number at " << i);
  }
}

TEST_CASE("each field of the key matters, and each gives uniform numbers") {
  const int field = GENERATE(range(0, fields));
  CAPTURE(field);
  constexpr int n = 50000, cells = 256;
  std::vector<int> counts(cells), pairs(cells);
  std::set<double> distinct;
  double sum = 0, lag = 0, previous = 0.5;
  for (std::uint32_t i = 0; i < n; ++i) {
    const double u = random_unit<double>(key_along(field, i));
    distinct.insert(u);
    ++counts[static_cast<std::size_t>(u * cells)];
    ++pairs[static_cast<std::size_t>(previous * 16) * 16 + static_cast<std::size_t>(u * 16)];
    sum += u;
    lag += (u - 0.5) * (previous - 0.5);
    previous = u;
  }
  // 50,000 draws of 2^24 values collide about 75 times.
  CHECK(distinct.size() > n - 150);
  CHECK(distinct.size() < n - 25);
  // Five deviations each.
  CHECK(std::abs(sum / n - 0.5) < 5 / std::sqrt(12.0 * n));
  CHECK(std::abs(lag / n) < 5.0 / 12 / std::sqrt(1.0 * n));
  CHECK(std::abs(chi_square(counts) - 255) < 5 * std::sqrt(2 * 255.0));
  CHECK(std::abs(chi_square(pairs) - 255) < 5 * std::sqrt(2 * 255.0));
}

TEST_CASE("mirrored pixels draw different numbers") {
  int equal = 0;
  for (std::int32_t i = 1; i < 500; ++i)
    for (const std::int32_t sign : {1, -1}) {
      const RandomKey a{0, i, sign * 3}, b{0, -i, sign * 3}, swapped{0, sign * 3, i};
      equal += random_unit<double>(a) == random_unit<double>(b);
      equal += random_unit<double>(a) == random_unit<double>(swapped) && i != sign * 3;
    }
  CHECK(equal <= 1);
}

TEST_CASE("small fields do not make up for each other: no two keys draw alike") {
  // Paths count up in `path`, where a path and an effect could else be mistaken for another path and another effect.
  std::set<std::uint64_t> all;
  std::size_t keys = 0;
  for (std::uint64_t path = 0; path < 40; ++path)
    for (std::uint32_t effect = 0; effect < 16; ++effect)
      for (std::uint32_t sample = 0; sample < 40; ++sample)
        for (std::uint32_t dimension = 0; dimension < 6; ++dimension, ++keys) {
          const RandomKey key{0, 0, 0, sample, effect, path, dimension};
          all.insert(detail::random_64(detail::common_bits(key), dimension));
        }
  CHECK(all.size() == keys);
}
