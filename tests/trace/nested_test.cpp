// Bodies of glass in one another: which index and which absorption counts where, against closed forms, by every
// integrator that refracts.

#include <cmath>
#include <memory>

#include "support/catch.h"
#include "trace/paths.h"
#include "trace/sampled.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Clear, and all goes through: one ray in, one out.
Material clear(double ior, double priority = 0) {
  Material material = black();
  material.transmission = Rgbd(1.0);
  material.ior = ior;
  material.priority = priority;
  material.shadow = ShadowKind::filtered;
  return material;
}
Material fresnel(double ior) {
  Material material = clear(ior);
  material.dielectric = true;
  return material;
}
// Bends nothing.
Material tinted(const Rgbd& absorption, double priority = 0) {
  Material material = clear(1, priority);
  material.absorption = absorption;
  return material;
}

Box<double> slab(double from, double to) { return {{from, -90, -90}, {to, 90, 90}}; }

// A closed box as a mesh, two triangles to a face.
MeshShape box_mesh(const Vec3d& min, const Vec3d& max) {
  auto mesh = std::make_shared<Mesh>();
  for (int i = 0; i < 8; ++i)
    mesh->positions.emplace_back(i & 1 ? max.x : min.x, i & 2 ? max.y : min.y, i & 4 ? max.z : min.z);
  mesh->triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  MeshShape shape;
  shape.mesh = mesh;
  return shape;
}

PathSettings without_chance() {
  PathSettings settings;
  settings.roulette_from = 1000;
  return settings;
}

// The secondary rays of a ray's tree, in the order in which they were formed.
std::vector<RayFormed> secondary_rays(Scene scene, Integrator integrator, const Vec3d& eye, const Vec3d& target) {
  scene.limits.depth = 30;
  scene.render.integrator = integrator;
  std::vector<RayFormed> formed;
  if (integrator == Integrator::path) {
    PathRecording recording;
    static_cast<void>(path_picture<double>(looking(scene, eye, target), 1, 1, without_chance(), {}, &recording));
    formed = recording.all<RayFormed>();
  } else {
    formed = record_along(scene, eye, target).all<RayFormed>();
  }
  std::vector<RayFormed> secondary;
  for (const RayFormed& ray : formed)
    if (ray.kind == RayKind::reflect || ray.kind == RayKind::refract) secondary.push_back(ray);
  return secondary;
}
constexpr std::array integrators{Integrator::whitted, Integrator::distributed, Integrator::path};

// The indices on both sides of every surface that the ray is refracted at.
using Indices = std::vector<std::pair<double, double>>;
void check_indices(const Scene& scene, const Vec3d& eye, const Vec3d& target, const Indices& expected) {
  for (const Integrator integrator : integrators) {
    Indices met;
    for (const RayFormed& ray : secondary_rays(scene, integrator, eye, target))
      if (ray.snell) met.emplace_back(ray.snell->n1, ray.snell->n2);
    CAPTURE(integrator_name(integrator));
    CHECK(met == expected);
  }
}

// What comes along a ray, by all of them, where nothing is drawn.
void check_along(Scene scene, const Vec3d& eye, const Vec3d& target, const Rgbd& expected) {
  scene.limits.depth = 30;
  const auto check = [&](const Rgbd& got) {
    CAPTURE(got.x, got.y, got.z, expected.x, expected.y, expected.z);
    for (int c = 0; c < 3; ++c) CHECK(got[c] == Approx(expected[c]).epsilon(1e-9).margin(1e-300));
  };
  for (const Integrator integrator : {Integrator::whitted, Integrator::distributed}) {
    scene.render.integrator = integrator;
    check(shade_along(scene, eye, target));
  }
  check(light_along(scene, eye, target, 1, without_chance()).mean);
}

Rgbd left(const Rgbd& depth) { return {std::exp(-depth.x), std::exp(-depth.y), std::exp(-depth.z)}; }

const Rgbd red(0.1, 0.7, 1.3), blue(1.1, 0.4, 0.2), green(0.5, 0.05, 0.6);

// Unpolarised reflectance by the angles, as Fresnel wrote it.
double reflectance(double n1, double n2, double in) {
  const double out = std::asin(n1 * std::sin(in) / n2);
  if (in == 0) return std::pow((n1 - n2) / (n1 + n2), 2);
  const double s = std::sin(in - out) / std::sin(in + out), p = std::tan(in - out) / std::tan(in + out);
  return (s * s + p * p) / 2;
}

}  // namespace

