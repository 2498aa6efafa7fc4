// What digits do while a lesson asks.
#include <string>

#include "gui/bench.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// A question with two choices.
State at_two_choices(bool presenter) {
  State state = classic_with_lessons();
  update(state, action::ShowLessons{true});
  update(state, action::SetLessonOptions{presenter, true});
  update(state, action::OpenLesson{"05-refraction"});
  update(state, action::GoToLessonStep{2});
  REQUIRE(state.lessons.at() != nullptr);
  REQUIRE(state.lessons.at()->step->id == "passes");
  return state;
}

}  // namespace

TEST_CASE("a digit chooses an answer, and one too many changes nothing") {
  Bench bench(at_two_choices(false));
  bench.frames(2);
  for (const std::string digit : {"3", "9"}) {
    bench.key(digit);
    CHECK(bench.state.walk.grain == Grain::line);
    CHECK_FALSE(bench.state.lessons.guess.choice.has_value());
  }
  bench.key("2");
  CHECK(bench.state.lessons.guess.choice == 1);
  // With the answer digits are those of the walk again.
  bench.key("Enter");
  REQUIRE(bench.state.lessons.revealed);
  bench.key("3");
  CHECK(bench.state.walk.grain == Grain::pixel);
}

TEST_CASE("a class's hands are counted by digits, and one too many counts nowhere") {
  Bench bench(at_two_choices(true));
  bench.frames(2);
  for (const std::string key : {"1", "2", "2", "3", "Shift+2", "Shift+3"}) bench.key(key);
  CHECK(bench.state.lessons.hands == std::vector<int>{1, 1});
  CHECK(bench.state.walk.grain == Grain::line);
}

TEST_CASE("after the answer Enter leads a presenter on, also from Move, where something was changed") {
  Bench bench(at_two_choices(true));
  bench.frames(2);
  bench.key("Enter");
  REQUIRE(bench.state.lessons.revealed);
  const int step = bench.state.lessons.step;
  update(bench.state, action::SetMode{Mode::move});
  update(bench.state, action::Select{{TargetKind::eye}});
  bench.frames(3);
  bench.key("Enter");
  CHECK((bench.state.lessons.at() == nullptr || bench.state.lessons.step == step + 1));
  // A student's Enter is for the fields of what is selected.
  Bench alone(at_two_choices(false));
  alone.frames(2);
  alone.key("2");
  alone.key("Enter");
  update(alone.state, action::SetMode{Mode::move});
  alone.frames(3);
  alone.key("Enter");
  CHECK(alone.state.lessons.step == step);
}
