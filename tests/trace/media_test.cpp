// Light inside of bodies that scatter it, against exact values of radiative transfer.

#include <algorithm>
#include <cmath>

#include "support/catch.h"
#include "support/effort.h"
#include "trace/paths.h"
#include "trace/sampled.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Bends nothing. One unit of length is one mean free path.
Material milky(double albedo, double g = 0) {
  Material material = black();
  material.transmission = Rgbd(1.0);
  material.ior = 1;
  material.scattering = Rgbd(albedo);
  material.absorption = Rgbd(1 - albedo);
  material.anisotropy = g;
  return material;
}

constexpr double aside = 1e6;

// Everything with x > 0, under a background of 1.
Scene half_space(double albedo) {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.background = Rgbd(1.0);
  scene.objects = {object("Milk", Plane<double>{{0, 0, 0}, {-1, 0, 0}}, milky(albedo))};
  return scene;
}

// What comes back along a ray that meets x = 0 at this cosine to the normal.
Estimate seen_at(const Scene& scene, double cos, int samples, bool flat = false, std::uint64_t seed = 1) {
  PathSettings settings;
  settings.flat = flat;
  return light_along(scene, {-cos, -std::sqrt(1 - cos * cos), 0}, {0, 0, 0}, samples, settings, seed);
}

// The mean over all directions, each weighted by its cosine: the reflectance under diffuse light.
Estimate diffuse(const Scene& scene, int samples, bool flat) {
  constexpr int strata = 64;
  Estimate mean{Rgbd(0.0), 0};
  for (int i = 0; i < strata; ++i) {
    const double share = (i + 0.5) / strata;
    // In space half the square of the cosine is spread evenly, in the plan the sine.
    const double cos = flat ? std::sqrt(1 - share * share) : std::sqrt(share);
    const Estimate seen = seen_at(scene, cos, samples / strata, flat, static_cast<std::uint64_t>(i) + 1);
    mean.mean += seen.mean / static_cast<double>(strata);
    mean.error += seen.error * seen.error / (strata * strata);
  }
  mean.error = std::sqrt(mean.error);
  return mean;
}

void check_close(const Estimate& found, double exact) {
  CAPTURE(found.mean.x, found.error, exact);
  CHECK(std::abs(found.mean.x - exact) < 3.5 * found.error + 1e-12);
  CHECK(found.error < (rounds(8) == 8 ? 5e-4 : 2e-3));
  if (rounds(8) == 8) CHECK(std::abs(found.mean.x - exact) < 1e-3);
}

}  // namespace

TEST_CASE("a half-space that scatters evenly reflects what Chandrasekhar says", "[odds]") {
  const int samples = rounds(1 << 20);
  check_close(seen_at(half_space(0.9), 1, samples), 0.414947);
  check_close(seen_at(half_space(0.5), 1, samples), 0.115226);
  check_close(diffuse(half_space(0.9), samples, false), 0.478024);
  check_close(diffuse(half_space(0.5), samples, false), 0.146544);
}

TEST_CASE("a half-space in the plan reflects what d'Eon and Williams say of Flatland", "[odds]") {
  const int samples = rounds(1 << 20);
  check_close(seen_at(half_space(0.9), 1, samples, true), 0.452252);
  check_close(seen_at(half_space(0.5), 1, samples, true), 0.132943);
  check_close(diffuse(half_space(0.9), samples, true), 0.488691);
  check_close(diffuse(half_space(0.5), samples, true), 0.152397);
}

TEST_CASE("what absorbs nothing reflects by Chandrasekhar's H", "[odds]") {
  // Lit and seen at one angle; a slab keeps 1 / (its thickness + twice the extrapolated end point) of it (H. van de
  // Hulst, "Multiple Light Scattering", 1980), and what is left out falls as exp(-thickness).
  constexpr double thickness = 24, beyond = 2 * 0.7104460895987;
  const auto h_of = [&](double cos, double exact) {
    Scene scene;
    scene.render.sampler = Sampler::random;
    scene.objects = {object("Slab", Box<double>{{0, -aside, -aside}, {thickness, aside, aside}}, milky(1))};
    DirectionalLight sun;
    sun.direction = {-cos, 0, std::sqrt(1 - cos * cos)};
    scene.lights = {{"Sun", Rgbd(1.0), sun}};
    const Estimate seen = seen_at(scene, cos, rounds(1 << 17));
    const double factor = cos / 4 * (1 / (2 * cos) - 1 / (thickness + beyond));
    const double h = std::sqrt(seen.mean.x / factor), error = seen.error / (2 * h * factor);
    CAPTURE(cos, h, error);
    CHECK(std::abs(h - exact) < 3.5 * error);
    CHECK(error < (rounds(8) == 8 ? 1e-2 : 3e-2));
  };
  h_of(0.5, 2.01278);
  h_of(1, 2.90781);
}

