// The path tracer in rooms and under lights whose radiance is known.

#include <memory>

#include "accel/meshes.h"
#include "support/catch.h"
#include "support/table.h"
#include "trace/enclosures.h"
#include "trace/paths.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

const Shape<double> cube = Box<double>{{-2, -1.5, -1}, {1.5, 2, 1.2}};

Scene room(const Shape<double>& shape, const Material& material) {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.background = Rgbd(1e9);  // whatever leaks out is seen
  scene.objects = {object("Room", shape, material)};
  return scene;
}

const Vec3d eye(-1, -0.75, 0.25), target(0, 0, 0);

// Without draws of lights and without roulette every path brings the same: the sum of the series.
PathSettings exactly(int length) { return {length, never, PathStrategy::directions}; }

// Reflections to path lengths; what 250 leave of albedo 0.8 is far below a double's digits.
int length_of(const Row& row) {
  return row.text("reflections") == "inf" ? 251 : static_cast<int>(row.number("reflections")) + 1;
}

}  // namespace

TEST_CASE("furnaces of furnace.tsv, by paths", "[odds]") {
  int rows = 0;
  for (const Row& row : read_table("furnace.tsv")) {
    INFO(row.text("id"));
    const double albedo = row.number("albedo"), emitted = row.number("emitted"), expected = row.number("radiance");
    const double exact = row.number("tol_exact"), sampled = row.number("tol_montecarlo");
    const std::string& setting = row.text("setting");
    const int length = length_of(row);
    ++rows;
    if (setting == "closed_emitter") {
      for (const Shape<double>& shape : {ball, quadrangle, cube, bent}) {
        CAPTURE(shape.index());
        const Scene scene = room(shape, matte(albedo, emitted));
        CHECK(light_along(scene, eye, target, 2, exactly(length)).mean.x == Approx(expected).margin(exact).epsilon(0));
        // Sampled: with lights drawn, and paths ended by roulette where they may be endless.
        const bool endless = row.text("reflections") == "inf";
        const PathSettings settings{endless ? 0 : length, endless ? 2 : never, PathStrategy::both};
        const Estimate estimate = light_along(scene, eye, target, 4000, settings);
        CHECK(std::abs(estimate.mean.x - expected) <= 4.5 * estimate.error + 1e-9);
        CHECK(4.5 * estimate.error < 3 * sampled * expected + 1e-9);
      }
    } else if (setting == "sphere_point_light") {
      // The tracer's strength is an intensity over pi.
      Scene scene = room(Sphere<double>{{0, 0, 0}, 1}, matte(albedo));
      scene.lights = {lamp({0, 0, 0}, row.number("point_intensity") / pi_v<double>, {0, 0, 1})};
      for (const Vec3d& at : {Vec3d(1, 0, 0), Vec3d(-0.3, 0.5, -0.6)})
        CHECK(light_along(scene, {0.5, -0.2, 0.1}, at, 2, exactly(length)).mean.x ==
              Approx(expected).margin(exact).epsilon(0));
      const PathSettings roulette{row.text("reflections") == "inf" ? 0 : length, 2, PathStrategy::both};
      const Estimate estimate = light_along(scene, {0.5, -0.2, 0.1}, {1, 0, 0}, 4000, roulette);
      CHECK(std::abs(estimate.mean.x - expected) <= 4.5 * estimate.error + 1e-9);
    } else {
      Material material = matte(setting == "env_lambert" ? albedo : 0);
      if (setting == "env_mirror") material.reflection = Rgbd(albedo);
      Scene scene = room(Sphere<double>{{5, 0, 0}, 1}, material);
      scene.background = Rgbd(emitted);
      for (const double y : {0.0, 0.5, 0.999})
        CHECK(light_along(scene, {0, 0, 0}, {5, y, 0}, 50, exactly(0)).mean.x ==
              Approx(expected).margin(exact).epsilon(0));
    }
  }
  CHECK(rows == 10);
}

TEST_CASE("glass and mirrors in even light are not to be seen: every path brings it all") {
  Material glass = black();
  glass.transmission = Rgbd(1.0);
  glass.dielectric = true;
  // A ball, and a smooth mesh of one, whose normals lean away from its few triangles.
  MeshShape smooth;
  smooth.mesh = std::make_shared<const Mesh>(icosphere(1, {5, 0, 0}));
  for (const bool is_mesh : {false, true})
    for (const double ior : {1.0, 1.33, 1.5, 2.4})
      for (const double translucency : {0.0, 5.0, 60.0}) {
        glass.ior = ior;
        glass.translucency = glass.gloss = translucency;
        Scene scene = room(Sphere<double>{{5, 0, 0}, 1}, glass);
        if (is_mesh) scene.objects[0].shape = smooth;
        scene.background = Rgbd(1.0);
        for (const double y : {0.0, 0.4, 0.8, 0.97}) {
          const Estimate estimate = light_along(scene, {0, 0, 0}, {5, y, 0}, 300, exactly(0));
          CAPTURE(is_mesh, ior, translucency, y);
          CHECK(estimate.mean.x == Approx(1).epsilon(1e-9));
        }
      }
}

