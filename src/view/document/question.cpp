#include "view/document/question.h"

#include "view/state.h"
#include "view/text/text.h"

#include <fmt/format.h>

#include <filesystem>

namespace raywalk {

namespace {

std::string said(const State& state, std::string_view id) { return std::string(text(id, state.appearance.language)); }

/// A lesson as in the list: "5 Refraction and total reflection". A path as it is.
std::string lesson_title(const State& state, const std::string& name) {
  const LessonEntry* entry = state.lessons.entry(name);
  if (entry == nullptr) return name;
  return fmt::format("{} {}", entry - state.lessons.list.data() + 1, entry->title(state.appearance.language));
}

/// When an autosave was written, in the language of the window.
std::string written_at(const State& state, const std::string& when) {
  // Earlier versions wrote "2026-11-21 at 14:05".
  constexpr std::size_t date = 10, time = 5;
  if (when.size() < date + time) return when;
  return fill("question.written_at", state.appearance.language,
              {{"date", when.substr(0, date)}, {"time", when.substr(when.size() - time)}});
}

}  // namespace

QuestionPanel question_panel(const State& state) {
  using action::Answer;
  QuestionPanel panel;
  if (!state.document.question) return panel;
  const Question& question = *state.document.question;
  const auto choice = [&](Answer answer, std::string_view label) {
    panel.choices.push_back({answer, said(state, label)});
  };
  const std::string file = state.document.path.empty() ? said(state, "scene.untitled")
                                                       : std::filesystem::path(state.document.path).filename().string();
  switch (question.kind) {
    case Question::Kind::unsaved:
    case Question::Kind::predictions:
      panel.text = fill(question.intent.question, state.appearance.language,
                        {{"file", file}, {"other", lesson_title(state, question.path)}});
      choice(Answer::save, "answer.save");
      choice(Answer::discard, "answer.discard");
      choice(Answer::cancel, "answer.cancel");
      break;
    case Question::Kind::recover: {
      const std::string when = written_at(state, question.when);
      panel.text = question.path == state.document.path
                       ? fill("question.recover", state.appearance.language, {{"file", file}, {"when", when}})
                       : fill("question.recover_other", state.appearance.language,
                              {{"file", question.path.empty() ? said(state, "scene.untitled") : question.path},
                               {"when", when},
                               {"other", file}});
      if (!question.why_not.empty())
        panel.text += "\n\n" + fill("question.recover_failed", state.appearance.language, {{"why", question.why_not}});
      choice(Answer::recover, "answer.recover");
      choice(Answer::cancel, "answer.later");
      choice(Answer::discard, "answer.throw_away");
      break;
    }
    case Question::Kind::overwrite:
      panel.text = fill(question.intent.question, state.appearance.language, {{"file", question.path}});
      choice(Answer::cancel, "answer.cancel");
      choice(Answer::save, "answer.overwrite");
      break;
  }
  return panel;
}

}  // namespace raywalk
