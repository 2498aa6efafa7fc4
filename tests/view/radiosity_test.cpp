// Radiosity in the plan: patches in their light, bars of unshot light, the strings of a form factor.

#include <algorithm>
#include <cmath>

#include "fixtures.h"
#include "support/catch.h"
#include "trace/patches.h"
#include "view/legend/legend.h"
#include "view/plan/plan_geometry.h"
#include "view/text/text.h"
#include "view/walk/code_panel.h"
#include "view/walk/walk.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

State room() {
  Scene scene = classic_state().scene();
  scene.background = Rgbd(0.0);
  scene.render.integrator = Integrator::radiosity;
  scene.render.radiosity.patch = 1;
  State state = state_of(scene);
  update(state, action::SetMode{Mode::trace});
  return state;
}

/// Lines with exactly these ends, in either direction.
int lines_between(const State& state, const Vec2d& a, const Vec2d& b) {
  const auto at = [&](const Vec2d& p) { return to_pixels(state.plan.camera, state.plan.viewport, p); };
  int lines = 0;
  for (const DisplayItem& item : plan_view(state)) {
    const auto* line = std::get_if<LineItem>(&item.shape);
    if (line == nullptr) continue;
    const auto same = [&](const Vec2d& p, const Vec2d& q) {
      return length(line->from - at(p)) < 1e-6 && length(line->to - at(q)) < 1e-6;
    };
    lines += same(a, b) || same(b, a);
  }
  return lines;
}

}  // namespace

TEST_CASE("the strings of a form factor are drawn from end to end, and stay while light is added") {
  State state = room();
  const Timeline& timeline = *state.walk.timeline;
  REQUIRE(timeline.of_radiosity());
  const int at = position_after<FormFactorFound>(timeline);
  REQUIRE(at > 0);
  const auto& found = std::get<FormFactorFound>(timeline.event(at - 1).detail);
  // Their lengths are those that the line computed.
  CHECK(length(found.from_a - found.to_a) + length(found.from_b - found.to_b) == Approx(found.crossed));
  CHECK(length(found.from_a - found.to_b) + length(found.from_b - found.to_a) == Approx(found.uncrossed));
  CHECK((found.crossed - found.uncrossed) / (2 * found.length) == Approx(found.factor));
  for (const int position : {at, at + 1}) {
    update(state, action::Jump{position});
    CHECK(lines_between(state, found.from_a, found.to_a) == 1);
    CHECK(lines_between(state, found.from_b, found.to_b) == 1);
    CHECK(lines_between(state, found.from_a, found.to_b) == 1);
    CHECK(lines_between(state, found.from_b, found.to_a) == 1);
  }
  update(state, action::Jump{at - 1});
  CHECK(lines_between(state, found.from_a, found.to_a) == 0);
}

TEST_CASE("the plan says that the world is flat, and how much light is unshot") {
  State state = room();
  const Timeline& timeline = *state.walk.timeline;
  for (const int position : {2, timeline.end_of_shot(0), timeline.end_of_shot(timeline.end_of_shot(0))}) {
    update(state, action::Jump{position});
    const std::string said = fill("plan.flat_patches", state.appearance.language,
                                  {{"share", percent_text(timeline.unshot_at(position), state.appearance.language)}});
    int notes = 0;
    for (const DisplayItem& item : plan_view(state)) {
      const auto* text_item = std::get_if<TextItem>(&item.shape);
      notes += text_item != nullptr && text_item->text == said;
    }
    CHECK(notes == 1);
    CHECK(is_finite(plan_view(state)));
  }
}

TEST_CASE("bars of unshot light shrink: they are measured by the first light") {
  State state = room();
  const Timeline& timeline = *state.walk.timeline;
  const auto longest_bar = [&](int position) {
    update(state, action::Jump{position});
    double longest = 0;
    for (const DisplayItem& item : plan_view(state)) {
      const auto* line = std::get_if<LineItem>(&item.shape);
      if (line != nullptr && line->stroke.colour == palette(state.appearance.theme).light)
        longest = std::max(longest, length(line->to - line->from));
    }
    return longest;
  };
  int last = 2;
  for (int at = timeline.end_of_shot(0); at > 0; at = timeline.end_of_shot(at)) last = at;
  CHECK(longest_bar(2) > 20);
  CHECK(longest_bar(last) < 0.5 * longest_bar(2));
}

TEST_CASE("both procedures are shown, and every row has its text") {
  State state = room();
  update(state, action::Jump{position_after<FormFactorFound>(*state.walk.timeline)});
  const CodePanel panel = code_panel(state);
  CHECK(panel.boxes[0].procedure == Procedure::radiosity);
  CHECK(panel.boxes[1].procedure == Procedure::shoot_light);
  CHECK(panel.boxes[0].rows.size() + panel.boxes[1].rows.size() == radiosity_pseudocode.size());
  CHECK(std::any_of(panel.boxes[1].rows.begin(), panel.boxes[1].rows.end(),
                    [](const CodeRow& row) { return row.just_run; }));
}

TEST_CASE("a ring marks the patch that shoots, and a dashed one the patch that the line speaks of") {
  State state = room();
  const Timeline& timeline = *state.walk.timeline;
  const auto rings = [&](int patch, bool dashed) {
    const Edge edge = (*timeline.patches())[patch].edge();
    const Vec2d middle = to_pixels(state.plan.camera, state.plan.viewport, 0.5 * (edge.a + edge.b));
    const DisplayList list = plan_view(state);
    return std::count_if(list.begin(), list.end(), [&](const DisplayItem& item) {
      const auto* circle = std::get_if<CircleItem>(&item.shape);
      return circle != nullptr && circle->stroke && (circle->stroke->dash.count > 0) == dashed &&
             length(circle->centre - middle) < 8;
    });
  };
  const int in_front = position_after<PatchInFront>(timeline);
  const int shooter = std::get<PatchTaken>(timeline.event(position_after<PatchTaken>(timeline) - 1).detail).patch;
  const int receiver = std::get<PatchInFront>(timeline.event(in_front - 1).detail).patch;
  // As long as the lines speak of this pair.
  for (int at = in_front; at < in_front + 3; ++at) {
    update(state, action::Jump{at});
    CHECK(rings(shooter, false) == 1);
    CHECK(rings(receiver, true) == 1);
  }
  update(state, action::Jump{in_front - 1});
  CHECK(rings(receiver, true) == 0);
  CHECK_THAT(legend(state).signs.back().meaning, contains("dashed ring"));
}
