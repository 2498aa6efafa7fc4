// Mirrors of small mirrors and of metal: white ones lose nothing, light goes the same both ways, what is drawn follows
// its density, and metals reflect by Fresnel.

#include "trace/microfacets.h"

#include "scene/metals.h"
#include "trace/bsdf.h"
#include "trace/chi_square.h"
#include "trace/drawn.h"
#include "trace/optics.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <optional>

#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// A direction above z = 0, by the cosine to z and a turn about it.
Vec3d above(double cos, double turn) {
  const double sin = std::sqrt(1 - cos * cos);
  return {sin * std::cos(turn), sin * std::sin(turn), cos};
}
constexpr double alphas[] = {0.001, 0.01, 0.05, 0.1, 0.3, 0.5, 0.8, 1};

Microsurface<double> mirrors_of(double roughness, MirrorKind kind = MirrorKind::ideal) {
  Material material;
  material.reflection = Rgbd(1.0);
  material.roughness = roughness;
  material.mirror = kind;
  return Microsurface<double>(material);
}

// A mirror of small mirrors, z = 0, met at an angle to the normal.
Bsdf<double> surface(const Microsurface<double>& mirrors, double cos) {
  Bsdf<double> bsdf;
  bsdf.incident = -above(cos, 0);
  bsdf.shading_normal = bsdf.geometric_normal = {0, 0, 1};
  bsdf.mirror = Rgbd(1.0);
  bsdf.facets = &mirrors;
  bsdf.prepare(Rgbd(1.0));
  return bsdf;
}

// What comes back of light from everywhere alike.
Rgbd furnace(const Bsdf<double>& bsdf, std::uint32_t n) {
  Rgbd sum(0.0);
  for (std::uint32_t i = 0; i < n; ++i) sum += bsdf.sample(Lobe::mirror, drawn(i)).weight;
  return sum / static_cast<double>(n);
}

}  // namespace

TEST_CASE("a metal reflects by Fresnel: at right angles, at grazing angles, and as glass where it absorbs nothing") {
  for (const double n : {0.2, 1.1, 1.5, 3.0})
    for (const double k : {0.0, 0.5, 4.0}) {
      CAPTURE(n, k);
      const Conductor<double> conductor{Rgbd(n), Rgbd(k)};
      const double straight = ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
      CHECK(conductor.reflectance(1).x == Approx(straight).epsilon(0).margin(1e-15));
      CHECK(conductor.reflectance(0).x == 1);
      for (double cos = 0.001; cos < 1; cos += 0.007) {
        const double reflected = conductor.reflectance(cos).x;
        CHECK(reflected >= 0);
        CHECK(reflected <= 1);
        if (k > 0) continue;
        const auto glass = refraction_at(-above(cos, 0), Vec3d(0, 0, 1), 1.0, n);
        if (n >= 1) CHECK(reflected == Approx(glass.fresnel()).epsilon(0).margin(1e-12));
      }
    }
  // Complex numbers say the same.
  const std::complex<double> index(1.2, 2.5);
  const double cos = 0.4;
  const std::complex<double> beyond = std::sqrt(index * index - (1 - cos * cos));
  const double s = std::norm((cos - beyond) / (cos + beyond));
  const double p = std::norm((index * index * cos - beyond) / (index * index * cos + beyond));
  CHECK(Conductor<double>{Rgbd(1.2), Rgbd(2.5)}.reflectance(cos).x == Approx((s + p) / 2).epsilon(1e-14));
}

TEST_CASE("gold is yellow, copper red, silver and aluminium have hardly a colour") {
  const auto straight = [](MirrorKind metal) {
    const MetalIndex index = refractive_index(metal);
    return Conductor<double>{index.eta, index.k}.reflectance(1);
  };
  const Rgbd gold = straight(MirrorKind::gold), copper = straight(MirrorKind::copper),
             silver = straight(MirrorKind::silver), aluminium = straight(MirrorKind::aluminium);
  CHECK(gold.x > gold.y + 0.1);
  CHECK(gold.y > gold.z + 0.2);
  CHECK(copper.x > copper.y + 0.2);
  CHECK(copper.y > copper.z);
  for (const Rgbd& grey : {silver, aluminium}) {
    CHECK(std::min({grey.x, grey.y, grey.z}) > 0.8);
    CHECK(max_component(grey) - std::min({grey.x, grey.y, grey.z}) < 0.1);
  }
}

TEST_CASE("a white mirror of small mirrors is white: nothing is lost or won, however rough it is", "[odds]") {
  std::size_t number = 0;
  for (const double alpha : alphas) {
    const Microsurface<double> mirrors = mirrors_of(alpha);
    for (const double cos : {1.0, 0.9, 0.6, 0.3, 0.1, 0.03, 0.01}) {
      if (left_out(number++, 11)) continue;
      CAPTURE(alpha, cos);
      CHECK(furnace(surface(mirrors, cos), 1 << 15).x == Approx(1).margin(1e-3));
      CHECK(mirrors.facets->reflectance(cos) <= 1);
      CHECK(mirrors.facets->reflectance(cos) > 0.3);
    }
  }
}

