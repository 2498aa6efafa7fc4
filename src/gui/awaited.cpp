#include "gui/awaited.h"

#include "view/walk/asked.h"

#include <filesystem>

namespace raywalk {

namespace {

/// Whether the action shows pictures of a lesson's step, which may have to be made first.
bool shows_pictures(const State& state, const Action& action) {
  const bool steps = action.is<action::Step>() || action.is<action::PlayPause>();
  return state.lessons.open &&
         (action.is<action::GoToLessonStep>() || action.is<action::RevealLesson>() || (steps && question_waits(state)));
}

}  // namespace

std::optional<Awaited> awaited_by(const State& state, const Action& action) {
  const Language language = state.appearance.language;
  if (shows_pictures(state, action))
    return Awaited{state.lessons.open->lesson.told(language).title,
                   std::string(text("files.making_pictures", language))};
  const auto read = [&](const std::string& name) {
    return Awaited{name, fill("files.reading_scene", language, {{"file", name}})};
  };
  std::string path;
  if (const auto* lesson = action.as<action::OpenLesson>()) {
    const LessonEntry* entry = state.lessons.entry(lesson->name);
    return read(entry == nullptr ? lesson->name : entry->title(language));
  }
  if (const auto* open = action.as<action::Open>()) path = open->path;
  if (action.is<action::AnswerQuestion>() && state.document.question) path = state.document.question->path;
  if (path.empty()) return std::nullopt;
  return read(std::filesystem::path(path).filename().string());
}

}  // namespace raywalk
