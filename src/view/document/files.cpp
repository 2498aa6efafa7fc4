#include "render/parallel.h"
#include "scene/warnings.h"
#include "text/file_ledger.h"
#include "text/file_path.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/plan/plan_view.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <filesystem>
#include <memory>

namespace raywalk {

namespace {

void complain(State& state, const Error& error) { complain(state, error.text()); }

bool same_file(const std::string& a, const std::string& b) {
  std::error_code failed;
  return a == b || std::filesystem::equivalent(a, b, failed);  // folders too
}

/// Whether a file is one of the shipped scenes, which the lessons use.
bool is_shipped(const State& state, const std::string& path) {
  return !state.lessons.scenes_folder.empty() &&
         same_file(std::filesystem::path(path).parent_path().string(), state.lessons.scenes_folder);
}

/// Before the user's scene is replaced.
void close_scene(State& state) {
  forget_autosave(state);
  for_each_room(Rooms(), [&]<class Room>() {
    if constexpr (requires { Room::close(state); }) Room::close(state);
  });
}

void open_file(State& state, const std::string& path) {
  // A reader cannot be cancelled; its result is then dropped.
  const auto reading = std::make_shared<Result<SceneDocument>>();
  run_detached(state.document.stop, [reading, path] { *reading = read_scene(path); });
  Result<SceneDocument> document = std::move(*reading);
  if (!document) return complain(state, document.error());
  show_another(state, std::move(*document), absolute_path(path));
  add_recent(state, state.document.path);
  const std::optional<std::string> warning = warning_of_file(state);
  inform_above(state, warning ? *warning : fill("notice.opened", state.appearance.language, {{"file", path}}));
}

void begin_scene(State& state, const std::string& /*path*/) {
  show_another(state, {new_scene(state.appearance.language), {}, {}}, {});
}

void quit(State& state, const std::string& /*path*/) {
  forget_autosave(state);
  state.document.quit = true;
}

/// Once unsaved work on the scene is settled.
void quit_if_predictions_are_kept(State& state, const std::string& path) {
  if (!state.predictions.unsaved()) return quit(state, path);
  state.document.question = Question{Question::Kind::predictions, {"question.predictions_quit", quit}, {}};
}

/// If the file was written, continues with the pending intent.
void write_to(State& state, const std::string& path) {
  action::FinishInk{}.apply(state);  // a text that is still in its field is meant to be there, too
  const Result<void> written = write_scene(state.document.contents, path);
  if (!written) {
    complain(state, written.error());
    if (state.document.prompt == PathPrompt::none) state.document.after_save.reset();
    return;
  }
  state.document.prompt = PathPrompt::none;
  state.document.path = absolute_path(path);
  state.document.saved.reset();
  state.document.saved_ink = state.document.contents.ink_of_file();
  state.document.dirty = false;
  state.document.last_edit.reset();
  forget_autosave(state);
  add_recent(state, state.document.path);
  inform(state, fill("notice.saved_as", state.appearance.language, {{"file", path}}));
  if (const std::optional<Intent> intent = std::exchange(state.document.after_save, std::nullopt))
    intent->carry_out(state, state.document.after_save_path);
}

/// Whether the scene's file holds something else than when it was last read or written here: another window or an
/// editor has written to it. One that is gone has nothing to lose.
bool changed_by_others(const DocumentRoom& document) {
  std::error_code failed;
  if (!std::filesystem::exists(document.path, failed)) return false;
  if (std::filesystem::is_directory(document.path, failed)) return false;  // the writer says that it cannot
  const Result<std::string> now = read_scene_text(document.path);
  return !now || *now != document.contents.text;
}

/// Writes the scene to its own file, which this may be another name of, and asks first if others have changed that.
void write_to_own(State& state, const std::string& path) {
  if (!changed_by_others(state.document)) return write_to(state, path);
  state.document.question = Question{Question::Kind::overwrite, {"question.overwrite_changed", write_to}, path};
}

/// Files that must not be replaced. A scene may overwrite itself and the file that it was read from.
std::vector<std::string> files_in_use(const State& state, bool of_scene) {
  std::vector<std::string> files = state.document.keeps;
  const auto is_itself = [&](const std::string& file) {
    return scene_format_of(file) == SceneFormat::toml &&
           (same_file(file, state.document.path) || same_file(file, state.document.contents.path));
  };
  for (const std::string& file : state.document.contents.files)
    if (!of_scene || !is_itself(file)) files.push_back(file);
  if (!of_scene && !state.document.path.empty()) files.push_back(state.document.path);
  return files;
}

constexpr std::string_view scene_file_ending = ".toml";

const std::string* gallery_text(const State& state, const std::string& name, std::string_view which) {
  return state.appearance.language.catalogue().find("gallery." + name + "." + std::string(which));
}

}  // namespace

std::optional<std::string> warning_of_file(const State& state) {
  const std::vector<std::string> warnings = collected(state.document.contents.warnings);
  if (warnings.empty() || is_shipped(state, state.document.path)) return std::nullopt;
  // The last of what a reader says is for the command line: in the window an object is added by a button.
  if (warnings.size() == 1 && is_empty(state.scene()))
    return fill("notice.no_object", state.appearance.language, {{"file", state.document.path}});
  return warnings.front();
}

std::string shipped_path(const State& state, const std::string& name) {
  return state.lessons.scenes_folder + "/" + name + std::string(scene_file_ending);
}

std::string shipped_title(const State& state, const std::string& name) {
  if (const std::string* known = gallery_text(state, name, "title")) return *known;
  std::string title = name;
  std::replace(title.begin(), title.end(), '_', ' ');
  return title;
}

const std::string* shipped_sentence(const State& state, const std::string& name) {
  return gallery_text(state, name, "sentence");
}

std::vector<std::string> shipped_names(const State& state) {
  std::vector<std::string> names;
  std::error_code failed;
  std::filesystem::directory_iterator entry(state.lessons.scenes_folder, failed);
  for (; !failed && entry != std::filesystem::directory_iterator(); entry.increment(failed))
    if (entry->path().extension() == scene_file_ending) names.push_back(entry->path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

void show_document(State& state, SceneDocument document, std::string path) {
  state.document.contents = std::move(document);
  ++state.document.number;
  state.document.worlds = std::make_shared<WorldCache>();
  state.document.path = std::move(path);
  state.document.saved.reset();
  state.document.saved_ink = state.document.contents.ink_of_file();
  state.document.dirty = false;
  state.document.undo.clear();
  state.document.redo.clear();
  state.document.replaced_redo.clear();
  state.document.last_edit.reset();
  state.walk.bug.reset();
  state.plan.drag.reset();
  state.ink.begun.reset();
  state.plan.selected = {};
  state.plan.hovered = {};
  state.plan.hovered_ray = -1;
  state.walk.position = 0;
  state.walk.playing = false;
  if (state.walk.mode == Mode::help) state.walk.mode = state.walk.before_help;  // which would hide it
  state.document.question.reset();
  state.document.notice.reset();
  state.walk.pixel.reset();
  state.walk.strip_position = 0;
  state.picture.camera.reset();
  state.space.lines_camera.reset();
  state.space.lines_wanted.reset();
  ++state.document.revision;
  record_again(state);
  state.walk.position = 0;
  state.plan.camera = fitted(state);
}

void show_another(State& state, SceneDocument document, std::string path) {
  close_scene(state);
  show_document(state, std::move(document), std::move(path));
}

std::string offered_path(const State& state) {
  const std::filesystem::path own = state.document.path;
  const LessonRoom& lessons = state.lessons;
  std::filesystem::path offered;
  switch (state.document.prompt) {
    case PathPrompt::none:
    case PathPrompt::start:
    case PathPrompt::open:
      return {};
    case PathPrompt::save_as:
      offered = (own.empty() ? "scene" : own.stem().string()) + std::string(scene_file_ending);
      break;
    case PathPrompt::save_predictions:
      offered = "predictions.csv";
      break;
    case PathPrompt::export_walk:
      // Presenters ask for the script; others start with slides.
      offered = with_ending(lessons.open  ? lessons.open->lesson.name
                            : own.empty() ? "walk"
                                          : own.filename().string(),
                            lessons.open && lessons.presenter ? ExportKind::script : ExportKind::slides);
      break;
  }
  return own.empty() || is_shipped(state, own.string()) ? offered.string() : (own.parent_path() / offered).string();
}

void ask_path(State& state, PathPrompt prompt) {
  state.document.prompt = prompt;
  state.walk.playing = false;
  if (state.document.notice && state.document.notice->kind == Notice::Kind::error) state.document.notice.reset();
}

void action::New::apply(State& state) const {
  state.document.prompt = PathPrompt::none;
  ask_or_do(state, {"question.unsaved_new", begin_scene}, {});
}

void action::AskNew::apply(State& state) const { ask_path(state, PathPrompt::start); }

void action::AskOpen::apply(State& state) const { ask_path(state, PathPrompt::open); }

void action::AskSaveAs::apply(State& state) const { ask_path(state, PathPrompt::save_as); }

void action::CancelPrompt::apply(State& state) const {
  // What went wrong in the dialog has been read there.
  const auto& notice = state.document.notice;
  if (state.document.prompt != PathPrompt::none && notice && notice->kind == Notice::Kind::error)
    state.document.notice.reset();
  state.document.prompt = PathPrompt::none;
  state.document.after_save.reset();
}

void action::Quit::apply(State& state) const {
  if (state.document.question) {
    state.document.quit = true;
    return;
  }
  state.document.prompt = PathPrompt::none;
  ask_or_do(state, {"question.unsaved_quit", quit_if_predictions_are_kept}, {});
}

void action::Open::apply(State& state) const {
  const PathPrompt prompt = std::exchange(state.document.prompt, PathPrompt::none);
  const bool asked = prompt == PathPrompt::open || prompt == PathPrompt::start;
  ask_or_do(state, {"question.unsaved_open", open_file}, path);
  // If it cannot be opened, the dialog stays and says why.
  if (asked && !state.document.question && state.document.notice && state.document.notice->kind == Notice::Kind::error)
    state.document.prompt = prompt;
}

void ask_or_do(State& state, const Intent& intent, const std::string& path) {
  state.document.after_save.reset();  // what waited for a path that was not given
  state.walk.playing = false;
  action::FinishInk{}.apply(state);  // which may be unsaved work
  if (!state.document.dirty) return intent.carry_out(state, path);
  state.document.question = Question{Question::Kind::unsaved, intent, path};
}

bool asks_to_overwrite(State& state, const std::string& path, void (*write)(State& state, const std::string& path),
                       bool of_scene) {
  if (const auto error = why_in_use(path, files_in_use(state, of_scene), "in use in this window")) {
    complain(state, *error);
    return true;
  }
  std::error_code failed;
  if (!std::filesystem::exists(path, failed)) return false;
  if (std::filesystem::is_directory(path, failed)) return false;  // the writer says that it cannot
  state.document.question = Question{Question::Kind::overwrite, {"question.overwrite", write}, path};
  return true;
}

void action::Save::apply(State& state) const {
  // A scene of another format is saved in ours, under a new name.
  const bool is_ours = !state.document.path.empty() && scene_format_of(state.document.path) == SceneFormat::toml;
  if (!is_ours) return ask_path(state, PathPrompt::save_as);
  if (is_shipped(state, state.document.path)) {
    ask_path(state, PathPrompt::save_as);
    return inform(state, std::string(text("notice.save_elsewhere", state.appearance.language)));
  }
  write_to_own(state, state.document.path);
}

void action::SaveAs::apply(State& state) const {
  if (path.empty()) return;
  // The path dialog stays until the file is written, and shows errors.
  if (state.document.prompt == PathPrompt::save_as) state.document.notice.reset();
  const std::string whole = has_scene_ending(path) ? path : path + std::string(scene_file_ending);
  const bool is_own = same_file(whole, state.document.path) && !is_shipped(state, whole);
  if (is_own) return write_to_own(state, whole);
  if (!asks_to_overwrite(state, whole, write_to, true)) write_to(state, whole);
}

void action::NotSaved::apply(State& state) const {
  DocumentRoom& document = state.document;
  if (path.empty() || document.path != path) return;
  if (!document.dirty) document.saved = Scene{};  // nobody knows what the file holds
  document.dirty = true;
  document.autosaved_revision = 0;
  const Language language = state.appearance.language;
  const std::string file = std::filesystem::path(path).filename().string();
  complain(state, why.empty() ? fill("notice.save_refused", language, {{"file", file}})
                              : fill("notice.not_saved", language, {{"file", file}, {"why", why}}));
}

void action::AnswerQuestion::apply(State& state) const {
  if (!state.document.question) return;
  const Question question = *state.document.question;
  switch (question.kind) {
    case Question::Kind::unsaved:
    case Question::Kind::predictions:
      if (answer == Answer::recover) return;
      state.document.question.reset();
      if (answer == Answer::discard) question.intent.carry_out(state, question.path);
      if (answer != Answer::save) return;
      state.document.after_save = question.intent;
      state.document.after_save_path = question.path;
      if (question.kind == Question::Kind::predictions) return AskSavePredictions{}.apply(state);
      return Save{}.apply(state);
    case Question::Kind::recover:
      if (answer == Answer::save) return;
      state.document.question.reset();
      if (answer == Answer::recover) return recover(state, question);
      if (answer == Answer::discard) discard_autosave(state, question.autosave);
      return;
    case Question::Kind::overwrite:
      if (answer == Answer::discard || answer == Answer::recover) return;
      state.document.question.reset();
      if (answer == Answer::save) {
        question.intent.carry_out(state, question.path);
      } else if (state.document.prompt == PathPrompt::none) {  // else the dialog asks for another path
        state.document.after_save.reset();
      }
      return;
  }
}

}  // namespace raywalk
