// Pictures by paths keep the invariants of all pictures: the same bits for any threads, tiles and accelerator, and the
// strip is the middle row.

#include "render/scenes.h"
#include "support/catch.h"

#include <algorithm>

using namespace raywalk;
using namespace raywalk::test;

namespace {

Scene glowing(Sampler sampler) {
  Scene scene = busy_scene();
  scene.render.integrator = Integrator::path;
  scene.render.sampler = sampler;
  scene.objects[0].material.gloss = 3;
  Material glow;
  glow.emission = Rgbd(3, 2, 1);
  scene.objects.push_back({"Bulb", Sphere<double>{{-2.5, -3, 0}, 0.4}, glow});
  scene.objects.push_back({"Pillar", Prism<double>{{{6, 2}, {6.5, 2}, {6.5, 2.5}, {6, 2.5}}, 1.5}, glow});
  return scene;
}

template <class T>
Film<T> film(const Scene& scene, RenderSettings settings) {
  settings.precision = precision_of<T>();
  const auto rendered = render(scene, settings);
  REQUIRE(rendered);
  CHECK(rendered->statistics.not_finite == 0);
  CHECK(rendered->statistics.drawn(Effect::indirect_light) > 0);
  return rendered->film_of<T>();
}

}  // namespace

TEMPLATE_TEST_CASE("paths give the same bits for any threads, tiles and accelerator", "", float, double) {
  using T = TestType;
  for (const Sampler sampler : {Sampler::random, Sampler::jittered, Sampler::sobol}) {
    const Scene scene = glowing(sampler);
    RenderSettings settings{ImageSize{69, 47}, {3, 11}};
    settings.threads = 1;
    const Film<T> one = film<T>(scene, settings);
    for (const int threads : {2, 5}) {
      settings.threads = threads;
      settings.reorder_tiles = [](std::vector<int>& tiles) { std::reverse(tiles.begin(), tiles.end()); };
      CHECK(pixels_that_differ(one, film<T>(scene, settings)) == 0);
    }
    for (const AcceleratorKind kind : {AcceleratorKind::none, AcceleratorKind::grid, AcceleratorKind::kdtree}) {
      settings.accelerator = kind;
      CHECK(pixels_that_differ(one, film<T>(scene, settings)) == 0);
    }
    settings.sampling.seed = 12;
    CHECK(pixels_that_differ(one, film<T>(scene, settings)) > one.pixels().size() / 2);
  }
}

TEMPLATE_TEST_CASE("the strip by paths is the middle row", "", float, double) {
  using T = TestType;
  const Scene scene = glowing(Sampler::sobol);
  REQUIRE(why_not_planar(scene) == "");
  for (const int samples : {1, 4}) {
    RenderSettings settings{ImageSize{scene.camera.screen.cells, 15}, {samples, 5}};
    settings.precision = precision_of<T>();
    const Film<T> image = film<T>(scene, settings);
    const auto strip = render_strip(scene, settings);
    REQUIRE(strip);
    for (int column = 0; column < scene.camera.screen.cells; ++column)
      CHECK(same_bits(strip->template film_of<T>().at(column, 0), image.at(column, 7)));
  }
}

TEST_CASE("the longest path of a scene is kept to") {
  Scene scene = glowing(Sampler::random);
  scene.render.path_length = 1;
  const auto seen = render(scene, {ImageSize{21, 15}});
  REQUIRE(seen);
  CHECK(seen->statistics.formed(RayKind::primary) == 21 * 15);
  CHECK(seen->statistics.formed(RayKind::shadow) + seen->statistics.formed(RayKind::reflect) == 0);
  CHECK(seen->statistics.ends(Ending::path_length) > 0);
  scene.render.path_length = 2;
  const auto lit = render(scene, {ImageSize{21, 15}});
  REQUIRE(lit);
  CHECK(lit->statistics.formed(RayKind::shadow) > 0);
}
