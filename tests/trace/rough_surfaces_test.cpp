// Rough matt surfaces and rough glass in scenes: by every integrator that follows them the same light.

#include "support/catch.h"
#include "trace/microfacets.h"
#include "trace/paths.h"
#include "trace/photon_scenes.h"
#include "trace/rough_dielectric.h"
#include "trace/sampled.h"

#include <algorithm>

using namespace raywalk;
using namespace raywalk::test;

namespace {

Material dusty(double albedo, double roughness) {
  Material material = matt(albedo);
  material.diffuse_roughness = roughness;
  return material;
}

Material frosted(double roughness, double ior = 1.5) {
  Material material = black();
  material.transmission = Rgbd(1.0);
  material.dielectric = true;
  material.ior = ior;
  material.roughness = roughness;
  return material;
}

// A ball in light from everywhere alike.
Scene ball_in_light(const Material& material) {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.background = Rgbd(1.0);
  scene.objects = {object("Ball", Sphere<double>{{5, 0, 0}, 1}, material)};
  return scene;
}

// A corner of a room with rough walls and a ball of rough glass, in which there is something matt.
Scene rough_corner() {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.background = {0.1, 0.2, 0.3};
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, dusty(0.7, 1)),
                   object("Wall", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, dusty(0.5, 0.4)),
                   object("Glass", Sphere<double>{{0, 1, 0.8}, 0.8}, frosted(0.4)),
                   object("Core", Sphere<double>{{0, 1, 0.8}, 0.3}, matt(0.7)),
                   object("Moon", Sphere<double>{{0.2, -1, 0.7}, 0.7}, dusty(0.8, 1)),
                   object("Glow", Sphere<double>{{-1, 0, 2.5}, 0.4}, matt(0, 2))};
  scene.lights = {lamp({-2, 2, 3}, 0.6)};
  scene = looking(scene, {-4, 0, 1}, {0, 0, 0.8});
  scene.camera.screen = {1, 1, 8};
  return scene;
}

}  // namespace

TEST_CASE("rough matt and glass balls in even light are not to be seen, by paths and by distributed rays") {
  for (const Material& material :
       {dusty(1, 0.5), dusty(1, 1), frosted(0.001), frosted(0.3), frosted(1), frosted(0.4, 1.1)})
    for (const double y : {0.0, 0.5, 0.9}) {
      CAPTURE(material.roughness, material.diffuse_roughness, material.ior, y);
      Scene scene = ball_in_light(material);
      const Estimate seen = light_along(scene, {0, 0, 0}, {5, y, 0}, 4000, {0, never, PathStrategy::both});
      CHECK(std::abs(seen.mean.x - 1) < 4.5 * seen.error + 1e-3);
      CHECK(seen.error < 0.03);
      if (!material.transmits()) continue;
      scene.render.integrator = Integrator::distributed;
      scene.limits.depth = 9;
      const Sampled rays = sample(scene, {0, 0, 0}, {5, y, 0}, 400);
      // What is still inside after as many rays is lost.
      CHECK(rays.mean < 1 + rays.tolerance() + 1e-3);
      CHECK(rays.mean > 0.9 - rays.tolerance());
    }
}

TEST_CASE("rough glass in rough glass loses nothing either") {
  Scene scene = ball_in_light(frosted(0.4, 1.33));
  scene.objects.push_back(object("Inner", Sphere<double>{{5, 0, 0}, 0.6}, frosted(0.2, 1.7)));
  const Estimate seen = light_along(scene, {0, 0, 0}, {5, 0.2, 0}, 6000, {0, never, PathStrategy::both});
  CHECK(std::abs(seen.mean.x - 1) < 4.5 * seen.error + 2e-3);
  const World<double> world(by_path(scene));
  REQUIRE_FALSE(world.bodies.empty());
  CHECK(world.rough_dielectric(world.surfaces[1], 1.33, 1.7) != nullptr);
  CHECK(world.rough_dielectric(world.surfaces[1], 1.7, 1.33) != nullptr);
  CHECK(world.rough_dielectric(world.surfaces[0], 1, 1.33) != nullptr);
  CHECK(world.rough_dielectric(world.surfaces[0], 1.33, 1.33) == nullptr);
}

