// Normals of maps in scenes: neither light from behind nor energy comes of them, and the integrators agree.

#include "support/catch.h"
#include "support/effort.h"
#include "trace/maps.h"
#include "trace/paths.h"
#include "trace/photon_scenes.h"
#include "trace/sampled.h"

#include <algorithm>

using namespace raywalk;
using namespace raywalk::test;

namespace {

Material with_normals(const std::shared_ptr<const Image>& pixels, double width = 1, double height = 1,
                      double strength = 1) {
  Material material = matt(1);
  material.normal_map = NormalMap{{"normals.png", width, height, pixels}, strength};
  return material;
}

Material with_heights(const std::shared_ptr<const Image>& pixels, double width, double height, double relief) {
  Material material = matt(1);
  material.bump_map = BumpMap{{"heights.png", width, height, pixels}, relief, MapChannel::red};
  return material;
}

}  // namespace

TEST_CASE("a matt floor of one leaning normal loses what it would send below, (1 - cos) / 2, and a mirror no more",
          "[odds]") {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.background = Rgbd(1.0);
  std::size_t number = 0;
  for (const double degrees : {0.0, 20.0, 40.0, 60.0}) {
    const Vec3d normal(std::sin(degrees * degree), 0, std::cos(degrees * degree));
    for (const double rough : {0.0, 0.5}) {
      if (left_out(number++, 3)) continue;
      CAPTURE(degrees, rough);
      Material floor = with_normals(uniform(coded(normal)));
      floor.diffuse_roughness = rough;
      scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, floor)};
      // From where the reflected ray of each stays above the floor.
      const Vec3d eye(2, 0, 2);
      const Estimate seen = light_along(scene, eye, {0, 0, 0}, 4000, {0, never, PathStrategy::both});
      const double kept = (1 + std::cos(degrees * degree)) / 2;
      if (rough == 0) CHECK(std::abs(seen.mean.x - kept) < 4.5 * seen.error + 1e-3);
      CHECK(seen.mean.x < 1 + 4.5 * seen.error + 1e-9);
      CHECK(seen.mean.x > kept - 0.1 - 4.5 * seen.error);
      Material mirror = floor;
      mirror.diffuse = Rgbd(0.0);
      mirror.reflection = Rgbd(1.0);
      for (const double roughness : {0.0, 0.2, 0.8}) {
        mirror.roughness = roughness;
        scene.objects[0].material = mirror;
        const Estimate shown = light_along(scene, eye, {0, 0, 0}, 4000, {0, never, PathStrategy::both});
        CHECK(shown.mean.x < 1 + 4.5 * shown.error + 1e-3);
        if (roughness == 0) CHECK(shown.mean.x == Approx(1));
        CHECK(shown.mean.x > 0.45);
        Scene rays = scene;
        rays.render.integrator = Integrator::distributed;
        const Sampled sampled = sample(rays, eye, {0, 0, 0}, 4000);
        CHECK(std::abs(sampled.mean - shown.mean.x) < sampled.tolerance() + 4.5 * shown.error + 1e-3);
      }
    }
  }
}

TEST_CASE("a lamp behind the surface does not shine through a bent normal, nor is anything black that faces it") {
  Scene scene;
  const Vec3d normal = normalize(Vec3d(1, 0, 1));
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, with_normals(uniform(coded(normal))))};
  const Vec3d eye(0.5, 0, 3);
  for (const Integrator integrator : {Integrator::whitted, Integrator::distributed, Integrator::path}) {
    scene.render.integrator = integrator;
    scene.lights = {lamp({4, 0, -0.5})};
    const auto seen = [&] {
      if (integrator == Integrator::path)
        return light_along(scene, eye, {0, 0, 0}, 4, {2, never, PathStrategy::both}).mean.x;
      return shade_along(scene, eye, {0, 0, 0}).x;
    };
    CHECK(seen() == 0);
    scene.lights = {lamp({4, 0, 0.5})};
    CHECK(seen() == Approx(dot(normal, normalize(Vec3d(4, 0, 0.5)))).epsilon(1e-6));
  }
  // However flat it is seen, a mirror shows what is above it.
  scene.lights.clear();
  scene.background = Rgbd(1.0);
  scene.objects[0].material.diffuse = Rgbd(0.0);
  scene.objects[0].material.reflection = Rgbd(1.0);
  for (const double height : {1.0, 0.1, 1e-3, 1e-6}) {
    for (const double side : {-1.0, 1.0}) {
      scene.render.integrator = Integrator::whitted;
      CHECK(shade_along(scene, {3 * side, 0, height}, {0, 0, 0}).x == Approx(1));
      CHECK(shade_along<float>(scene, {3 * side, 0, height}, {0, 0, 0}).x == Approx(1));
      CHECK(light_along(scene, {3 * side, 0, height}, {0, 0, 0}, 4, {0, never, PathStrategy::both}).mean.x ==
            Approx(1));
    }
  }
}

TEST_CASE("glass of bent normals passes on no more than it gets, and the ray that goes in stays in") {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.background = Rgbd(1.0);
  const auto normals = image_of(8, 8, [](double u, double v) {
    return coded(normalize(Vec3d(0.8 * std::sin(2 * pi_v<double> * u), 0.8 * std::cos(2 * pi_v<double> * v), 1)));
  });
  for (const double roughness : {0.0, 0.3}) {
    Material glass = black();
    glass.transmission = Rgbd(1.0);
    glass.dielectric = true;
    glass.roughness = roughness;
    glass.normal_map = NormalMap{{"normals.png", 0.4, 0.4, normals}, 1};
    scene.objects = {object("Ball", Sphere<double>{{5, 0, 0}, 1}, glass)};
    for (const double y : {0.0, 0.4, 0.8, 0.97}) {
      CAPTURE(roughness, y);
      const Estimate seen = light_along(scene, {0, 0, 0}, {5, y, 0.1}, 3000, {0, 4, PathStrategy::both});
      CHECK(seen.mean.x < 1 + 4.5 * seen.error + 2e-3);
      CHECK(seen.mean.x > (roughness == 0 ? 0.99 : 0.5) - 4.5 * seen.error);
    }
  }
}

TEST_CASE("photons and paths agree about a room with a relief", "[odds]") {
  Scene scene;
  scene.render.sampler = Sampler::random;
  const auto heights =
      image_of(16, 16, [](double u, double v) { return Rgbd(0.5 + 0.5 * std::sin(6.283 * u) * std::sin(6.283 * v)); });
  Material wall = with_heights(heights, 0.8, 0.8, 0.08);
  wall.diffuse = Rgbd(0.6);
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, wall),
                   object("Wall", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, wall),
                   object("Ball", Sphere<double>{{0.2, -1, 0.7}, 0.7}, wall)};
  scene.lights = {lamp({-2, 2, 3}, 0.6)};
  scene = looking(scene, {-4, 0, 1}, {0, 0, 0.8});
  scene.camera.screen = {1, 1, 8};
  check_against_paths(by_photons(scene, 100000, 60),
                      path_estimates(scene, 10, 10, 400, {12, never, PathStrategy::both}), 0.05);
}

TEST_CASE("a walk shows the normal that a hit is shaded with") {
  Scene scene;
  const Vec3d normal = normalize(Vec3d(0.3, 0.2, 1));
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, with_normals(uniform(coded(normal))))};
  const auto found = record_along(scene, {0.5, 0, 3}, {0, 0, 0}).all<Found>();
  REQUIRE(found.size() == 1);
  CHECK(length(found[0].normal - normal) < 1e-6);
}
