// The lobes of a surface: what is drawn follows the density, estimates what the lobes say, and gives back no more light
// than came.

#include "trace/bsdf.h"

#include "math/sampler.h"
#include "trace/drawn.h"

#include <utility>
#include <vector>

#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// A surface z = 0 that a ray meets at an angle to the normal.
Bsdf<double> surface(double degrees) {
  const double angle = degrees * pi_v<double> / 180;
  Bsdf<double> bsdf;
  bsdf.incident = {std::sin(angle), 0, -std::cos(angle)};
  bsdf.shading_normal = bsdf.geometric_normal = {0, 0, 1};
  bsdf.mirror_axis = {std::sin(angle), 0, std::cos(angle)};
  bsdf.transparent_axis =
      normalize(Vec3d(std::sin(angle) / 1.5, 0, -std::sqrt(1 - std::pow(std::sin(angle) / 1.5, 2))));
  return bsdf;
}

Bsdf<double> everything(double degrees) {
  Bsdf<double> bsdf = surface(degrees);
  bsdf.diffuse = {0.3, 0.2, 0.1};
  bsdf.shininess = 12;
  bsdf.highlight = highlight_scale(12.0) * Vec3d(0.2, 0.3, 0.1);
  bsdf.mirror = {0.1, 0.1, 0.3};
  bsdf.mirror_width = one_minus_cos_of(0.5);
  bsdf.transparent = {0.2, 0.1, 0.05};
  bsdf.transparent_width = one_minus_cos_of(0.3);
  return bsdf;
}

// The integral of density and value over all directions, by sums.
Bsdf<double>::BsdfValue integral(const Bsdf<double>& bsdf) {
  Bsdf<double>::BsdfValue sum;
  constexpr int bands = 1500, sectors = 900;
  for (int band = 0; band < bands; ++band)
    for (int sector = 0; sector < sectors; ++sector) {
      const double z = (band + 0.5) / bands * 2 - 1, turn = (sector + 0.5) / sectors * 2 * pi_v<double>;
      const double sin = std::sqrt(1 - z * z);
      const auto at = bsdf.evaluate({sin * std::cos(turn), sin * std::sin(turn), z});
      const double cell = 4 * pi_v<double> / (bands * sectors);
      sum.value += cell * at.value;
      sum.pdf += cell * at.pdf;
    }
  return sum;
}

// The mean of what is drawn: the light given back when light comes from everywhere alike.
Rgbd furnace(const Bsdf<double>& bsdf, std::uint32_t n = 1 << 15) {
  Rgbd sum(0.0);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Lobe lobe = bsdf.sample_lobe(drawn(i, 2).x);
    sum += bsdf.sample(lobe, drawn(i)).weight / static_cast<double>(n);
  }
  return sum;
}

}  // namespace

TEST_CASE("the balance of two strategies: weights sum to 1, at all sizes") {
  const double inf = std::numeric_limits<double>::infinity();
  for (const double a : {1e-300, 1e-20, 0.1, 1.0, 3.0, 1e200})
    for (const double b : {1e-300, 1e-20, 0.1, 1.0, 3.0, 1e200}) {
      CHECK(power_heuristic(a, b) + power_heuristic(b, a) == Approx(1).epsilon(1e-15));
      CHECK((power_heuristic(a, b) > 0.5) == (a > b));
    }
  CHECK(power_heuristic(1.0, 2.0) == Approx(0.2).epsilon(1e-15));
  CHECK(power_heuristic(3.0, 1.0) == Approx(0.9).epsilon(1e-15));
  CHECK(power_heuristic(2.0, 0.0) == 1);
  CHECK(power_heuristic(2.0, inf) == 0);
  CHECK(power_heuristic(inf, 2.0) == 1);
  CHECK(power_heuristic(inf, inf) == 0.5);
}