TEST_CASE("a surface of all lobes never gives back more than came, by roulette or not") {
  Material material = matte(0.3);
  material.specular = Rgbd(0.25);
  material.reflection = Rgbd(0.25);
  material.gloss = 20;
  material.transmission = Rgbd(0.2);
  material.translucency = 10;
  for (const double shininess : {0.0, 2.0, 40.0, 2000.0}) {
    material.shininess = shininess;
    Scene scene = room(Sphere<double>{{5, 0, 0}, 1}, material);
    scene.background = Rgbd(1.0);
    for (const int roulette : {1, never})
      for (const double y : {0.0, 0.6, 0.95}) {
        const Estimate estimate = light_along(scene, {0, 0, 0}, {5, y, 0}, 4000, {0, roulette, PathStrategy::both});
        CHECK(estimate.mean.x <= 1 + 4.5 * estimate.error);
        CHECK(estimate.mean.x > 0.5);
      }
  }
}

TEST_CASE("Russian roulette changes no mean, in any colour") {
  Material material = matte(0, 1);
  material.diffuse = {0.8, 0.5, 0.1};
  const Scene scene = room(cube, material);
  for (const int from : {1, 2, 5}) {
    CAPTURE(from);
    const Scene seen = looking(scene, eye, target);
    const Estimates sampled = path_estimates(seen, 1, 1, 20000, {0, from, PathStrategy::directions});
    for (int channel = 0; channel < 3; ++channel) {
      const double expected = 1 / (1 - material.diffuse[channel]);
      CHECK(std::abs(sampled.mean[0][channel] - expected) <= 4 * sampled.error(0, channel));
      CHECK(sampled.error(0, channel) < 0.02 * expected);
    }
    // All end by it: nothing is missed, nothing too long.
    CHECK(sampled.statistics.ends(Ending::threshold) == 20000);
    CHECK(sampled.statistics.ends(Ending::missed) == 0);
  }
}

TEST_CASE("triangle lights of triangle_light.tsv: all three strategies", "[odds]") {
  int rows = 0;
  for (const Row& row : read_table("triangle_light.tsv")) {
    INFO(row.text("id"));
    const Vec3d point = row.vector("point"), normal = row.vector("normal");
    const double expected = row.number("radiance");
    Material light = black();
    light.emission = Rgbd(row.number("light_radiance"));
    Scene scene;
    scene.objects = {
        object("Light", Triangle<double>{row.vector("light_a"), row.vector("light_b"), row.vector("light_c")}, light),
        object("Spot", Disk<double>{point, normal, 0.01}, matte(row.number("albedo")))};
    const Vec3d viewer = point + 0.001 * (normal + 0.3 * Basis<double>(normal).s);
    for (const PathStrategy strategy : {PathStrategy::both, PathStrategy::lights, PathStrategy::directions}) {
      CAPTURE(static_cast<int>(strategy));
      scene.render.sampler = Sampler::random;
      const Estimate estimate = light_along(scene, viewer, point, 20000, {0, 4, strategy});
      CHECK(std::abs(estimate.mean.x - expected) <= 4 * estimate.error);
      scene.render.sampler = Sampler::sobol;
      const double even = light_along(scene, viewer, point, 1 << 16, {0, 4, strategy}).mean.x;
      CHECK(even == Approx(expected).epsilon(row.number("tol_montecarlo")));
      if (strategy != PathStrategy::directions) CHECK(even == Approx(expected).epsilon(0.002));
    }
    ++rows;
  }
  CHECK(rows == 5);
}

TEST_CASE("every kind of light shape brings what it should: pi E over what the point sees of it") {
  // A horizontal point under a light brings albedo / pi times the integral of the cosine; a sphere's is known.
  Scene scene;
  scene.render.sampler = Sampler::sobol;
  Material light = black();
  light.emission = Rgbd(3.0);
  for (const double radius : {0.02, 0.5, 1.5}) {
    scene.objects = {object("Light", Sphere<double>{{1, 0, 2}, radius}, light),
                     object("Spot", Disk<double>{{0, 0, 0}, {0, 0, 1}, 0.01}, matte(0.6))};
    // A sphere wholly above the horizon: E = pi L (r / d)^2 cos.
    const double d2 = 5, expected = 0.6 * 3 * radius * radius / d2 * 2 / std::sqrt(d2);
    const double got = light_along(scene, {0.0003, 0, 0.001}, {0, 0, 0}, 1 << 12).mean.x;
    CHECK(got == Approx(expected).epsilon(0.002));
  }
  for (const double radius : {0.1, 1.0, 20.0}) {
    // A disk overhead: E = pi L r^2 / (r^2 + h^2).
    scene.objects = {object("Light", Disk<double>{{0, 0, 2}, {0, 0, -1}, radius}, light),
                     object("Spot", Disk<double>{{0, 0, 0}, {0, 0, 1}, 0.01}, matte(0.6))};
    const double expected = 0.6 * 3 * radius * radius / (radius * radius + 4);
    CHECK(light_along(scene, {0.0003, 0, 0.001}, {0, 0, 0}, 1 << 12).mean.x == Approx(expected).epsilon(0.003));
  }
}
