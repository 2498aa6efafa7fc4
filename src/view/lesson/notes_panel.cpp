#include "view/lesson/notes_panel.h"

#include "lesson/script.h"
#include "view/text/text.h"
#include "view/walk/asked.h"

#include <fmt/format.h>

#include <cstddef>
#include <string_view>
#include <utility>

namespace raywalk {

namespace {

std::string without_marks(std::string text) {
  std::erase_if(text, [](char c) { return c == '*' || c == '`'; });
  return text;
}

void add(NotesPanel& panel, const std::string& title, std::string text, bool later = false) {
  if (!text.empty()) panel.parts.push_back({title, without_marks(std::move(text)), later});
}

}  // namespace

NotesPanel notes_panel(const State& state) {
  const LessonRoom& sitting = state.lessons;
  const Language language = state.appearance.language;
  const auto word = [&](std::string_view id) { return std::string(text(id, language)); };
  NotesPanel panel;
  if (sitting.at() == nullptr) {
    panel.heading = word("notes.no_lesson");
    return panel;
  }
  const PlayedLesson& played = sitting.open->played;
  const LessonWords& words = sitting.open->lesson.told(language);
  const Language told_in = sitting.open->lesson.told_in(language);
  const auto index = static_cast<std::size_t>(sitting.step);
  const auto said_in = [&](std::size_t i) { return words.find(played.steps[i].step->id); };
  const auto filled_at = [&](std::size_t i, const Passage& passage, int position) {
    return filled(played, i, position, passage, told_in).value_or(passage.text);
  };
  panel.lesson = fmt::format("{} \u00b7 {}/{}", words.title, index + 1, played.steps.size());
  const Lesson& lesson = sitting.open->lesson;
  panel.time = lesson.steps[index].extra
                   ? word("lesson.extra")
                   : fill("lesson.time", language,
                          {{"end", minutes_text(script_time(lesson, words, index).end)},
                           {"all", minutes_text(script_time(lesson, words, lesson.steps.size() - 1).end)}});
  if (const StepWords* said = said_in(index)) {
    const PlayedStep& step = played.steps[index];
    const ScriptParts script = parts_of_script(filled_at(index, said->presenter, step.shown));
    panel.heading = without_marks(with_quotes(said->heading, told_in));
    add(panel, word("lesson.script_say"), script.before);
    if (step.step->question) add(panel, word("lesson.script_ask"), question_with_answer(played, index, *said, told_in));
    add(panel, word("lesson.reveal"), filled_at(index, said->reveal, step.shown));
    add(panel, word("lesson.script_say"), script.after);
    add(panel, word("lesson.change"), filled_at(index, said->change, step.shown));
    add(panel, word("lesson.teacher"), filled_at(index, said->teacher, step.shown));
  }
  for (std::size_t i = index + 1; i < played.steps.size(); ++i) {
    const StepWords* said = said_in(i);
    if (said == nullptr) continue;
    if (i == index + 1) add(panel, word("notes.next"), with_quotes(said->heading, told_in), true);
    if (!played.steps[i].step->question) continue;
    add(panel, word("notes.next_question"), question_with_answer(played, i, *said, told_in), true);
    break;
  }
  return panel;
}

}  // namespace raywalk
