#include "render/scenes.h"

#include "io/scene_file.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "support/catch.h"

namespace raywalk::test {

Scene busy_scene() {
  Scene scene;
  scene.background = Rgbd(0.1, 0.2, 0.3);
  scene.camera.eye = {-7, 0.3, 0};
  scene.camera.look_at = {0.1, -0.2, 0};
  scene.camera.screen = {2.5, 2.7, 21};
  scene.limits = {5, 0.004};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{-2.5, 4.2, 0}, {0.5, 0.05, 0.01}}},
                  {"Sun", Rgbd(0.3, 0.3, 0.2), DirectionalLight{{-1, -0.7, 0}}}};

  const auto add = [&](const std::string& name, const Shape<double>& shape) -> Material& {
    scene.objects.push_back({name, shape, {}});
    return scene.objects.back().material;
  };
  Material& mirror = add("Mirror Sphere", Sphere<double>{{1.2, 2.3, 0}, 1.4});
  mirror.reflection = Rgbd(0.6, 0.5, 0.4);
  mirror.specular = Rgbd(0.3);
  Material& glass = add("Glass Sphere", Sphere<double>{{-1.1, -1.4, 0}, 1.1});
  glass.diffuse = Rgbd(0.03);
  glass.reflection = Rgbd(0.1);
  glass.transmission = Rgbd(0.85);
  glass.dielectric = true;
  Material& filter = add("Filter", Sphere<double>{{-2.2, 1.9, 0}, 0.5});
  filter.transmission = Rgbd(0.7, 0.2, 0.2);
  filter.shadow = ShadowKind::filtered;
  filter.ior = 1.2;
  Material& polygon =
      add("Polygon", Prism<double>{{{3.6, -2.6}, {5.6, -1.6}, {4.6, 0.6}, {4.4, -1.0}, {3.0, -0.4}}, 2.8});
  polygon.transmission = Rgbd(0.6);
  polygon.ior = 1.6;
  Material& wall = add("Wall", Plane<double>{{9, 0, 0}, {-1, 0.2, 0}});
  wall.checker = Checker{Rgbd(1.0), Rgbd(0.3, 0.4, 0.2), 0.7};
  Material& floor = add("Floor", Plane<double>{{0, 0, -1.4}, {0, 0, 1}});
  floor.checker = Checker{Rgbd(0.9), Rgbd(0.35), 1.0};
  floor.reflection = Rgbd(0.2);
  return scene;
}

std::vector<NamedScene> planar_scenes() {
  std::vector<NamedScene> scenes{{"the busy scene", busy_scene()}};
  const std::filesystem::path folder = std::filesystem::path(RAYWALK_SOURCE_DIR) / "scenes";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() != ".toml") continue;
    const auto document = read_scene(entry.path().string());
    INFO((document ? "" : document.error().text()));
    REQUIRE(document.has_value());
    if (!is_planar(document->scene)) continue;
    scenes.push_back({entry.path().filename().string(), document->scene});
    // What is computed once of a scene is computed for every picture here, so there is less of it.
    RenderChoices& choices = scenes.back().scene.render;
    choices.photons.count = std::min(choices.photons.count, 2000);
    choices.radiosity.patch = 2;
  }
  REQUIRE(std::any_of(scenes.begin(), scenes.end(), [](const auto& named) { return named.name == "classic.toml"; }));
  return scenes;
}

std::string text_of(const Statistics& statistics) {
  std::ostringstream text;
  for (const std::uint64_t count : statistics.rays) text << count << ' ';
  text << "| ";
  for (const std::uint64_t count : statistics.ended) text << count << ' ';
  text << "| " << statistics.tests.nodes << ' ' << statistics.tests.primitives << ' '
       << statistics.tests.exactly_decided << " | " << statistics.random_draws() << ' ' << statistics.not_finite;
  return text.str();
}

}  // namespace raywalk::test