TEST_CASE("densities of all lobes together integrate to 1, their values to what is drawn", "[odds]") {
  std::size_t number = 0;
  for (const double degrees : {0.0, 30.0, 60.0, 85.0}) {
    if (left_out(number++, 4)) continue;
    CAPTURE(degrees);
    Bsdf<double> bsdf = everything(degrees);
    bsdf.prepare(Rgbd(1, 0.5, 0.25));
    CHECK(bsdf.several());
    CHECK_FALSE(bsdf.all_sharp());
    const auto sum = integral(bsdf);
    const Rgbd mean = furnace(bsdf, 1 << 18);
    // Half vectors below the horizon lead nowhere: at grazing angles a part of the highlight's draws is lost, and
    // the density says so.
    CHECK(sum.pdf <= 1.002);
    CHECK(sum.pdf > (degrees > 80 ? 0.85 : degrees > 50 ? 0.95 : 0.98));
    for (int channel = 0; channel < 3; ++channel) CHECK(mean[channel] == Approx(sum.value[channel]).epsilon(0.004));
  }
}

TEST_CASE("each lobe is drawn by its density") {
  for (int one = 0; one < lobe_count; ++one) {
    if (left_out(static_cast<std::size_t>(one), 2)) continue;
    Bsdf<double> bsdf = surface(40);
    const Lobe lobe = static_cast<Lobe>(one);
    INFO(name_of(lobe));
    bsdf.shininess = 30;
    bsdf.mirror_width = one_minus_cos_of(0.9);  // reaches below the horizon
    bsdf.transparent_width = one_minus_cos_of(1.4);
    (lobe == Lobe::diffuse     ? bsdf.diffuse
     : lobe == Lobe::highlight ? bsdf.highlight
     : lobe == Lobe::mirror    ? bsdf.mirror
                               : bsdf.transparent) = Rgbd(1.0);
    bsdf.prepare(Rgbd(1.0));
    CHECK_FALSE(bsdf.several());
    CHECK(bsdf.sample_lobe(0.999) == lobe);
    constexpr int bands = 20, sectors = 12, fine = 24, n = rounds(100000);
    std::vector<double> expected(bands * sectors);
    for (int band = 0; band < bands * fine; ++band)
      for (int sector = 0; sector < sectors * fine; ++sector) {
        const double z = (band + 0.5) / (bands * fine) * 2 - 1;
        const double turn = ((sector + 0.5) / (sectors * fine) - 0.5) * 2 * pi_v<double>, sin = std::sqrt(1 - z * z);
        expected[static_cast<std::size_t>(band / fine * sectors + sector / fine)] +=
            bsdf.evaluate({sin * std::cos(turn), sin * std::sin(turn), z}).pdf * 4 * pi_v<double> * n /
            (bands * fine * sectors * fine);
      }
    std::vector<int> held(bands * sectors);
    for (std::uint32_t i = 0; i < n; ++i) {
      RandomKey key{};
      key.sample = i;
      const auto choice = bsdf.sample(lobe, draw_pair<double>(Sampler::random, key, Strata(n)));
      if (is_black(choice.weight)) continue;
      const Vec3d& d = choice.direction;
      if (std::abs(length(d) - 1) > 1e-12) FAIL("not of unit length");
      if ((d.z > 0) != (lobe != Lobe::transparent)) FAIL("on the wrong side");
      const double turn = std::atan2(d.y, d.x) / (2 * pi_v<double>)+0.5;
      ++held[static_cast<std::size_t>(std::min((d.z + 1) / 2 * bands, bands - 1e-9)) * sectors +
             static_cast<std::size_t>(std::min(turn * sectors, sectors - 1e-9))];
      // The weight is the one that the density answers for.
      const auto at = bsdf.evaluate(d, lobe);
      if (std::abs(choice.pdf - at.pdf) > 1e-9 * at.pdf) FAIL("another density");
    }
    double chi = 0, freedom = 0;
    for (std::size_t i = 0; i < held.size(); ++i) {
      if (expected[i] < 30) continue;
      // The sums over a cell that the cone's edge cuts are only good to some per cent.
      const double spread = expected[i] + std::pow(0.01 * expected[i], 2);
      chi += (held[i] - expected[i]) * (held[i] - expected[i]) / spread;
      ++freedom;
    }
    CHECK(freedom > 10);
    CHECK(chi < freedom + 6 * std::sqrt(2 * freedom));
  }
}