TEST_CASE("a medium that absorbs only is as Beer's law says, and one whose channels differ is so in each") {
  Scene scene;
  scene.background = Rgbd(1.0);
  Material material = milky(0);
  material.absorption = {0.1, 0.7, 3};
  material.scattering = {0, 1e-12, 0};  // so little that it is a medium for paths, but nothing is met
  scene.objects = {object("Slab", Box<double>{{0, -9, -9}, {0.8, 9, 9}}, material)};
  PathSettings settings;
  settings.roulette_from = never;
  // Each path has its own channel: the mean of many is exact only in the mean.
  const Estimates seen = path_estimates(
      [&] {
        Scene along = scene;
        along.camera.screen = {1, 1e-9, 1};
        along.camera.fov.reset();
        return looking(along, {-3, 0, 0}, {0, 0, 0});
      }(),
      1, 1, rounds(1 << 16), settings);
  for (int c = 0; c < 3; ++c) {
    CAPTURE(c, seen.mean[0][c], seen.error(0, c));
    CHECK(std::abs(seen.mean[0][c] - std::exp(-0.8 * material.absorption[c])) < 4.5 * seen.error(0, c) + 1e-9);
    CHECK(seen.error(0, c) < (rounds(8) == 8 ? 4e-3 : 1.2e-2));
  }
}

TEST_CASE("through a medium that is never left nothing is seen, be it a background or a sky") {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.background = Rgbd(1.0);
  scene.sky = Sky{GradientSky{Rgbd(1.0), Rgbd(1.0)}};
  Material clear = milky(0);
  SECTION("it absorbs") {
    scene.objects = {object("Sea", Plane<double>{{0, 0, 0}, {-1, 0, 0}}, clear)};
    CHECK(seen_at(scene, 0.7, 4).mean == Rgbd(0.0));
    SECTION("also from a wall in it") {
      scene.objects.push_back(object("Wall", Disk<double>{{0.5, -0.5, 0}, {0, 1, 0}, 0.4}, matte(1)));
      PathSettings settings;
      settings.max_length = 3;  // from the wall straight on
      CHECK(light_along(scene, {-1, 1, 0}, {0, 0, 0}, 64, settings).mean == Rgbd(0.0));
    }
    scene.sky.reset();
    CHECK(seen_at(scene, 0.7, 4).mean == Rgbd(0.0));
  }
  SECTION("it scatters: as much comes back under a sky as under a background") {
    scene.objects = {object("Milk", Plane<double>{{0, 0, 0}, {-1, 0, 0}}, milky(0.5))};
    const Estimate by_sky = seen_at(scene, 0.7, rounds(1 << 15));
    scene.sky.reset();
    const Estimate by_background = seen_at(scene, 0.7, rounds(1 << 15));
    CAPTURE(by_sky.mean.x, by_background.mean.x);
    CHECK(std::abs(by_sky.mean.x - by_background.mean.x) < 4.5 * (by_sky.error + by_background.error));
  }
}

TEST_CASE("channels that scatter differently are each as if alone") {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.background = Rgbd(1.0);
  Material material = milky(0.5);
  material.scattering = {0.9, 0.25, 2}, material.absorption = {0.1, 0.75, 2};
  scene.objects = {object("Milk", Plane<double>{{0, 0, 0}, {-1, 0, 0}}, material)};
  PathSettings settings;
  Scene along = scene;
  along.camera.screen = {1, 1e-9, 1};
  along.camera.fov.reset();
  const Estimates seen = path_estimates(looking(along, {-1, 0, 0}, {0, 0, 0}), 1, 1, rounds(1 << 17), settings);
  const Rgbd exact{0.414947, 0, 0.115226};
  for (const int c : {0, 2}) {
    CAPTURE(c, seen.mean[0][c], seen.error(0, c));
    CHECK(std::abs(seen.mean[0][c] - exact[c]) < 4 * seen.error(0, c));
  }
}

TEST_CASE("in a white furnace a body that absorbs nothing cannot be seen", "[odds]") {
  for (const double g : {-0.6, 0.0, 0.8}) {
    Scene scene;
    scene.render.sampler = Sampler::random;
    scene.background = Rgbd(0.7);
    scene.objects = {object("Ball", Sphere<double>{{0, 0, 0}, 3}, milky(1, g))};
    const auto even = [&] {
      const Estimate seen = light_along(scene, {-5, 1, 0}, {0, 0.5, 0}, rounds(1 << 14));
      CAPTURE(g, seen.mean.x, seen.error);
      CHECK(std::abs(seen.mean.x - 0.7) < 4 * seen.error + 1e-9);
      CHECK(seen.error < 0.02);
    };
    even();
    // A sky of the same radiance is also looked for from inside.
    GradientSky sky;
    sky.horizon = sky.zenith = Rgbd(0.7);
    scene.sky = Sky{sky};
    even();
    // Bent, and with a body around it that the eye is in.
    scene.objects[0].material.ior = 1.3;
    scene.objects[0].material.dielectric = true;
    even();
    scene.objects.push_back(object("Fog", Sphere<double>{{0, 0, 0}, 7}, milky(1, g)));
    even();
  }
}

