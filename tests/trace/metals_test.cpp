// Metals and rough mirrors in scenes: by every integrator that follows them the same light.

#include "scene/metals.h"
#include "support/catch.h"
#include "trace/microfacets.h"
#include "trace/paths.h"
#include "trace/photon_scenes.h"
#include "trace/sampled.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Material rough(double roughness, MirrorKind kind = MirrorKind::ideal) {
  Material material = black();
  material.reflection = Rgbd(1.0);
  material.roughness = roughness;
  material.mirror = kind;
  return material;
}

// A floor, and nothing that is straight above it or in it.
Scene floor_of(const Material& material) {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.objects = {object("Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, material)};
  return scene;
}

const Vec3d above_floor(-2, 0.5, 1.5), on_floor(0, 0, 0);

// A corner of a room with rough metals in it, lit by a lamp and by what glows.
Scene metal_corner() {
  Scene scene = floor_of(matt(0.6));
  scene.background = {0.1, 0.2, 0.3};
  scene.objects.push_back({"Gold", Sphere<double>{{0, 1, 0.8}, 0.8}, rough(0.3, MirrorKind::gold)});
  scene.objects.push_back({"Copper", Sphere<double>{{0.2, -1, 0.7}, 0.7}, rough(0, MirrorKind::copper)});
  scene.objects.push_back({"Wall", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, rough(0.6, MirrorKind::aluminium)});
  scene.objects.push_back({"Glow", Sphere<double>{{-1, 0, 2.5}, 0.4}, matt(0, 2)});
  scene.lights = {lamp({-2, 2, 3}, 0.6)};
  scene = looking(scene, {-4, 0, 1}, {0, 0, 0.8});
  scene.camera.screen = {1, 1, 8};
  return scene;
}

}  // namespace

TEST_CASE("a rough mirror in even light is not to be seen, by paths and by distributed rays") {
  for (const double roughness : {0.001, 0.2, 1.0})
    for (const bool paths : {false, true}) {
      CAPTURE(roughness, paths);
      Scene scene = floor_of(rough(roughness));
      scene.objects[0].shape = Sphere<double>{{0, 0, 0}, 0.5};  // nothing is met twice
      scene.background = Rgbd(1.0);
      if (paths) {
        const Estimate seen = light_along(scene, above_floor, {0.1, 0.1, 0.1}, 20000);
        CHECK(std::abs(seen.mean.x - 1) < 4.5 * seen.error + 1e-3);
        CHECK(seen.error < 0.01);
      } else {
        scene.render.integrator = Integrator::distributed;
        const Sampled seen = sample(scene, above_floor, {0.1, 0.1, 0.1}, 20000);
        CHECK(std::abs(seen.mean - 1) < seen.tolerance() + 1e-3);
      }
    }
}

TEST_CASE("a lamp shines on a rough mirror as its scattering function says, by whitted and by paths alike") {
  const Vec3d light(1, -1, 2);
  for (const MirrorKind kind : {MirrorKind::ideal, MirrorKind::gold})
    for (const double roughness : {0.1, 0.4, 1.0}) {
      Scene scene = floor_of(rough(roughness, kind));
      scene.lights = {lamp(light, 2)};
      scene.render.integrator = Integrator::whitted;
      const Microsurface<double> mirrors(rough(roughness, kind));
      const Rgbd expected = 2 * pi_v<double> *
                            mirrors.value(mirrors.facets->evaluate({0, 0, 1}, normalize(above_floor - on_floor),
                                                                   normalize(light - on_floor)));
      const Rgbd whitted = shade_along(scene, above_floor, on_floor);
      scene.render.path_length = 2;
      const Rgbd paths = light_along(scene, above_floor, on_floor, 2, {2, never, PathStrategy::both}).mean;
      for (int c = 0; c < 3; ++c) {
        CHECK(whitted[c] == Approx(expected[c]).epsilon(1e-9));
        CHECK(paths[c] == Approx(expected[c]).epsilon(1e-7));  // nearly the same ray
      }
      CHECK(expected.x > 0.01);
    }
}

TEST_CASE("a smooth metal weighs what it reflects by Fresnel, and needs no random number") {
  Scene scene = floor_of(rough(0, MirrorKind::copper));
  scene.background = Rgbd(1.0);
  const auto [eta, k] = refractive_index(MirrorKind::copper);
  for (const Vec3d& from : {Vec3d(0, 0, 3), Vec3d(-2, 0, 1), Vec3d(-9, 1, 0.1)}) {
    const Rgbd expected = Conductor<double>{eta, k}.reflectance(normalize(from).z);
    const auto seen = picture<double>(looking(scene, from, {0, 0, 0}), 1, 1);
    CHECK(seen.statistics.random_draws() == 0);
    for (int c = 0; c < 3; ++c) CHECK(seen.at(0, 0)[c] == Approx(expected[c]).epsilon(1e-12));
  }
}

TEST_CASE("what glows is found in rough metals by its light and by chance alike") {
  const Scene scene = metal_corner();
  for (const Vec3d& at : {Vec3d(-0.6, 0.8, 1.2), Vec3d(2, 0.1, 1.5), Vec3d(-0.4, -1, 0.9)}) {
    const Estimate lights = light_along(scene, {-4, 0, 1}, at, 6000, {4, never, PathStrategy::lights}, 1);
    const Estimate chance = light_along(scene, {-4, 0, 1}, at, 6000, {4, never, PathStrategy::directions}, 2);
    const Estimate both = light_along(scene, {-4, 0, 1}, at, 6000, {4, never, PathStrategy::both}, 3);
    CHECK(std::abs(both.mean.x - chance.mean.x) < 4.5 * (both.error + chance.error));
    // By lights alone nothing is seen of them in a smooth mirror.
    if (at.y > -0.5) CHECK(std::abs(both.mean.x - lights.mean.x) < 4.5 * (both.error + lights.error));
  }
}

TEST_CASE("photons and paths agree among rough metals", "[odds]") {
  const Scene scene = by_photons(metal_corner(), 60000, 40);
  check_against_paths(scene, path_estimates(scene, 10, 10, 400, {12, never, PathStrategy::both}));
}

TEMPLATE_TEST_CASE("watched or not, rough metals have the same bits by paths, and all of them are finite", "", float,
                   double) {
  using T = TestType;
  Scene scene = metal_corner();
  for (const bool sky : {false, true}) {
    if (sky) scene.sky = Sky{GradientSky{}};
    Recording recording;
    const auto plain = path_picture<T>(scene, 31, 23, {}, {3, 7});
    const auto watched = path_picture<T>(scene, 31, 23, {}, {3, 7}, &recording);
    CHECK(same_bits(plain, watched));
    CHECK(same_counts(plain.statistics, watched.statistics));
    CHECK(plain.statistics.not_finite == 0);
    CHECK(plain.statistics.drawn(Effect::microfacets) > 0);
    CHECK(plain.statistics.drawn(Effect::gloss) == 0);
  }
}
