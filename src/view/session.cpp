// What outlives the window: the autosave and the list of recent files.

#include "io/file.h"
#include "view/text.h"
#include "view/update_parts.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

namespace raywalk {

namespace detail {

namespace {

constexpr std::size_t most_recent = 10;
constexpr std::size_t most_bytes = 64 << 20;
/// First line of an autosave: the file that it belongs to. For the reader of scenes it is a comment.
constexpr std::string_view autosave_head = "# autosave of: ";

std::string file_in(const State& state, const char* name) {
  return (std::filesystem::path(state.state_dir) / name).string();
}
std::string autosave_path(const State& state) { return file_in(state, "autosave.toml"); }
std::string recent_path(const State& state) { return file_in(state, "recent.txt"); }

Result<void> write_in_folder(const State& state, const std::string& path, const std::string& bytes) {
  std::error_code failed;
  std::filesystem::create_directories(state.state_dir, failed);  // that it failed shows in the writing
  return write_file_atomically(path, bytes);
}

Result<void> write_autosave(const State& state) {
  const Result<std::string> written = format_scene(state.scene(), state.document.text);
  if (!written) return tl::unexpected(written.error());
  return write_in_folder(state, autosave_path(state), std::string(autosave_head) + state.path + "\n" + written.value());
}

}  // namespace

void autosave(State& state, double seconds) {
  state.autosave_in = std::max(0.0, state.autosave_in - seconds);
  const bool wanted = state.dirty && state.revision != state.autosaved_revision && !state.state_dir.empty();
  if (!wanted || state.autosave_in > 0) return;
  state.autosave_in = autosave_every;
  state.autosaved_revision = state.revision;
  const Result<void> written = write_autosave(state);
  if (!written) complain(state, fill(TextId::autosave_failed, {written.error().text()}));
}

void forget_autosave(State& state) {
  state.autosaved_revision = state.revision;
  if (state.state_dir.empty()) return;
  std::error_code failed;  // nothing there is as good as removed
  std::filesystem::remove(autosave_path(state), failed);
}

void recover(State& state, const std::string& original) {
  Result<SceneDocument> document = read_scene(autosave_path(state));
  if (!document) return complain(state, document.error().text());
  std::string& text = document->text;
  if (text.starts_with(autosave_head)) text.erase(0, std::min(text.size(), text.find('\n') + 1));
  const Result<SceneDocument> file = read_scene(original);
  show_document(state, std::move(*document), original);
  // Without a file to compare with, everything is unsaved.
  if (file) state.saved = file->scene;
  state.dirty = !file || state.saved != state.scene();
  if (!file) state.saved = Scene{};
  state.autosaved_revision = 0;
  inform(state, fill(TextId::recovered, {document_title(state)}));
}

void add_recent(State& state, const std::string& path) {
  std::error_code failed;
  const std::filesystem::path absolute = std::filesystem::absolute(path, failed);
  const std::string entry = failed ? path : absolute.lexically_normal().string();
  std::erase(state.recent, entry);
  state.recent.insert(state.recent.begin(), entry);
  if (state.recent.size() > most_recent) state.recent.resize(most_recent);
  if (state.state_dir.empty()) return;
  std::string lines;
  for (const std::string& recent : state.recent) lines += recent + "\n";
  // A convenience: that it cannot be kept is no reason to bother anyone.
  static_cast<void>(write_in_folder(state, recent_path(state), lines));
}

}  // namespace detail

void restore_session(State& state) {
  if (state.state_dir.empty()) return;
  const Result<std::string> recent = read_file(detail::recent_path(state), detail::most_bytes);
  std::size_t start = 0;
  while (recent && start < recent->size() && state.recent.size() < detail::most_recent) {
    const std::size_t end = std::min(recent->find('\n', start), recent->size());
    if (end > start) state.recent.push_back(recent->substr(start, end - start));
    start = end + 1;
  }
  const Result<std::string> autosaved = read_file(detail::autosave_path(state), detail::most_bytes);
  if (!autosaved) return;
  std::string path;
  if (autosaved->starts_with(detail::autosave_head)) {
    const std::size_t begin = detail::autosave_head.size();
    path = autosaved->substr(begin, std::min(autosaved->find('\n'), autosaved->size()) - begin);
  }
  state.question = Question{Question::Kind::recover, Intent::open, path};
}

}  // namespace raywalk
