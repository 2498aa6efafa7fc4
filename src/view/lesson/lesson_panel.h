#pragma once
// What the lesson pane shows, as data.

#include "view/state.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

struct LessonRow {
  std::string name, title;
  int done = 0, steps = 0;
  bool locked = false;
  bool next = false;  ///< to go on with, or chosen by keys
};
struct LessonChoice {
  std::string text;
  bool guessed = false;
  bool right = false;  ///< known only once the answer is shown
  int hands = 0;       ///< of a class
};
/// The control that asks.
enum class Asks { nothing, choice, number, arrow, line };

struct LessonPanel {
  std::vector<LessonRow> rows;  ///< the list, if no lesson is open
  std::string lesson, heading;
  std::string told_in;      ///< a note that it is in English, if it has no words in the language of the interface
  int step = 0, steps = 0;  ///< from 1
  std::string summary;      ///< of the lesson: at its first step
  std::string text;         ///< paragraphs between empty lines; items of lists begin with "- "
  Asks asks = Asks::nothing;
  std::string question;
  std::vector<LessonChoice> choices;
  std::string unit;
  std::string marked;   ///< of a line: which one, or how to mark it
  std::string verdict;  ///< after the answer: whether right, and the error
  bool is_right = false;
  std::string reveal, change;      ///< after the answer, or if nothing was asked
  std::string presenter, teacher;  ///< if shown; before the answer only what leads to it
  std::string time;                ///< of a presentation, at the end of this step; empty for students
  std::string notes, sources;      ///< of the whole lesson: for presenters, at its end
  std::string hands;               ///< a class's choices; empty without a show of hands
  std::string unanswered;          ///< after the answer: that nothing was predicted
  std::string score;               ///< of this session; empty before the first prediction
  bool astray = false;             ///< a question waits at another position, or in another scene
  bool can_reveal = false, can_go_on = false, can_go_back = false, is_last = false;
};
/// The list: a lesson is available once the previous one is finished.
[[nodiscard]] std::vector<LessonRow> lesson_rows(const LessonRoom& sitting, Language language);
[[nodiscard]] LessonPanel lesson_panel(const State& state);
/// Whether the step of the open lesson has a question, answered or not.
[[nodiscard]] inline bool has_question(const State& state) {
  const PlayedStep* step = state.lessons.shown ? state.lessons.at() : nullptr;
  return step != nullptr && step->step->question.has_value();
}

/// Whether that is about a line of the code, which then is needed, with its answer too.
[[nodiscard]] inline bool asks_about_code(const State& state) {
  return has_question(state) && std::holds_alternative<LineQuestion>(*state.lessons.at()->step->question);
}

/// Whether the 3-D image shows what the open step asks about pictures, and that has yet to be answered.
[[nodiscard]] bool image_tells_answer(const State& state);
/// Whether the mark of the walked pixel in it does: what a pixel shows is what its ray has met.
[[nodiscard]] bool mark_tells_answer(const State& state);

/// What a step leaves beside the plan.
[[nodiscard]] inline LessonBeside left_by(const LessonStep& step) {
  return step.then == LessonBeside::unchanged ? step.pane : step.then;
}
/// What the steps before the open one have left there; `unchanged`: nothing.
[[nodiscard]] LessonBeside left_before(const LessonRoom& sitting);

/// Whether the open step asks for room for the tab that is shown.
[[nodiscard]] bool lesson_enlarges(const State& state);
/// Whether the open tab has the plan's place, and the plan the tab's: a large one, or where the step of a lesson wants
/// it so. What waits for an answer lets the plan be seen first.
[[nodiscard]] bool has_plans_place(const State& state);
/// Whether a person has exchanged them: of what a step enlarges for that step and mode alone, else of the open tab.
[[nodiscard]] bool exchanged_by_hand(const State& state);

/// Whether a guess counts as right, and its error: in degrees for an arrow, else in the question's unit; 0 or 1 for a
/// choice.
struct LessonVerdict {
  bool right = false;
  double error = 0;
};
[[nodiscard]] std::optional<LessonVerdict> judge(const LessonRoom& sitting);

}  // namespace raywalk
