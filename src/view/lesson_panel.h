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
};
struct LessonChoice {
  std::string text;
  bool guessed = false;
  bool right = false;  ///< known only once the answer stands there
  int hands = 0;       ///< of a class
};
/// Which control asks.
enum class Asks { nothing, choice, number, arrow, line };

struct LessonPanel {
  std::vector<LessonRow> rows;  ///< the list, where no lesson is open
  std::string lesson, heading;
  std::string told_in;      ///< that it is told in English, where it has no words in the language of the interface
  int step = 0, steps = 0;  ///< from 1
  std::string summary;      ///< of the lesson: at its first step
  std::string text;         ///< paragraphs between empty lines; items of lists begin with "- "
  Asks asks = Asks::nothing;
  std::string question;
  std::vector<LessonChoice> choices;
  std::string unit;
  std::string marked;   ///< of a line: which one, or how to mark it
  std::string verdict;  ///< after the answer: right or not, and the error
  bool is_right = false;
  std::string reveal, change;      ///< after the answer, or where nothing was asked
  std::string presenter, teacher;  ///< where they are shown; no more than what leads to the answer before it stands
  std::string time;                ///< of a presentation, at the end of this step; empty for students
  std::string notes, sources;      ///< of the whole lesson: for presenters, at its end
  std::string hands;               ///< how a class chose; empty without a show of hands
  std::string score;               ///< of this sitting; empty before the first prediction
  bool astray = false;             ///< a question waits at another place of the walk, or of another scene
  bool can_reveal = false, can_go_on = false, can_go_back = false, is_last = false;
};
/// The list: a lesson opens when the one before is done.
[[nodiscard]] std::vector<LessonRow> lesson_rows(const LessonSitting& sitting, Language language);
[[nodiscard]] LessonPanel lesson_panel(const State& state);

/// Whether the walk stands where a lesson asks, and the prediction is still to be made. (Where a faulty line is looked
/// for one walks freely.)
[[nodiscard]] bool question_waits(const State& state);

/// Whether the plan takes an arrow from the mouse now, and where it starts.
[[nodiscard]] std::optional<Vec2d> arrow_origin(const State& state);

/// Where the arrow of a guess starts, as long as the step that asked for it is on the screen.
[[nodiscard]] std::optional<Vec2d> guess_origin(const State& state);

/// The angle between two arrows, 0 to 180.
[[nodiscard]] double degrees_between(const Vec2d& a, const Vec2d& b);

/// How many decimals matter of the answer to a question, or of an error about it.
[[nodiscard]] int decimals_of(const NumberQuestion& question, double number);

/// Of a guess, when there is one: whether it counts as right, and by how much it is off: degrees of an arrow, else the
/// question's own unit; 0 or 1 of a choice.
struct LessonVerdict {
  bool right = false;
  double error = 0;
};
[[nodiscard]] std::optional<LessonVerdict> judge(const LessonSitting& sitting);

}  // namespace raywalk