TEST_CASE("a lamp shines on a rough matt floor as its scattering function says, by all integrators alike") {
  const Vec3d light(1, -1, 2), eye(-2, 0.5, 1.5);
  for (const double roughness : {0.2, 1.0}) {
    Scene scene;
    scene.render.sampler = Sampler::random;
    scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, dusty(0.6, roughness))};
    scene.lights = {lamp(light, 2)};
    const Vec3d l = normalize(light);
    const double expected = 2 * l.z * RoughDiffuse<double>(roughness).value(Rgbd(0.6), {0, 0, 1}, normalize(eye), l).x;
    for (const Integrator integrator : {Integrator::cast, Integrator::whitted, Integrator::distributed}) {
      scene.render.integrator = integrator;
      CHECK(shade_along(scene, eye, {0, 0, 0}).x == Approx(expected).epsilon(1e-9));
    }
    scene.render.path_length = 2;
    CHECK(light_along(scene, eye, {0, 0, 0}, 2, {2, never, PathStrategy::both}).mean.x ==
          Approx(expected).epsilon(1e-7));
    CHECK(std::abs(expected / (2 * l.z * 0.6) - 1) > 0.01);
  }
}

TEST_CASE("a lamp shows in rough glass, which whitted else takes as smooth") {
  const Vec3d light(1, -1, 2), eye(-2, 0.5, 1.5);
  Scene scene;
  scene.background = {0.2, 0.4, 0.6};
  scene.objects = {object("Block", Box<double>{{-9, -9, -9}, {9, 9, 0}}, frosted(0.3))};
  scene.render.integrator = Integrator::whitted;
  scene.limits.depth = 2;
  const Rgbd rough = shade_along(scene, eye, {0, 0, 0});
  scene.lights = {lamp(light, 2)};
  const Rgbd lit = shade_along(scene, eye, {0, 0, 0});
  scene.lights.clear();
  scene.objects[0].material.roughness = 0;
  CHECK(rough == shade_along(scene, eye, {0, 0, 0}));
  using Glass = RoughDielectric<double>;
  const Glass glass(0.3, 1, 1.5);
  const auto at = glass.evaluate(Glass::Side::rarer, {0, 0, 1}, normalize(eye), normalize(light));
  CHECK(lit.x - rough.x == Approx(2 * pi_v<double> * (at.once + at.again)).epsilon(1e-9));
}

TEST_CASE("a lamp behind rough glass shows in it to paths and photons, but not to paths where the glass filters it") {
  const Vec3d light(0.5, -0.3, -2), eye(-2, 0.5, 1.5);
  Scene scene;
  scene.background = Rgbd(0.0);
  scene.objects = {object("Pane", Disk<double>{{0, 0, 0}, {0, 0, 1}, 9}, frosted(0.3))};
  scene.lights = {lamp(light, 2)};
  scene = looking(scene, eye, {0, 0, 0});
  scene.camera.screen = {1, 1e-9, 1};
  scene.camera.fov.reset();
  using Glass = RoughDielectric<double>;
  const Glass glass(0.3, 1, 1.5);
  const auto at = glass.evaluate(Glass::Side::rarer, {0, 0, 1}, normalize(eye), normalize(light));
  for (const Integrator integrator : {Integrator::path, Integrator::photons}) {
    scene.render.integrator = integrator;
    CHECK(mean_of_pictures(scene, 1, 1, 1, 2).mean == Approx(2 * pi_v<double> * (at.once + at.again)).epsilon(1e-6));
  }
  CHECK(at.once > 0.01);
  scene.render.integrator = Integrator::path;
  scene.objects[0].material.shadow = ShadowKind::filtered;
  CHECK(mean_of_pictures(scene, 1, 1, 1, 2).mean == 0);
}

TEST_CASE("nearly smooth glass and matt surfaces bring what smooth ones do") {
  Scene scene = rough_corner();
  const auto set = [&](double roughness) {
    for (Object& each : scene.objects) {
      if (each.material.transmits()) each.material.roughness = roughness;
      each.material.diffuse_roughness = roughness;
    }
  };
  for (const Vec3d& at : {Vec3d(-0.6, 0.8, 1.2), Vec3d(2, 0.1, 1.5), Vec3d(-0.4, -1, 0.9)}) {
    set(0);
    const Estimate smooth = light_along(scene, {-4, 0, 1}, at, 8000, {5, never, PathStrategy::both}, 1);
    set(1e-6);
    const Estimate rough = light_along(scene, {-4, 0, 1}, at, 8000, {5, never, PathStrategy::both}, 2);
    CHECK(std::abs(smooth.mean.x - rough.mean.x) < 4.5 * (smooth.error + rough.error) + 0.002);
  }
}

TEST_CASE("a matt surface keeps every bit beside a rough one") {
  Scene scene = rough_corner();
  for (Object& each : scene.objects) each.material.diffuse_roughness = 0, each.material.roughness = 0;
  const auto plain = path_picture<double>(scene, 15, 11, {1, never, PathStrategy::both}, {2, 7});
  scene.objects.push_back(object("Behind", Sphere<double>{{-9, 0, 1}, 1}, dusty(0.8, 1)));
  scene.objects.back().material.mirror = MirrorKind::gold;
  scene.objects.back().material.reflection = Rgbd(0.1);
  const auto beside = path_picture<double>(scene, 15, 11, {1, never, PathStrategy::both}, {2, 7});
  CHECK(same_bits(plain, beside));
}

