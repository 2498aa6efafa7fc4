// Rough glass: clear glass loses nothing from either side, light goes the same both ways but for the indices, what is
// drawn follows its density, and without roughness it is glass.

#include "trace/rough_dielectric.h"

#include "trace/bsdf.h"
#include "trace/chi_square.h"
#include "trace/drawn.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

using Glass = RoughDielectric<double>;
using Side = Glass::Side;
// Prepared once.
const Glass& glass_of(double alpha, double ior) {
  static std::vector<std::shared_ptr<const Glass>> kept;
  kept.push_back(rough_dielectric_of(alpha, 1.0, ior));
  return *kept.back();
}
constexpr Side both_sides[] = {Side::rarer, Side::denser};
const Vec3d front_normal(0, 0, 1);

// A direction by the cosine to z, negative below, and a turn about it.
Vec3d glass_direction(double cos, double turn) {
  const double sin = std::sqrt(1 - cos * cos);
  return {sin * std::cos(turn), sin * std::sin(turn), cos};
}

// What comes back, and what comes through, of light from everywhere alike.
struct Sums {
  double reflected = 0, transmitted = 0;
};
Sums glass_furnace(const Glass& glass, Side side, double cos, std::uint32_t n) {
  Sums sums;
  const Vec3d eye = glass_direction(cos, 0);
  for (const bool through : {false, true})
    for (std::uint32_t i = 0; i < n; ++i) {
      const Vec3d light = glass.sample(side, through, front_normal, eye, drawn(i));
      if ((light.z < 0) != through) continue;
      const auto at = glass.evaluate(side, front_normal, eye, light);
      if (at.pdf > 0) (through ? sums.transmitted : sums.reflected) += (at.once + at.again) / at.pdf / n;
    }
  return sums;
}

Bsdf<double> glass_surface(const Glass& glass, Side side, double cos) {
  Bsdf<double> bsdf;
  bsdf.incident = -glass_direction(cos, 0);
  bsdf.shading_normal = bsdf.geometric_normal = front_normal;
  bsdf.glass = &glass;
  bsdf.side = side;
  bsdf.both = Rgbd(1.0);
  bsdf.mirror = glass.reflectance(side, cos) * bsdf.both;
  bsdf.transparent = bsdf.both - bsdf.mirror;
  bsdf.prepare(Rgbd(1.0));
  return bsdf;
}

}  // namespace

TEST_CASE("clear rough glass is not to be seen in even light, from both sides, however rough it is", "[odds]") {
  std::size_t number = 0;
  for (const double alpha : {0.001, 0.05, 0.1, 0.3, 1.0})
    for (const double ior : {1.5, 2.4}) {
      for (const Side side : both_sides)
        for (const double cos : {1.0, 0.9, 0.75, 0.6, 0.3, 0.1, 0.02}) {
          if (const std::size_t now = number++; left_out(now, 37) || left_to_all(now, 3)) continue;
          const Glass& glass = glass_of(alpha, ior);
          CAPTURE(alpha, ior, static_cast<int>(side), cos);
          const Sums sums = glass_furnace(glass, side, cos, 1 << 14);
          CHECK(sums.reflected + sums.transmitted == Approx(1).margin(1e-3));
          CHECK(sums.reflected == Approx(glass.reflectance(side, cos)).margin(0.03));
        }
    }
}

TEST_CASE("a path's surface of rough glass gives all light back, by the lobes that it draws", "[odds]") {
  std::size_t number = 0;
  for (const double alpha : {0.1, 0.6}) {
    if (left_out(alpha > 0.5, 2)) continue;
    const Glass& glass = glass_of(alpha, 1.5);
    for (const Side side : both_sides)
      for (const double cos : {0.95, 0.5, 0.1}) {
        if (left_out(number++, 4)) continue;
        CAPTURE(alpha, static_cast<int>(side), cos);
        const Bsdf<double> bsdf = glass_surface(glass, side, cos);
        CHECK_FALSE(bsdf.all_sharp());
        CHECK(bsdf.needs_direction(Lobe::transparent));
        Rgbd sum(0.0);
        double most = 0;
        int wrong = 0;
        constexpr std::uint32_t n = 1 << 15;
        for (std::uint32_t i = 0; i < n; ++i) {
          const double u = drawn(i, 2).x;
          const auto choice = bsdf.sample(bsdf.sample_lobe(u), drawn(i), u);
          sum += choice.weight / static_cast<double>(n);
          most = std::max(most, choice.weight.x);
          wrong += choice.pdf > 0 && (choice.direction.z < 0) != (choice.lobe == Lobe::transparent);
        }
        CHECK(wrong == 0);
        CHECK(sum.x == Approx(1).margin(2.5e-3));
        // A facet reflects as often as it does: no sample counts for many.
        CHECK(most < 3);
      }
  }
}

