// Weights resolved before SHADE's first line, total internal reflection, and shadows through glass.

#include <numbers>

#include "support/catch.h"
#include "trace/pictures.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Material glass(const Rgbd& reflection, const Rgbd& transmission, double ior, bool dielectric) {
  Material material = black();
  material.reflection = reflection;
  material.transmission = transmission;
  material.ior = ior;
  material.dielectric = dielectric;
  return material;
}

// The half space below z = 0 of glass; above it the light of `sky`, below it that of `ground`, far away.
Scene pool(const Material& material, double sky, double ground) {
  Material above = black(), below = black();
  above.emission = Rgbd(sky);
  below.emission = Rgbd(ground);
  Scene scene;
  scene.objects = {object("Pool", Plane<double>{}, material),
                   object("Sky", Plane<double>{{0, 0, 100}, {0, 0, -1}}, above),
                   object("Ground", Plane<double>{{0, 0, -100}, {0, 0, 1}}, below)};
  return scene;
}

using std::numbers::pi;

Rgbd from_above(const Scene& scene, double degrees) {
  return shade_along(scene, {-std::sin(degrees * pi / 180), 0, std::cos(degrees * pi / 180)}, {0, 0, 0});
}
Rgbd from_below(const Scene& scene, double degrees) {
  return shade_along(scene, {-std::sin(degrees * pi / 180), 0, -std::cos(degrees * pi / 180)}, {0, 0, 0});
}

// What the first hit's SHADE decided at a line.
Decided decision(const Recording& recording, Line line) {
  for (const Event& event : recording.events)
    if (event.line == line && event.depth == 1) return std::get<Decided>(event.detail);
  FAIL("never decided");
  return {};
}

}  // namespace

TEST_CASE("a dielectric shares its light by Fresnel's equations") {
  // 45 degrees onto glass of 1.5: 0.05023991101224 is reflected (the shared table, op-018).
  const Scene scene = pool(glass(Rgbd(0.0), Rgbd(1.0), 1.5, true), 1, 0);
  CHECK(from_above(scene, 45).x == Approx(0.05023991101224).epsilon(1e-9));
  const Scene under = pool(glass(Rgbd(0.0), Rgbd(1.0), 1.5, true), 0, 1);
  CHECK(from_above(under, 45).x == Approx(1 - 0.05023991101224).epsilon(1e-9));
  // 40 degrees from inside: 0.2452912042869 (op-034).
  CHECK(from_below(under, 40).x == Approx(0.2452912042869).epsilon(1e-9));
  CHECK(from_below(scene, 40).x == Approx(1 - 0.2452912042869).epsilon(1e-9));
}

TEST_CASE("a dielectric shares kr + kt, channel by channel") {
  const Material material = glass({0.5, 0, 0.25}, {0.25, 0.5, 0}, 1.5, true);
  const Recording recording = record_along(pool(material, 1, 1), {0, 0, 1}, {0, 0, 0});
  const Decided reflective = decision(recording, Line::if_reflective);
  const Decided transparent = decision(recording, Line::if_transparent);
  const Rgbd both(0.75, 0.5, 0.25);
  CHECK(length(reflective.weight - 0.04 * both) < 1e-15);
  CHECK(length(transparent.weight - 0.96 * both) < 1e-15);
}

TEST_CASE("glass that is no dielectric keeps the weights it was given") {
  const Scene scene = pool(glass({0.5, 0, 0.25}, {0.25, 0.5, 0}, 1.5, false), 1, 0);
  CHECK(from_above(scene, 60) == Rgbd(0.5, 0, 0.25));
}

TEST_CASE("beyond the critical angle kr' is kr + kt, even where kr is 0") {
  const double critical = std::asin(1 / 1.5) * 180 / pi;
  for (const bool dielectric : {false, true}) {
    const Scene scene = pool(glass(Rgbd(0.0), {0.75, 0.5, 0.25}, 1.5, dielectric), 0, 1);
    // The mirrored ray sees the ground; a refracted one would see the dark sky.
    CHECK(from_below(scene, critical + 1e-6) == Rgbd(0.75, 0.5, 0.25));
    CHECK(from_below(scene, 89) == Rgbd(0.75, 0.5, 0.25));
    if (!dielectric) CHECK(from_below(scene, critical - 1e-6) == Rgbd(0.0));
  }
  const Scene both = pool(glass({0.25, 0.25, 0}, {0.5, 0.25, 1}, 1.5, false), 0, 1);
  CHECK(from_below(both, 60) == Rgbd(0.75, 0.5, 1));
  CHECK(from_below(both, 10) == Rgbd(0.25, 0.25, 0));
}

TEST_CASE("total internal reflection is told, counted, and forms no refract ray") {
  const Scene scene = pool(glass(Rgbd(0.0), Rgbd(1.0), 1.5, false), 0, 1);
  const Vec3d eye(-std::sin(1.0), 0, -std::cos(1.0));
  const Recording recording = record_along(scene, eye, {0, 0, 0});
  const Decided reflective = decision(recording, Line::if_reflective);
  const Decided transparent = decision(recording, Line::if_transparent);
  CHECK(reflective.holds);
  CHECK(reflective.weight == Rgbd(1.0));
  CHECK_FALSE(transparent.holds);
  CHECK(transparent.weight == Rgbd(0.0));
  REQUIRE(transparent.why);
  CHECK(name_of(*transparent.why) == "total_internal_reflection");
  const auto counted = picture<double>(looking(scene, eye, {0, 0, 0}), 1, 1).statistics;
  CHECK(counted.ends(Ending::total_internal_reflection) == 1);
  CHECK(counted.formed(RayKind::refract) == 0);
  CHECK(counted.formed(RayKind::reflect) == 1);
}

