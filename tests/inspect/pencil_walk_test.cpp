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
                             double last_length) {
  const std::vector<Vec3d> way = true_neighbour(world, stages, angle, last_length);
  if (way.size() != stages.size() + 1) return std::nullopt;
  const PencilStage& last = stages.back();
  const Vec3d from = way[way.size() - 2], along = normalize(way.back() - from), left = left_of(last.direction);
  const double forward = dot(along, last.direction);
  const Vec3d end = last.origin + last_length * last.direction;
  const Vec3d met = from + dot(end - from, last.direction) / forward * along;
  return Beside{dot(met - end, left), dot(along, left) / forward};
}

}  // namespace

TEST_CASE("the matrix of each ray is what its neighbours do, to first order") {
  int followed = 0, bent = 0, curved = 0, folded = 0;
  for (const std::string name : {"classic", "mirrors", "glass", "glass_in_water", "whitted"}) {
    Scene scene = shipped_scene(name);
    scene.render.integrator = Integrator::whitted;
    const Timeline timeline = record_strip(scene, {Precision::double_});
    const World<double> world(scene);
    for (int ray = 0; ray < static_cast<int>(timeline.rays().size()); ++ray) {
      const std::vector<PencilStage> stages = pencil_of(world, timeline, ray);
      if (stages.empty()) continue;
      CAPTURE(name, ray, stages.size());
      REQUIRE(stages.back().ray == ray);
      const PencilStage& last = stages.back();
      // From one medium to another light is neither lost nor gained between rays.
      CHECK(std::abs(last.start.determinant()) == Approx(stages.front().n / last.n).epsilon(1e-9));
      const double reach = std::isfinite(last.length) ? last.length : 3.0;
      constexpr double angle = 1e-6;
      const auto one = beside(world, stages, angle, reach), other = beside(world, stages, -angle, reach);
      if (!one || !other) continue;  // one of them meets something else: the axis grazes an edge
      // By central differences, whose error is of the third order.
      const ParaxialRay at = (pencil_transfer(reach) * last.start)({0, angle});
      const double offset = (one->offset - other->offset) / 2, slope = (one->slope - other->slope) / 2;
      const double size =
          angle *
          (1 + std::abs(last.start.a) + std::abs(last.start.b) + std::abs(last.start.c) + std::abs(last.start.d)) *
          (1 + reach);
      CHECK(std::abs(offset - at.offset) < 1e-4 * size);
      CHECK(std::abs(slope - at.slope) < 1e-4 * size);
      ++followed;
      bent += stages.size() > 1;
      for (const PencilStage& stage : stages) curved += stage.curvature != 0;
      if (last.focus && stages.size() > 1 && std::abs(*last.focus) < 20) {
        // There the neighbours cross, before the ray or behind it.
        const double cross_at = reach - offset / slope;
        CHECK(cross_at == Approx(*last.focus).margin(1e-3 * (1 + reach)));
        ++folded;
      }
    }
  }
  CHECK(followed > 200);
  CHECK(bent > 60);
  CHECK(curved > 60);
  CHECK(folded > 30);
}

TEST_CASE("there is no pencil about a ray that has a width, goes to a light, or was drawn at random") {
  Scene scene = shipped_scene("classic");
  const World<double> world(scene);
  const Timeline timeline = record_strip(scene, {Precision::double_});
  int shadows = 0;
  for (int ray = 0; ray < static_cast<int>(timeline.rays().size()); ++ray) {
    if (timeline.rays()[static_cast<std::size_t>(ray)].kind != RayKind::shadow) continue;
    CHECK(pencil_of(world, timeline, ray).empty());
    ++shadows;
  }
  CHECK(shadows > 10);
  scene.render.integrator = Integrator::cones;
  const Timeline cones = record_strip(scene, {Precision::double_});
  for (int ray = 0; ray < static_cast<int>(cones.rays().size()); ++ray) CHECK(pencil_of(world, cones, ray).empty());
  CHECK(true_neighbour(world, {}, 0, 1).empty());
}
