// Bodies of glass in one another: which index and which absorption counts where, against closed forms, by every
// integrator that refracts.

#include "trace/nested.h"

using namespace raywalk;
using namespace raywalk::test;

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
    for (const Integrator integrator : bending_integrators) {
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
    for (const Integrator integrator : bending_integrators) {
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
    for (const Integrator integrator : bending_integrators)
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
