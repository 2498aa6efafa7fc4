// The walk through PHOTON MAPPING: what the timeline and the messages make of its events.

#include "timeline/message.h"
#include "timeline/recorder.h"
#include "trace/photon_pass.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "messages.h"
#include "support/catch.h"

using namespace raywalk;

namespace {

/// A room with a lamp, something that glows, glass, a mirror, something shiny and something black, half open to a sky.
Scene photon_room() {
  Scene scene;
  scene.background = Rgbd(0.1);
  scene.camera.eye = {-4, 0.1, 0};
  scene.camera.look_at = {0, 0.1, 0};
  scene.camera.screen = {1, 1.6, 41};
  scene.render.integrator = Integrator::photons;
  scene.render.photons.count = 2000;
  scene.render.photons.nearest = 10;
  scene.render.photons.radius = 0.3;
  Material matt, mirror, glass, black, shiny, glow;
  matt.diffuse = Rgbd(0.7);
  mirror.diffuse = black.diffuse = glass.diffuse = glow.diffuse = shiny.diffuse = Rgbd(0.0);
  mirror.reflection = Rgbd(0.9);
  glass.transmission = Rgbd(0.95);
  glass.dielectric = true;
  shiny.specular = Rgbd(0.9);
  shiny.shininess = 8;
  glow.emission = Rgbd(2.0);
  glow.diffuse = Rgbd(0.2);
  scene.objects = {
      {"Wall", Box<double>{{2, -4, -3}, {2.5, 4, 3}}, matt},  {"Glass", Sphere<double>{{0, -1.2, 0}, 0.7}, glass},
      {"Mirror", Sphere<double>{{0.5, 0.5, 0}, 0.6}, mirror}, {"Coal", Sphere<double>{{-0.5, 2, 0}, 0.4}, black},
      {"Shiny", Sphere<double>{{-0.5, -2.6, 0}, 0.4}, shiny}, {"Glow", Sphere<double>{{0.8, 2.2, 0}, 0.4}, glow}};
  scene.lights = {{"Lamp", Rgbd(4.0), PointLight{{-2, -2, 0}, {0, 0, 1}}}};
  return scene;
}

}  // namespace

TEST_CASE("photons are walked first, in a flat world, then pixels") {
  const Scene scene = photon_room();
  const Timeline timeline = record_strip(scene);
  REQUIRE(timeline.of_photons());
  CHECK(timeline.of_paths());
  CHECK(timeline.is_flat());
  CHECK(timeline.pixels().size() == 41);
  REQUIRE(timeline.photons() != nullptr);
  CHECK_FALSE(timeline.photons()->caustic.empty());
  const int photons = timeline.all_photons_at();
  CHECK(timeline.event(photons - 1).line == Line::for_each_photon);
  CHECK(timeline.pixels().front().begun_at > photons);
  for (int at = photons; at < timeline.steps(); ++at)
    CHECK(pseudocode_of(timeline.event(at).line).procedure != Procedure::follow_photon);
  // Everything stays in the plane.
  for (const RayRecord& ray : timeline.rays()) {
    CHECK(ray.origin.z == 0);
    CHECK(ray.direction.z == 0);
  }
  for (const Photon& photon : timeline.photons()->other.photons()) CHECK(photon.position.z == 0);
  // A pixel of the picture is walked in space.
  const Timeline pixel = record_pixel(scene, {41, 31}, 20, 3);
  CHECK_FALSE(pixel.is_flat());
  CHECK(
      std::any_of(pixel.rays().begin(), pixel.rays().end(), [](const RayRecord& ray) { return ray.direction.z != 0; }));
}

