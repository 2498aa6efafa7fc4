// Focus: the zoom to the ray in question, and back.
#include "lesson_state.h"
#include "support/catch.h"
#include "view/document/properties.h"
#include "view/text/text.h"
#include "view/walk/status.h"

#include <algorithm>

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// The first step of a shipped lesson that wants its ray large, opened.
State at_zooming_step() {
  State state = state_with_lessons();
  for (const LessonEntry& entry : std::vector<LessonEntry>(state.lessons.list)) {
    update(state, action::OpenLesson{entry.name});
    for (int step = 0; step < entry.steps && state.lessons.at() != nullptr; ++step) {
      update(state, action::GoToLessonStep{step});
      if (state.lessons.step == step && state.lessons.at()->step->zoom) return state;
    }
  }
  FAIL("no lesson has a step with zoom");
  return state;
}

}  // namespace

TEST_CASE("in Focus a step that says so shows its ray large, and the plan is as before when Focus ends") {
  State state = at_zooming_step();
  const PlanCamera before = state.plan.camera;
  CHECK_FALSE(state.focus.zoomed);
  update(state, action::SetFocus{true});
  REQUIRE(state.focus.zoomed);
  CHECK(state.plan.camera.pixels_per_unit > 1.2 * before.pixels_per_unit);
  const std::optional<Vec2d> origin = guess_origin(state);
  REQUIRE(origin);
  const Vec2d middle(state.plan.viewport.width / 2, state.plan.viewport.height / 2);
  CHECK(length(to_pixels(state, *origin) - middle) < 1e-6);
  // It can be zoomed by hand from there.
  update(state, action::Zoom{{10, 10}, 1.1});
  const PlanCamera by_hand = state.plan.camera;
  update(state, action::Tick{0.1});
  CHECK(state.plan.camera == by_hand);
  // Another pane: zoomed for that.
  update(state, action::ResizePlan{{900, 500}});
  CHECK(state.plan.camera != by_hand);
  update(state, action::SetFocus{false});
  CHECK_FALSE(state.focus.zoomed);
  CHECK(state.plan.camera == fitted(state));
}

TEST_CASE("a plan moved by hand is there again after the zoom of a step") {
  State state = at_zooming_step();
  update(state, action::Pan{{31, 17}});
  const PlanCamera own = state.plan.camera;
  update(state, action::SetFocus{true});
  REQUIRE(state.plan.camera != own);
  update(state, action::Step{false, Grain::line});
  CHECK(state.plan.camera == own);
  update(state, action::Step{true, Grain::line});
  update(state, action::SetFocus{false});
  CHECK(state.plan.camera == own);
}

TEST_CASE("Focus, which folds the fields of what is selected, tells their values") {
  State state = classic_state();
  update(state, action::SetMode{Mode::move});
  update(state, action::Select{{TargetKind::object, 0}});
  const std::string without = sentence(state);
  update(state, action::SetFocus{true});
  const auto& sphere = std::get<Sphere<double>>(state.scene().objects[0].shape);
  CHECK(sentence(state) != without);
  CHECK(sentence(state).starts_with(properties_title(state) + ": "));
  CHECK(sentence(state).find(number_text(sphere.radius, state.appearance.language)) != std::string::npos);
  // A handle: what it changes.
  update(state, action::Select{{TargetKind::corner, 2, 1}});
  const auto texts = property_texts(state, state.plan.selected);
  const auto corner =
      std::find_if(texts.begin(), texts.end(), [](const auto& each) { return each.key == "corners.2"; });
  REQUIRE(corner != texts.end());
  CHECK(sentence(state) == properties_title(state) + ": " + corner->label + " " + corner->value);
}

TEST_CASE("in Focus a panel's key shows it in the plan's place and again the plan, unless it speaks in the plan") {
  State state = classic_state();
  update(state, action::SetTab{PictureRoom::tab});
  CHECK_FALSE(state.focus.shows_tab());
  update(state, action::SetFocus{true});
  CHECK_FALSE(state.focus.shows_tab());
  update(state, action::SetTab{PictureRoom::tab});
  CHECK(state.focus.shows_tab());
  update(state, action::SetTab{TreeRoom::tab});
  CHECK(state.focus.shows_tab());
  update(state, action::SetTab{TreeRoom::tab});
  CHECK_FALSE(state.focus.shows_tab());
  update(state, action::SetTab{TreeRoom::tab});
  update(state, action::ExchangePanes{});
  CHECK_FALSE(state.focus.shows_tab());
  for (const Tab tab : {EquationRoom::tab, StructureRoom::tab}) {
    update(state, action::SetTab{tab});
    CHECK_FALSE(state.focus.shows_tab());
  }
  update(state, action::SetTab{PictureRoom::tab});
  update(state, action::SetFocus{false});
  update(state, action::SetFocus{true});
  CHECK_FALSE(state.focus.shows_tab());
}

TEST_CASE("the list of lessons, which Focus would fold away, ends it") {
  State state = state_with_lessons();
  update(state, action::ShowLessons{false});
  update(state, action::SetFocus{true});
  update(state, action::ShowLessons{true});
  CHECK_FALSE(state.focus.on);
  update(state, action::OpenLesson{"01-ray-casting"});
  update(state, action::SetFocus{true});
  update(state, action::GoToLessonStep{1});
  CHECK(state.focus.on);
  update(state, action::LeaveLesson{});
  CHECK_FALSE(state.focus.on);
}
