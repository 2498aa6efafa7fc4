// Glass that absorbs: what is left of light follows from its way inside, by every integrator alike.

#include <cmath>
#include <memory>

#include "support/catch.h"
#include "trace/paths.h"
#include "trace/photon_scenes.h"
#include "trace/sampled.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// Bends nothing and reflects nothing.
Material tinted() {
  Material material = black();
  material.transmission = Rgbd(1.0);
  material.ior = 1;
  material.absorption = {0.1, 0.7, 3};
  material.shadow = ShadowKind::filtered;
  return material;
}

/// Of white, after `way` inside it.
Rgbd left_of_white(double way) {
  const Rgbd a = tinted().absorption;
  return {std::exp(-a.x * way), std::exp(-a.y * way), std::exp(-a.z * way)};
}

/// What comes along a ray, by SHADE and by paths, which must agree where nothing is drawn.
void check_along(const Scene& scene, const Vec3d& eye, const Vec3d& target, const Rgbd& expected) {
  PathSettings settings;
  settings.roulette_from = 100;
  const Rgbd shaded = shade_along(scene, eye, target);
  const Rgbd followed = light_along(scene, eye, target, 1, settings).mean;
  CAPTURE(shaded.x, shaded.y, shaded.z, followed.x, followed.y, followed.z, expected.x, expected.y, expected.z);
  for (int c = 0; c < 3; ++c) {
    CHECK(shaded[c] == Approx(expected[c]).epsilon(1e-9));
    CHECK(followed[c] == Approx(expected[c]).epsilon(1e-9));
  }
}

}  // namespace

TEST_CASE("glass absorbs by the way inside it") {
  Scene scene;
  scene.background = Rgbd(1.0);
  scene.objects = {object("Slab", Box<double>{{0, -9, -9}, {0.8, 9, 9}}, tinted())};
  check_along(scene, {-3, 0, 0}, {0, 0, 0}, left_of_white(0.8));
  // Aslant, straight on because of ior 1: the way is longer.
  check_along(scene, {-3, -3, 0}, {0, 0, 0}, left_of_white(0.8 * std::sqrt(2.0)));
  SECTION("also up to what is inside it, and back") {
    scene.objects.push_back(object("Core", Box<double>{{0.3, -9, -9}, {0.5, 9, 9}}, glowing(1)));
    check_along(scene, {-3, 0, 0}, {0, 0, 0}, left_of_white(0.3));
    scene.objects[1].material = black();
    scene.objects[1].material.reflection = Rgbd(1.0);
    scene.limits.depth = 9;  // in, to the mirror, out again, to the background
    check_along(scene, {-3, 0, 0}, {0, 0, 0}, left_of_white(0.6));
  }
  SECTION("also beyond a second one that begins inside it") {
    scene.objects.push_back(object("Core", Box<double>{{0.3, -9, -9}, {1.5, 9, 9}}, tinted()));
    scene.objects.push_back(object("Wall", Plane<double>{{0.7, 0, 0}, {-1, 0, 0}}, glowing(1)));
    check_along(scene, {-3, 0, 0}, {0, 0, 0}, left_of_white(0.7));
  }
  SECTION("the events say so") {
    const auto computed = record_along(scene, {-3, 0, 0}, {0, 0, 0}).all<ShadeComputed>();
    REQUIRE(computed.size() == 2);
    CHECK(computed[0].transmittance.y == Approx(std::exp(-0.8 * 0.7)).epsilon(1e-12));  // the inner SHADE returns first
    CHECK(computed[0].total.y == Approx(computed[0].transmittance.y * computed[0].refract.y).epsilon(1e-15));
    CHECK(computed[1].transmittance == Rgbd(1.0));
  }
}

TEST_CASE("shadow rays are absorbed by their way inside, whatever the object is made of") {
  Scene scene;
  scene.objects = {object("Wall", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, lambert()),
                   object("Glass", Box<double>{{0, -9, -9}, {0.8, 9, 9}}, tinted())};
  Object& glass = scene.objects[1];
  scene.lights = {lamp({-4, 0, 0}, 1)};
  const auto lit = [&](double way) { check_along(scene, {1.5, -1, 0}, {2, 0, 0}, left_of_white(way)); };
  SECTION("a box") { lit(0.8); }
  SECTION("a box as a mesh") {
    glass.shape = box_mesh({0, -9, -8}, {0.8, 9, 9});  // the ray passes beside the diagonals
    lit(0.8);
  }
  SECTION("each crossing multiplies by the transmission besides") {
    glass.material.transmission = {1, 0.5, 1};
    check_along(scene, {1.5, -1, 0}, {2, 0, 0}, left_of_white(0.8) * Rgbd(1, 0.25, 1));
  }
  SECTION("two boxes one behind the other") {
    scene.objects.push_back(object("Second", Box<double>{{-3, -9, -9}, {-2, 9, 9}}, tinted()));
    lit(1.8);
  }
  SECTION("an object that is left and entered again") {
    // Two arms, 0.8 and 0.5 wide where the ray passes, which meet above.
    glass.shape = Prism<double>{{{0, -9}, {0.8, -9}, {0.8, 5}, {0.9, 5}, {0.9, -9}, {1.4, -9}, {1.4, 9}, {0, 9}}, 20};
    lit(1.3);
  }
  for (const bool as_mesh : {false, true}) {
    CAPTURE(as_mesh);
    const auto put_glass = [&](const Vec3d& min, const Vec3d& max) {
      if (as_mesh)
        glass.shape = box_mesh(min, max);
      else
        glass.shape = Box<double>{min, max};
    };
    DYNAMIC_SECTION("the lamp inside, mesh " << as_mesh) {
      put_glass({-5, -9, -8}, {0.8, 9, 9});
      lit(4.8);
    }
    DYNAMIC_SECTION("what is lit inside, mesh " << as_mesh) {
      put_glass({0, -9, -8}, {3, 9, 9});
      lit(2 + std::hypot(0.5, 1));  // the eye is inside, too
    }
  }
}

