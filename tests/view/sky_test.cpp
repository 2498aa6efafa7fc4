// The sky in the plan: a ring whose colours are those of the sky, the curve of the pdf, the place that a ray met.

#include <algorithm>
#include <cmath>

#include "fixtures.h"
#include "support/catch.h"
#include "trace/sky_light.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"
#include "view/tree/tree_panel.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

Scene under_sky(Integrator integrator) {
  Scene scene = classic_state().scene();
  // Upright in the plan, so that its directions differ.
  scene.sky = Sky{GradientSky{{0.1, 0.2, 0.3}, {0.9, 0.6, 0.2}}, {0, 1, 0}, 0};
  scene.render.integrator = integrator;
  return scene;
}

/// The middle of the pane, from where the ring is seen.
Vec2d middle_of(const State& state) { return {state.plan.viewport.width / 2, state.plan.viewport.height / 2}; }

/// Pieces of the ring, by the direction of the plan that they stand for.
std::vector<std::pair<Vec2d, Colour>> pieces_of(const State& state) {
  const Vec2d middle = middle_of(state);
  std::vector<std::pair<Vec2d, Colour>> pieces;
  for (const DisplayItem& item : plan_view(state)) {
    const auto* piece = std::get_if<PolygonItem>(&item.shape);
    if (piece == nullptr || item.target || piece->points.size() != 4 || !piece->fill || piece->stroke) continue;
    if (piece->fill->a < 255) continue;  // the ground of words
    const Vec2d at = (piece->points[0] + piece->points[1]) / 2.0 - middle;
    if (length(at) > 0.4 * std::min(state.plan.viewport.width, state.plan.viewport.height))
      pieces.emplace_back(Vec2d(at.x, -at.y), *piece->fill);
  }
  return pieces;
}

Vec2d unit(const Vec2d& v) { return v / length(v); }

bool says(const State& state, std::string_view id) {
  return has_text(plan_view(state), text(id, state.appearance.language));
}

}  // namespace

TEST_CASE("the ring has the sky's colour in every direction of the plan") {
  for (const Mode mode : {Mode::trace, Mode::move}) {
    State state = state_of(under_sky(Integrator::whitted));
    update(state, action::SetMode{mode});
    const SkyLight light(*state.scene().sky, state.scene().background);
    const auto pieces = pieces_of(state);
    CHECK(pieces.size() >= 100);
    int bright = 0;
    for (const auto& [direction, colour] : pieces) {
      const Colour expected = display_colour(light.radiance(Vec3d(direction, 0)), state.scene().encoding);
      CHECK(std::abs(colour.r - expected.r) + std::abs(colour.g - expected.g) + std::abs(colour.b - expected.b) <= 6);
      bright += direction.y > 0;
    }
    CHECK(bright * 2 > static_cast<int>(pieces.size()) - 4);
    CHECK(is_finite(plan_view(state)));
  }
  CHECK(pieces_of(classic_state()).empty());
}

TEST_CASE("paths are told how often they aim there; who samples no sky is not") {
  CHECK(says(state_of(under_sky(Integrator::path)), "plan.sky"));
  CHECK(says(state_of(under_sky(Integrator::path)), "plan.sky_curve"));
  CHECK(says(state_of(under_sky(Integrator::whitted)), "plan.sky"));
  CHECK_FALSE(says(state_of(under_sky(Integrator::whitted)), "plan.sky_curve"));
  CHECK_FALSE(says(classic_state(), "plan.sky"));
}

TEST_CASE("where the current ray meets the sky, the ring is marked, and the sentence says where and what") {
  State state = state_of(under_sky(Integrator::whitted));
  const Timeline& timeline = *state.walk.timeline;
  int met = 0;
  for (int i = 0; i < timeline.steps() && met < 5; ++i) {
    const auto* found = std::get_if<Found>(&timeline.event(i).detail);
    if (found == nullptr || !std::holds_alternative<SkyNumbers>(found->numbers)) continue;
    ++met;
    update(state, action::Jump{i + 1});
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(timeline.current_ray(i + 1))];
    const Vec2d flat = unit(Vec2d(ray.direction.x, ray.direction.y));
    const Vec2d middle = middle_of(state);
    int marks = 0;
    for (const DisplayItem& item : plan_view(state)) {
      const auto* frame = std::get_if<PolygonItem>(&item.shape);
      if (frame == nullptr || frame->fill || item.target || frame->points.size() != 4) continue;
      Vec2d at(0.0);
      for (const Vec2d& corner : frame->points) at += 0.25 * Vec2d(corner.x - middle.x, middle.y - corner.y);
      const bool on_ring = std::abs(at.x) > 0.8 * middle.x || std::abs(at.y) > 0.8 * middle.y;
      marks += on_ring && dot(unit(at), flat) > 1 - 1e-4;
    }
    CHECK(marks == 1);
    CHECK(says(state, "plan.sky_met"));
    const Message said = describe(state.scene(), timeline, i + 1);
    CHECK((said.id == "walk.found_sky" || said.id == "walk.found_sky_below"));
  }
  CHECK(met == 5);
}

TEST_CASE("the sky is changed and the change undone, with the background") {
  State state = classic_state();
  const Scene before = state.scene();
  update(state, action::SetSurroundings{before.background, before.ambient, Sky{OvercastSky{}}});
  REQUIRE(state.scene().sky.has_value());
  CHECK(state.sky.light != nullptr);
  CHECK(says(state, "plan.sky"));
  update(state, action::Undo{});
  CHECK(state.scene() == before);
  CHECK(state.sky.light == nullptr);
}

TEST_CASE("the words about the sky stand inside of its ring, whatever rays there are") {
  State state = state_of(under_sky(Integrator::path));
  state.plan.viewport = {1360, 880};
  update(state, action::FitView{});
  for (const Mode mode : {Mode::move, Mode::trace}) {
    update(state, action::SetMode{mode});
    for (int position = 0; position < state.walk.timeline->steps(); position += 37) {
      INFO("step " << position);
      update(state, action::Jump{position});
      const DisplayList list = plan_view(state);
      const auto words = std::find_if(list.begin(), list.end(), [&](const DisplayItem& item) {
        const auto* said = std::get_if<TextItem>(&item.shape);
        return said != nullptr && said->text == text("plan.sky_curve", state.appearance.language);
      });
      REQUIRE(words != list.end());
      const auto& said = std::get<TextItem>(words->shape);
      const double half = text_width(said.text, said.size) / 2;
      // The ring's equation, four pixels inside of the pane; it is nine pixels wide.
      const Vec2d middle = middle_of(state);
      for (const double side : {-1.0, 1.0}) {
        const double x = (said.at.x + side * half - middle.x) / (middle.x - 13);
        const double y = (said.at.y - middle.y) / (middle.y - 13);
        CHECK(x * x * x * x + y * y * y * y < 1);
      }
    }
  }
}

TEST_CASE("a shadow ray to the sky is labelled in the ray tree") {
  State state = state_of(under_sky(Integrator::path));
  int labelled = 0;
  for (int position = 1; position <= state.walk.timeline->steps() && labelled == 0; ++position) {
    update(state, action::Jump{position});
    for (const TreeNode& node : tree_panel(state).nodes)
      labelled += node.kind == RayKind::shadow && node.ending == Ending::reached_light && node.label == "sky";
  }
  CHECK(labelled > 0);
}
