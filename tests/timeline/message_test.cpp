#include "timeline/message.h"

#include "timeline/recorder.h"

#include <set>

#include "messages.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

/// A mirror, glass with total internal reflection, a body that blocks, two lights; shallow, and with a threshold.
Scene scene_of_all_messages() {
  Scene scene;
  scene.background = Rgbd(0.1, 0.2, 0.3);
  scene.camera.eye = Vec3d(-6, 0, 0);
  scene.camera.look_at = Vec3d(0.0);
  scene.camera.screen = Screen{2, 3.2, 25};
  scene.limits = {4, 0.02};
  scene.lights.push_back({"Lamp", Rgbd(1.0), PointLight{Vec3d(-1, 4, 0), {}}});
  scene.lights.push_back({"Sun", Rgbd(0.3), DirectionalLight{Vec3d(0.3, -1, 0)}});
  scene.lights.push_back({"Spot", Rgbd(0.2), SpotLight{Vec3d(-6, 3, 0), Vec3d(1, -3.2, 0), 20, 10, {}}});
  Material mirror, glass, dark_glass;
  mirror.reflection = Rgbd(0.6);
  glass.reflection = Rgbd(0.1);
  glass.transmission = Rgbd(0.8);
  glass.shadow = ShadowKind::filtered;
  dark_glass = glass;
  dark_glass.ior = 1.6;
  dark_glass.shadow = ShadowKind::opaque;
  scene.objects.push_back({"Mirror", Sphere<double>{Vec3d(1, 1.5, 0), 1}, mirror});
  scene.objects.push_back({"Glass", Sphere<double>{Vec3d(0, -0.5, 0), 0.8}, glass});
  scene.objects.push_back(
      {"Block", Prism<double>{{{2.5, -2}, {4.5, -2}, {4.5, 0.8}, {3.5, -0.5}, {2.5, 0.4}}, 2}, dark_glass});
  scene.objects.push_back({"Matte", Sphere<double>{Vec3d(1, -3.2, 0), 0.7}, Material{}});
  return scene;
}

/// The same with air in the glass.
Scene with_bubble() {
  Scene scene = scene_of_all_messages();
  Material air = scene.objects[1].material;
  air.ior = 1;
  scene.objects.push_back({"Bubble", Sphere<double>{Vec3d(0, -0.5, 0), 0.5}, air});
  return scene;
}

}  // namespace

TEST_CASE("position 0 is the start") {
  const Scene scene = scene_of_all_messages();
  CHECK(describe(scene, record_strip(scene), 0).id == "walk.start");
}

TEST_CASE("one scene, lit and unlit, reaches every message but those of the path tracer and of skies") {
  std::set<std::string_view> found;
  const auto gather = [&found](const Scene& scene) {
    const Timeline timeline = record_strip(scene, {Precision::double_, {2}});
    for (int position = 0; position <= timeline.steps(); ++position)
      found.insert(describe(scene, timeline, position).id);
  };
  for (const TraceLimits& limits : {TraceLimits{2, 0}, TraceLimits{4, 0.02}, TraceLimits{9, 0.7}}) {
    Scene scene = scene_of_all_messages();
    scene.limits = limits;
    gather(scene);
    CHECK(found.count("walk.shade_called_unlit") == 0);
  }
  Scene dark = scene_of_all_messages();
  dark.lights.clear();
  gather(dark);
  gather(with_bubble());
  for (const std::string& id : test::strip_messages()) {
    INFO(id);
    CHECK(found.count(id) == (id == "walk.path_length" ? 0 : 1));
  }
}