TEST_CASE("inside a glass, lamp and wall see each other through it") {
  Scene scene;
  scene.objects = {object("Wall", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, lambert()),
                   object("Glass", Box<double>{{-5, -9, -9}, {9, 9, 9}}, tinted())};
  scene.lights = {lamp({-4, 0, 0}, 1)};
  check_along(scene, {-6, 0, 0}, {2, 0, 0}, left_of_white(7 + 6));
  SECTION("also to photon mapping, whose shadow rays stay inside") {
    Scene mapped = looking(scene, {-6, 0, 0}, {2, 0, 0});
    mapped.camera.screen = {1, 1e-9, 1};
    mapped.camera.fov.reset();
    mapped.render.integrator = Integrator::photons;
    CHECK(mean_of_pictures(mapped, 1, 1, 1, 2).mean == Approx(left_of_white(7 + 6).x).epsilon(1e-6));
  }
  SECTION("also where their way leaves it and enters it again") {
    scene.objects[1].shape =
        Prism<double>{{{-5, -9}, {-3, -9}, {-3, 5}, {-1, 5}, {-1, -9}, {9, -9}, {9, 9}, {-5, 9}}, 20};
    check_along(scene, {-1.5, -3, 0}, {2, 0, 0}, left_of_white(3 * std::sqrt(1 + 9 / 12.25) + 1 + 3));
  }
}

TEST_CASE("photons know the glass that their lamp stands in, whether or not the eye is in it") {
  for (const Vec3d& eye : {Vec3d(0.1, 0.2, 0), Vec3d(9, 0, 0)}) {
    Scene scene = by_photons(hollow_ball(2, 1e-9, {0, 0, 0}, {0, 0, 1}), 1000, 10);
    scene.objects.push_back(object("Glass", Sphere<double>{{0, 0, 0}, 5}, tinted()));
    scene.render.photons.gather = true;  // photons straight from the lamp are kept
    scene = looking(scene, eye, {0, 1, 0});
    const World<double> world(scene);
    const Emitters<double> emitters(world);
    PhotonKernel<double> kernel(scene, world, emitters, photon_settings_of(scene));
    static_cast<void>(kernel.send(1, 0, 1));
    Rgbd power(0.0);
    for (const Photon& photon : kernel.maps()[0].other.photons()) power += Rgbd(photon.power);
    CAPTURE(eye.x, world.bodies.empty());
    for (int c = 0; c < 3; ++c)
      CHECK(power[c] == Approx(4 * pi_v<double> * pi_v<double> * left_of_white(2)[c]).epsilon(1e-4));
  }
}

TEST_CASE("inside a glass, paths find what glows alike by its light and by chance") {
  Scene scene;
  Material clear = tinted();
  clear.absorption = {0.3, 0.7, 1.5};
  scene.objects = {object("Glass", Sphere<double>{{0, 0, 0}, 5}, clear),
                   object("Wall", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, matte(0.8)),
                   object("Glow", Sphere<double>{{0, 2, 0}, 1}, glowing(1))};
  const auto found_by = [&](PathStrategy strategy) {
    PathSettings settings;
    settings.strategy = strategy;
    settings.max_length = 3;  // to the glass, to the wall, to what glows
    return light_along(scene, {-9, -0.5, 0}, {2, 0, 0}, 40000, settings, static_cast<std::uint64_t>(strategy));
  };
  const Estimate chance = found_by(PathStrategy::directions);
  CHECK(chance.error < 0.03 * chance.mean.x);
  for (const PathStrategy strategy : {PathStrategy::lights, PathStrategy::both}) {
    const Estimate found = found_by(strategy);
    CAPTURE(static_cast<int>(strategy), found.mean.x, found.error, chance.mean.x, chance.error);
    CHECK(std::abs(found.mean.x - chance.mean.x) < 5 * std::hypot(found.error, chance.error));
  }
}
