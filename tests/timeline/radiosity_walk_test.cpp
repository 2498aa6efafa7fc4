// The walk through RADIOSITY: what the timeline and the messages make of its events.

#include "timeline/event_json.h"
#include "timeline/message.h"
#include "timeline/recorder.h"
#include "timeline/stops.h"
#include "trace/patches.h"

#include <algorithm>
#include <set>

#include "messages.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

/// A room with something that glows, a block that is in the way, something black and a window.
Scene glowing_room() {
  Scene scene;
  scene.camera.eye = {-1.5, 0.1, 0};
  scene.camera.look_at = {0, 0.1, 0};
  scene.camera.screen = {1, 1.6, 21};
  scene.background = Rgbd(0.1);
  scene.render.integrator = Integrator::radiosity;
  scene.render.radiosity.patch = 1.1;
  Material matt, black, glow;
  matt.diffuse = Rgbd(0.6);
  black.diffuse = glow.diffuse = Rgbd(0.0);
  glow.emission = Rgbd(2.0);
  scene.objects = {{"North", Box<double>{{-2, 2, -1}, {2, 2.2, 1}}, matt},
                   {"South", Box<double>{{-2, -2.2, -1}, {2, -2, 1}}, matt},
                   {"East", Box<double>{{2, -2, -1}, {2.2, 1, 1}}, black},
                   {"Block", Box<double>{{0.3, -0.4, -0.5}, {0.9, 0.3, 0.5}}, matt},
                   {"Lamp", Box<double>{{-0.3, 1.2, -0.1}, {0.3, 1.4, 0.1}}, glow}};
  return scene;
}

}  // namespace

TEST_CASE("light is shot first, in a flat world, then pixels look it up") {
  const Scene scene = glowing_room();
  const Timeline timeline = record_strip(scene);
  REQUIRE(timeline.of_radiosity());
  CHECK_FALSE(timeline.of_photons());
  CHECK(timeline.is_flat());
  REQUIRE(timeline.patches() != nullptr);
  CHECK(timeline.pixels().size() == 21);
  CHECK(timeline.frames().empty());
  CHECK(timeline.event(0).line == Line::cut_patches);
  CHECK(timeline.event(1).line == Line::light_patches);
  // The first shot, line by line.
  CHECK(timeline.event(2).line == Line::while_unshot_light);
  CHECK(timeline.event(3).line == Line::take_patch);
  CHECK(timeline.event(4).line == Line::shoot_light);
  CHECK(scene.objects[static_cast<std::size_t>(std::get<PatchTaken>(timeline.event(3).detail).object)].name == "Lamp");
  // A step over the call ends the shot, and back; a step of a pixel is one shot as well.
  const int end = timeline.end_of_shot(0);
  CHECK(timeline.event(end - 1).line == Line::forget_unshot_light);
  CHECK(step_over(timeline, 4) == end);
  CHECK(step_back_over(timeline, end) == 4);
  CHECK(timeline.next_pixel(0) == end);
  CHECK(timeline.next_pixel(end) > end);
  CHECK(timeline.previous_pixel(timeline.next_pixel(end)) == end);
  // Unshot light falls from shot to shot, and is what the patches say.
  double before = 1;
  int shots = 0;
  for (int at = timeline.end_of_shot(0); at > 0; at = timeline.end_of_shot(at), ++shots) {
    CHECK(timeline.unshot_at(at) < before);
    before = timeline.unshot_at(at);
  }
  CHECK(shots > 10);
  CHECK(before <= scene.render.radiosity.tolerance);
  const Timeline pixel = record_pixel(scene, {21, 15}, 10, 3);
  CHECK_FALSE(pixel.is_flat());
  CHECK(pixel.of_radiosity());
}

TEST_CASE("the light of patches at any position is that of the events up to there") {
  const Timeline timeline = record_strip(glowing_room());
  const Patches& patches = *timeline.patches();
  const auto power = [&](int position) {
    double sum = 0;
    const std::vector<PatchLight> lights = timeline.lights_at(position);
    for (std::size_t i = 0; i < lights.size(); ++i) sum += patches[static_cast<int>(i)].area * lights[i].unshot.x;
    return sum;
  };
  CHECK(timeline.lights_at(1).empty());
  const double first = power(2);
  CHECK(first > 0);
  for (int at = timeline.end_of_shot(0), shots = 0; at > 0 && shots < 20; at = timeline.end_of_shot(at), ++shots)
    CHECK(power(at) == Approx(first * timeline.unshot_at(at)));
  // Only the receiver changes.
  for (int i = 0; i < 60; ++i) {
    const auto* arrived = std::get_if<LightArrived>(&timeline.event(i).detail);
    if (arrived == nullptr) continue;
    const auto now = timeline.lights_at(i + 1), then = timeline.lights_at(i);
    for (std::size_t k = 0; k < now.size(); ++k)
      CHECK((now[k].irradiance != then[k].irradiance) ==
            (static_cast<int>(k) == arrived->patch && arrived->arrived != Rgbd(0.0)));
  }
}

TEST_CASE("the walk is the picture: watched or not the same bits, and pixels show what patches hold") {
  const Scene scene = glowing_room();
  const Timeline timeline = record_strip(scene), again = record_strip(scene);
  CHECK_FALSE(first_difference(scene, timeline, again));
  Recording line_by_line;
  line_by_line.shots = 100000;
  const Timeline long_walk = record_strip(scene, line_by_line);
  REQUIRE(long_walk.pixels().size() == timeline.pixels().size());
  for (std::size_t i = 0; i < timeline.pixels().size(); ++i) {
    CHECK(long_walk.pixels()[i].shade == timeline.pixels()[i].shade);
    CHECK(timeline.pixels()[i].shade.x >= 0);
  }
}

TEST_CASE("every message of radiosity is reached") {
  std::set<std::string_view> found;
  const auto gather = [&found](const Scene& scene, const Timeline& timeline) {
    for (int position = 0; position <= timeline.steps(); ++position)
      found.insert(describe(scene, timeline, position).id);
  };
  const Scene room = glowing_room();
  gather(room, record_strip(room));
  gather(room, record_pixel(room, {21, 15}, 10, 3));
  Scene dark = room;
  dark.objects.pop_back();
  gather(dark, record_strip(dark));
  Scene covered = room;  // the eye in a body that no light reaches
  covered.objects.push_back({"Cage", Box<double>{{-1.8, -0.2, -0.5}, {-1.2, 0.4, 0.5}}, Material{}});
  covered.objects.push_back({"Sheet", Plane<double>{{-1.3, 0, 0}, {1, 0, 0}}, Material{}});
  gather(covered, record_strip(covered));
  for (const std::string_view id : test::radiosity_messages) {
    INFO(id);
    CHECK(found.count(id) == 1);
  }
}