TEST_CASE("messages name what the events say") {
  const Scene scene = scene_of_all_messages();
  const Timeline timeline = record_strip(scene);
  const auto object = [&](int index) { return scene.objects[static_cast<std::size_t>(index)].name; };
  int seen = 0;
  for (int position = 1; position <= timeline.steps(); ++position) {
    const Message message = describe(scene, timeline, position);
    const Event& event = *timeline.just_run(position);
    if (const auto* found = std::get_if<Found>(&event.detail)) {
      if (found->ending == Ending::hit) {
        CHECK(std::get<HitObject>(message.arguments.at(1).value) == HitObject{object(found->object)});
        const double distance = std::get<double>(message.arguments[2].value);
        const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(position))];
        CHECK(distance == Approx(length(found->point - ray.origin)));
        ++seen;
      }
      if (message.id == "walk.light_blocked") {
        CHECK(std::get<HitObject>(message.arguments.at(1).value) == HitObject{object(found->object)});
        ++seen;
      }
    }
    if (const auto* formed = std::get_if<RayFormed>(&event.detail); formed != nullptr && formed->snell) {
      // Into glass the angle shrinks, out of it it grows.
      const double in = std::get<double>(message.arguments[1].value),
                   out = std::get<double>(message.arguments[2].value);
      CHECK(std::sin(in * 3.14159265358979 / 180) * formed->snell->n1 ==
            Approx(std::sin(out * 3.14159265358979 / 180) * formed->snell->n2).epsilon(0).margin(1e-6));
      const bool inwards = formed->snell->n2 > formed->snell->n1;
      CHECK(message.id == (inwards ? "walk.refract_formed_in" : "walk.refract_formed_out"));
      ++seen;
    }
    if (const auto* computed = std::get_if<ShadeComputed>(&event.detail)) {
      CHECK(std::get<Rgbd>(message.arguments[1].value) == computed->total);
      CHECK(message.id == (event.depth == 1 ? "walk.rtnshade_to_main" : "walk.rtnshade_to_caller"));
      ++seen;
    }
    if (const auto* put = std::get_if<PixelPut>(&event.detail)) {
      CHECK(std::get<int>(message.arguments[0].value) == put->column);
      CHECK(std::get<Rgbd>(message.arguments[1].value) == put->shade);
      ++seen;
    }
    if (message.id == "walk.shade_called") CHECK(std::get<int>(message.arguments[0].value) == event.depth + 1);
  }
  CHECK(seen > 100);
}

TEST_CASE("a recording in float is described like one in double") {
  const Scene scene = scene_of_all_messages();
  Recording how;
  how.precision = Precision::float_;
  const Timeline timeline = record_strip(scene, how);
  int totals = 0;
  for (int position = 0; position <= timeline.steps(); ++position)
    totals += describe(scene, timeline, position).id == "walk.reflective_totally" ? 1 : 0;
  const Timeline in_double = record_strip(scene);
  int expected = 0;
  for (int position = 0; position <= in_double.steps(); ++position)
    expected += describe(scene, in_double, position).id == "walk.reflective_totally" ? 1 : 0;
  CHECK(expected > 0);
  CHECK(totals == expected);
}

TEST_CASE("inside of another body both indices are said, and which way nothing gets through") {
  const Scene scene = with_bubble();
  const Timeline timeline = record_strip(scene);
  int into_air = 0, out_of_air = 0, kept_out = 0;
  for (int position = 1; position <= timeline.steps(); ++position) {
    const Message message = describe(scene, timeline, position);
    if (message.id == "walk.refract_formed_within") {
      const SnellNumbers& snell = *std::get<RayFormed>(timeline.just_run(position)->detail).snell;
      REQUIRE(message.arguments.size() == 5);
      CHECK(std::get<std::string>(message.arguments[0].value) == "Bubble");
      CHECK(std::get<double>(message.arguments[3].value) == snell.n1);
      CHECK(std::get<double>(message.arguments[4].value) == snell.n2);
      (snell.n1 == 1.5 && snell.n2 == 1 ? into_air : out_of_air) += 1;
    }
    if (message.id == "walk.totally_reflected_in") {
      CHECK(std::get<std::string>(message.arguments[0].value) == "Bubble");
      const Decided& decided = std::get<Decided>(timeline.just_run(position)->detail);
      REQUIRE(decided.snell);
      CHECK(decided.snell->n1 == 1.5);
      CHECK(decided.snell->n2 == 1);
      ++kept_out;
    }
  }
  CHECK(into_air > 0);
  CHECK(out_of_air > 0);
  CHECK(kept_out > 0);
}
