// Numbers that lessons ask for, typed on the bench.
#include <cmath>
#include <string>

#include "gui/bench.h"
#include "gui/classic_walk.h"
#include "support/catch.h"
#include "support/languages.h"
#include "view/lesson/lesson_panel.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// By Escape, which also takes back what was typed since the field has had the keyboard.
void leave_field(Bench& bench) {
  for (const bool down : {true, false}) {
    bench.hold(ImGuiKey_Escape, down);
    bench.frames(3);
  }
  REQUIRE_FALSE(ImGui::GetIO().WantTextInput);
}

/// Opens a lesson where it asks for a number, with all unlocked.
void ask_for_a_number(Bench& bench) {
  bench.resize(1280, 720);
  update(bench.state, action::ShowLessons{true});
  update(bench.state, action::SetLessonOptions{false, true});
  update(bench.state, action::OpenLesson{"18-rays-with-width"});
  update(bench.state, action::GoToLessonStep{1});
  bench.frames(2);
}

}  // namespace

TEST_CASE("a number that nobody typed has no field once the answer is shown") {
  Bench bench(classic_with_lessons());
  ask_for_a_number(bench);
  REQUIRE(bench.has("lesson-number"));
  update(bench.state, action::RevealLesson{});
  bench.frames(2);
  CHECK_FALSE(bench.has("lesson-number"));
  // A typed one stays beside the answer.
  update(bench.state, action::GoToLessonStep{1});
  update(bench.state, action::GuessNumber{0.5});
  update(bench.state, action::RevealLesson{});
  bench.frames(2);
  CHECK(bench.has("lesson-number"));
}

TEST_CASE("a prediction that is no number is said to be none, and shows no answer, also where all is unlocked") {
  const auto is_revealed_by = [](const std::string& typed) {
    Bench bench(classic_with_lessons());
    ask_for_a_number(bench);
    bench.type(typed);
    bench.enter();
    bench.frames(2);
    // It can be mended at once.
    CHECK(ImGui::GetIO().WantTextInput != bench.state.lessons.revealed);
    return bench.state.lessons.revealed;
  };
  for (const char* const unread : {"37 $", "1.2.3", "2e"}) {
    CAPTURE(unread);
    CHECK_FALSE(is_revealed_by(unread));
  }
  CHECK(is_revealed_by("0.5"));
}

TEST_CASE("Enter shows no answer where no number was typed, and says so; Reveal does, and presenters go on") {
  Bench bench(classic_with_lessons());
  ask_for_a_number(bench);
  REQUIRE(bench.interface().types_number());
  SECTION("in the field") { bench.enter(); }
  SECTION("beside it") {
    leave_field(bench);
    bench.key("Enter");
  }
  CHECK_FALSE(bench.state.lessons.revealed);
  CHECK(bench.has("lesson-nothing-typed"));
  CHECK(bench.interface().types_number());
  bench.type("0");
  CHECK_FALSE(bench.has("lesson-nothing-typed"));
  CHECK(bench.state.lessons.guess.number == 0);
  leave_field(bench);
  REQUIRE_FALSE(bench.state.lessons.guess.number);
  bench.click("lesson-reveal");
  CHECK(bench.state.lessons.revealed);
  update(bench.state, action::SetLessonOptions{true, false});
  update(bench.state, action::GoToLessonStep{1});
  bench.frames(3);
  REQUIRE_FALSE(bench.state.lessons.revealed);
  leave_field(bench);
  bench.key("Enter");
  CHECK(bench.state.lessons.revealed);
}

TEST_CASE("digits that are typed beside a lesson's field for a number go into it") {
  Bench bench(classic_with_lessons());
  ask_for_a_number(bench);
  const auto stroke = [&](const std::string& digit) {  // the key, and what it types
    ImGui::GetIO().AddInputCharactersUTF8(digit.c_str());
    bench.key(digit);
  };
  leave_field(bench);
  for (const std::string digit : {"3", "7", "5"}) stroke(digit);
  CHECK(bench.interface().types_number());
  CHECK(bench.state.lessons.guess.number == 375);
  // Behind what stands there.
  bench.click("lesson-about");
  REQUIRE_FALSE(ImGui::GetIO().WantTextInput);
  stroke("1");
  CHECK(bench.state.lessons.guess.number == 3751);
  // Those that come while the field is given the keyboard.
  leave_field(bench);
  update(bench.state, action::GuessNumber{std::nan("")});
  bench.frames(2);
  bench.settle = 1;
  stroke("4");
  ImGui::GetIO().AddInputCharactersUTF8("2");
  bench.frames(3);
  CHECK(bench.state.lessons.guess.number == 42);
  bench.settle = 3;
  bench.enter();
  CHECK(bench.state.lessons.revealed);
  CHECK(bench.state.lessons.first_tries[bench.state.lessons.last].judged() == 1);
}

TEST_CASE("a lesson's field holds what was guessed, and nothing once that is forgotten") {
  Bench bench(classic_with_lessons());
  bench.resize(1280, 720);
  update(bench.state, action::ShowLessons{true});
  update(bench.state, action::SetLessonOptions{false, true});
  update(bench.state, action::OpenLesson{"18-rays-with-width"});
  update(bench.state, action::GoToLessonStep{1});
  bench.frames(2);
  bench.type("0.5");
  CHECK(bench.state.lessons.guess.number == 0.5);
  // Elsewhere and back to the question.
  update(bench.state, action::ShowLessons{false});
  bench.frames(2);
  update(bench.state, action::ShowLessons{true});
  update(bench.state, action::GoToLessonStep{1});
  REQUIRE_FALSE(bench.state.lessons.guess.number);
  bench.frames(2);
  bench.click("lesson-number");
  bench.type("0.25");
  CHECK(bench.state.lessons.guess.number == 0.25);
}
