// Persistent data: the autosave and the list of recent files.

#include "text/file.h"
#include "text/text_file.h"
#include "view/action.h"
#include "view/document/document.h"
#include "view/text/text.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <ctime>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>

namespace raywalk {

namespace {

constexpr std::size_t max_recent = 10;
constexpr std::size_t max_bytes = 64 << 20;
/// First line of an autosave: the file that it belongs to. A comment for scene readers.
constexpr std::string_view autosave_head = "# autosave of: ";
constexpr std::string_view time_head = "# written on: ";  ///< its second line

std::string file_in(const State& state, const char* name) {
  return (std::filesystem::path(state.document.state_dir) / name).string();
}
/// Of this session's autosave, which has a name.
std::string autosave_path(const State& state) { return file_in(state, state.document.autosave_file.c_str()); }
constexpr int max_autosaves = 99;
/// The name of the autosave of this number, from 1 on.
std::string autosave_name(int number) {
  return number == 1 ? "autosave.toml" : "autosave-" + std::to_string(number) + ".toml";
}

/// A time as in ISO 8601, without seconds: "2026-11-21T14:05".
std::string time_text(std::time_t time) {
  std::tm parts{};
  std::array<char, 64> text{};
  if (localtime_r(&time, &parts) != nullptr) std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M", &parts);
  return text.data();
}

/// When a file was last written; now, if nobody knows.
std::time_t time_of(const std::string& path) {
  struct stat status{};
  return ::stat(path.c_str(), &status) == 0 ? status.st_mtime : std::time(nullptr);
}

/// The rest of the line at `begin` after `head`, and the start of the next line; nothing if there is no such line.
struct HeadLine {
  std::string value;
  std::size_t next;
};
std::optional<HeadLine> head_line(const std::string& text, std::size_t begin, std::string_view head) {
  if (text.compare(begin, head.size(), head) != 0) return std::nullopt;
  const std::size_t end = std::min(text.find('\n', begin), text.size());
  return HeadLine{text.substr(begin + head.size(), end - begin - head.size()), std::min(end + 1, text.size())};
}

/// Keeps an autosave that cannot be read under another name: no window will ask about it again.
void give_up_autosave(State& state, const std::string& path, const Error& why) {
  const Result<std::string> kept = set_aside(path);
  complain(state, fill("notice.autosave_damaged", state.appearance.language,
                       {{"why", why.text()}, {"file", kept ? *kept : path}}));
}

/// What is wrong with an autosave itself; nothing if it is whole, and only lacks a file that it names.
std::optional<Error> why_damaged(const std::string& path) {
  const Result<SceneDocument> own = read_scene_text(path).and_then(
      [&](const std::string& text) { return parse_scene(text, path, MeshReading::skip); });
  return own ? std::nullopt : std::optional(own.error());
}

/// Offers to recover the latest autosave of earlier sessions, if any. Those of windows that still run are theirs.
void ask_to_recover(State& state) {
  std::filesystem::file_time_type latest{};
  std::string found;
  std::shared_ptr<const FileHold> hold;
  for (int i = 1; i <= max_autosaves; ++i) {
    std::error_code missing;
    const std::string name = autosave_name(i), path = file_in(state, name.c_str());
    const auto written = std::filesystem::last_write_time(path, missing);
    if (missing || name == state.document.autosave_file || !std::filesystem::is_regular_file(path, missing)) continue;
    const bool is_empty = std::filesystem::file_size(path, missing) == 0;
    if (!is_empty && !found.empty() && written <= latest) continue;
    auto free = FileHold::take(path);
    if (!free) continue;
    if (is_empty) {  // a name that a session took, which then wrote nothing
      std::filesystem::remove(path, missing);
      continue;
    }
    latest = written;
    found = name;
    hold = std::move(free);
  }
  if (found.empty()) return;
  const std::string path = file_in(state, found.c_str());
  const Result<std::string> autosaved = read_file(path, max_bytes);
  if (!autosaved) return give_up_autosave(state, path, autosaved.error());
  state.document.question = Question{Question::Kind::recover, {}, {}, found, std::move(hold), {}};
  std::size_t next = 0;
  if (const auto line = head_line(*autosaved, 0, autosave_head)) {
    // Earlier versions may have written a path of which nobody knows any more from where it led.
    if (std::filesystem::path(line->value).is_absolute()) state.document.question->path = line->value;
    next = line->next;
  }
  const auto line = head_line(*autosaved, next, time_head);
  state.document.question->when = line ? line->value : time_text(time_of(path));
}
/// Gives this session's autosave a name that no other one has: another window may have started with the same folder.
void claim_autosave(State& state) {
  DocumentRoom& document = state.document;
  if (!document.autosave_file.empty()) return;
  std::error_code failed;
  std::filesystem::create_directories(document.state_dir, failed);  // a failure shows on writing
  for (int i = 1; i <= max_autosaves; ++i) {
    document.autosave_file = autosave_name(i);
    document.autosave_hold = FileHold::take(autosave_path(state));
    if (!document.autosave_hold) continue;
    const Result<bool> made = make_new_file(autosave_path(state));
    if (!made || *made) return;
  }
}

std::string recent_path(const State& state) { return file_in(state, "recent.txt"); }

Result<void> write_in_folder(const State& state, const std::string& path, const std::string& bytes) {
  std::error_code failed;
  std::filesystem::create_directories(state.document.state_dir, failed);  // a failure shows on writing
  return write_file_atomically(path, bytes);
}

Result<void> write_autosave(const State& state) {
  const std::string path = autosave_path(state);
  Result<std::string> written =
      with_names_from(state.scene(), state.document.contents.path, path).and_then([&](const Scene& scene) {
        return format_scene(scene, state.document.contents.text, state.document.contents.ink_of_file());
      });
  if (!written) return tl::unexpected(written.error());
  drop_utf8_marks(*written);  // below the head lines no scene may begin with one
  return write_in_folder(state, path,
                         std::string(autosave_head) + state.document.path + "\n" + std::string(time_head) +
                             time_text(std::time(nullptr)) + "\n" + written.value());
}

/// Removes this session's autosave, if there is one; the next is given a name anew.
void remove_autosave(State& state) {
  if (state.document.autosave_file.empty()) return;
  std::error_code failed;  // if absent, nothing to remove
  std::filesystem::remove(autosave_path(state), failed);
  state.document.autosave_file.clear();
  state.document.autosave_hold.reset();
}

/// Whether somebody else has removed it, though there is work that only it holds.
bool is_autosave_gone(const State& state) {
  std::error_code failed;
  return holds_unsaved_work(state) && !state.document.autosave_file.empty() &&
         !std::filesystem::exists(autosave_path(state), failed);
}

/// That nothing is autosaved is said at once, and again when what was said meanwhile is gone, until it is dismissed.
void tell_of_failure(State& state, const std::string& why) {
  DocumentRoom& document = state.document;
  if (std::exchange(document.autosave_failure, why) != why)
    document.failure_dismissed = false;
  else if (document.failure_dismissed || document.notice || waits_for_answer(state))
    return;
  complain(state, fill("notice.autosave_failed", state.appearance.language, {{"why", why}}));
  document.notice->lasts = true;
}

void end_telling_of_failure(State& state) {
  if (state.document.notice && state.document.notice->lasts) state.document.notice.reset();
}

}  // namespace

void autosave(State& state, double seconds) {
  state.document.autosave_in = std::max(0.0, state.document.autosave_in - seconds);
  if (state.document.autosave_in > 0) return;
  if (is_autosave_gone(state)) {
    remove_autosave(state);
  } else if (!wants_autosave(state)) {
    return;
  }
  state.document.autosave_in = autosave_every;
  const bool is_first = state.document.autosave_file.empty();
  claim_autosave(state);
  const Result<void> written = write_autosave(state);
  if (written) {
    state.document.autosaved_revision = state.document.revision;
    state.document.autosave_failure.clear();
    return end_telling_of_failure(state);
  }
  state.document.autosaved_revision = 0;  // tried again, also where an earlier one was removed by others
  if (is_first) remove_autosave(state);   // nothing but a name
  tell_of_failure(state, written.error().text());
}

void forget_autosave(State& state) {
  if (state.bugs.hunt) return;  // it belongs to the suspended scene
  state.document.autosaved_revision = state.document.revision;
  end_telling_of_failure(state);  // there is nothing to autosave
  if (!state.document.state_dir.empty()) remove_autosave(state);
}

void discard_autosave(State& state, const std::string& autosave) {
  std::error_code failed;  // if absent, nothing to remove
  std::filesystem::remove(file_in(state, autosave.c_str()), failed);
  ask_to_recover(state);
}

void recover(State& state, const Question& question) {
  const std::string& original = question.path;
  const std::string autosaved = file_in(state, question.autosave.c_str());
  Result<SceneDocument> document = read_scene(autosaved);
  if (!document) {
    if (const auto why = why_damaged(autosaved)) {
      give_up_autosave(state, autosaved, *why);
      return ask_to_recover(state);
    }
    // A page begins without the user's files: once it has those that the scene names, this goes well.
    state.document.question = question;
    state.document.question->why_not = document.error().text();
    return;
  }
  std::string& text = document->text;
  if (const auto line = head_line(text, 0, autosave_head)) text.erase(0, line->next);
  if (const auto line = head_line(text, 0, time_head)) text.erase(0, line->next);
  // Its meshes and textures are relative to the autosave folder; makes them relative to the scene's own.
  if (auto home = with_names_from(document->scene, document->path, original); home && !original.empty()) {
    document->scene = std::move(*home);
    document->path = original;
  }
  const Result<SceneDocument> file = read_scene(original);
  if (file && !file->text.empty()) text = file->text;  // which the scene will be written into
  // A link may have opened a lesson or a hunt before this was asked.
  action::LeaveHunt{}.apply(state);
  show_another(state, std::move(*document), original);
  state.document.autosave_file = question.autosave;  // it holds this session's work now
  state.document.autosave_hold = question.hold;
  // Without a file to compare with, everything is unsaved.
  const bool changed = !file || file->scene != state.scene();
  if (changed) state.document.saved = file ? file->scene : Scene{};
  state.document.saved_ink = file ? file->ink : Ink{};
  state.document.dirty = changed || state.document.contents.ink_of_file() != state.document.saved_ink;
  state.document.autosaved_revision = 0;
  inform_above(state, fill("notice.recovered", state.appearance.language, {{"file", document_title(state)}}));
}

namespace {

void read_recent(State& state) {
  const Result<std::string> recent = read_file(recent_path(state), max_bytes);
  if (!recent) return;
  state.document.recent.clear();
  std::size_t start = 0;
  while (start < recent->size() && state.document.recent.size() < max_recent) {
    const std::size_t end = std::min(recent->find('\n', start), recent->size());
    std::string path = recent->substr(start, end - start);
    std::error_code failed;
    if (std::filesystem::exists(path, failed)) state.document.recent.push_back(std::move(path));
    start = end + 1;
  }
}

}  // namespace

void add_recent(State& state, const std::string& path) {
  if (!state.document.state_dir.empty()) read_recent(state);  // another window may have added some
  std::erase(state.document.recent, path);
  state.document.recent.insert(state.document.recent.begin(), path);
  if (state.document.recent.size() > max_recent) state.document.recent.resize(max_recent);
  if (state.document.state_dir.empty()) return;
  std::string lines;
  for (const std::string& recent : state.document.recent) lines += recent + "\n";
  // A convenience: failures are ignored.
  static_cast<void>(write_in_folder(state, recent_path(state), lines));
}

void restore_session(State& state) {
  if (state.document.state_dir.empty()) return;
  read_recent(state);
  state.document.autosave_file.clear();  // an undecided autosave is never overwritten
  ask_to_recover(state);
}

}  // namespace raywalk
