// Rough matt surfaces: white ones lose nothing, light goes the same both ways, and without roughness they are
// Lambert's.

#include "trace/rough_diffuse.h"

#include "trace/bsdf.h"
#include "trace/chi_square.h"
#include "trace/drawn.h"

#include <cmath>
#include <optional>

#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr double matt_roughnesses[] = {0, 1e-9, 0.01, 0.3, 0.7, 1};

Vec3d matt_direction(double cos, double turn) {
  const double sin = std::sqrt(1 - cos * cos);
  return {sin * std::cos(turn), sin * std::sin(turn), cos};
}

// What comes back of light from everywhere alike, by sums over the cosine and the turn.
double matt_furnace(const RoughDiffuse<double>& surface, const Rgbd& albedo, double cos) {
  constexpr int bands = 1000, sectors = 400;
  double sum = 0;
  for (int i = 0; i < bands; ++i)
    for (int j = 0; j < sectors; ++j) {
      // By the square root, which is even by the cosine.
      const double up = std::sqrt((i + 0.5) / bands), turn = (j + 0.5) / sectors * 2 * pi_v<double>;
      sum += surface.value(albedo, {0, 0, 1}, matt_direction(cos, 0), matt_direction(up, turn)).x;
    }
  return sum / (bands * sectors);
}

Bsdf<double> matt_surface(const RoughDiffuse<double>& rough, const Rgbd& albedo, double cos) {
  Bsdf<double> bsdf;
  bsdf.incident = -matt_direction(cos, 0);
  bsdf.shading_normal = bsdf.geometric_normal = {0, 0, 1};
  bsdf.diffuse = albedo;
  bsdf.matt = &rough;
  bsdf.prepare(Rgbd(1.0));
  return bsdf;
}

}  // namespace

TEST_CASE("a white matt surface is white, however rough it is", "[odds]") {
  std::size_t number = 0;
  for (const double roughness : matt_roughnesses)
    for (const double cos : {1.0, 0.8, 0.4, 0.1, 0.02}) {
      if (left_out(number++, 4)) continue;
      CAPTURE(roughness, cos);
      const RoughDiffuse<double> rough(roughness);
      CHECK(matt_furnace(rough, Rgbd(1.0), cos) == Approx(1).margin(3e-4));
      Rgbd drawn_sum(0.0);
      const Bsdf<double> bsdf = matt_surface(rough, Rgbd(1.0), cos);
      constexpr std::uint32_t n = 1 << 14;
      for (std::uint32_t i = 0; i < n; ++i) drawn_sum += bsdf.sample(Lobe::diffuse, drawn(i)).weight / double(n);
      CHECK(drawn_sum.x == Approx(1).margin(1e-3));
    }
}

TEST_CASE("what a matt surface sends back at once is what sums say, and so is its mean") {
  for (const double roughness : matt_roughnesses) {
    CAPTURE(roughness);
    const RoughDiffuse<double> rough(roughness);
    double mean = 0;
    constexpr int steps = 20000;
    for (int i = 0; i < steps; ++i) {
      const double cos = (i + 0.5) / steps;
      CHECK(rough.reflectance(cos) <= 1);
      mean += rough.reflectance(cos) * 2 * cos / steps;
    }
    CHECK(rough.mean_reflectance() == Approx(mean).epsilon(1e-7));
    // Of a nearly black one nothing is left that met the surface again.
    for (const double cos : {1.0, 0.5, 0.05})
      CHECK(matt_furnace(rough, Rgbd(1e-6), cos) == Approx(1e-6 * rough.reflectance(cos)).epsilon(1e-3));
  }
}

TEST_CASE("without roughness it is Lambert's, to the last bit") {
  const RoughDiffuse<double> smooth(0);
  const Rgbd albedo(0.7, 0.3, 0.123);
  for (const double out : {1.0, 0.3, 1e-4})
    for (const double in : {1.0, 0.7, 1e-9})
      CHECK(smooth.value(albedo, {0, 0, 1}, matt_direction(out, 0), matt_direction(in, 2)) == albedo);
  CHECK(smooth.mean_reflectance() == 1);
}

TEST_CASE("a rough matt surface sends light back to where it came from, as the full moon does") {
  const RoughDiffuse<double> rough(1);
  const auto sent = [&](double out, double in, double turn) {
    return rough.value(Rgbd(0.8), {0, 0, 1}, matt_direction(out, 0), matt_direction(in, turn)).x;
  };
  CHECK(sent(0.3, 0.3, 0) > 1.5 * sent(0.3, 0.3, pi_v<double>));
  CHECK(sent(0.3, 0.3, 0) > 1.5 * sent(1, 1, 0));
  // Its light is a deeper colour for having met the surface again.
  const Rgbd tinted = rough.value({0.9, 0.3, 0.1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1});
  CHECK(tinted.z / tinted.x < 0.1 / 0.9);
}

TEST_CASE("matt surfaces scatter the same both ways, never less than nothing, and float agrees") {
  const Rgbd albedo(0.9, 0.5, 0.1);
  for (const double roughness : matt_roughnesses) {
    const RoughDiffuse<double> rough(roughness);
    const RoughDiffuse<float> small(static_cast<float>(roughness));
    for (const double out : {1.0, 0.7, 1e-3, 1e-9, 1e-30, 0.0})
      for (const double in : {1.0, 0.7000001, 0.2, 1e-4, 1e-20, 0.0})
        for (const double turn : {0.0, 1.0, 3.14159, 3.2}) {
          CAPTURE(roughness, out, in, turn);
          const Vec3d eye = matt_direction(out, 0), light = matt_direction(in, turn);
          const Rgbd there = rough.value(albedo, {0, 0, 1}, eye, light);
          const Rgbd back = rough.value(albedo, {0, 0, 1}, light, eye);
          const Rgb<float> rounded = small.value(Rgb<float>(albedo), {0, 0, 1}, Vec3<float>(eye), Vec3<float>(light));
          for (int c = 0; c < 3; ++c) {
            CHECK(std::isfinite(there[c]));
            CHECK(there[c] >= 0);
            CHECK(there[c] == Approx(back[c]).epsilon(1e-13));
            CHECK(std::isfinite(rounded[c]));
            CHECK(rounded[c] >= 0);
            if (out > 1e-2 && in > 1e-2) CHECK(rounded[c] == Approx(there[c]).epsilon(1e-4));
          }
        }
  }
}

TEST_CASE("directions from a rough matt surface pass the chi-square test, and weigh what it scatters", "[odds]") {
  const RoughDiffuse<double> rough(0.8);
  for (const double cos : {1.0, 0.3}) {
    if (left_out(cos > 0.5, 2)) continue;
    const Bsdf<double> bsdf = matt_surface(rough, Rgbd(0.7), cos);
    const auto pdf = [&](const Vec3d& d) { return bsdf.evaluate(d).pdf; };
    const auto draw = [&](const Vec2d& unit) { return std::optional(bsdf.sample(Lobe::diffuse, unit).direction); };
    CHECK(chi_square_deviation(200000, pdf, draw) < 4);
    for (std::uint32_t i = 0; i < 100; ++i) {
      const auto choice = bsdf.sample(Lobe::diffuse, drawn(i));
      const Rgbd value = rough.value(Rgbd(0.7), {0, 0, 1}, -bsdf.incident, choice.direction);
      CHECK(choice.weight.x == Approx(value.x).epsilon(1e-12));
    }
  }
}
