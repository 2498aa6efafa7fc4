// The pencil about each ray of a walk, against the true rays beside it.
#include "inspect/pencil_walk.h"

#include <cmath>
#include <string>

#include "io/scene_file.h"
#include "support/catch.h"
#include "timeline/recorder.h"

using namespace raywalk;

namespace {

Scene shipped_scene(const std::string& name) {
  return read_scene(std::string(RAYWALK_SOURCE_DIR) + "/scenes/" + name + ".toml")->scene;
}

Vec3d left_of(const Vec3d& direction) { return {-direction.y, direction.x, 0}; }

// Where a true ray passes the end of the last stage, or its own end, and how it slopes there: against the axis.
struct Beside {
  double offset, slope;
};
std::optional<Beside> beside(const World<double>& world, const std::vector<PencilStage>& stages, double angle,
                             double last_length, ConePlane plane) {
  const std::vector<Vec3d> way = true_neighbour(world, stages, angle, last_length, plane);
  if (way.size() != stages.size() + 1) return std::nullopt;
  const PencilStage& last = stages.back();
  const Vec3d from = way[way.size() - 2], along = normalize(way.back() - from);
  const Vec3d side = plane == ConePlane::across ? Vec3d(0, 0, 1) : left_of(last.direction);
  const double forward = dot(along, last.direction);
  const Vec3d end = last.origin + last_length * last.direction;
  const Vec3d met = from + dot(end - from, last.direction) / forward * along;
  return Beside{dot(met - end, side), dot(along, side) / forward};
}

}  // namespace

TEST_CASE("the matrix of each ray is what its neighbours do, to first order") {
  int followed = 0, bent = 0, curved = 0, folded = 0, astigmatic = 0;
  for (const std::string name : {"classic", "mirrors", "glass", "glass_in_water", "whitted"}) {
    Scene scene = shipped_scene(name);
    scene.render.integrator = Integrator::whitted;
    const Timeline timeline = record_strip(scene, {Precision::double_});
    const World<double> world(scene);
    const auto camera = camera_of<double>(scene, timeline);
    for (int ray = 0; ray < static_cast<int>(timeline.rays().size()); ++ray) {
      const std::vector<PencilStage> stages = pencil_of(world, camera, timeline, ray);
      if (stages.empty()) continue;
      CAPTURE(name, ray, stages.size());
      REQUIRE(stages.back().ray == ray);
      const PencilStage& last = stages.back();
      const double reach = std::isfinite(last.length) ? last.length : 3.0;
      constexpr double angle = 1e-6;
      for (const ConePlane plane : {ConePlane::of_incidence, ConePlane::across}) {
        const bool in_plan = plane == ConePlane::of_incidence;
        const PencilMatrix& start = in_plan ? last.start : last.start_across;
        const std::optional<double>& focus = in_plan ? last.focus : last.focus_across;
        // From one medium to another light is neither lost nor gained between rays.
        CHECK(std::abs(start.determinant()) == Approx(stages.front().n / last.n).epsilon(1e-9));
        const auto one = beside(world, stages, angle, reach, plane),
                   other = beside(world, stages, -angle, reach, plane);
        if (!one || !other) continue;  // one of them meets something else: the axis grazes an edge
        // By central differences, whose error is of the third order.
        const ParaxialRay at = (pencil_transfer(reach) * start)({0, angle});
        const double offset = (one->offset - other->offset) / 2, slope = (one->slope - other->slope) / 2;
        const double size =
            angle * (1 + std::abs(start.a) + std::abs(start.b) + std::abs(start.c) + std::abs(start.d)) * (1 + reach);
        CHECK(std::abs(offset - at.offset) < 1e-4 * size);
        CHECK(std::abs(slope - at.slope) < 1e-4 * size);
        ++followed;
        bent += stages.size() > 1;
        for (const PencilStage& stage : stages) curved += stage.curvature != 0;
        if (focus && stages.size() > 1 && std::abs(*focus) < 20) {
          // There the neighbours cross, before the ray or behind it.
          const double cross_at = reach - offset / slope;
          CHECK(cross_at == Approx(*focus).margin(1e-3 * (1 + reach)));
          ++folded;
          astigmatic += last.focus && std::abs(*last.focus - *last.focus_across) > 0.1;
        }
      }
    }
  }
  CHECK(followed > 400);
  CHECK(bent > 120);
  CHECK(curved > 120);
  CHECK(folded > 60);
  CHECK(astigmatic > 20);
}

