// The lobe in the plan: where a rough mirror sends light, from the hit that the walk is at.

#include <algorithm>
#include <cmath>
#include <optional>

#include "fixtures.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "view/plan/plan_geometry.h"
#include "view/plan/plan_view.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State metals(Integrator integrator) {
  auto read = read_scene(RAYWALK_SOURCE_DIR "/scenes/metals.toml");
  REQUIRE(read);
  read->scene.render.integrator = integrator;
  read->scene.render.samples = 1;
  State state = state_of(read->scene);
  state.plan.viewport = {900, 620};
  update(state, action::SetMode{Mode::trace});
  return state;
}

// The position after the first hit of an object by a primary ray.
int hit_of(const State& state, const std::string& name) {
  for (const RayRecord& ray : state.walk.timeline->rays())
    if (ray.kind == RayKind::primary && ray.object >= 0 &&
        state.scene().objects[static_cast<std::size_t>(ray.object)].name == name)
      return ray.found_at;
  return -1;
}

// The curve that begins at the current hit.
std::optional<PolygonItem> lobe(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(state.walk.position))];
  const Vec2d hit = to_pixels(state.plan.camera, state.plan.viewport, Vec2d(ray.end.x, ray.end.y));
  for (const DisplayItem& item : plan_view(state))
    if (const auto* polygon = std::get_if<PolygonItem>(&item.shape))
      if (polygon->points.size() > 50 && length(polygon->points[0] - hit) < 1e-6) return *polygon;
  return {};
}

}  // namespace

TEST_CASE("the lobe of a rough mirror points where light is mirrored to, and is wider the rougher") {
  for (const Integrator integrator : {Integrator::path, Integrator::distributed, Integrator::whitted}) {
    State state = metals(integrator);
    double before = 0;
    for (const std::string name : {"Rough Gold", "Rougher Gold"}) {
      CAPTURE(name);
      const int position = hit_of(state, name);
      REQUIRE(position > 0);
      update(state, action::Jump{position});
      const auto curve = lobe(state);
      REQUIRE(curve);
      const Timeline& timeline = *state.walk.timeline;
      const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(position))];
      const Vec3d mirrored = ray.direction - 2 * dot(ray.direction, ray.normal) * ray.normal;
      const Vec2d hit = curve->points[0], along(mirrored.x, -mirrored.y);
      double farthest = 0, half_as_far = 0;
      Vec2d tip = hit;
      for (const Vec2d& at : curve->points)
        if (length(at - hit) > farthest) farthest = length(at - hit), tip = at;
      CHECK(farthest > 30);
      CHECK(farthest < 200);
      // Rough mirrors send most of it a little flatter than a smooth one.
      CHECK(dot(tip - hit, along) / farthest > 0.8);
      for (const Vec2d& at : curve->points) {
        if (length(at - hit) < farthest / 2) continue;
        half_as_far = std::max(
            half_as_far, std::acos(std::clamp(dot(at - hit, tip - hit) / (length(at - hit) * farthest), -1.0, 1.0)));
      }
      CHECK(half_as_far > before);
      before = half_as_far;
    }
    const int smooth = hit_of(state, "Smooth Gold");
    REQUIRE(smooth > 0);
    update(state, action::Jump{smooth});
    CHECK_FALSE(lobe(state));
  }
}

TEST_CASE("there is no lobe where nothing is reflected, nor while the scene is changed") {
  State cast = metals(Integrator::cast);
  update(cast, action::Jump{hit_of(cast, "Rough Gold")});
  CHECK_FALSE(lobe(cast));
  State state = metals(Integrator::path);
  update(state, action::Jump{hit_of(state, "Rough Gold")});
  CHECK(lobe(state));
  update(state, action::SetMode{Mode::move});
  CHECK_FALSE(lobe(state));
}
