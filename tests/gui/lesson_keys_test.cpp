// What digits do while a lesson asks.
#include <algorithm>
#include <string>

#include "gui/bench.h"
#include "support/catch.h"
#include "view/lesson/lesson_panel.h"

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

TEST_CASE("a lesson of the list is chosen by arrows and opened by Enter, and Escape hides the list and the lesson") {
  Bench bench(classic_with_lessons());
  bench.frames(2);
  bench.key("F2");
  const auto marked = [&] {
    const std::vector<LessonRow> rows = lesson_panel(bench.state).rows;
    const auto row = std::find_if(rows.begin(), rows.end(), [](const LessonRow& each) { return each.next; });
    return row == rows.end() ? std::string() : row->name;
  };
  const std::vector<LessonEntry>& list = bench.state.lessons.list;
  CHECK(marked() == list[0].name);
  bench.key("Up");
  CHECK(marked() == list[0].name);
  for (const char* key : {"Down", "Down"}) bench.key(key);
  CHECK(marked() == list[2].name);
  bench.key("Enter");
  CHECK(bench.state.lessons.at() == nullptr);  // it is locked, which is said
  CHECK(bench.state.document.notice);
  bench.key("Escape");
  CHECK_FALSE(bench.state.document.notice);
  for (int i = 0; i < 30; ++i) bench.key("Down");
  CHECK(marked() == list.back().name);
  bench.key("Escape");
  CHECK_FALSE(bench.state.lessons.shown);
  bench.key("F2");
  CHECK(marked() == list[0].name);
  bench.key("Enter");
  REQUIRE(bench.state.lessons.at() != nullptr);
  const int step = bench.state.lessons.step;
  bench.key("Escape");
  CHECK_FALSE(bench.state.lessons.shown);
  bench.key("F2");
  REQUIRE(bench.state.lessons.at() != nullptr);
  CHECK(bench.state.lessons.step == step);
}