TEST_CASE("slabs in slabs bend from each to the next") {
  const std::vector<double> indices{1.33, 1.5, 2.4};
  for (std::size_t count = 1; count <= 3; ++count) {
    Scene scene;
    Indices expected;
    std::vector<double> layers;  // indices, along the way
    for (std::size_t i = 0; i < count; ++i) {
      const double inset = static_cast<double>(i) * 0.5;
      scene.objects.push_back(object("Slab " + std::to_string(i), slab(inset, 5 - inset), clear(indices[i])));
      layers.push_back(indices[i]);
    }
    for (std::size_t i = count - 1; i-- > 0;) layers.push_back(indices[i]);
    layers.push_back(1);
    for (std::size_t i = 0; i < layers.size(); ++i) expected.emplace_back(i == 0 ? 1 : layers[i - 1], layers[i]);
    CAPTURE(count);
    check_indices(scene, {-2, -1, 0}, {0, 0, 0}, expected);
    // n sin stays what it was, and so does the direction behind all of them.
    const double sine = 1 / std::sqrt(5.0);
    for (const Integrator integrator : integrators) {
      const auto rays = secondary_rays(scene, integrator, {-2, -1, 0}, {0, 0, 0});
      REQUIRE(rays.size() == layers.size());
      for (std::size_t i = 0; i < rays.size(); ++i) {
        CHECK(rays[i].direction.y * layers[i] == Approx(sine).epsilon(1e-13));
        if (i + 1 == rays.size()) continue;
        const double way = rays[i + 1].origin.x - rays[i].origin.x;
        CHECK(rays[i + 1].origin.y - rays[i].origin.y ==
              Approx(way * std::tan(std::asin(sine / layers[i]))).epsilon(1e-12));
      }
    }
  }
}

TEST_CASE("Fresnel's shares of nested slabs") {
  Material glow = black();
  glow.emission = Rgbd(1.0);
  for (const double degrees : {0.0, 35.0, 70.0}) {
    const double in = degrees * 3.14159265358979323846 / 180;
    Scene scene;
    scene.objects = {object("Water", slab(0, 4), fresnel(1.33)), object("Glass", slab(1, 3), fresnel(1.5)),
                     object("Air", slab(1.5, 2), fresnel(1)),
                     object("Wall", Plane<double>{{9, 0, 0}, {-1, 0, 0}}, glow)};
    double passed = 1, index = 1;
    for (const double next : {1.33, 1.5, 1.0, 1.5, 1.33, 1.0}) {
      passed *= 1 - reflectance(index, next, std::asin(std::sin(in) / index));
      index = next;
    }
    CAPTURE(degrees);
    const Vec3d eye(-std::cos(in), -std::sin(in), 0);
    // Light that is mirrored twice on its way comes deeper than this.
    scene.limits.depth = 7;
    for (const Integrator integrator : {Integrator::whitted, Integrator::distributed}) {
      scene.render.integrator = integrator;
      CHECK(shade_along(scene, eye, {0, 0, 0}).x == Approx(passed).epsilon(1e-12));
    }
    PathSettings settings = without_chance();
    settings.max_length = 7;
    const Estimate followed = light_along(scene, eye, {0, 0, 0}, 4000, settings);
    CHECK(std::abs(followed.mean.x - passed) < 5 * followed.error + 1e-9);
  }
}

