// Cancelling a render inside a pixel that would never end.

#include "render/render.h"
#include "render/scenes.h"
#include "support/asked.h"
#include "support/catch.h"
#include "support/exploding_room.h"

#include <optional>
#include <string>

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("a render is stopped inside a pixel", "[render]") {
  const Integrator integrator = GENERATE(Integrator::whitted, Integrator::distributed);
  const Numerics numerics = GENERATE(Numerics::robust, Numerics::naive);
  Scene scene = exploding_room(integrator);
  scene.render.numerics = numerics;
  for (const int threads : {1, 2}) {
    Asked asked(100'000);
    RenderSettings settings;
    settings.threads = threads;
    settings.stop = Stop(asked);
    const auto part = render(scene, settings).value();
    CHECK_FALSE(part.finished);
    // Nothing but what was finished is in the picture.
    CHECK(part.done == 0);
    CHECK(part.film_of<double>().pixels() == Film<double>(scene.image).pixels());
    CHECK(asked.times < 100'100);
  }
}

TEST_CASE("what was finished before a pixel was cut off is kept", "[render]") {
  Scene scene = exploding_room(Integrator::whitted);
  scene.limits.depth = 7;
  const auto whole = render(scene, {}).value();
  Asked all;
  RenderSettings settings;
  settings.threads = 1;
  settings.stop = Stop(all);
  CHECK(render(scene, settings).value().film_of<double>().pixels() == whole.film_of<double>().pixels());
  for (int part = 1; part < 7; ++part) {
    Asked asked(all.times * part / 7);
    settings.stop = Stop(asked);
    const auto stopped = render(scene, settings).value();
    CHECK_FALSE(stopped.finished);
    const auto& pixels = stopped.film_of<double>().pixels();
    std::size_t finished = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (pixels[i] == Rgbd(0.0)) continue;
      ++finished;
      CHECK(pixels[i] == whole.film_of<double>().pixels()[i]);
    }
    CHECK(finished > 0);
    CHECK(stopped.done == static_cast<double>(finished) / static_cast<double>(pixels.size()));
  }
}

TEST_CASE("a path that hardly ends is stopped on its way", "[render]") {
  Scene scene = exploding_room(Integrator::path);
  for (Object& object : scene.objects) object.material.reflection = Rgbd(1.0), object.material.transmission = Rgbd(0.0);
  scene.render.path_length = 0;
  Asked asked(100'000);
  RenderSettings settings;
  settings.sampling.per_pixel = 1 << 20;
  settings.stop = Stop(asked);
  const auto part = render(scene, settings).value();
  CHECK_FALSE(part.finished);
  CHECK(asked.times < 100'100);
}

TEST_CASE("many lights and many places on a light are stopped before they are all asked for", "[render]") {
  Scene scene;
  scene.image = {1, 1};
  scene.objects.push_back({"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, {}});
  scene.camera.eye = {-3, 0, 3};
  const bool wide = GENERATE(false, true);
  CAPTURE(wide);
  if (wide) {
    scene.lights = {{"Ball", Rgbd(1.0), SphereLight{{0, 0, 5}, 1, 1, {}}}};
    scene.render.integrator = Integrator::distributed;
    scene.render.light_grid = 100;
  } else {
    for (int i = 0; i < 10'000; ++i)
      scene.lights.push_back({"L" + std::to_string(i), Rgbd(1.0), PointLight{{0, 0, 5.0 + i}, {}}});
  }
  Asked asked(20);
  RenderSettings settings;
  settings.stop = Stop(asked);
  const auto part = render(scene, settings).value();
  CHECK_FALSE(part.finished);
  CHECK(part.done == 0);
}

TEST_CASE("cones whose tree has no end are warned of before the trace", "[render]") {
  Scene scene;
  scene.camera.eye = {-14, 0, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.limits.depth = 9;
  scene.render.integrator = Integrator::cones;
  for (int i = 0; i < 60; ++i) {
    Object ball{"Ball " + std::to_string(i), Sphere<double>{{2 * (i / 20), i / 4 % 5 - 2, 1.5 * (i % 4) - 2}, 0.6}, {}};
    ball.material.reflection = Rgbd(0.4);
    scene.objects.push_back(ball);
  }
  constexpr int most = 3'000'000;
  Asked asked(most);
  RenderSettings settings;
  settings.size = ImageSize{16, 12};
  settings.stop = Stop(asked);
  std::optional<TreeSize> warned;
  settings.endless = [&](const TreeSize& tree) {
    warned = tree;
    asked.times = most;  // enough
  };
  CHECK_FALSE(render(scene, settings).value().finished);
  REQUIRE(warned);
  CHECK(warned->rays > 1e6);
  CHECK(warned->growth > 2);
}
