// The presenter's window: what to say and ask, with the answers, before the class sees them.
#include "view/lesson/notes_panel.h"

#include "lesson_state.h"
#include "support/catch.h"
#include "support/effort.h"
#include "support/languages.h"
#include "view/lesson/lesson_panel.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("without a lesson the notes say so") {
  State state = state_with_lessons();
  const NotesPanel panel = notes_panel(state);
  CHECK(panel.parts.empty());
  CHECK_FALSE(panel.heading.empty());
}

TEST_CASE("the notes hold every step's script, answer and next question, in every language") {
  State state = state_with_lessons();
  update(state, action::ShowNotesWindow{true});
  CHECK(state.lessons.presenter);
  CHECK_FALSE(state.lessons.notes);
  std::size_t lesson = 0, steps = 0;
  for (const LessonEntry& entry : std::vector<LessonEntry>(state.lessons.list)) {
    if (left_out(lesson++, 7)) continue;
    update(state, action::OpenLesson{entry.name});
    REQUIRE(state.lessons.open);
    for (int step = 0; step < entry.steps; ++step) {
      update(state, action::GoToLessonStep{step});
      REQUIRE(state.lessons.step == step);
      for (const Language language : all_languages()) {
        update(state, action::SetLanguage{std::string(language.code())});
        CAPTURE(language.code(), entry.name, step);
        const NotesPanel panel = notes_panel(state);
        CHECK_FALSE(panel.heading.empty());
        CHECK_FALSE(panel.time.empty());
        REQUIRE_FALSE(panel.parts.empty());
        bool answered = false, tells_change = false;
        for (const NotesPanel::Part& part : panel.parts) {
          CHECK(part.text.find_first_of("*`") == std::string::npos);
          tells_change = tells_change || part.title == text("lesson.change", language);
          answered = answered || (!part.later && part.text.find("\u2713") != std::string::npos);
        }
        // The answer of a choice is ticked, although the class has not seen it.
        const LessonPanel shown = lesson_panel(state);
        if (shown.asks == Asks::choice || shown.asks == Asks::number || shown.asks == Asks::line) CHECK(answered);
        CHECK(shown.presenter.empty());
        const StepWords* said = state.lessons.open->lesson.told(language).find(state.lessons.at()->step->id);
        REQUIRE(said != nullptr);
        CHECK(tells_change == !said->change.text.empty());
        if (step + 1 < entry.steps) CHECK(panel.parts.back().later);
        ++steps;
      }
    }
  }
  CHECK(steps > (sanitized ? 20U : 100U));
}