TEST_CASE("rough gold returns less than smooth gold, and its light is yellower for having met several mirrors") {
  const MetalIndex index = refractive_index(MirrorKind::gold);
  const Conductor<double> gold{index.eta, index.k};
  const Microsurface<double> smooth = mirrors_of(0.01, MirrorKind::gold), rough = mirrors_of(1, MirrorKind::gold);
  const Rgbd of_smooth = furnace(surface(smooth, 1), rounds(1 << 15)),
             of_rough = furnace(surface(rough, 1), rounds(1 << 15));
  for (int c = 0; c < 3; ++c) {
    CHECK(of_smooth[c] == Approx(gold.reflectance(1)[c]).epsilon(2e-3));
    CHECK(of_rough[c] < of_smooth[c]);
  }
  CHECK(of_rough.z / of_rough.x < of_smooth.z / of_smooth.x);
}

TEST_CASE("what is reflected once is a share below 1, the less the rougher, and its mean is that over the hemisphere") {
  double rougher = 1;
  for (const double alpha : alphas) {
    CAPTURE(alpha);
    const Microfacets<double> facets(alpha);
    CHECK(facets.mean_reflectance() <= rougher);
    rougher = facets.mean_reflectance();
    double mean = 0;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      const double cos = (i + 0.5) / steps;
      mean += facets.reflectance(cos) * 2 * cos / steps;
    }
    CHECK(rougher == Approx(mean).epsilon(1e-6));
  }
  CHECK(rougher < 0.85);
  CHECK(Microfacets<double>(0.01).mean_reflectance() > 0.999);
}

TEST_CASE("small mirrors reflect the same both ways, are never dark below 0 or undefined, and float agrees") {
  for (const double alpha : {0.0, 1e-9, 0.001, 0.2, 1.0}) {
    const Microfacets<double> facets(alpha);
    const Microfacets<float> small(static_cast<float>(alpha));
    for (const double out : {1.0, 0.7, 1e-3, 1e-9, 1e-30})
      for (const double in : {1.0, 0.7000001, 0.2, 1e-4, 1e-20, 0.0, -0.5})
        for (const double turn : {0.0, 1.0, 3.14159, 3.2}) {
          CAPTURE(alpha, out, in, turn);
          const Vec3d eye = above(out, 0), light = above(in, turn);
          const auto there = facets.evaluate({0, 0, 1}, eye, light), back = facets.evaluate({0, 0, 1}, light, eye);
          for (const double one : {there.once, there.again, there.pdf, there.half_cos}) {
            CHECK(std::isfinite(one));
            CHECK(one >= 0);
          }
          if (in <= 0) CHECK(there.once + there.again == 0);
          if (in > 0) {
            CHECK(there.once / in == Approx(back.once / out).epsilon(1e-10));
            CHECK(there.again / in == Approx(back.again / out).epsilon(1e-10));
          }
          const auto rounded = small.evaluate({0, 0, 1}, Vec3<float>(eye), Vec3<float>(light));
          CHECK(std::isfinite(rounded.once));
          CHECK(std::isfinite(rounded.pdf));
          if (alpha > 0.1 && in > 1e-5 && out > 1e-5)
            CHECK(rounded.once == Approx(there.once).epsilon(2e-3).margin(1e-7));
        }
    for (const double cos : {1.0, 0.5, 1e-6, 1e-30})
      for (const Vec2d& unit : {Vec2d(0, 0), Vec2d(0.5, 0.5), Vec2d(0.999999, 0.999999), Vec2d(0, 0.999999)}) {
        const Vec3d direction = facets.sample({0, 0, 1}, above(cos, 0), unit);
        CHECK(length(direction) == Approx(1).epsilon(1e-12));
        const Vec3<float> rounded =
            small.sample({0, 0, 1}, Vec3<float>(above(cos, 0)), Vec2<float>(static_cast<float>(unit.x), 0.5F));
        CHECK(length(rounded) == Approx(1).epsilon(1e-5));
      }
  }
}

TEST_CASE("directions from small mirrors pass the chi-square test", "[odds]") {
  std::size_t number = 0;
  for (const double alpha : {0.1, 0.4, 1.0})
    for (const double cos : {1.0, 0.6, 0.1}) {
      if (left_out(number++, 5)) continue;
      CAPTURE(alpha, cos);
      const Microfacets<double> facets(alpha);
      const Vec3d eye = above(cos, 0);
      const auto pdf = [&](const Vec3d& d) { return facets.evaluate({0, 0, 1}, eye, d).pdf; };
      const auto draw = [&](const Vec2d& unit) -> std::optional<Vec3d> {
        const Vec3d d = facets.sample({0, 0, 1}, eye, unit);
        return d.z > 0 ? std::optional(d) : std::nullopt;
      };
      CHECK(chi_square_deviation(200000, pdf, draw) < 4);
    }
}