TEST_CASE("no lobe gives back more than came", "[odds]") {
  std::size_t number = 0;
  for (const double degrees : {0.0, 20.0, 45.0, 70.0, 89.0}) {
    if (const std::size_t now = number++; left_out(now, 5) || left_to_all(now, 2)) continue;
    CAPTURE(degrees);
    const auto albedo = [&](auto&& set) {
      Bsdf<double> bsdf = surface(degrees);
      set(bsdf);
      bsdf.prepare(Rgbd(1.0));
      return furnace(bsdf).x;
    };
    CHECK(albedo([](auto& l) { l.diffuse = Rgbd(1.0); }) == Approx(1).epsilon(1e-12));
    CHECK(albedo([](auto& l) { l.mirror = Rgbd(1.0); }) == Approx(1).epsilon(1e-12));
    CHECK(albedo([](auto& l) { l.transparent = Rgbd(1.0); }) == Approx(1).epsilon(1e-12));
    for (const double angle : {1e-6, 0.01, 0.4, 1.5}) {
      CHECK(albedo([&](auto& l) { l.mirror = Rgbd(1.0), l.mirror_width = one_minus_cos_of(angle); }) ==
            Approx(1).epsilon(1e-9));
      CHECK(albedo([&](auto& l) { l.transparent = Rgbd(1.0), l.transparent_width = one_minus_cos_of(angle); }) ==
            Approx(1).epsilon(1e-9));
    }
    for (const double shininess : {0.0, 0.5, 1.0, 3.0, 5.0, 8.0, 30.0, 500.0}) {
      CAPTURE(shininess);
      const double back = albedo([&](auto& l) {
        l.highlight = Rgbd(highlight_scale(shininess));
        l.shininess = shininess;
      });
      CHECK(back <= 1.005);
      // Along the normal, what the formula says; where that would be too much, all of it.
      const double most = 8 / (shininess + 2) * (1 - std::exp2(-(shininess + 2) / 2));
      if (degrees == 0) CHECK(back == Approx(std::min(1.0, most)).epsilon(0.01));
    }
  }
}

TEST_CASE("lobes share the draws by what they bring; what brings nothing is never drawn") {
  Bsdf<double> bsdf = everything(30);
  // A ray that has only blue left sees the blue mirror most.
  bsdf.prepare(Rgbd(0, 0, 1));
  std::vector<int> drawn_of(lobe_count);
  constexpr int n = 1000;
  for (int i = 0; i < n; ++i) ++drawn_of[static_cast<std::size_t>(bsdf.sample_lobe((i + 0.5) / n))];
  const double sum = 0.1 + 0.1 * 8 / 14 + 0.3 + 0.05;
  CHECK(drawn_of[0] == Approx(n * 0.1 / sum).margin(1.5));
  CHECK(drawn_of[1] == Approx(n * 0.1 * 8 / 14 / sum).margin(1.5));
  CHECK(drawn_of[2] == Approx(n * 0.3 / sum).margin(1.5));
  CHECK(drawn_of[3] == Approx(n * 0.05 / sum).margin(1.5));

  Bsdf<double> black = surface(30);
  black.prepare(Rgbd(1.0));
  CHECK(black.absorbs());
  CHECK(black.evaluate({0, 0, 1}).pdf == 0);
  Bsdf<double> mirror = surface(30);
  mirror.mirror = Rgbd(0.5);
  mirror.prepare(Rgbd(1.0));
  CHECK(mirror.all_sharp());
  CHECK_FALSE(mirror.needs_direction(Lobe::mirror));
  const auto choice = mirror.sample(Lobe::mirror, Vec2d(0.3, 0.4));
  CHECK(choice.direction == mirror.mirror_axis);
  CHECK(choice.weight == Rgbd(0.5));
  CHECK(choice.pdf == 0);
}