TEST_CASE("light is found from inside alike, whichever way they are sampled", "[odds]") {
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.objects = {object("Milk", Sphere<double>{{0, 0, 0}, 1}, milky(0.8, 0.4)),
                   object("Lamp", Sphere<double>{{0.5, 3, 0}, 0.7}, glowing(5))};
  const auto same = [&] {
    double first = 0, first_error = 0;
    for (const PathStrategy strategy : {PathStrategy::directions, PathStrategy::both, PathStrategy::lights}) {
      PathSettings settings;
      settings.strategy = strategy;
      const Estimate seen = light_along(scene, {-5, 0, 0}, {0, 0.2, 0}, rounds(1 << 17), settings);
      CAPTURE(static_cast<int>(strategy), seen.mean.x, seen.error, first, first_error);
      CHECK(seen.mean.x > 0);
      if (strategy == PathStrategy::directions) first = seen.mean.x, first_error = seen.error;
      CHECK(std::abs(seen.mean.x - first) < 4.5 * std::hypot(seen.error, first_error));
    }
  };
  SECTION("emitters") { same(); }
  SECTION("emitters, from fog around all, and through a second body") {
    scene.objects.push_back(object("Fog", Sphere<double>{{0, 0, 0}, 9}, milky(0.3)));
    scene.objects[2].material.scattering /= 9.0, scene.objects[2].material.absorption /= 9.0;
    same();
  }
  SECTION("the sky") {
    GradientSky sky;
    sky.zenith = Rgbd(3.0);
    scene.sky = Sky{sky};
    same();
  }
}

TEST_CASE("a lamp's light that scatters once is as its integral says") {
  // Without the orders above the first, which take another ray: cos / 4 (1 - exp(-2 d)) / (2 cos), lit and seen along
  // the normal.
  constexpr double thickness = 1, albedo = 0.6;
  Scene scene;
  scene.render.sampler = Sampler::random;
  scene.objects = {object("Slab", Box<double>{{0, -9, -9}, {thickness, 9, 9}}, milky(albedo))};
  DirectionalLight sun;
  sun.direction = {-1, 0, 0};
  scene.lights = {{"Sun", Rgbd(1.0), sun}};
  PathSettings settings;
  settings.max_length = 3;  // to the slab, into it, to the sun
  const Estimate seen = light_along(scene, {-1, 0, 0}, {0, 0, 0}, rounds(1 << 17), settings);
  const double exact = albedo / 8 * -std::expm1(-2 * thickness);
  CAPTURE(seen.mean.x, seen.error, exact);
  CHECK(std::abs(seen.mean.x - exact) < 4 * seen.error);
  CHECK(seen.error < (rounds(8) == 8 ? 0.003 : 0.01) * exact);
}

TEST_CASE("walks inside have the same bits watched or not, in both precisions, and are finite") {
  Scene scene;
  scene.background = Rgbd(0.2);
  scene.objects = {object("Milk", Sphere<double>{{2, 0, 0}, 1}, milky(0.95, 0.5)),
                   object("Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, lambert()),
                   object("Lamp", Sphere<double>{{1, 2, 2}, 0.3}, glowing(9))};
  scene.objects[0].material.scattering = {9, 5, 2};
  const auto check = [&]<class T>(T) {
    Recording recording;
    const auto plain = path_picture<T>(scene, 9, 9, {}, {4, 3});
    const auto watched = path_picture<T>(scene, 9, 9, {}, {4, 3}, &recording);
    CHECK(same_bits(plain, watched));
    CHECK(same_counts(plain.statistics, watched.statistics));
    CHECK(plain.statistics.not_finite == 0);
    CHECK(plain.statistics.ends(Ending::scattered) > 100);
    CHECK(plain.statistics.drawn(Effect::scattering) > 100);
    std::uint64_t told = 0;
    for (const Found& found : recording.all<Found>()) {
      if (found.ending != Ending::scattered) continue;
      ++told;
      CHECK(found.object == 0);
    }
    CHECK(told == plain.statistics.ends(Ending::scattered));
    std::uint64_t formed = 0, ended = 0;
    for (const std::uint64_t rays : plain.statistics.rays) formed += rays;
    for (const Ending end : {Ending::hit, Ending::missed, Ending::blocked, Ending::reached_light, Ending::scattered})
      ended += plain.statistics.ends(end);
    CHECK(formed == ended);
  };
  check(1.0);
  check(1.0F);
  SECTION("also where bodies nest and bend") {
    scene.objects.push_back(object("Glass", Sphere<double>{{2, 0, 0}, 1.2}, black()));
    scene.objects[3].material.transmission = Rgbd(1.0);
    scene.objects[3].material.dielectric = true;
    scene.objects[0].material.ior = 1.3;
    scene.objects[0].material.priority = 1;
    check(1.0);
    check(1.0F);
  }
}

TEST_CASE("integrators that do not walk inside take what is scattered as lost") {
  Scene scene;
  scene.background = Rgbd(1.0);
  scene.objects = {object("Slab", Box<double>{{0, -9, -9}, {0.8, 9, 9}}, milky(0.5))};
  CHECK(shade_along(scene, {-3, 0, 0}, {0, 0, 0}).x == Approx(std::exp(-0.8)).epsilon(1e-9));
}
