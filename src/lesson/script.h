#pragma once
// A presenter's script: its two parts, and the time that they take.

#include "lesson/lesson.h"

#include <string>

namespace raywalk {

struct ScriptParts {
  std::string before;  ///< what leads to the answer
  std::string after;   ///< after the first empty line: what is said about it; may be empty
};
[[nodiscard]] ScriptParts parts_of_script(const std::string& script);

/// The allowed duration of a presentation, in minutes, without extra steps: about five.
inline constexpr double fewest_minutes = 2, max_minutes = 5.5;

/// Minutes that a step takes with a class: the script and the answer at 130 words per minute, and 40 seconds for each
/// question: to read it, for hands or an arrow, and to look at the answer. A formula counts as one word.
[[nodiscard]] double minutes_of(const LessonStep& step, const StepWords& words);

/// When a step begins and ends in a presentation, in minutes. Extra steps take no time.
struct ScriptTime {
  double begin = 0, end = 0;
};
[[nodiscard]] ScriptTime script_time(const Lesson& lesson, const LessonWords& words, std::size_t index);

/// Minutes as a clock shows them, to five seconds: "1:05".
[[nodiscard]] std::string minutes_text(double minutes);

}  // namespace raywalk