TEST_CASE("GATHER LIGHT returns what the pixel gets, and each photon's way is a chain") {
  const Timeline timeline = record_strip(photon_room());
  int pixels = 0, photons = 0;
  for (const FrameRecord& frame : timeline.frames()) {
    const Line called = timeline.event(frame.called_at - 1).line;
    if (called == Line::follow_photon) {
      ++photons;
      CHECK(timeline.event(frame.returned_at - 1).line == Line::while_photon);
      continue;
    }
    REQUIRE(called == Line::gather_light);
    ++pixels;
    const PixelRecord& pixel =
        timeline.pixels()[static_cast<std::size_t>(timeline.rays()[static_cast<std::size_t>(frame.ray)].pixel)];
    CHECK(frame.returned_at == pixel.done_at - 1);
    CHECK(length(frame.returned - pixel.shade) <= 1e-9 * (1 + length(pixel.shade)));
  }
  CHECK(pixels == 41);
  CHECK(photons == 100);
  int longest = 0;
  for (const RayRecord& ray : timeline.rays()) {
    if (ray.kind != RayKind::photon || ray.parent < 0) continue;
    const RayRecord& parent = timeline.rays()[static_cast<std::size_t>(ray.parent)];
    CHECK(parent.kind == RayKind::photon);
    CHECK(length(ray.origin - parent.end) <= 1e-9);
    longest = std::max(longest, ray.depth);
  }
  CHECK(longest > 1);
}

TEST_CASE("the circle of an estimate holds the power that it says") {
  Recording how;
  how.photons = 0;
  const Scene scene = photon_room();
  const Timeline timeline = record_strip(scene, how);
  int circles = 0;
  for (int i = 0; i < timeline.steps(); ++i) {
    const auto* found = std::get_if<PhotonsFound>(&timeline.event(i).detail);
    if (found == nullptr || found->other.count == 0) continue;
    ++circles;
    double power = 0, inside = 0;
    for (const Photon& photon : timeline.photons()->other.photons()) {
      const Vec3d apart = Vec3d(photon.position) - found->position;
      if (!(dot(Vec3d(photon.normal), found->normal) > 0.5) || !(length(apart) < found->other.radius)) continue;
      power += static_cast<double>(photon.power.x);
      ++inside;
    }
    CHECK(inside == found->other.count);
    CHECK(power == Approx(found->other.power.x));
    CHECK(found->other.irradiance.x == Approx(power / (2 * found->other.radius)));  // by length
    CHECK(found->other.at_limit == (found->other.radius == Approx(0.3)));
  }
  CHECK(circles > 3);
}

TEST_CASE("every line and every message of photon mapping is reached") {
  std::set<std::string_view> messages;
  std::set<Line> lines;
  for (const bool gather : {false, true})
    for (const bool sky : {false, true}) {
      Scene scene = photon_room();
      scene.render.photons.gather = gather;
      scene.render.photons.progressive = sky;  // with circles of a radius that is given
      if (sky) scene.lights.clear(), scene.objects.pop_back();
      for (const bool in_space : {false, true}) {
        const Timeline timeline = in_space ? record_pixel(scene, {41, 31}, 30, 15) : record_strip(scene);
        for (int position = 1; position <= timeline.steps(); ++position) {
          messages.insert(describe(scene, timeline, position).id);
          lines.insert(timeline.event(position - 1).line);
        }
      }
    }
  CHECK(lines.size() == photon_line_count);
  Scene rough = photon_room();
  for (Object& object : rough.objects)
    if (object.material.reflects()) object.material.roughness = 0.2;
  const Timeline timeline = record_strip(rough);
  for (int position = 1; position <= timeline.steps(); ++position)
    messages.insert(describe(rough, timeline, position).id);
  CHECK(messages.count("walk.photon_small_mirror") == 1);
  Scene sunny = photon_room();
  sunny.lights = {{"Sun", Rgbd(1.0), DirectionalLight{Vec3d(-1, 0.3, 0)}}};
  const Timeline by_day = record_strip(sunny);
  for (int position = 1; position <= by_day.steps(); ++position) messages.insert(describe(sunny, by_day, position).id);
  for (const std::string_view id : test::photon_messages) {
    INFO(id);
    CHECK(messages.count(id) == 1);
  }
}