TEST_CASE("balls in balls turn a ray by Bouguer's rule") {
  // n r sin is the same all along; each surface turns the ray by the difference of its angles, twice.
  const auto check_turn = [](const std::vector<std::pair<double, double>>& balls, double aside) {
    Scene scene;
    double turned = 0, outside = 1;
    Indices in, out;
    for (const auto& [radius, ior] : balls) {
      scene.objects.push_back(
          object("Ball " + std::to_string(scene.objects.size()), Sphere<double>{{0, 0, 0}, radius}, clear(ior)));
      turned += 2 * (std::asin(aside / (outside * radius)) - std::asin(aside / (ior * radius)));
      in.emplace_back(outside, ior);
      out.emplace(out.begin(), ior, outside);
      outside = ior;
    }
    in.insert(in.end(), out.begin(), out.end());
    const Vec3d eye(-9, aside, 0), target(0, aside, 0);
    check_indices(scene, eye, target, in);
    for (const Integrator integrator : integrators) {
      const auto rays = secondary_rays(scene, integrator, eye, target);
      REQUIRE(rays.size() == in.size());
      const Vec3d& direction = rays.back().direction;
      CHECK(std::atan2(-direction.y, direction.x) == Approx(turned).epsilon(1e-11).margin(1e-13));
    }
  };
  for (const double aside : {0.0, 0.2, 0.45}) {
    CAPTURE(aside);
    check_turn({{1, 1.5}}, aside);
    check_turn({{1, 1.33}, {0.6, 1.5}}, aside);
    check_turn({{1, 1.5}, {0.6, 1}}, aside);  // a bubble
    check_turn({{1, 1.33}, {0.7, 1.5}, {0.5, 1}}, aside);
  }
}

TEST_CASE("total reflection at a bubble, and none at what is nearly as dense") {
  // Beyond asin(1 / 1.5) the bubble is a mirror; seen from water it begins at asin(1.33 / 1.5).
  Scene scene;
  scene.objects = {object("Glass", Sphere<double>{{0, 0, 0}, 2}, clear(1.5)),
                   object("Bubble", Sphere<double>{{0, 0, 0}, 1}, clear(1))};
  const auto first_inside = [&](double aside) {
    std::vector<RayKind> kinds;
    for (const Integrator integrator : integrators)
      kinds.push_back(secondary_rays(scene, integrator, {-9, aside, 0}, {0, aside, 0})[1].kind);
    CHECK(kinds[0] == kinds[1]);
    CHECK(kinds[0] == kinds[2]);
    return kinds[0];
  };
  CHECK(first_inside(0.999) == RayKind::refract);
  CHECK(first_inside(1.001) == RayKind::reflect);
  scene.objects[1].material = clear(1.33);
  CHECK(first_inside(1.001) == RayKind::refract);
  CHECK(first_inside(1.329) == RayKind::refract);
  CHECK(first_inside(1.331) == RayKind::reflect);
}

TEST_CASE("absorption of nested and of overlapping bodies") {
  Scene scene;
  scene.background = Rgbd(1.0);
  const Vec3d left_eye(-5, 0, 0), right_eye(15, 0, 0), target(1, 0, 0);
  SECTION("one in the other") {
    scene.objects = {object("Outer", slab(0, 5), tinted(red)), object("Inner", slab(1, 3), tinted(blue)),
                     object("Core", slab(1.5, 2), tinted(green))};
    check_along(scene, left_eye, target, left(red * 3.0 + blue * 1.5 + green * 0.5));
    check_along(scene, {-5, -6, 0}, {1, 0, 0}, left(std::sqrt(2.0) * (red * 3.0 + blue * 1.5 + green * 0.5)));
  }
  SECTION("a hole") {
    scene.objects = {object("Outer", slab(0, 5), tinted(red)), object("Hole", slab(1, 3), clear(1))};
    check_along(scene, left_eye, target, left(red * 3.0));
  }
  SECTION("overlapping, the one entered last") {
    scene.objects = {object("A", slab(0, 2), tinted(red)), object("B", slab(1, 4), tinted(blue))};
    check_along(scene, left_eye, target, left(red * 1.0 + blue * 3.0));
    check_along(scene, right_eye, target, left(red * 2.0 + blue * 2.0));
  }
  SECTION("overlapping, by priority") {
    scene.objects = {object("A", slab(0, 2), tinted(red, 1)), object("B", slab(1, 4), tinted(blue))};
    check_along(scene, left_eye, target, left(red * 2.0 + blue * 2.0));
    check_along(scene, right_eye, target, left(red * 2.0 + blue * 2.0));
    scene.objects[1].material.priority = 1.5;
    check_along(scene, left_eye, target, left(red * 1.0 + blue * 3.0));
    check_along(scene, right_eye, target, left(red * 1.0 + blue * 3.0));
    scene.objects[0].material.priority = scene.objects[1].material.priority = -2;
    check_along(scene, left_eye, target, left(red * 1.0 + blue * 3.0));
  }
  SECTION("three at once") {
    scene.objects = {object("A", slab(0, 6), tinted(red, 1)), object("B", slab(1, 4), tinted(blue, 2)),
                     object("C", slab(2, 8), tinted(green, 0))};
    check_along(scene, left_eye, target, left(red * 3.0 + blue * 3.0 + green * 2.0));
  }
}

