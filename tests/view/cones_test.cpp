// Cones in the plan: an area for each, whose parts say how much of it they are, and no sooner than the walk knows.

#include <algorithm>
#include <cmath>
#include <optional>

#include "fixtures.h"
#include "io/scene_file.h"
#include "support/catch.h"
#include "view/legend/legend.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"
#include "view/walk/code_panel.h"
#include "view/walk/equation.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State cone_state() {
  const auto read = read_scene(RAYWALK_SOURCE_DIR "/scenes/cones.toml");
  REQUIRE(read);
  State state = state_of(read->scene);
  update(state, action::SetMode{Mode::trace});
  REQUIRE(state.walk.timeline->of_cones());
  return state;
}

// The areas of rays of the pixel at work.
std::size_t areas_in(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  std::size_t count = 0;
  for (const DisplayItem& item : plan_view(state))
    count += item.target.kind == TargetKind::ray && std::holds_alternative<PolygonItem>(item.shape) &&
             timeline.rays()[static_cast<std::size_t>(item.target.index)].pixel ==
                 timeline.current_pixel(state.walk.position);
  return count;
}

}  // namespace

TEST_CASE("a cone is an area, and each part of it says its share once it is at work") {
  State state = cone_state();
  const Timeline& timeline = *state.walk.timeline;
  int told = 0;
  for (int at = position_after<PartBegun>(timeline); at > 0; at = position_after<PartBegun>(timeline, at)) {
    const auto& begun = std::get<PartBegun>(timeline.event(at - 1).detail);
    const std::string share = number_text(begun.coverage, state.appearance.language) + " of the cone";
    update(state, action::Jump{at});
    CAPTURE(at, share);
    CHECK(is_finite(plan_view(state)));
    CHECK(areas_in(state) > 0);
    CHECK(has_text(plan_view(state), share));
    ++told;
  }
  CHECK(told > 20);
}

TEST_CASE("what is said of the flat world stands off the cone at work, and stays where it is") {
  State state = cone_state();
  const std::string said(text("plan.flat_cones", state.appearance.language));
  const Timeline& timeline = *state.walk.timeline;
  int seen = 0;
  std::optional<Vec2d> stays;
  for (int at = position_after<BeamCut>(timeline); at > 0; at = position_after<BeamCut>(timeline, at)) {
    update(state, action::Jump{at});
    const int cone = timeline.current_ray(at);
    if (timeline.rays()[static_cast<std::size_t>(cone)].parent >= 0) continue;
    const DisplayList list = plan_view(state);
    const auto note = std::find_if(list.begin(), list.end(), [&](const DisplayItem& item) {
      const auto* words = std::get_if<TextItem>(&item.shape);
      return words != nullptr && words->text == said;
    });
    REQUIRE(note != list.end());
    const TextItem& words = std::get<TextItem>(note->shape);
    CHECK(words.at == stays.value_or(words.at));
    stays = words.at;
    const Vec2d half(text_width(said, words.size) / 2, words.size / 2);
    const BeamArea& area =
        timeline.beams()[static_cast<std::size_t>(timeline.rays()[static_cast<std::size_t>(cone)].beam)].area;
    for (const std::size_t side : {std::size_t{0}, area.starts.size() - 1}) {
      const Vec2d from = to_pixels(state, plan(area.starts[side])), to = to_pixels(state, plan(area.ends[side]));
      CAPTURE(at, side, words.at.x, words.at.y);
      // Both ends of what is said, above and below, on one side of the line, or beyond its start.
      const Vec2d along = to - from;
      int left = 0, before = 0;
      for (const double x : {-half.x, half.x})
        for (const double y : {-half.y, half.y}) {
          left += cross(along, words.at + Vec2d(x, y) - from) > 0;
          before += dot(along, words.at + Vec2d(x, y) - from) < 0;
        }
      CHECK((left == 0 || left == 4 || before == 4));
    }
    ++seen;
  }
  CHECK(seen == state.scene().camera.screen.cells);
}

TEST_CASE("the legend, the code and the plan speak of cones where they are walked") {
  State state = cone_state();
  CHECK(legend(state).rays.front().short_name == text("ray.short_cone", state.appearance.language));
  CHECK(has_text(plan_view(state), text("plan.flat_cones", state.appearance.language)));
  update(state, action::Jump{state.walk.timeline->steps()});
  REQUIRE(areas_in(state) > 0);
  update(state, action::ShowRays{RayKind::beam, false});
  CHECK(areas_in(state) == 0);
  const CodePanel panel = code_panel(state);
  CHECK(panel.boxes[0].procedure == Procedure::cone_tracing);
  CHECK(panel.boxes[1].procedure == Procedure::shade_cone);
}