TEST_CASE("what glows is found through rough glass and on rough matt walls by its light and by chance alike",
          "[odds]") {
  const Scene scene = rough_corner();
  for (const Vec3d& at : {Vec3d(-0.6, 0.8, 1.2), Vec3d(0, 1, 0.8), Vec3d(2, 0.1, 1.5), Vec3d(-0.4, -1, 0.9)}) {
    const Estimate lights = light_along(scene, {-4, 0, 1}, at, 8000, {4, never, PathStrategy::lights}, 1);
    const Estimate chance = light_along(scene, {-4, 0, 1}, at, 8000, {4, never, PathStrategy::directions}, 2);
    const Estimate both = light_along(scene, {-4, 0, 1}, at, 8000, {4, never, PathStrategy::both}, 3);
    CHECK(std::abs(both.mean.x - chance.mean.x) < 4.5 * (both.error + chance.error));
    CHECK(std::abs(both.mean.x - lights.mean.x) < 4.5 * (both.error + lights.error));
  }
}

TEST_CASE("photons and paths agree among rough walls and rough glass", "[odds]") {
  constexpr double few = 0.05;  // in the corner's open space: what photons do not say is in their interval
  const auto agree = [](const Scene& scene, int length) {
    check_against_paths(scene, path_estimates(scene, 10, 10, 400, {length, never, PathStrategy::both}), few);
  };
  Scene scene = rough_corner();
  scene.lights.clear();  // a lamp's light through glass is for photons alone
  agree(by_photons(scene, 100000, 60), 14);
  scene.objects.erase(scene.objects.begin() + 2);
  scene.lights = {lamp({-2, 2, 3}, 0.6)};
  agree(by_photons(scene, 100000, 60), 12);
}

TEST_CASE("the flat world of photons takes matt surfaces as smooth; radiosity says that it does, too") {
  Scene rough = hollow_ball(2, 0.6, {0.3, 0, 0}, {0, 1, 0}), smooth = rough;
  rough.objects[0].material.diffuse_roughness = 1;
  rough = by_photons(rough, 2000, 30), smooth = by_photons(smooth, 2000, 30);
  CHECK(mean_of_pictures(rough, 9, 1, 1, 2, true).mean == mean_of_pictures(smooth, 9, 1, 1, 2, true).mean);
  CHECK(mean_of_pictures(rough, 9, 1, 1, 2).mean != mean_of_pictures(smooth, 9, 1, 1, 2).mean);
  rough.render.integrator = Integrator::radiosity;
  CHECK(effects_of(rough)[Effect::microfacets].why == "none: radiosity takes matt surfaces as smooth");
}

TEMPLATE_TEST_CASE("watched or not, rough surfaces have the same bits, and all of them are finite", "", float, double) {
  using T = TestType;
  Scene scene = rough_corner();
  Recording recording;
  const auto plain = path_picture<T>(scene, 31, 23, {}, {3, 7});
  const auto watched = path_picture<T>(scene, 31, 23, {}, {3, 7}, &recording);
  CHECK(same_bits(plain, watched));
  CHECK(same_counts(plain.statistics, watched.statistics));
  CHECK(plain.statistics.not_finite == 0);
  CHECK(plain.statistics.drawn(Effect::microfacets) > 0);
  CHECK(plain.statistics.drawn(Effect::translucency) == 0);
  scene.render.integrator = Integrator::distributed;
  Recording rays;
  const auto seen = picture<T>(scene, 31, 23, {3, 7});
  CHECK(same_bits(seen, watched_picture<T>(scene, 31, 23, rays, {3, 7})));
  CHECK(seen.statistics.not_finite == 0);
  CHECK(seen.statistics.drawn(Effect::microfacets) > 0);
  // Snell's law holds at the facet that turned the ray, where one did.
  int bent = 0;
  for (const RayFormed& formed : rays.template all<RayFormed>()) {
    if (formed.kind != RayKind::refract || !formed.snell) continue;
    const auto sine = [](double cos) { return std::sqrt(std::max(1 - cos * cos, 0.0)); };
    ++bent;
    CHECK(formed.snell->n1 * sine(formed.snell->cos_in) ==
          Approx(formed.snell->n2 * sine(formed.snell->cos_out)).margin(2e-3));
  }
  CHECK(bent > 10);
}
