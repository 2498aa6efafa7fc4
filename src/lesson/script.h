#pragma once
// A presenter's script: its two parts, and the time that they take with a class.

#include "lesson/lesson.h"

#include <string>

namespace raywalk {

struct ScriptParts {
  std::string before;  ///< what leads to the answer
  std::string after;   ///< behind the first empty line: what is said about it; may be empty
};
[[nodiscard]] ScriptParts parts_of_script(const std::string& script);

/// What a presentation may take, in minutes, without the steps that are extra: five, and a breath.
inline constexpr double fewest_minutes = 2, most_minutes = 5.5;

/// Minutes that a step takes with a class: the script and the answer spoken at 130 words a minute, as one speaks to be
/// followed, and 40 seconds for each question: to read it, for hands or an arrow,
/// and for a look at the answer. A formula counts as one word.
[[nodiscard]] double minutes_of(const LessonStep& step, const StepWords& words);

/// When a step begins and ends in a presentation, in minutes. Extra steps take no time of it.
struct ScriptTime {
  double begin = 0, end = 0;
};
[[nodiscard]] ScriptTime script_time(const Lesson& lesson, const LessonWords& words, std::size_t index);

/// Minutes as a clock shows them, to five seconds: "1:05".
[[nodiscard]] std::string minutes_text(double minutes);

}  // namespace raywalk
