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
