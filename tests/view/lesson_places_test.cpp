// Which pane has the plan's place in a lesson.
#include "lesson_state.h"
#include "support/catch.h"
#include "view/action.h"

using namespace raywalk;

namespace {

State at_step(const std::string& lesson, std::string_view id) {
  State state = test::state_with_lessons();
  update(state, action::OpenLesson{lesson});
  REQUIRE(state.lessons.at() != nullptr);
  for (int step = 0; state.lessons.at()->step->id != id; ++step) {
    update(state, action::GoToLessonStep{step});
    REQUIRE(state.lessons.step == step);
  }
  return state;
}

}  // namespace

TEST_CASE("a question under the microscope lets the plan be seen, and the answer the microscope") {
  for (const std::string_view id : {"touch", "near-miss", "far"}) {
    INFO(id);
    State state = at_step("09-numbers-lie", id);
    CHECK(state.appearance.tab == MicroscopeRoom::tab);
    CHECK_FALSE(has_plans_place(state));
    update(state, action::RevealLesson{});
    CHECK(state.appearance.tab == MicroscopeRoom::tab);
    CHECK(has_plans_place(state));
  }
}

TEST_CASE("a picture that a lesson is about has the plan's place, until another tab is opened") {
  State state = at_step("11-noise", "four-times");
  CHECK(state.appearance.tab == PictureRoom::tab);
  CHECK(has_plans_place(state));
  update(state, action::SetTab{TreeRoom::tab});
  CHECK_FALSE(has_plans_place(state));
  update(state, action::SetTab{PictureRoom::tab});
  CHECK(has_plans_place(state));
  update(state, action::LeaveLesson{});
  CHECK_FALSE(has_plans_place(state));
}

TEST_CASE("a picture that would tell the answer is shown with the answer") {
  State state = at_step("13-whitted-to-path-tracing", "ceiling");
  CHECK(state.appearance.tab == TreeRoom::tab);
  CHECK_FALSE(has_plans_place(state));
  update(state, action::RevealLesson{});
  CHECK(state.appearance.tab == PictureRoom::tab);
  CHECK(has_plans_place(state));
  // The next step hides it again.
  update(state, action::GoToLessonStep{state.lessons.step + 1});
  CHECK(state.appearance.tab == TreeRoom::tab);
}

TEST_CASE("what is asked about a picture is answered with one in sight") {
  State state = test::state_with_lessons();
  int asked = 0;
  for (const LessonEntry& entry : std::vector(state.lessons.list)) {
    update(state, action::OpenLesson{entry.name});
    for (int step = 0; step < entry.steps; ++step) {
      update(state, action::GoToLessonStep{step});
      REQUIRE(state.lessons.step == step);
      const LessonStep& at = *state.lessons.at()->step;
      const auto* question = at.question ? std::get_if<ChoiceQuestion>(&*at.question) : nullptr;
      if (question == nullptr || question->choices.front().text.find("pixel(") == std::string::npos) continue;
      CAPTURE(entry.name, at.id);
      ++asked;
      update(state, action::RevealLesson{});
      CHECK(state.appearance.tab == PictureRoom::tab);
    }
    update(state, action::LeaveLesson{});
  }
  CHECK(asked > 3);
}

TEST_CASE("each step of a lesson shows the whole plan, however the one before was looked at") {
  for (const bool focus : {false, true}) {
    CAPTURE(focus);
    State state = at_step("18-rays-with-width", "mirror");
    const PlanCamera whole = state.plan.camera;
    update(state, action::RevealLesson{});
    update(state, action::SetFocus{focus});
    update(state, action::Zoom{{400, 300}, 0.3});
    REQUIRE(state.plan.camera != whole);
    update(state, action::GoToLessonStep{state.lessons.step + 1});
    CHECK(state.plan.camera == whole);
    // Within a step it stays as it was put.
    update(state, action::Zoom{{400, 300}, 0.3});
    const PlanCamera by_hand = state.plan.camera;
    update(state, action::RevealLesson{});
    CHECK(state.plan.camera == by_hand);
  }
  // Out of the zoom of one step, too, and into that of the next.
  State state = at_step("02-ray-meets-sphere", "from-inside");
  update(state, action::Pan{{50, 20}});
  update(state, action::SetFocus{true});
  update(state, action::GoToLessonStep{0});
  update(state, action::SetFocus{false});
  CHECK(state.plan.camera == fitted(state));
}
