#include "view/export/export.h"

#include "text/file.h"
#include "text/file_ledger.h"
#include "timeline/event_json.h"
#include "timeline/message.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/drawing/svg.h"
#include "view/export/lesson_script.h"
#include "view/export/slides.h"
#include "view/plan/plan_view.h"
#include "view/plan/pointer.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>

namespace raywalk {

namespace {

/// In the language of the window: a shipped scene's title is that of the gallery, unless it was changed.
std::string title_of(const State& state) {
  const std::string& path = state.document.path;
  const std::string name = std::filesystem::path(path).stem().string(), &own = state.scene().title;
  const bool is_shipped = !path.empty() && own == saved_scene(state).title &&
                          shipped_sentence(state, name) != nullptr && is_same_file(path, shipped_path(state, name));
  return is_shipped && state.appearance.language.code() != "en" ? shipped_title(state, name) : own;
}

/// Exports that need no window.
Result<std::string> exported(const State& state, ExportKind kind) {
  Scene scene = state.scene();
  scene.title = title_of(state);
  switch (kind) {
    case ExportKind::plan:
      return svg_file(plan_view(state, state.plan.viewport), state.plan.viewport.width, state.plan.viewport.height,
                      palette(state.appearance.theme).plan, scene.title.empty() ? "Raywalk" : scene.title);
    case ExportKind::slides:
      if (state.walk.timeline->steps() > max_slides)
        return tl::unexpected(
            Error{"", 0, 0, fill("notice.too_many_slides", state.appearance.language, {{"most", max_slides}}), ""});
      return slides_page(scene, state.walk.timeline, state.appearance.language, state.appearance.theme,
                         state.document.contents.ink, state.appearance.english_code);
    case ExportKind::transcript:
      return transcript(scene, *state.walk.timeline, state.appearance.language);
    case ExportKind::steps: {
      std::string all;
      const TraceLimits limits = walked_scene(state)->limits;
      const auto written = write_steps_json(scene, *state.walk.timeline,
                                            {{"scene", state.document.path},
                                             {"title", scene.title},
                                             {"depth", limits.depth},
                                             {"threshold", limits.threshold}},
                                            [&](const std::string& part) -> Result<void> {
                                              all += part;
                                              return {};
                                            });
      if (!written) return tl::unexpected(written.error());
      return all;
    }
    case ExportKind::script:
      if (!state.lessons.open)
        return tl::unexpected(Error{"", 0, 0, std::string(text("lesson.no_lesson", state.appearance.language)), ""});
      return lesson_script(state.lessons.open->played, state.appearance.language, ScriptForm::page);
    case ExportKind::picture:
    case ExportKind::animation:
      break;
  }
  return std::string();
}

/// The longest matching extension of a path; null if none.
const ExportEnding* ending_in(std::string_view path) {
  std::string name = std::filesystem::path(path).filename().string();
  for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  const ExportEnding* best = nullptr;
  for (const ExportEnding& each : kinds_of_export)
    if (name.size() > each.ending.size() && name.ends_with(each.ending) &&
        (best == nullptr || each.ending.size() > best->ending.size()))
      best = &each;
  return best;
}

/// The length of a foreign extension: a few letters and digits. "1. Casting" has none.
std::size_t foreign_ending(const std::string& path) {
  constexpr std::size_t most = 5;  // with its dot
  const std::string ending = std::filesystem::path(path).extension().string();
  const auto is = [](int (*what)(int)) { return [what](char c) { return what(static_cast<unsigned char>(c)) != 0; }; };
  const bool fits = ending.size() > 1 && ending.size() <= most && is(std::isalpha)(ending[1]);
  return fits && std::all_of(ending.begin() + 1, ending.end(), is(std::isalnum)) ? ending.size() : 0;
}

/// Overwrites an existing file.
void export_over(State& state, const std::string& path) {
  action::FinishInk{}.apply(state);  // an export has what is seen
  const ExportKind kind = *export_kind_of(path);
  if (kind == ExportKind::picture || kind == ExportKind::animation) {
    // The window without the dialog and without hover effects.
    state.document.prompt = PathPrompt::none;
    state.document.notice.reset();
    state.walk.playing = false;
    state.plan.pointer.reset();
    state.plan.hovered_line.reset();
    hover(state);
    if (kind == ExportKind::animation) state.walk.mode = Mode::trace;
    state.exports.window = WindowExport{kind, path};
    return;
  }
  const auto text = exported(state, kind);
  const auto written = text ? write_file_atomically(path, *text) : tl::unexpected(text.error());
  action::FinishExport{written ? "" : written.error().text()}.apply(state);
  if (written) inform(state, fill("notice.saved_as", state.appearance.language, {{"file", path}}));
}

}  // namespace

std::optional<ExportKind> export_kind_of(std::string_view path) {
  const ExportEnding* ending = ending_in(path);
  return ending == nullptr ? std::nullopt : std::optional(ending->kind);
}

std::string with_ending(const std::string& path, ExportKind kind) {
  const std::string ending(std::find_if(kinds_of_export.begin(), kinds_of_export.end(), [&](const ExportEnding& each) {
                             return each.kind == kind;
                           })->ending);
  const ExportEnding* has = ending_in(path);
  std::string stem = path.substr(0, path.size() - (has != nullptr ? has->ending.size() : foreign_ending(path)));
  // The rest may combine to a longer extension: notes.script and .html.
  while (export_kind_of(stem + ending).value_or(kind) != kind) {
    const std::size_t more = std::filesystem::path(stem).extension().string().size();
    if (more == 0) break;  // there is no name yet: a folder is being typed
    stem.resize(stem.size() - more);
  }
  return stem + ending;
}

std::vector<int> animation_positions(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const bool whole = state.walk.grain == Grain::pixel;
  const int last = whole ? timeline.steps() : timeline.next_pixel(state.walk.position);
  std::vector<int> positions{state.walk.position};
  while (positions.back() < last) {
    const int next = std::min(stepped(timeline, positions.back(), state.walk.grain, true), last);
    positions.push_back(next);
  }
  if (static_cast<int>(positions.size()) > max_frames) {
    positions.resize(max_frames - 1);
    positions.push_back(last);
  }
  return positions;
}

Result<void> write_steps_json(const Scene& scene, const Timeline& timeline, const nlohmann::ordered_json& head,
                              const std::function<Result<void>(const std::string&)>& print) {
  using Json = nlohmann::ordered_json;
  const auto dump = [](const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); };
  std::string text = dump(head);
  text.pop_back();  // its closing brace
  text += ",\"steps\":[";
  for (int position = 1; position <= timeline.steps(); ++position) {
    Json step{{"step", position}};
    step.update(event_json(scene, timeline.event(position - 1)));
    step["sentence"] = sentence_of(scene, describe(scene, timeline, position), Language());
    text += (position == 1 ? "\n" : ",\n") + dump(step);
    constexpr std::size_t enough = 1 << 16;
    if (text.size() < enough) continue;
    if (auto printed = print(text); !printed) return printed;
    text.clear();
  }
  return print(text + "\n]}\n");
}

void action::AskExport::apply(State& state) const { ask_path(state, PathPrompt::export_walk); }

void action::Export::apply(State& state) const {
  if (path.empty()) return;
  if (state.document.prompt == PathPrompt::export_walk) state.document.notice.reset();
  if (!export_kind_of(path))
    return complain(state, fill("notice.export_endings", state.appearance.language, {{"file", path}}));
  if (!asks_to_overwrite(state, path, export_over)) export_over(state, path);
}

void action::FinishExport::apply(State& state) const {
  const auto done = std::exchange(state.exports.window, std::nullopt);
  if (!why_not.empty()) return complain(state, why_not);
  state.document.prompt = PathPrompt::none;
  if (done) inform(state, fill("notice.saved_as", state.appearance.language, {{"file", done->path}}));
}

}  // namespace raywalk