TEST_CASE("nearly smooth glass reflects and transmits as glass does, and totally where that does") {
  const Glass& glass = glass_of(0, 1.5);
  std::size_t number = 0;
  for (const Side side : both_sides)
    for (const double cos : {1.0, 0.9, 0.6, 0.3}) {
      if (left_out(number++, 3)) continue;
      const double n1 = side == Side::rarer ? 1 : 1.5, n2 = side == Side::rarer ? 1.5 : 1;
      const Vec3d incident = -glass_direction(cos, 0);
      const Refraction<double> at = refraction_at(incident, front_normal, n1, n2);
      CAPTURE(static_cast<int>(side), cos);
      const Sums sums = glass_furnace(glass, side, cos, 1 << 12);
      CHECK(sums.reflected == Approx(at.fresnel()).margin(2e-3));
      CHECK(sums.transmitted == Approx(1 - at.fresnel()).margin(2e-3));
      if (at.total()) continue;
      // Half of the facets are within alpha of the normal.
      const Vec3d sent = *refract(incident, front_normal, at);
      int near = 0;
      constexpr std::uint32_t n = 1000;
      for (std::uint32_t i = 0; i < n; ++i)
        near += length(glass.sample(side, true, front_normal, -incident, drawn(i)) - sent) < 0.01;
      CHECK(near > 980);
    }
}

TEST_CASE("through rough glass light goes the same both ways, but for the squares of the indices") {
  for (const double alpha : {0.001, 0.2, 1.0})
    for (const double ior : {1.01, 2.4}) {
      const Glass& glass = glass_of(alpha, ior);
      for (const double out : {1.0, 0.7, 0.1, 1e-3})
        for (const double in : {1.0, 0.6, 0.05, 1e-4})
          for (const double turn : {0.0, 1.0, 3.0, 3.2}) {
            CAPTURE(alpha, ior, out, in, turn);
            const Vec3d above = glass_direction(out, 0), below = glass_direction(-in, turn);
            const auto there = glass.evaluate(Side::rarer, front_normal, above, below);
            const auto back = glass.evaluate(Side::denser, -front_normal, below, above);
            const double through = ior * ior;
            CHECK(there.once / in == Approx(back.once / out * through).epsilon(1e-8));
            CHECK(there.again / in == Approx(back.again / out * through).epsilon(1e-9));
            for (const Side side : both_sides) {
              const Vec3d beside = glass_direction(in, turn);
              const auto one = glass.evaluate(side, front_normal, above, beside);
              const auto other = glass.evaluate(side, front_normal, beside, above);
              CHECK(one.once / in == Approx(other.once / out).epsilon(1e-9));
              CHECK(one.again / in == Approx(other.again / out).epsilon(1e-9));
            }
          }
    }
}

TEST_CASE("rough glass is never dark below 0 or undefined at grazing angles, and float agrees") {
  for (const double alpha : {0.0, 1e-9, 0.01, 0.3, 1.0}) {
    const Glass& glass = glass_of(alpha, 1.5);
    const RoughDielectric<float> small(static_cast<float>(alpha), 1, 1.5F);
    for (const Side side : both_sides) {
      const auto its = static_cast<RoughDielectric<float>::Side>(side);
      for (const double out : {1.0, 0.7, 1e-3, 1e-9, 1e-30})
        for (const double in : {1.0, 0.7, 1e-4, 1e-20, 0.0, -1e-20, -1e-4, -0.3, -1.0})
          for (const double turn : {0.0, 1.0, 3.14159, 3.2}) {
            CAPTURE(alpha, out, in, turn);
            const auto at = glass.evaluate(side, front_normal, glass_direction(out, 0), glass_direction(in, turn));
            const auto rounded = small.evaluate(its, {0, 0, 1}, Vec3<float>(glass_direction(out, 0)),
                                                Vec3<float>(glass_direction(in, turn)));
            for (const double one : {at.once, at.again, at.pdf, at.pdf_of_both}) {
              CHECK(std::isfinite(one));
              CHECK(one >= 0);
            }
            for (const float one : {rounded.once, rounded.again, rounded.pdf, rounded.pdf_of_both}) {
              CHECK(std::isfinite(one));
              CHECK(one >= 0);
            }
            if (alpha > 0.1 && std::abs(in) > 1e-3 && out > 1e-3)
              CHECK(static_cast<double>(rounded.once) == Approx(at.once).epsilon(2e-3).margin(1e-6));
          }
      for (const double cos : {1.0, 0.5, 1e-6, 1e-30})
        for (const bool through : {false, true})
          for (const Vec2d& unit : {Vec2d(0, 0), Vec2d(0.5, 0.5), Vec2d(0.999999, 0.999999), Vec2d(0, 0.999999)}) {
            CHECK(length(glass.sample(side, through, front_normal, glass_direction(cos, 0), unit)) ==
                  Approx(1).epsilon(1e-12));
            CHECK(length(small.sample(its, through, {0, 0, 1}, Vec3<float>(glass_direction(cos, 0)),
                                      Vec2<float>(static_cast<float>(unit.x), 0.5F))) == Approx(1).epsilon(1e-5));
          }
    }
  }
}