TEST_CASE("there is no pencil about a ray that has a width, goes to a light, or was drawn at random") {
  Scene scene = shipped_scene("classic");
  const World<double> world(scene);
  const Timeline timeline = record_strip(scene, {Precision::double_});
  int shadows = 0;
  for (int ray = 0; ray < static_cast<int>(timeline.rays().size()); ++ray) {
    if (timeline.rays()[static_cast<std::size_t>(ray)].kind != RayKind::shadow) continue;
    CHECK(pencil_of(world, camera_of<double>(scene, timeline), timeline, ray).empty());
    ++shadows;
  }
  CHECK(shadows > 10);
  scene.render.integrator = Integrator::cones;
  const Timeline cones = record_strip(scene, {Precision::double_});
  for (int ray = 0; ray < static_cast<int>(cones.rays().size()); ++ray)
    CHECK(pencil_of(world, camera_of<double>(scene, cones), cones, ray).empty());
  CHECK(true_neighbour(world, {}, 0, 1).empty());
}

TEST_CASE("a pencil meets what moves where it was when the shutter opened, as its ray did") {
  Scene scene = shipped_scene("mirrors");
  scene.render.integrator = Integrator::whitted;
  for (Object& object : scene.objects) object.motion = {{0, {0, 0, 0}}, {1, {0.3, 0.2, 0}}};
  scene.camera.shutter_open = 0.5, scene.camera.shutter_close = 1;
  const Timeline timeline = record_strip(scene, {Precision::double_});
  const World<double> world(scene);
  const auto camera = camera_of<double>(scene, timeline);
  int followed = 0;
  for (int ray = 0; ray < static_cast<int>(timeline.rays().size()); ++ray) {
    for (const PencilStage& stage : pencil_of(world, camera, timeline, ray)) {
      const RayRecord& record = timeline.rays()[static_cast<std::size_t>(stage.ray)];
      CAPTURE(ray, stage.ray);
      REQUIRE(stage.object == record.object);
      if (record.object >= 0)
        REQUIRE(length(stage.origin + stage.length * stage.direction - record.end) == Approx(0).margin(1e-9));
      followed += record.object >= 0;
    }
  }
  CHECK(followed > 20);
}

TEST_CASE("a recording of 24 bits has pencils too") {
  Scene scene = shipped_scene("mirrors");
  scene.render.integrator = Integrator::whitted;
  const World<double> world(scene);
  const auto mirrored = [&](Precision precision) {
    const Timeline timeline = record_strip(scene, {precision});
    const auto camera = camera_of<double>(scene, timeline);
    int count = 0;
    for (int ray = 0; ray < static_cast<int>(timeline.rays().size()); ++ray)
      count += pencil_of(world, camera, timeline, ray).size() > 1;
    return count;
  };
  const int expected = mirrored(Precision::double_);
  CHECK(expected > 10);
  CHECK(mirrored(Precision::float_) > 0.9 * expected);
}

TEST_CASE("a true ray beside ends where it meets another object") {
  // A mirror that faces EYE, and beside it one that stands nearer.
  Scene scene;
  scene.camera.eye = {-6, 0, 0}, scene.camera.look_at = {0, 0, 0};
  scene.camera.screen = {2, 1, 1};
  Material mirror;
  mirror.reflection = Rgbd(0.9);
  scene.objects = {{"Far", Box<double>{{2, -1, -1}, {3, 1, 1}}, mirror},
                   {"Near", Box<double>{{0, 1, -1}, {3, 3, 1}}, mirror}};
  scene.render.integrator = Integrator::whitted;
  const Timeline timeline = record_strip(scene, {Precision::double_});
  const World<double> world(scene);
  REQUIRE(timeline.rays().size() > 1);
  int reflected = 0;
  while (timeline.rays()[static_cast<std::size_t>(reflected)].kind != RayKind::reflect) ++reflected;
  const auto stages = pencil_of(world, camera_of<double>(scene, timeline), timeline, reflected);
  REQUIRE(stages.size() == 2);
  CHECK(stages[0].object == 0);
  CHECK(true_neighbour(world, stages, 0.05, 3).size() == 3);
  CHECK(true_neighbour(world, stages, 0.25, 3).size() == 1);  // it meets Near
}
