#include "math/sampler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "support/catch.h"

using namespace raywalk;

namespace {

constexpr Sampler samplers[] = {Sampler::random, Sampler::jittered, Sampler::sobol};

std::vector<Vec2d> points(Sampler sampler, RandomKey key, std::uint32_t count) {
  static std::map<std::uint32_t, Strata> known;
  const Strata& strata = known.try_emplace(count, count).first->second;
  std::vector<Vec2d> all;
  for (key.sample = 0; key.sample < count; ++key.sample) all.push_back(draw_pair<double>(sampler, key, strata));
  return all;
}

std::vector<double> numbers(Sampler sampler, RandomKey key, std::uint32_t count) {
  std::vector<double> all;
  for (key.sample = 0; key.sample < count; ++key.sample) all.push_back(draw<double>(sampler, key, count));
  return all;
}

// The i-th of many keys that differ in one field each: seed, pixel, effect, path and dimension in turn.
RandomKey key_number(std::uint32_t i) {
  const std::uint32_t n = 1 + i / 6;
  RandomKey key{3, 5, -7, 0, 2, 9, 0};
  switch (i % 6) {
    case 0:
      key.seed += n;
      break;
    case 1:
      key.pixel_x += static_cast<std::int32_t>(2 * n);
      break;
    case 2:
      key.pixel_y += static_cast<std::int32_t>(2 * n);
      break;
    case 3:
      key.effect += n;
      break;
    case 4:
      key.path = child_path(key.path, n);
      break;
    case 5:
      key.dimension += 2 * n;
      break;
  }
  return key;
}

// Whether every cell of a columns x rows grid over the unit square holds exactly one of the points.
bool one_in_each(const std::vector<Vec2d>& all, std::size_t begin, std::size_t columns, std::size_t rows) {
  std::vector<int> held(columns * rows);
  for (std::size_t i = begin; i < begin + columns * rows; ++i)
    ++held[static_cast<std::size_t>(all[i].x * static_cast<double>(columns)) * rows +
           static_cast<std::size_t>(all[i].y * static_cast<double>(rows))];
  return std::all_of(held.begin(), held.end(), [](int count) { return count == 1; });
}

double chi_square(const std::vector<int>& counts) {
  double total = 0, sum = 0;
  for (const int count : counts) total += count;
  const double expected = total / static_cast<double>(counts.size());
  for (const int count : counts) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

// T. Warnock's formula (1972): the root mean square, over all boxes [0, x) x [0, y), of the share of points in the box
// less its area.
double l2_discrepancy(const std::vector<Vec2d>& all) {
  const double n = static_cast<double>(all.size());
  double pairs = 0, singles = 0;
  for (const Vec2d& p : all) {
    singles += (1 - p.x * p.x) * (1 - p.y * p.y);
    for (const Vec2d& q : all) pairs += (1 - std::max(p.x, q.x)) * (1 - std::max(p.y, q.y));
  }
  return std::sqrt(1.0 / 9 - singles / (2 * n) + pairs / (n * n));
}

// Of a function's mean over n samples, the root mean square error over many keys.
template <class F>
double error_of_mean(Sampler sampler, std::uint32_t n, double truth, F&& f) {
  double squares = 0;
  constexpr std::uint32_t keys = 300;
  for (std::uint32_t k = 0; k < keys; ++k) {
    double sum = 0;
    for (const Vec2d& p : points(sampler, key_number(k), n)) sum += f(p);
    squares += (sum / n - truth) * (sum / n - truth);
  }
  return std::sqrt(squares / keys);
}

}  // namespace

TEST_CASE("Sobol: every elementary interval of a 2^m block holds exactly one point") {
  constexpr std::uint32_t count = 4096;
  for (std::uint32_t k = 0; k < 24; ++k) {
    const std::vector<Vec2d> all = points(Sampler::sobol, key_number(k), count);
    for (std::size_t m = 0; m <= 12; ++m)
      for (std::size_t across = 0; across <= m; ++across)
        for (std::size_t begin = 0; begin < count; begin += std::size_t{1} << m)
          if (!one_in_each(all, begin, std::size_t{1} << across, std::size_t{1} << (m - across)))
            FAIL("key " << k << ", block of 2^" << m << " at " << begin << ", 2^" << across << " columns");
  }
  CHECK(one_in_each({{0.1, 0.2}, {0.7, 0.6}}, 0, 1, 2));
  CHECK_FALSE(one_in_each({{0.1, 0.2}, {0.7, 0.3}}, 0, 1, 2));
}

TEST_CASE("Sobol: single numbers fill every 2^m block evenly too") {
  for (std::uint32_t k = 0; k < 24; ++k) {
    const std::vector<double> all = numbers(Sampler::sobol, key_number(k), 1024);
    for (std::size_t m = 0; m <= 10; ++m)
      for (std::size_t begin = 0; begin < 1024; begin += std::size_t{1} << m) {
        std::set<double> cells;
        for (std::size_t i = begin; i < begin + (std::size_t{1} << m); ++i)
          cells.insert(std::floor(all[i] * std::ldexp(1.0, static_cast<int>(m))));
        if (cells.size() != std::size_t{1} << m) FAIL("key " << k << ", block of 2^" << m << " at " << begin);
      }
  }
}

TEST_CASE("jittered: one sample in each cell, exactly, for any count") {
  for (const std::uint32_t count : {1u, 2u, 3u, 4u, 7u, 9u, 15u, 16u, 17u, 100u, 120u, 121u, 1000u}) {
    std::size_t edge = 1;
    while ((edge + 1) * (edge + 1) <= count) ++edge;
    for (std::uint32_t k = 0; k < 60; ++k) {
      CAPTURE(count, k);
      const std::vector<Vec2d> all = points(Sampler::jittered, key_number(k), count);
      if (!one_in_each(all, 0, edge, edge)) FAIL("a cell of the grid without a sample");
      std::vector<int> held(count);
      for (const double u : numbers(Sampler::jittered, key_number(k), count))
        ++held[static_cast<std::size_t>(u * count)];
      if (std::count(held.begin(), held.end(), 1) != static_cast<std::ptrdiff_t>(count)) FAIL("a stretch without one");
    }
  }
}

TEST_CASE("jittered: the samples beyond the grid lie anywhere") {
  const Strata strata(8);
  std::vector<int> counts(64);
  for (std::uint32_t k = 0; k < 20000; ++k) {
    RandomKey key = key_number(k);
    key.sample = 4 + k % 4;
    const Vec2d p = draw_pair<double>(Sampler::jittered, key, strata);
    ++counts[static_cast<std::size_t>(p.x * 8) * 8 + static_cast<std::size_t>(p.y * 8)];
  }
  CHECK(std::abs(chi_square(counts) - 63) < 5 * std::sqrt(2 * 63.0));
}

TEST_CASE("every single sample of every sampler is uniform over keys, in both coordinates together") {
  const Strata strata(16);
  for (const Sampler sampler : samplers)
    for (const std::uint32_t sample : {0u, 1u, 5u, 15u}) {
      INFO(name_of(sampler) << ", sample " << sample);
      std::vector<int> counts(256), single(256), low(256);
      for (std::uint32_t k = 0; k < 60000; ++k) {
        RandomKey key = key_number(k);
        key.sample = sample;
        const Vec2d p = draw_pair<double>(sampler, key, strata);
        ++counts[static_cast<std::size_t>(p.x * 16) * 16 + static_cast<std::size_t>(p.y * 16)];
        ++single[static_cast<std::size_t>(draw<double>(sampler, key, 16) * 256)];
        // The last eight digits as well: a scramble must reach them all.
        ++low[static_cast<std::size_t>(p.y * 0x1p24) & 255];
      }
      for (const auto* held : {&counts, &single, &low}) CHECK(std::abs(chi_square(*held) - 255) < 5 * std::sqrt(510.0));
    }
}

TEST_CASE("samples of two keys are independent: pixels, effects, paths, dimensions") {
  // Pairs made of one number from each key, sample by sample: the joint square must be filled as by chance. The same
  // order or the same strata in both would fill its diagonal.
  for (const Sampler sampler : samplers)
    for (std::uint32_t field = 0; field < 6; ++field) {
      INFO(name_of(sampler) << ", field " << field);
      std::vector<int> joint(256), singles(256);
      double correlation = 0;
      constexpr std::uint32_t keys = 1500, count = 16;
      for (std::uint32_t k = 0; k < keys; ++k) {
        const std::vector<Vec2d> a = points(sampler, key_number(6 * k + field), count),
                                 b = points(sampler, key_number(6 * (k + 1) + field), count);
        const std::vector<double> c = numbers(sampler, key_number(6 * k + field), count),
                                  d = numbers(sampler, key_number(6 * (k + 1) + field), count);
        for (std::size_t i = 0; i < count; ++i) {
          ++joint[static_cast<std::size_t>(a[i].x * 16) * 16 + static_cast<std::size_t>(b[i].x * 16)];
          ++singles[static_cast<std::size_t>(c[i] * 16) * 16 + static_cast<std::size_t>(d[i] * 16)];
          correlation += (a[i].x - 0.5) * (b[i].x - 0.5) + (a[i].y - 0.5) * (b[i].y - 0.5);
        }
      }
      // Both marginals are even, so the joint counts spread less than by chance, never more.
      CHECK(chi_square(joint) < 255 + 5 * std::sqrt(510.0));
      CHECK(chi_square(singles) < 255 + 5 * std::sqrt(510.0));
      CHECK(std::abs(correlation) < 5.0 / 12 * std::sqrt(2.0 * keys * count));
    }
}

TEST_CASE("the discrepancy of even samplers is far below that of random ones") {
  std::array<double, 3> mean{};
  for (std::uint32_t k = 0; k < 40; ++k)
    for (std::size_t s = 0; s < mean.size(); ++s)
      mean[s] += l2_discrepancy(points(samplers[s], key_number(k), 256)) / 40;
  const auto [random, jittered, sobol] = mean;
  // By chance the mean square is (1/4 - 1/9) / n.
  CHECK(random == Approx(std::sqrt((1.0 / 4 - 1.0 / 9) / 256)).epsilon(0.1));
  CHECK(jittered < 0.35 * random);
  CHECK(sobol < 0.12 * random);
}

TEST_CASE(
    "jittered: which cell a sample of one effect comes into tells nothing of another effect's, nor of its "
    "neighbour's") {
  for (const std::uint32_t edge : {3u, 4u}) {
    const Strata strata(edge * edge);
    const std::size_t cells = std::size_t{edge} * edge;
    const auto cell = [&](const RandomKey& key) {
      const Vec2d p = draw_pair<double>(Sampler::jittered, key, strata) * static_cast<double>(edge);
      return static_cast<std::size_t>(p.y) * edge + static_cast<std::size_t>(p.x);
    };
    std::vector<int> effects(cells * cells), samples(cells * (cells - 1));
    for (std::uint32_t k = 0; k < 60000; ++k) {
      RandomKey key = key_number(k), other = key;
      key.sample = other.sample = k % 7;
      other.effect += 100;
      RandomKey next = key;
      ++next.sample;
      ++effects[cell(key) * cells + cell(other)];
      // Never the same; else all of them alike.
      ++samples[cell(key) * (cells - 1) + (cell(next) + cells - cell(key)) % cells - 1];
    }
    for (const auto* held : {&effects, &samples}) {
      const double freedom = static_cast<double>(held->size()) - 1;
      CHECK(std::abs(chi_square(*held) - freedom) < 5 * std::sqrt(2 * freedom));
    }
  }
}

TEST_CASE("errors fall as theory has it: -1/2 random, about -1 jittered and below it Sobol, for a smooth function") {
  const auto smooth = [](const Vec2d& p) { return std::exp(p.x) * std::sin(2 * p.y); };
  const double truth = (std::exp(1.0) - 1) * (1 - std::cos(2.0)) / 2;
  const auto slope = [&](Sampler sampler) {
    return std::log(error_of_mean(sampler, 1024, truth, smooth) / error_of_mean(sampler, 16, truth, smooth)) /
           std::log(1024.0 / 16);
  };
  CHECK(slope(Sampler::random) == Approx(-0.5).margin(0.05));
  CHECK(slope(Sampler::jittered) == Approx(-1).margin(0.07));
  CHECK(slope(Sampler::sobol) < -1.25);
}

TEST_CASE("float and double draw the same numbers; random is random_unit itself") {
  const Strata strata(50);
  for (const Sampler sampler : samplers)
    for (std::uint32_t k = 0; k < 3000; ++k) {
      RandomKey key = key_number(k);
      key.sample = k % 50;
      const Vec2d pair = draw_pair<double>(sampler, key, strata);
      const double one = draw<double>(sampler, key, 50);
      for (const double u : {pair.x, pair.y, one})
        if (!(u >= 0 && u < 1) || std::floor(u * 0x1p24) != u * 0x1p24) FAIL("no multiple of 2^-24 in [0, 1): " << u);
      if (Vec2d(draw_pair<float>(sampler, key, strata)) != pair) FAIL("float draws another pair");
      if (static_cast<double>(draw<float>(sampler, key, 50)) != one) FAIL("float draws another number");
      if (sampler != Sampler::random) continue;
      if (one != random_unit<double>(key) || pair.x != one) FAIL("not random_unit's numbers");
      if (RandomPairs(key).draw<double>(key.dimension) != pair) FAIL("another pair where the hash is shared");
    }
}

TEST_CASE("samples are a pure function of their key, known on every machine") {
  // Were these to change, every picture with such samples would. As computed by a program in another language, which
  // takes Pascal's triangle mod 2 for the second coordinate's matrix.
  const RandomKey key{1, -2, 3, 4, 5, 6, 7};
  const auto steps = [](const Vec2d& p) { return Vec2d(p.x * 0x1p24, p.y * 0x1p24); };
  for (int again = 0; again < 2; ++again) {
    CHECK(draw<double>(Sampler::jittered, key, 9) * 0x1p24 == 14681078);
    CHECK(steps(draw_pair<double>(Sampler::jittered, key, Strata(9))) == Vec2d(4896399, 7968957));
    CHECK(draw<double>(Sampler::sobol, key, 9) * 0x1p24 == 15626890);
    CHECK(steps(draw_pair<double>(Sampler::sobol, key, Strata(9))) == Vec2d(15626890, 11577516));
  }
}

TEST_CASE("more samples than there are cells, and very many, still draw") {
  RandomKey key{};
  key.sample = 4000000000u;
  for (const Sampler sampler : samplers)
    for (const std::uint32_t count : {1u, 5u, 4000000001u, 0xffffffffu}) {
      const Vec2d p = draw_pair<double>(sampler, key, Strata(count));
      CHECK((p.x >= 0 && p.x < 1 && p.y >= 0 && p.y < 1));
      CHECK((draw<double>(sampler, key, count) >= 0 && draw<double>(sampler, key, count) < 1));
    }
}

TEST_CASE("paths of a ray tree are all different") {
  // Three branches to depth 9: 29,523 rays below the primary one.
  std::vector<std::uint64_t> level{0};
  std::set<std::uint64_t> all{0};
  for (int depth = 0; depth < 9; ++depth) {
    std::vector<std::uint64_t> next;
    for (const std::uint64_t path : level)
      for (std::uint32_t branch = 0; branch < 3; ++branch) next.push_back(child_path(path, branch));
    all.insert(next.begin(), next.end());
    level = std::move(next);
  }
  CHECK(all.size() == 29524);
}
