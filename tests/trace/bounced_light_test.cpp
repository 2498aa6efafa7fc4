// Light between surfaces in the place of ambient light: Whitted's tracer counts what lamps send straight, patches all
// else, and each of it once.

#include <cmath>

#include "support/catch.h"
#include "trace/photon_scenes.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Scene by_patches(Scene scene) {
  scene.render.integrator = Integrator::whitted;
  scene.render.radiosity.as_ambient = true;
  scene.render.radiosity.tolerance = 1e-5;
  scene.background = Rgbd(0.0);
  scene.ambient = Rgbd(0.7);  // which nothing sends out any more
  for (Object& each : scene.objects) each.material.specular = Rgbd(0.0), each.material.ambient = Rgbd(0.5);
  return scene;
}

template <class T>
Picture<T> seen(const Scene& scene, int width, int height, Observer* observer = nullptr) {
  return picture_by<T>(scene, width, height, {},
                       [&](const World<T>& world, const auto& camera, const PixelBlock& block, const PutPixel<T>& put) {
                         const SceneKernel<T> kernel(scene, world);
                         return observer ? kernel.watched(camera, block, *observer, put) : kernel(camera, block, put);
                       });
}

// Two walls, of which one is red, a mirror and a lamp over a floor.
Scene corner() {
  Material red = matt(0.5), mirror = matt(0.1);
  red.diffuse = {0.8, 0.1, 0.1};
  mirror.reflection = Rgbd(0.8);
  Scene scene;
  scene.objects = {{"Floor", Polygon<double>{{{-2, -2, -1}, {2, -2, -1}, {2, 2, -1}, {-2, 2, -1}}, {}}, matt(0.7)},
                   {"Wall", Box<double>{{2, -2, -1}, {2.5, 2, 1}}, red},
                   {"Mirror", Sphere<double>{{0, 0.5, 0}, 0.6}, mirror}};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{-1, -1, 0}, {}}}};
  scene.camera.eye = {-4, 0, 0};
  scene.camera.screen = {1, 1.2, 9};
  return by_patches(scene);
}

}  // namespace

TEST_CASE("in a furnace Whitted's tracer sees E / (1 - rho) once patches give it ambient light") {
  Scene furnace;
  furnace.objects = {{"Room", Box<double>{{-1, -2, -1}, {3, 1, 1}}, matt(0.6, 0.3)}};
  furnace.camera.eye = {0, 0, 0};
  furnace.camera.look_at = {1, 0.3, 0};
  furnace.camera.screen = {1, 2, 8};
  furnace = by_patches(furnace);
  furnace.render.radiosity.patch = 1.3;
  furnace.render.radiosity.tolerance = 1e-7;
  for (const Integrator integrator : {Integrator::automatic, Integrator::whitted, Integrator::distributed}) {
    furnace.render.integrator = integrator;
    for (const double shade : {seen<double>(furnace, 9, 7).at(4, 3).x, seen<double>(furnace, 9, 7).at(0, 0).x})
      CHECK(shade == Approx(0.3 / 0.4).epsilon(1e-4));
    CHECK(seen<float>(furnace, 3, 3).at(1, 1).x == Approx(0.75).epsilon(1e-4));
  }
}

TEST_CASE("what lamps send straight counts once, what is reflected as often as it is", "[odds]") {
  constexpr double radius = 2, albedo = 0.5;
  Scene ball = by_patches(hollow_ball(radius, albedo, {0, 0, 0}, Attenuation{0, 0, 1}));
  ball.render.radiosity.patch = 0.5;
  CHECK(mean_of_pictures(ball, 8, 8, 1, 1).mean == Approx(albedo / (radius * radius) / (1 - albedo)).epsilon(0.02));
  // Under a black roof nothing comes back.
  Scene floor;
  floor.objects = {{"Floor", Polygon<double>{{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}}, {}}, matt(0.5)},
                   {"Roof", Polygon<double>{{{0, -1, 0.5}, {1, -1, 0.5}, {1, 1, 0.5}, {0, 1, 0.5}}, {}}, matt(0)}};
  floor.lights = {{"Lamp", Rgbd(1.0), PointLight{{0, 0, 1}, {0, 0, 1}}}};
  floor.camera.eye = {-3, 0, 1};
  floor.camera.screen = {1, 1, 8};
  const Scene dark = by_patches(floor);
  Scene without = dark;
  without.render.radiosity.as_ambient = false;
  without.ambient = Rgbd(0.0);
  CHECK(same_bits(seen<double>(dark, 31, 31), seen<double>(without, 31, 31)));
}

TEMPLATE_TEST_CASE("light between surfaces is the same watched, in the strip and in mirrors", "", float, double) {
  struct Sums final : Observer {
    int bounced = 0, all = 0;
    void record(Event&& event) override {
      if (const auto* sum = std::get_if<ShadeComputed>(&event.detail)) {
        ++all;
        bounced += sum->irradiance && sum->irradiance->x > sum->irradiance->z;
      }
    }
  } sums;
  const Scene scene = corner();
  const auto plain = seen<TestType>(scene, 27, 21);
  CHECK(same_bits(plain, seen<TestType>(scene, 27, 21, &sums)));
  CHECK(sums.bounced > 100);  // reddened by the wall
  CHECK(sums.all > 27 * 21 / 3);
  const auto strip = picture_by<TestType>(
      scene, 9, 1, {},
      [&](const World<TestType>& world, const auto& /*own*/, const PixelBlock& block, const PutPixel<TestType>& put) {
        const SceneKernel<TestType> kernel(scene, world, std::nullopt, true);
        return kernel(RayGenerator<TestType>(scene, {9, 1}, {27, 21}), block, put);
      });
  for (int cell = 0; cell < 9; ++cell) CHECK(strip.at(cell, 0) == plain.at(3 * cell + 1, 10));
}

TEST_CASE("those that follow light between surfaces themselves take none from patches, nor do casts and faults") {
  for (const Integrator integrator : {Integrator::path, Integrator::cast}) {
    Scene scene = corner();
    scene.render.integrator = integrator;
    CHECK_FALSE(takes_ambient_from_patches(scene));
    Scene plain = scene;
    plain.render.radiosity.as_ambient = false;
    CHECK(same_bits(seen<double>(scene, 13, 9), seen<double>(plain, 13, 9)));
  }
  const Scene scene = corner();
  CHECK(takes_ambient_from_patches(scene));
  CHECK(effects_of(scene).used(Effect::indirect_light));
  CHECK(effects_of(scene)[Effect::indirect_light].why.find("patches") != std::string::npos);
  const World<double> faulty(scene, AcceleratorKind::automatic, Fault::reflection_flipped);
  CHECK_FALSE(SceneKernel<double>(scene, faulty).shoots_light());
  CHECK(SceneKernel<double>(scene, World<double>(scene)).shoots_light());
  CHECK(SceneKernel<double>(scene, World<double>(scene)).radiosity() == nullptr);
}
