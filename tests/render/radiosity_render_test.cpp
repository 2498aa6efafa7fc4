// Rendering by radiosity: neither threads, tiles, precision's order nor accelerators change a bit, and what cannot be
// cut is refused.

#include "render/render.h"

#include <algorithm>
#include <vector>

#include "render/scenes.h"
#include "support/catch.h"

using namespace raywalk;
using raywalk::test::contains;
using raywalk::test::same_pixels;

namespace {

Scene room() {
  Scene scene;
  Material matt, glow;
  matt.diffuse = {0.7, 0.5, 0.4};
  glow.diffuse = Rgbd(0.0);
  glow.emission = Rgbd(3.0);
  scene.objects = {{"Room", Box<double>{{-2, -1, -1}, {2, 1, 1}}, matt},
                   {"Ball", Sphere<double>{{0.5, -0.3, -0.5}, 0.4}, matt},
                   {"Lamp", Box<double>{{0, -0.3, 0.8}, {0.5, 0.3, 1.1}}, glow}};
  scene.camera.eye = {-1.8, 0.1, 0.1};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.up = {0, 0, 1};
  scene.render.integrator = Integrator::radiosity;
  scene.render.radiosity.patch = 0.6;
  return scene;
}

}  // namespace

TEST_CASE("radiosity: threads, the order of tiles and the accelerator change no bit") {
  for (const Precision precision : {Precision::float_, Precision::double_}) {
    CAPTURE(name_of(precision));
    RenderSettings settings;
    settings.size = ImageSize{40, 36};
    settings.precision = precision;
    settings.threads = 1;
    std::vector<double> done;
    settings.progress = [&](const Progress& progress) { done.push_back(progress.done); };
    const auto one = render(room(), settings);
    REQUIRE(one);
    REQUIRE_FALSE(done.empty());
    CHECK(std::is_sorted(done.begin(), done.end()));
    CHECK(done.back() == 1);
    settings.progress = {};
    settings.threads = 3;
    settings.reorder_tiles = [](std::vector<int>& tiles) { std::reverse(tiles.begin(), tiles.end()); };
    for (const AcceleratorKind kind : {AcceleratorKind::none, AcceleratorKind::grid, AcceleratorKind::kdtree}) {
      settings.accelerator = kind;
      const auto other = render(room(), settings);
      REQUIRE(other);
      CHECK(same_pixels(*one, *other));
    }
    CHECK(one->statistics.random_draws() == 0);
    CHECK(one->statistics.formed(RayKind::primary) == 40U * 36);
  }
}

TEST_CASE("ambient light by radiosity: neither threads nor accelerators change a bit, and its progress is told") {
  Scene scene = room();
  scene.render.integrator = Integrator::whitted;
  scene.render.radiosity.as_ambient = true;
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{-1, 0.3, 0.5}, {0, 0, 1}}}};
  RenderSettings settings;
  settings.size = ImageSize{40, 36};
  settings.threads = 1;
  std::vector<double> done;
  settings.progress = [&](const Progress& progress) { done.push_back(progress.done); };
  const auto one = render(scene, settings);
  REQUIRE(one);
  CHECK(std::is_sorted(done.begin(), done.end()));
  CHECK(done.back() == 1);
  settings.progress = {};
  settings.threads = 3;
  settings.accelerator = AcceleratorKind::octree;
  const auto other = render(scene, settings);
  REQUIRE(other);
  CHECK(same_pixels(*one, *other));
  CHECK(one->statistics.random_draws() == 0);
  // Another tracer, the same light: but for what is straight.
  scene.render.radiosity.as_ambient = false;
  const auto without = render(scene, settings);
  REQUIRE(without);
  CHECK_FALSE(same_pixels(*one, *without));
  Stopper stopper;
  stopper.raised = true;
  settings.stop = Stop(stopper);
  scene.render.radiosity.as_ambient = true;
  CHECK_FALSE(render(scene, settings)->finished);
}

TEST_CASE("radiosity that is stopped before its first pixel is not finished") {
  Stopper stopper;
  stopper.raised = true;
  RenderSettings settings;
  settings.size = ImageSize{20, 20};
  settings.stop = Stop(stopper);
  const auto stopped = render(room(), settings);
  REQUIRE(stopped);
  CHECK_FALSE(stopped->finished);
  CHECK(stopped->done == 0);
}

TEST_CASE("a scene that radiosity cannot cut is an error with the object's name") {
  Scene scene = room();
  scene.objects.push_back({"Ground", Plane<double>{{0, 0, -2}, {0, 0, 1}}, Material{}});
  const auto refused = render(scene, {});
  REQUIRE_FALSE(refused);
  CHECK_THAT(refused.error().text(), contains("\"Ground\"") && contains("endless") && contains("hint"));
  scene.render.integrator = Integrator::whitted;
  CHECK(render(scene, {}));
  scene.render.radiosity.as_ambient = true;
  CHECK_FALSE(render(scene, {}));
}