TEST_CASE("indices where bodies overlap") {
  Scene scene;
  scene.objects = {object("A", slab(0, 2), clear(1.3)), object("B", slab(1, 4), clear(1.6))};
  const Vec3d left_eye(-2, -1, 0), right_eye(6, -1, 0);
  check_indices(scene, left_eye, {0, 0, 0}, {{1, 1.3}, {1.3, 1.6}, {1.6, 1.6}, {1.6, 1}});
  check_indices(scene, right_eye, {4, 0, 0}, {{1, 1.6}, {1.6, 1.3}, {1.3, 1.3}, {1.3, 1}});
  scene.objects[0].material.priority = 3;
  check_indices(scene, left_eye, {0, 0, 0}, {{1, 1.3}, {1.3, 1.3}, {1.3, 1.6}, {1.6, 1}});
  check_indices(scene, right_eye, {4, 0, 0}, {{1, 1.6}, {1.6, 1.3}, {1.3, 1.3}, {1.3, 1}});
}

TEST_CASE("shadow rays through bodies in one another") {
  Scene scene;
  scene.objects = {object("Wall", Plane<double>{{9, 0, 0}, {-1, 0, 0}}, lambert())};
  scene.lights = {lamp({-4, 0, 0}, 1)};
  const auto lit = [&](const Rgbd& depth) { check_along(scene, {8.5, -1, 0}, {9, 0, 0}, left(depth)); };
  const auto put = [&](const char* name, const ObjectShape& shape, const Material& material) {
    Object one;
    one.name = name, one.shape = shape, one.material = material;
    scene.objects.push_back(one);
  };
  SECTION("nested") {
    put("Outer", slab(0, 5), tinted(red));
    put("Inner", slab(1, 3), tinted(blue));
    lit(red * 3.0 + blue * 2.0);
    scene.objects.back().material.transmission = {1, 0.5, 1};
    const Rgbd expected = left(red * 3.0 + blue * 2.0) * Rgbd(1, 0.25, 1);
    check_along(scene, {8.5, -1, 0}, {9, 0, 0}, expected);
  }
  SECTION("a hole") {
    put("Outer", slab(0, 5), tinted(red));
    put("Hole", slab(1, 3), clear(1));
    lit(red * 3.0);
  }
  SECTION("overlapping: shadow rays come from the wall") {
    put("A", slab(0, 2), tinted(red));
    put("B", slab(1, 4), tinted(blue));
    lit(red * 2.0 + blue * 2.0);
    scene.objects.back().material.priority = 1;
    lit(red * 1.0 + blue * 3.0);
  }
  for (const bool mesh : {false, true}) {
    const auto block = [&](double from, double to) -> ObjectShape {
      if (mesh) return box_mesh({from, -90, -70}, {to, 90, 80});
      return slab(from, to);
    };
    DYNAMIC_SECTION("side by side, mesh " << mesh) {
      put("A", block(0, 2), tinted(red));
      put("B", block(2, 5), tinted(blue));
      lit(red * 2.0 + blue * 3.0);
    }
    DYNAMIC_SECTION("that end at a light inside, mesh " << mesh) {
      put("Outer", block(-6, 5), tinted(red));
      put("Inner", block(-5, 3), tinted(blue));
      lit(red * 2.0 + blue * 7.0);
    }
    DYNAMIC_SECTION("that begin inside, mesh " << mesh) {
      put("Outer", block(0, 20), tinted(red));
      put("Inner", block(1, 15), tinted(blue));
      // The eye is inside of both, too.
      check_along(scene, {8.5, 0, 0}, {9, 0, 0}, left(blue * 8.0 + red * 1.0 + blue * 0.5));
    }
    DYNAMIC_SECTION("all inside, and nothing crossed, mesh " << mesh) {
      put("Outer", block(-20, 20), tinted(red));
      put("Inner", block(-15, 15), tinted(blue));
      check_along(scene, {8, 0, 0}, {9, 0, 0}, left(blue * 13.0 + blue * 1.0));
    }
  }
}

