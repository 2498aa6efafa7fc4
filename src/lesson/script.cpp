#include "lesson/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

int spoken_words(std::string_view text) {
  int count = 0, depth = 0;
  bool between = true;
  for (const char c : text) {
    if (c == '}') --depth;
    const bool space = depth == 0 && (c == ' ' || c == '\n');
    if (between && !space) ++count;
    between = space;
    if (c == '{') ++depth;
  }
  return count;
}

}  // namespace

ScriptParts parts_of_script(const std::string& script) {
  const std::size_t end = std::min(script.find("\n\n"), script.size());
  return {script.substr(0, end), script.substr(std::min(end + 2, script.size()))};
}

double minutes_of(const LessonStep& step, const StepWords& words) {
  constexpr double words_a_minute = 130, minutes_a_question = 40.0 / 60;
  return (spoken_words(words.presenter.text) + spoken_words(words.reveal.text)) / words_a_minute +
         (step.question ? minutes_a_question : 0);
}

ScriptTime script_time(const Lesson& lesson, const LessonWords& words, std::size_t index) {
  ScriptTime time;
  for (std::size_t i = 0; i <= index && i < lesson.steps.size(); ++i) {
    const StepWords* said = words.find(lesson.steps[i].id);
    time.begin = time.end;
    if (said != nullptr && !lesson.steps[i].extra) time.end += minutes_of(lesson.steps[i], *said);
  }
  return time;
}

std::string minutes_text(double minutes) {
  const int seconds = static_cast<int>(std::lround(minutes * 12)) * 5;
  return fmt::format("{}:{:02}", seconds / 60, seconds % 60);
}

}  // namespace raywalk
