// Rendering by photons: the map is made once, and neither threads, tiles nor accelerators change a bit.

#include "render/render.h"

#include <algorithm>

#include "render/memory_need.h"
#include "render/scenes.h"
#include "support/catch.h"

using namespace raywalk;
using raywalk::test::contains;
using raywalk::test::same_pixels;

namespace {

Scene caustic_scene() {
  Scene scene;
  Material glass, matt;
  glass.diffuse = Rgbd(0.0);
  glass.transmission = Rgbd(0.9);
  glass.dielectric = true;
  matt.diffuse = {0.7, 0.5, 0.4};
  scene.objects = {{"Glass", Sphere<double>{{0, 0, 0}, 1}, glass},
                   {"Wall", Box<double>{{2, -3, -1}, {2.5, 3, 3}}, matt},
                   {"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, matt}};
  scene.lights = {{"Lamp", Rgbd(5.0), PointLight{{-3, 1, 1}, {0, 0, 1}}}};
  scene.camera.eye = {-6, 0, 0.5};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.up = {0, 0, 1};
  scene.render.integrator = Integrator::photons;
  scene.render.photons.count = 20000;
  scene.render.photons.nearest = 30;
  return scene;
}

Rendering rendered(const Scene& scene, const RenderSettings& settings) {
  auto rendering = render(scene, settings);
  REQUIRE(rendering);
  return std::move(*rendering);
}

}  // namespace

TEST_CASE("photons: threads, the order of tiles and the accelerator change no bit") {
  for (const bool gather : {false, true})
    for (const bool progressive : {false, true})
      for (const Precision precision : {Precision::float_, Precision::double_}) {
        Scene scene = caustic_scene();
        scene.render.photons.gather = gather;
        scene.render.photons.progressive = progressive;
        CAPTURE(gather, progressive, name_of(precision));
        RenderSettings settings;
        settings.size = ImageSize{40, 36};
        settings.sampling.per_pixel = 3;
        settings.precision = precision;
        settings.threads = 1;
        const Rendering one = rendered(scene, settings);
        settings.threads = 3;
        settings.accelerator = AcceleratorKind::none;
        settings.reorder_tiles = [](std::vector<int>& tiles) { std::reverse(tiles.begin(), tiles.end()); };
        const Rendering other = rendered(scene, settings);
        CHECK(same_pixels(one, other));
        CHECK(one.statistics.rays == other.statistics.rays);
        CHECK(one.statistics.formed(RayKind::photon) >= 20000U * (progressive ? 3 : 1));
        CHECK(one.statistics.not_finite == 0);
        settings.sampling.seed = 1;
        CHECK_FALSE(same_pixels(one, rendered(scene, settings)));
      }
}

TEST_CASE("photons: the bright spot behind the glass is there, as paths never find it") {
  Scene scene = caustic_scene();
  // Straight through the middle of the glass, from the lamp.
  scene.camera.eye = {1.2, -2.5, 2.6};
  const Vec3d lamp(-3, 1, 1);
  const Vec3d spot = lamp + (5 / 3.0) * (Vec3d(0, 0, 0) - lamp);
  scene.camera.look_at = spot;
  scene.camera.screen = {1, 0.05, 1};
  RenderSettings settings;
  settings.size = ImageSize{5, 5};
  settings.sampling.per_pixel = 8;
  const auto mean = [](const Rendering& of) {
    double sum = 0;
    for (const Rgb<float>& pixel : of.image().pixels) sum += static_cast<double>(pixel.x) / 25;
    return sum;
  };
  const double by_photons = mean(rendered(scene, settings));
  scene.render.integrator = Integrator::path;
  const double by_paths = mean(rendered(scene, settings));
  CHECK(by_photons > 5 * by_paths);
}

TEST_CASE("photons: progress rises to the end, and a render can be cancelled while photons are sent") {
  Scene scene = caustic_scene();
  scene.render.photons.count = 300000;
  RenderSettings settings;
  settings.size = ImageSize{16, 16};
  settings.threads = 1;
  double last = 0;
  settings.progress = [&](const Progress& progress) {
    CHECK(progress.done >= last);
    last = progress.done;
  };
  CHECK(rendered(scene, settings).finished);
  CHECK(last == 1);
  Stopper stopper;
  settings.stop = Stop(stopper);
  settings.progress = [&](const Progress&) { stopper.raised = true; };
  scene.render.photons.count = 3000000;
  const Rendering cancelled = rendered(scene, settings);
  CHECK_FALSE(cancelled.finished);
  CHECK(cancelled.done < 0.5);
}

TEST_CASE("photons: the memory that they need is told, where they are sent") {
  Scene scene = caustic_scene();
  scene.render.photons.count = 100000000;
  RenderSettings settings;
  settings.size = ImageSize{4, 4};
  CHECK_THAT(memory_needed(scene, settings).what, contains("a map of 100000000 photons"));
  CHECK(memory_needed(scene, settings).bytes > 1e9);
  CHECK_THAT(memory_needed(scene, settings).hint, contains("fewer photons") && contains("that many again"));
  scene.render.integrator = Integrator::whitted;
  CHECK(memory_needed(scene, settings).bytes < 1e6);
}