TEST_CASE("an eye that starts inside knows it") {
  Scene scene;
  scene.background = Rgbd(1.0);
  SECTION("inside one: absorbed up to the first surface, whatever it is") {
    scene.objects = {object("Glass", slab(-3, 3), tinted(red))};
    check_along(scene, {0, 0, 0}, {1, 0, 0}, left(red * 3.0));
    scene.objects.push_back(object("Lamp", Plane<double>{{2, 0, 0}, {-1, 0, 0}}, glowing(1)));
    check_along(scene, {0, 0, 0}, {1, 0, 0}, left(red * 2.0));
  }
  SECTION("inside two: the inner one first, then the outer one, in any order of the list") {
    for (const bool swapped : {false, true}) {
      scene.objects = {object("Outer", slab(-5, 6), clear(1.3)), object("Inner", slab(-1, 2), clear(1.7))};
      scene.objects[0].material.absorption = red, scene.objects[1].material.absorption = blue;
      if (swapped) std::swap(scene.objects[0], scene.objects[1]);
      check_indices(scene, {0, 0, 0}, {1, 0.2, 0}, {{1.7, 1.3}, {1.3, 1}});
      check_along(scene, {0, 0, 0}, {1, 0, 0}, left(blue * 2.0 + red * 4.0));
      check_along(scene, {0, 0, 0}, {-1, 0, 0}, left(blue * 1.0 + red * 4.0));
    }
  }
  SECTION("inside two, by priority") {
    scene.objects = {object("Outer", slab(-5, 6), tinted(red, 1)), object("Inner", slab(-1, 2), tinted(blue))};
    check_along(scene, {0, 0, 0}, {1, 0, 0}, left(red * 6.0));
  }
  SECTION("under water without end, also along its surface") {
    scene.objects = {object("Water", Plane<double>{{0, 0, 1}, {0, 0, 1}}, clear(1.33)),
                     object("Ball", Sphere<double>{{5, 0, 0}, 1}, clear(1.5))};
    check_indices(scene, {0, 0, 0}, {5, 0.3, 0}, {{1.33, 1.5}, {1.5, 1.33}});
    check_indices(scene, {0, 0, 0}, {5, 0.3, -0.2}, {{1.33, 1.5}, {1.5, 1.33}});
    check_indices(scene, {0, 0, 0}, {0.1, 0, 1}, {{1.33, 1}});
  }
  SECTION("on the surface, looking in and looking out") {
    scene.objects = {object("Ball", Sphere<double>{{0, 0, 0}, 1}, clear(1.5)),
                     object("Next", Sphere<double>{{-5, 0, 0}, 1}, clear(1.4))};
    check_indices(scene, {-1, 0, 0}, {0, 0.2, 0}, {{1.5, 1}});
    check_indices(scene, {-1, 0, 0}, {-5, 0.2, 0}, {{1, 1.4}, {1.4, 1}});
  }
  SECTION("beside it, in its box") {
    scene.objects = {object("Ball", Sphere<double>{{0, 0, 0}, 1}, clear(1.5))};
    check_indices(scene, {-0.9, 0.9, 0}, {0, 0.2, 0}, {{1, 1.5}, {1.5, 1}});
  }
}

TEST_CASE("surfaces in one place are crossed together") {
  Scene scene;
  const Vec3d eye(-2, -1, 0), target(0, 0, 0);
  SECTION("side by side") {
    scene.objects = {object("A", slab(0, 1), clear(1.3)), object("B", slab(1, 2), clear(1.6))};
    check_indices(scene, eye, target, {{1, 1.3}, {1.3, 1.6}, {1.6, 1}});
    std::swap(scene.objects[0], scene.objects[1]);
    check_indices(scene, eye, target, {{1, 1.3}, {1.3, 1.6}, {1.6, 1}});
  }
  SECTION("a common front: the later of the list is entered last") {
    scene.objects = {object("A", slab(0, 1), clear(1.3)), object("B", slab(0, 2), clear(1.6))};
    check_indices(scene, eye, target, {{1, 1.6}, {1.6, 1.6}, {1.6, 1}});
    std::swap(scene.objects[0], scene.objects[1]);
    check_indices(scene, eye, target, {{1, 1.3}, {1.3, 1.6}, {1.6, 1}});
  }
  SECTION("the same body twice is there once") {
    scene.objects = {object("A", slab(0, 1), clear(1.3)), object("B", slab(0, 1), clear(1.6))};
    check_indices(scene, eye, target, {{1, 1.3}, {1.3, 1}});
  }
  SECTION("meshes") {
    Object a = object("A", slab(0, 1), clear(1.3)), b = a;
    a.shape = box_mesh({0, -90, -70}, {1, 90, 80});
    b.shape = box_mesh({1, -90, -70}, {2, 90, 80});
    b.name = "B", b.material = clear(1.6);
    scene.objects = {a, b};
    check_indices(scene, eye, target, {{1, 1.3}, {1.3, 1.6}, {1.6, 1}});
    scene.objects[1].shape = a.shape;  // twice in one place
    check_indices(scene, eye, target, {{1, 1.3}, {1.3, 1}});
  }
}