TEST_CASE("refract rays carry Snell's numbers") {
  const Scene scene = pool(glass(Rgbd(0.0), Rgbd(1.0), 1.25, true), 1, 1);
  const auto formed = record_along(scene, {-3, 0, 4}, {0, 0, 0}).all<RayFormed>();
  const RayFormed* refract_ray = nullptr;
  for (const RayFormed& ray : formed)
    if (ray.kind == RayKind::refract) refract_ray = &ray;
  REQUIRE(refract_ray);
  REQUIRE(refract_ray->snell);
  const SnellNumbers& snell = *refract_ray->snell;
  CHECK(snell.n1 == 1);
  CHECK(snell.n2 == 1.25);
  CHECK(snell.cos_in == Approx(0.8));
  CHECK(snell.n1 * std::sqrt(1 - snell.cos_in * snell.cos_in) ==
        Approx(snell.n2 * std::sqrt(1 - snell.cos_out * snell.cos_out)));
  CHECK(length(refract_ray->direction) == Approx(1));
  CHECK(refract_ray->direction.x == Approx(0.48));
}

TEST_CASE("a loss-free glass ball in even light cannot be seen") {
  // All of its light comes from the same surroundings. What the depth limit cuts off is less than 1e-9.
  Scene scene;
  scene.background = Rgbd(1.0);
  scene.limits.depth = 12;
  for (const double ior : {1.1, 1.5, 2.4}) {
    scene.objects = {object("Ball", Sphere<double>{{5, 0, 0}, 1}, glass(Rgbd(0.0), Rgbd(1.0), ior, true))};
    for (const double y : {0.0, 0.3, 0.6, 0.9}) {
      const double shade = shade_along(scene, {0, 0, 0}, {5, y, 0.1}).x;
      CHECK(shade <= 1 + 1e-12);
      CHECK(shade >= 1 - 1e-4);
    }
  }
}

TEST_CASE("glass throws a full shadow unless it filters; filtering weighs each crossing") {
  Scene scene;
  Material white;
  white.diffuse = Rgbd(1.0);
  Material pane = glass(Rgbd(0.0), {0.5, 1, 0}, 1.5, false);
  scene.objects = {object("Table", Plane<double>{}, white), object("Ball", Sphere<double>{{0, 0, 2}, 0.5}, pane)};
  scene.lights = {lamp({0, 0, 4})};
  const Vec3d eye(3, 0, 1);
  CHECK(shade_along(scene, eye, {0, 0, 0}) == Rgbd(0.0));
  scene.objects[1].material.shadow = ShadowKind::filtered;
  CHECK(shade_along(scene, eye, {0, 0, 0}) == Rgbd(0.25, 1, 0));
  // The lamp inside the ball: one crossing.
  scene.lights = {lamp({0, 0, 2})};
  CHECK(shade_along(scene, eye, {0, 0, 0}) == Rgbd(0.5, 1, 0));
  // Something opaque behind it.
  scene.lights = {lamp({0, 0, 4})};
  scene.objects.push_back(object("Blocker", Sphere<double>{{0, 0, 3.2}, 0.3}, black()));
  CHECK(shade_along(scene, eye, {0, 0, 0}) == Rgbd(0.0));
  // An opaque object that asks for filtering has nothing to let through.
  scene.objects.pop_back();
  scene.objects[1].material = white;
  scene.objects[1].material.shadow = ShadowKind::filtered;
  CHECK(shade_along(scene, eye, {0, 0, 0}) == Rgbd(0.0));
}

TEST_CASE("two filters in one place are one") {
  // A ray that leaves one surface must not meet the other there again and again.
  Scene scene;
  Material white;
  white.diffuse = Rgbd(1.0);
  Material pane = glass(Rgbd(0.0), {0.5, 1, 0.25}, 1.5, false);
  pane.shadow = ShadowKind::filtered;
  const Sphere<double> ball{{0.1, 0.2, 2}, 0.7};
  scene.objects = {object("Table", Plane<double>{}, white), object("One", ball, pane), object("Two", ball, pane)};
  for (int i = 0; i < 50; ++i) {
    scene.lights = {lamp({0.01 * i, 0.007 * i, 4})};
    const double n_l = normalize(Vec3d(0.01 * i, 0.007 * i, 4)).z;
    const Rgbd got = shade_along(scene, {3, 0, 1}, {0, 0, 0});
    if (length(got - n_l * Rgbd(0.25, 1, 0.0625)) > 1e-9) FAIL("light " << i << " brings " << got.x);
  }
}

TEST_CASE("an object twice in one place is one object") {
  // Exact ties go to the first, and what leaves it does not meet the second.
  Scene scene = busy_scene();
  const auto single = picture<double>(scene, 33, 25);
  const std::vector<Object> objects = scene.objects;
  for (Object copy : objects) {
    copy.name += " 2";
    scene.objects.push_back(copy);
  }
  const auto doubled = picture<double>(scene, 33, 25);
  CHECK((doubled.pixels == single.pixels));
}
