// The photon map against brute force, and its estimates against the laws that hold for photons scattered at random: the
// circle to the k-th has Gamma(k) / density as its area, so that k / area is on average k / (k - 1) too large, while
// (k - 1) / area is right and has the relative variance 1 / (k - 2).

#include "trace/photon_map.h"

#include "math/random.h"
#include "support/catch.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace raywalk;

namespace {

const Vec3d upwards{0, 0, 1};

double number_of(int index, std::uint32_t dimension, std::uint64_t seed = 7) {
  RandomKey key;
  key.seed = seed;
  key.sample = static_cast<std::uint32_t>(index);
  key.dimension = dimension;
  return random_unit<double>(key);
}

Photon photon_at(double x, double y, double z = 0, const Vec3d& normal = upwards, double power = 1) {
  return {Vec3<float>(Vec3d(x, y, z)), Vec3<float>(normal), Rgb<float>(Rgbd(power))};
}

// In the unit square.
std::vector<Photon> scattered_photons(int count, std::uint64_t seed = 7) {
  std::vector<Photon> photons;
  for (int i = 0; i < count; ++i)
    photons.push_back(photon_at(number_of(i, 0, seed), number_of(i, 1, seed), 0, upwards, 1.0 / count));
  return photons;
}

double squared_way(const Photon& photon, const Vec3d& point) {
  const Vec3d apart = Vec3d(photon.position) - point;
  return dot(apart, apart);
}

struct DensitySpread {
  double mean = 0, variance = 0;
  int count = 0;
  void add(double value) {
    ++count;
    const double step = value - mean;
    mean += step / count;
    variance += (step * (value - mean) - variance) / count;
  }
  [[nodiscard]] double error() const { return std::sqrt(variance / count); }
};

// Of the density that the map tells at `count` places given by `place`; the true one is 1.
template <class Place>
DensitySpread density_estimates(const PhotonMap& map, int k, bool all_of_them, int count, Place place) {
  DensitySpread spread;
  for (int i = 0; i < count; ++i) {
    const PhotonsNear near = map.nearest(place(i), upwards, k);
    const double photons = all_of_them ? k : near.count;
    spread.add(photons / static_cast<double>(map.size()) * photon_density(near.squared_radius, false));
  }
  return spread;
}

}  // namespace

TEST_CASE("a search finds exactly the nearest photons") {
  std::vector<Photon> photons;
  for (int i = 0; i < 3000; ++i) {
    const Vec3d normal = number_of(i, 3) < 0.7 ? upwards : Vec3d(1, 0, 0);
    photons.push_back(photon_at(number_of(i, 0), number_of(i, 1), number_of(i, 2), normal, 1 + number_of(i, 4)));
  }
  // Many in one place, and many at equal distances: ties go by the order in which they came.
  for (int i = 0; i < 40; ++i) photons.push_back(photon_at(0.5, 0.5, 0.5, upwards, 0.25 * (i + 1)));
  for (int i = 0; i < 40; ++i) photons.push_back(photon_at(i % 2 == 0 ? 0.25 : 0.75, 0.5, 0.5, upwards, 0.5 * (i + 1)));
  const PhotonMap map(photons);
  REQUIRE(map.size() == photons.size());
  for (int i = 0; i < 200; ++i) {
    const Vec3d point = i == 0 ? Vec3d(0.5) : Vec3d(number_of(i, 5), number_of(i, 6), number_of(i, 7));
    for (const int k : {2, 5, 60}) {
      std::vector<double> squares;
      for (const Photon& photon : photons)
        if (photon.normal.z > 0.5) squares.push_back(squared_way(photon, point));
      std::nth_element(squares.begin(), squares.begin() + (k - 1), squares.end());
      const double square = squares[static_cast<std::size_t>(k) - 1];
      const PhotonsNear near = map.nearest(point, upwards, k);
      CHECK(near.count == k - 1);
      CHECK(near.squared_radius == square);
      double inside = 0;
      int nearer = 0;
      for (const Photon& photon : photons)
        if (photon.normal.z > 0.5 && squared_way(photon, point) < square) inside += photon.power.x, ++nearer;
      CHECK(near.power.x >= inside - 1e-9);
      if (nearer == k - 1) CHECK(near.power.x == Approx(inside));  // else several lie on the edge
    }
    const PhotonsNear within = map.within(point, upwards, 0.2);
    double power = 0;
    int count = 0;
    for (const Photon& photon : photons) {
      if (photon.normal.z <= 0.5 || !(squared_way(photon, point) <= 0.04)) continue;
      power += photon.power.x;
      ++count;
    }
    CHECK(within.count == count);
    CHECK(within.power.x == Approx(power));
  }
}