TEST_CASE("directions from rough glass pass the chi-square test, reflected and transmitted, from both sides",
          "[odds]") {
  std::size_t number = 0;
  for (const double alpha : {0.5, 1.0})
    for (const Side side : both_sides)
      for (const double cos : {0.95, 0.3})
        for (const bool through : {false, true}) {
          if (left_out(number++, 11)) continue;
          CAPTURE(alpha, static_cast<int>(side), cos, through);
          const Glass& glass = glass_of(alpha, 1.5);
          const Vec3d eye = glass_direction(cos, 0);
          const auto wanted = [&](const Vec3d& d) { return (d.z < 0) == through; };
          const auto pdf = [&](const Vec3d& d) {
            return wanted(d) ? glass.evaluate(side, front_normal, eye, d).pdf : 0.0;
          };
          const auto draw = [&](const Vec2d& unit) -> std::optional<Vec3d> {
            const Vec3d d = glass.sample(side, through, front_normal, eye, unit);
            return wanted(d) ? std::optional(d) : std::nullopt;
          };
          CHECK(chi_square_deviation(200000, pdf, draw) < 4);
        }
}

TEST_CASE("directions of a path's rough glass pass the chi-square test, on both sides together and beside what is matt",
          "[odds]") {
  std::size_t number_of_case = 0;
  for (const Side side : both_sides)
    for (const double cos : {0.95, 0.3}) {
      if (left_out(number_of_case++, 4)) continue;
      CAPTURE(static_cast<int>(side), cos);
      Bsdf<double> bsdf = glass_surface(glass_of(0.5, 1.5), side, cos);
      bsdf.diffuse = Rgbd(0.5);
      bsdf.prepare(Rgbd(1.0));
      CHECK(bsdf.several());
      CHECK(bsdf.probability_of_choice(Lobe::mirror) == Approx(2.0 / 3));
      std::uint32_t number = 0;
      const auto pdf = [&](const Vec3d& d) { return bsdf.evaluate(d).pdf; };
      const auto draw = [&](const Vec2d& unit) -> std::optional<Vec3d> {
        RandomKey key{};
        key.seed = 5;
        key.sample = number++;
        const double u = draw_pair<double>(Sampler::random, key, Strata(200000)).x;
        const auto choice = bsdf.sample(bsdf.sample_lobe(u), unit, u);
        return choice.pdf > 0 ? std::optional(choice.direction) : std::nullopt;
      };
      CHECK(chi_square_deviation(200000, pdf, draw) < 4);
    }
}

TEST_CASE("the facet that turns a direction does so by Snell's law; equal indices bend nothing") {
  const Glass& glass = glass_of(0.4, 1.5);
  CHECK(glass.is_between(1, 1.5));
  CHECK(glass.is_between(1.5, 1));
  CHECK_FALSE(glass.is_between(1.33, 1.5));
  CHECK(glass.side_of(1) == Side::rarer);
  CHECK(glass.side_of(1.5) == Side::denser);
  CHECK(Glass::bends(1, 1.33));
  CHECK_FALSE(Glass::bends(1.5, 1.5));
  const Vec3d incident = -glass_direction(0.8, 0);
  int bent = 0;
  for (std::uint32_t i = 0; i < 200; ++i) {
    const Vec3d sent = glass.sample(Side::denser, true, front_normal, -incident, drawn(i));
    if (!(sent.z < 0)) continue;
    const auto at = glass.bends_by(Side::denser, incident, sent);
    if (!at) continue;
    ++bent;
    CHECK(1.5 * std::sqrt(1 - at->cos_in * at->cos_in) ==
          Approx(std::sqrt(1 - at->cos_out * at->cos_out)).epsilon(0).margin(1e-9));
  }
  CHECK(bent > 50);
}
