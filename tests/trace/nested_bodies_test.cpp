// What is one body, and when bodies nest: surfaces in one place, instances, meshes, flat shapes, open ones.

#include "trace/nested.h"

using namespace raywalk;
using namespace raywalk::test;

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
  for (const AcceleratorKind kind : values_of<AcceleratorKind>) {
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