TEST_CASE("photons on the other side, or around a corner, tell nothing") {
  const PhotonMap map(
      {photon_at(0, 0, 0, upwards, 1), photon_at(0.1, 0, 0, -upwards, 2), photon_at(0.1, 0, 0, {1, 0, 0}, 4)});
  CHECK(map.within({0, 0, 0}, upwards, 1).power.x == 1);
  CHECK(map.within({0, 0, 0}, -upwards, 1).power.x == 2);
  CHECK(map.within({0, 0, 0}, Vec3d(1, 0, 0), 1).power.x == 4);
  CHECK(map.within({0, 0, 0}, std::nullopt, 1).power.x == 7);
}

TEST_CASE("no photon and few photons: the circle ends at its largest radius, and all inside count") {
  const PhotonMap none;
  CHECK(none.empty());
  CHECK(none.nearest({0, 0, 0}, upwards, 10, 1).count == 0);
  const PhotonMap few({photon_at(0.1, 0), photon_at(0.2, 0), photon_at(3, 0)});
  const PhotonsNear near = few.nearest({0, 0, 0}, upwards, 10, 1);
  CHECK(near.count == 2);
  CHECK(near.squared_radius == 1);
  CHECK(near.power.x == 2);
}

TEST_CASE("the same photons make the same map") {
  const std::vector<Photon> photons = scattered_photons(5000);
  const PhotonMap one(photons), other(photons);
  for (int i = 0; i < 50; ++i) {
    const Vec3d point(number_of(i, 2), number_of(i, 3), 0);
    CHECK(one.nearest(point, upwards, 50).power == other.nearest(point, upwards, 50).power);
  }
}

TEST_CASE("with k - 1 in place of k the density is unbiased, with relative variance 1 / (k - 2)") {
  const PhotonMap map(scattered_photons(400000));
  const auto inside = [](int i) { return Vec3d(0.1 + 0.8 * number_of(i, 2), 0.1 + 0.8 * number_of(i, 3), 0); };
  for (const int k : {5, 10, 20}) {
    INFO("k = " << k);
    constexpr int places = 6000;
    const DensitySpread right = density_estimates(map, k, false, places, inside),
                        with_all = density_estimates(map, k, true, places, inside);
    CHECK(std::abs(right.mean - 1) < 4 * right.error());
    CHECK(std::abs(with_all.mean - k / (k - 1.0)) < 4 * with_all.error());
    CHECK(std::abs(with_all.mean - 1) > 8 * with_all.error());
    // The fourth moment of k / Gamma is large: its own error is estimated generously.
    CHECK(right.variance == Approx(1 / (k - 2.0)).epsilon(k == 5 ? 0.25 : 0.1));
  }
}

TEST_CASE("at an edge half of the density is seen, in a corner a quarter") {
  constexpr int k = 10, count = 20000;
  DensitySpread edge, corner;
  const auto add = [&](DensitySpread& spread, const PhotonMap& map, const Vec3d& place) {
    const PhotonsNear near = map.nearest(place, upwards, k);
    spread.add(near.power.x * photon_density(near.squared_radius, false));
  };
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const PhotonMap map(scattered_photons(count, seed));
    for (int i = 0; i < 8; ++i) {  // too far apart to share photons
      add(edge, map, {0, 0.12 + 0.1 * i, 0});
      add(edge, map, {0.12 + 0.1 * i, 1, 0});
    }
    for (const double x : {0.0, 1.0})
      for (const double y : {0.0, 1.0}) add(corner, map, {x, y, 0});
  }
  CHECK(std::abs(edge.mean - 0.5) < 4 * edge.error());
  CHECK(edge.error() < 0.006);
  CHECK(std::abs(corner.mean - 0.25) < 4 * corner.error());
  CHECK(corner.error() < 0.006);
}

TEST_CASE("in a flat world the same laws hold for lengths") {
  std::vector<Photon> photons;
  constexpr int count = 100000, k = 10;
  for (int i = 0; i < count; ++i) photons.push_back(photon_at(number_of(i, 0), 0, 0, {0, 1, 0}, 1.0 / count));
  const PhotonMap map(photons);
  DensitySpread right, end;
  for (int i = 0; i < 4000; ++i) {
    const PhotonsNear near = map.nearest({0.1 + 0.8 * number_of(i, 2), 0, 0}, Vec3d(0, 1, 0), k);
    right.add(near.power.x * photon_density(near.squared_radius, true));
  }
  CHECK(std::abs(right.mean - 1) < 4 * right.error());
  CHECK(right.variance == Approx(1 / (k - 2.0)).epsilon(0.15));
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    std::vector<Photon> own;
    for (int i = 0; i < 500; ++i) own.push_back(photon_at(number_of(i, 0, seed), 0, 0, {0, 1, 0}, 1.0 / 500));
    const PhotonsNear near = PhotonMap(own).nearest({0, 0, 0}, Vec3d(0, 1, 0), k);
    end.add(near.power.x * photon_density(near.squared_radius, true));
  }
  CHECK(std::abs(end.mean - 0.5) < 4 * end.error());
}

TEST_CASE("sorting photons can be cancelled") {
  Stopper stopper;
  stopper.raised = true;
  CHECK_THROWS_AS(PhotonMap(scattered_photons(100), Stop(stopper)), Stopped);
}
