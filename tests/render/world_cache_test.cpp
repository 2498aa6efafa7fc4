#include "render/world_cache.h"

#include "render/preview.h"
#include "render/scenes.h"

#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("a scene is made ready once for all who ask, wherever they look from") {
  Scene scene = busy_scene();
  WorldCache worlds;
  const auto first = worlds.of<double>(scene);
  CHECK(worlds.of<double>(scene) == first);
  scene.camera.eye = scene.camera.eye + Vec3d(1, 2, 3);
  scene.camera.fov = FieldOfView{30, FovAxis::y};
  scene.image = {7, 5};
  CHECK(worlds.of<double>(scene) == first);
}

TEST_CASE("what else a world is made from makes another") {
  const Scene scene = busy_scene();
  const auto differs = [&](const Scene& other, AcceleratorKind kind, std::optional<Fault> fault) {
    WorldCache worlds;
    const auto first = worlds.of<double>(scene);
    return worlds.of<double>(other, kind, fault) != first;
  };
  constexpr auto automatic = AcceleratorKind::automatic;
  CHECK_FALSE(differs(scene, automatic, {}));
  CHECK(differs(scene, AcceleratorKind::grid, {}));
  CHECK(differs(scene, automatic, values_of<Fault>.front()));
  const auto changed = [&](const auto& change) {
    Scene other = scene;
    change(other);
    return differs(other, automatic, {});
  };
  CHECK(changed([](Scene& s) { s.limits.depth += 1; }));
  CHECK(changed([](Scene& s) { s.limits.threshold += 0.1; }));
  CHECK(changed([](Scene& s) { s.render.integrator = Integrator::cast; }));
  CHECK(changed([](Scene& s) { s.background = Rgbd(0.9, 0.1, 0.1); }));
  CHECK(changed([](Scene& s) { s.ambient = Rgbd(0.9, 0.1, 0.1); }));
  CHECK(changed([](Scene& s) { s.camera.aperture = 1; }));
  CHECK(changed([](Scene& s) { s.camera.shutter_close += 1; }));
}

TEST_CASE("where the eye goes into a body, another world is made") {
  Scene scene = busy_scene();
  const Vec3d outside = scene.camera.eye;
  Material glass;
  glass.transmission = Rgbd(0.8);
  glass.ior = 1.5;
  scene.objects.push_back({"Ball", Sphere<double>{outside + Vec3d(0, 0, 40), 2}, glass});
  WorldCache worlds;
  const auto first = worlds.of<double>(scene);
  scene.camera.eye = outside + Vec3d(0, 0, 40.5);
  const auto inside = worlds.of<double>(scene);
  CHECK(inside != first);
  scene.camera.eye = outside + Vec3d(0, 0, 39.5);
  CHECK(worlds.of<double>(scene) == inside);
  scene.camera.eye = outside;
  CHECK(worlds.of<double>(scene) != inside);
}

TEST_CASE("two worlds are kept, and no third, for each may be large") {
  const Scene scene = busy_scene();
  WorldCache worlds;
  const auto walked = worlds.of<double>(scene);
  const std::weak_ptr<const World<double>> pictured = worlds.of<double>(scene, AcceleratorKind::grid);
  CHECK(worlds.of<double>(scene) == walked);
  CHECK_FALSE(pictured.expired());
  const auto single = worlds.of<float>(scene);
  CHECK(pictured.expired());
  CHECK(worlds.of<double>(scene) == walked);
  CHECK(worlds.of<float>(scene) == single);
}

TEST_CASE("a preview takes the world that is there, with the same picture") {
  const Scene scene = busy_scene();
  const PreviewSettings settings{{33, 21}, Precision::double_, 4};
  Preview alone(scene, settings), shared;
  WorldCache worlds;
  const auto world = worlds.of<double>(scene);
  shared.reset(scene, settings, &worlds);
  CHECK(world.use_count() == 3);  // here, in the worlds, in the preview
  while (alone.refine(1000)) {
  }
  while (shared.refine(1000)) {
  }
  CHECK(pixels_that_differ(alone.film<double>(), shared.film<double>()) == 0);
}
