#include "timeline/event_json.h"

#include "timeline/recorder.h"

#include <nlohmann/json.hpp>
#include <set>

#include "support/catch.h"

using namespace raywalk;

namespace {

// A glass ball before a mirror floor, and two lights: every kind of event and of number comes.
Scene glass_scene() {
  Scene scene;
  scene.camera.eye = {-5, 0, 0};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.screen = {1, 1.2, 5};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{-3, 4, 0}, {}}}, {"Sun", Rgbd(0.5), DirectionalLight{{0, -1, 0}}}};
  Material glass;
  glass.transmission = Rgbd(0.8);
  glass.dielectric = true;
  Material mirror;
  mirror.reflection = Rgbd(0.5);
  scene.objects = {{"Ball", Sphere<double>{{0, 0.4, 0}, 1}, glass},
                   {"Wall", Plane<double>{{3, 0, 0}, {-1, 0.1, 0}}, mirror}};
  return scene;
}

using Json = nlohmann::ordered_json;

std::vector<Json> steps_of(const Scene& scene) {
  const Timeline timeline = record_strip(scene);
  std::vector<Json> steps;
  for (int i = 0; i < timeline.steps(); ++i) steps.push_back(event_json(scene, timeline.event(i)));
  return steps;
}

}  // namespace

TEST_CASE("every event is told with its line and its numbers") {
  const Scene scene = glass_scene();
  const Timeline timeline = record_strip(scene);
  std::set<std::string> kinds, members;
  for (int i = 0; i < timeline.steps(); ++i) {
    const Event& event = timeline.event(i);
    const Json json = event_json(scene, event);
    CHECK(json.at("line") == std::string(pseudocode_of(event.line).text));
    CHECK(json.at("procedure") == std::string(name_of(pseudocode_of(event.line).procedure)));
    CHECK(json.at("depth") == event.depth);
    kinds.insert(json.at("what").get<std::string>());
    for (const auto& [name, value] : json.items()) members.insert(name);
    if (const auto* formed = std::get_if<RayFormed>(&event.detail)) {
      CHECK(json.at("ray") == formed->ray);
      CHECK(json.at("direction") == Json({formed->direction.x, formed->direction.y, formed->direction.z}));
      CHECK(json.contains("parent") == (formed->kind != RayKind::primary));
      if (formed->light >= 0)
        CHECK(json.at("light_name") == scene.lights[static_cast<std::size_t>(formed->light)].name);
    } else if (const auto* found = std::get_if<Found>(&event.detail)) {
      CHECK(json.at("ending") == std::string(name_of(found->ending)));
      CHECK(json.contains("object_name") == (found->object >= 0));
      if (found->object >= 0) {
        CHECK(json.at("object_name") == scene.objects[static_cast<std::size_t>(found->object)].name);
        CHECK(json.at("t") == found->t);
        CHECK(json.contains("quadratic") == (found->object == 0));
        CHECK(json.contains("plane") == (found->object == 1));
      }
    } else if (const auto* put = std::get_if<PixelPut>(&event.detail)) {
      CHECK(json.at("shade") == Json({put->shade.x, put->shade.y, put->shade.z}));
    }
  }
  CHECK(kinds == std::set<std::string>{"decided", "found", "pixel_begun", "pixel_put", "ray_formed", "ray_not_formed",
                                       "shade_called", "shade_computed"});
  for (const std::string name : {"snell", "why", "quadratic", "plane", "light_name", "background", "lights", "passed"})
    CHECK(members.count(name) == 1);
}

TEST_CASE("what is written reads back with every bit") {
  for (const Json& step : steps_of(glass_scene())) CHECK(Json::parse(step.dump()) == step);
}