TEST_CASE("instances, transforms and meshes of glass nest like all else") {
  // A block with a bubble, as a group, placed twice, once mirrored and stretched: bodies are told apart though they
  // share their materials.
  Group group{"Block",
              {object("Glass", Box<double>{{-1, -40, -40}, {1, 40, 40}}, clear(1.5)),
               object("Bubble", Box<double>{{-0.5, -30, -30}, {0.5, 30, 30}}, clear(1))}};
  Object mesh_block = group.objects[0];
  SECTION("shapes") {}
  SECTION("a mesh outside") { group.objects[0].shape = box_mesh({-1, -40, -37}, {1, 40, 41}); }
  SECTION("meshes") {
    group.objects[0].shape = box_mesh({-1, -40, -37}, {1, 40, 41});
    group.objects[1].shape = box_mesh({-0.5, -30, -27}, {0.5, 30, 31});
  }
  const auto content = std::make_shared<const GroupContent>(group);
  Scene scene;
  scene.groups = {group};
  const auto place = [&](const char* name, const std::vector<TransformStep>& transform) {
    Object one;
    one.name = name, one.transform = transform;
    Instance instance;
    instance.group = group.name, instance.content = content;
    one.shape = instance;
    scene.objects.push_back(one);
  };
  place("One", {{Translate{{2, 0, 0}}}});
  place("Two", {{Scale{{-2, 1, 1}}}, {Translate{{4, 0, 0}}}});  // from 2 to 6: it overlaps the first from 2 to 3
  // 1 enters One at 1, its bubble at 1.5, Two at 2, leaves the bubble at 2.5, One at 3; Two's bubble is from 3 to 5.
  check_indices(scene, {-3, -1, 0}, {0, 0, 0},
                {{1, 1.5}, {1.5, 1}, {1, 1.5}, {1.5, 1.5}, {1.5, 1}, {1, 1.5}, {1.5, 1}});
}

TEST_CASE("flat shapes of the same glass are the skin of one body") {
  // A block of six polygons, as course scenes have it, with a bubble.
  const auto face = [](const char* name, std::vector<Vec3d> outline) {
    return object(name, Polygon<double>{std::move(outline), {}}, clear(1.5));
  };
  Scene scene;
  scene.objects = {face("Left", {{0, -9, -9}, {0, -9, 9}, {0, 9, 9}, {0, 9, -9}}),
                   face("Right", {{4, -9, -9}, {4, 9, -9}, {4, 9, 9}, {4, -9, 9}}),
                   object("Bubble", Sphere<double>{{2, 0, 0}, 1}, clear(1))};
  check_indices(scene, {-3, -0.2, 0}, {0, 0, 0}, {{1, 1.5}, {1.5, 1}, {1, 1.5}, {1.5, 1}});
  scene.objects.pop_back();
  check_indices(scene, {-3, -0.2, 0}, {0, 0, 0}, {{1, 1.5}, {1.5, 1}});
}

TEST_CASE("an open body that is only ever left refracts as its surface says") {
  Scene scene;
  scene.objects = {object("Pane", Polygon<double>{{{4, -9, -9}, {4, 9, -9}, {4, 9, 9}, {4, -9, 9}}, {}}, clear(1.5)),
                   object("Ball", Sphere<double>{{4, 0, 0}, 1}, clear(1.2))};
  // The ball, then the pane inside of it, from behind.
  check_indices(scene, {0, -0.2, 0}, {4, 0, 0}, {{1, 1.2}, {1.5, 1.2}, {1.2, 1}});
}

