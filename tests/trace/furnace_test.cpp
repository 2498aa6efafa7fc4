// Closed enclosures whose radiance is known exactly: a geometric series in the number of reflections.

#include "support/catch.h"
#include "support/table.h"
#include "trace/enclosures.h"
#include "trace/pictures.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Material glowing_mirror(const Rgbd& reflectance, const Rgbd& emission) {
  Material material = black();
  material.reflection = reflectance;
  material.emission = emission;
  return material;
}

Scene furnace(const Shape<double>& shape, const Material& material, int depth) {
  Scene scene;
  scene.camera.eye = {-1, -0.75, 0.25};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.screen = {1, 4.0, 21};
  scene.background = Rgbd(1e9);  // whatever leaks out is seen
  scene.limits.depth = depth;
  scene.objects = {object("Furnace", shape, material)};
  return scene;
}

double series(double emission, double rho, int terms) {
  return rho == 1 ? emission * terms : emission * (1 - std::pow(rho, terms)) / (1 - rho);
}

}  // namespace

TEST_CASE("a mirror furnace shows E (1 - rho^N) / (1 - rho), N the deepest SHADE") {
  const Vec3d rho(0.5, 0.9, 1.0), emission(1, 0.5, 0.25);
  const Shape<double>& shape = GENERATE(ball, quadrangle, bent);
  for (const int depth : {1, 2, 3, 5, 10, 40}) {
    const auto traced = picture<double>(furnace(shape, glowing_mirror(rho, emission), depth), 21, 15);
    const Rgbd expected(series(1, 0.5, depth), series(0.5, 0.9, depth), series(0.25, 1, depth));
    double worst = 0;
    for (const Rgbd& pixel : traced.pixels)
      for (int channel = 0; channel < 3; ++channel)
        worst = std::max(worst, std::abs(pixel[channel] / expected[channel] - 1));
    CAPTURE(depth, shape.index());
    CHECK(worst <= 1e-12);
    CHECK(traced.statistics.ends(Ending::missed) == 0);
    CHECK(traced.statistics.ends(Ending::depth) == 21 * 15);
  }
}

TEST_CASE("no float ray leaks out of a mirror furnace either") {
  const auto traced =
      picture<float>(furnace(GENERATE(ball, quadrangle, bent), glowing_mirror(Rgbd(0.9), Rgbd(1.0)), 60), 45, 31);
  CHECK(traced.statistics.ends(Ending::missed) == 0);
  for (const Rgb<float>& pixel : traced.pixels)
    if (std::abs(static_cast<double>(pixel.x) / series(1, 0.9, 60) - 1) > 1e-5) FAIL("pixel of " << pixel.x);
}

TEST_CASE("closed emitters and mirrors of furnace.tsv") {
  int emitters = 0, mirrors = 0;
  for (const Row& row : read_table("furnace.tsv")) {
    const double albedo = row.number("albedo"), emitted = row.number("emitted");
    const double expected = row.number("radiance"), tolerance = row.number("tol_exact");
    INFO(row.text("id"));
    if (row.text("setting") == "closed_emitter") {
      // What a Lambert wall scatters, a mirror wall of the same albedo reflects; in even light the two look alike.
      ++emitters;
      const bool endless = row.text("reflections") == "inf";
      const int depth = endless ? 200 : static_cast<int>(row.number("reflections")) + 1;
      const Scene scene = furnace(quadrangle, glowing_mirror(Rgbd(albedo), Rgbd(emitted)), depth);
      CHECK(picture<double>(scene, 1, 1).at(0, 0).x == Approx(expected).margin(tolerance).epsilon(0));
    } else if (row.text("setting") == "env_mirror") {
      ++mirrors;
      Scene scene;
      scene.background = Rgbd(emitted);
      scene.objects = {object("Ball", Sphere<double>{{5, 0, 0}, 1}, glowing_mirror(Rgbd(albedo), Rgbd(0.0)))};
      for (const double y : {0.0, 0.5, 0.999})
        CHECK(shade_along(scene, {0, 0, 0}, {5, y, 0}).x == Approx(expected).margin(tolerance).epsilon(0));
    }
  }
  CHECK(emitters >= 5);
  CHECK(mirrors >= 1);
}