TEST_CASE("nested balls that lose no light cannot be seen in even light") {
  Scene scene;
  scene.background = Rgbd(1.0);
  scene.limits.depth = 14;
  scene.objects = {object("Water", Sphere<double>{{5, 0, 0}, 1}, fresnel(1.33)),
                   object("Ice", Sphere<double>{{5, 0.2, 0}, 0.5}, fresnel(1.31)),
                   object("Half out", Sphere<double>{{5, -0.9, 0}, 0.4}, fresnel(1.5))};
  for (const double y : {-1.1, -0.7, 0.0, 0.3, 0.6}) {
    const double shade = shade_along(scene, {0, 0, 0}, {5, y, 0.1}).x;
    CHECK(shade <= 1 + 1e-12);
    CHECK(shade >= 1 - 2e-3);
    const Estimate followed = light_along(scene, {0, 0, 0}, {5, y, 0.1}, 2000);
    CHECK(std::abs(followed.mean.x - 1) < 5 * followed.error + 1e-9);
  }
}

TEST_CASE("nesting keeps the promises: watched or not, by every structure, the same bits") {
  Scene scene = busy_scene();
  for (Object& each : scene.objects)
    if (each.material.transmits()) each.material.absorption = {0.3, 0.2, 0.1};
  scene.objects[2].material.shadow = ShadowKind::filtered;
  Material bubble = fresnel(1);
  scene.objects.push_back(object("Bubble", Sphere<double>{{-1.2, -1.1, 0}, 0.4}, bubble));
  scene.objects.push_back(object("Stuck", Sphere<double>{{-1, -0.4, 0.1}, 0.5}, clear(1.8, 1)));
  const auto plain = picture<double>(scene, 33, 25);
  Recording recording;
  CHECK((watched_picture<double>(scene, 33, 25, recording).pixels == plain.pixels));
  const RayGenerator<double> camera(scene, {33, 25}, {33, 25});
  for (const AcceleratorKind kind : all_accelerators) {
    const World<double> world(scene, kind);
    CHECK_FALSE(world.bodies.empty());
    std::vector<Rgbd> pixels(plain.pixels.size());
    static_cast<void>(trace(world, camera, PixelBlock{0, 33, 0, 25}, [&](const Pixel& pixel, const Rgbd& shade) {
      pixels[static_cast<std::size_t>(pixel.row * 33 + pixel.column)] = shade;
    }));
    CHECK((pixels == plain.pixels));
  }
}

TEST_CASE("only where bodies may nest are stacks kept") {
  const auto nests = [](const Scene& scene) { return !World<double>(scene).bodies.empty(); };
  Scene scene;
  scene.camera.eye = {-9, 0, 0};
  CHECK_FALSE(nests(scene));
  scene.objects = {object("Ball", Sphere<double>{{0, 0, 0}, 1}, clear(1.5)),
                   object("Core", Sphere<double>{{0, 0, 0}, 0.5}, black()),
                   object("Other", Sphere<double>{{3, 0, 0}, 1}, clear(1.5))};
  CHECK_FALSE(nests(scene));
  const auto other = [&]() -> Vec3d& { return std::get<Sphere<double>>(scene.objects[2].shape).centre; };
  other().x = 2;  // they touch
  CHECK(nests(scene));
  other().x = 0.5;
  CHECK(nests(scene));
  other().x = 0;  // the same ball twice
  CHECK_FALSE(nests(scene));
  other().x = -9;  // around the eye
  CHECK(nests(scene));
  other().x = 30;
  CHECK_FALSE(nests(scene));
  scene.objects.push_back(object("Pool", Plane<double>{{0, 0, -2}, {0, 0, 1}}, clear(1.33)));
  CHECK_FALSE(nests(scene));
  other().z = -4;
  CHECK(nests(scene));
  other().z = 0;
  scene.camera.eye.z = -3;
  CHECK(nests(scene));
  scene.camera.eye.z = 0;
  scene.objects[3].transform = {{Rotate{{0, 0, 1}, 30}}};  // of a plane under a map nothing is known
  CHECK(nests(scene));
  scene.render.integrator = Integrator::cast;
  CHECK_FALSE(nests(scene));
}
