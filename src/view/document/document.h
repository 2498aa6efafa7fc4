#pragma once
// What all rooms do with the scene, its file, and the notice to the user.

#include "io/scene_file.h"
#include "view/document/room.h"
#include "view/state.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raywalk {

inline void inform(State& state, std::string text) {
  state.document.notice = Notice{Notice::Kind::info, std::move(text)};
}
/// The same above what is said already, such as how much of a scene is walked.
inline void inform_above(State& state, std::string text) {
  const auto said = std::exchange(state.document.notice, std::nullopt);
  inform(state, said ? std::move(text) + "\n" + said->text : std::move(text));
}
inline void complain(State& state, std::string text) {
  state.document.notice = Notice{Notice::Kind::error, std::move(text)};
}

/// Where an edit is done: what was said before is of the past, unless it goes on.
inline void forget_notice(State& state) {
  if (state.document.notice && !state.document.notice->lasts) state.document.notice.reset();
}

// history.cpp

/// Replaces the scene by `next` without an undo entry; records again, and drops references to what no longer exists.
void replace_scene(State& state, Scene next);
/// The same with one undo entry; none if nothing changed. Where what `continues` an edit leads back to where that
/// began, both leave no trace: what could be redone then can be again.
void commit(State& state, Scene next, EditMark mark = {}, bool continues = false);
/// Adds an undo entry that restores `before`.
void remember(State& state, Undone before);
/// What could be redone if all that can be undone were: whoever shows the scene as it was then loses nothing.
[[nodiscard]] History all_undone(const DocumentRoom& document);
/// Replaces the ink, with one undo entry; none if nothing changed. `joins`: the entry of the edit before holds for this
/// one too.
void commit_ink(State& state, Ink next, bool joins = false);
/// Whether the ink goes into the file of the scene.
void keep_ink(State& state, bool kept);
/// Why `scene` cannot be saved because of the given parts; empty if it can. -1: not checked.
[[nodiscard]] std::string why_refused(const Scene& scene, int object, int light);
/// Commits `next` unless the changed part is invalid; then reports why.
bool commit_if_valid(State& state, Scene next, int object, int light, EditMark mark = {}, bool continues = false);

// files.cpp

/// Whether a question or a dialog for a path is open: what is no answer has no effect.
[[nodiscard]] inline bool waits_for_answer(const State& state) {
  return state.document.question || state.document.prompt != PathPrompt::none;
}
/// The names of the shipped scenes, in alphabetical order: "classic".
[[nodiscard]] std::vector<std::string> shipped_names(const State& state);
[[nodiscard]] std::string shipped_path(const State& state, const std::string& name);
/// The title of one in the window's language; if it has none, as of a file that a teacher added, the file's name.
[[nodiscard]] std::string shipped_title(const State& state, const std::string& name);
/// What is said of it in the window's language; null if nothing is.
[[nodiscard]] const std::string* shipped_sentence(const State& state, const std::string& name);

/// What is said of the scene's file when it is opened; nothing of a shipped one, which does on purpose what it does.
[[nodiscard]] std::optional<std::string> warning_of_file(const State& state);
void show_document(State& state, SceneDocument document, std::string path);
/// The same once the user's scene is closed, with all that belongs to it.
void show_another(State& state, SceneDocument document, std::string path);
/// What the dialog for a path offers to write to: beside the user's scene, but not among those that are shipped. Empty
/// where a scene is to be opened.
[[nodiscard]] std::string offered_path(const State& state);
/// Opens the dialog for a path.
void ask_path(State& state, PathPrompt prompt);
/// Carries out the intent, once unsaved work is settled.
void ask_or_do(State& state, const Intent& intent, const std::string& path);
/// Asks before overwriting an existing file, and refuses if it is in use. Returns whether it did either: then the file
/// must not be written now. `write`: writes it, once asked. `of_scene`: the scene, which may overwrite itself.
[[nodiscard]] bool asks_to_overwrite(State& state, const std::string& path,
                                     void (*write)(State& state, const std::string& path), bool of_scene = false);

// autosave.cpp

void autosave(State& state, double seconds);
void forget_autosave(State& state);
/// Removes an autosave of an earlier session, and asks about the next one.
void discard_autosave(State& state, const std::string& autosave);
void recover(State& state, const Question& question);
void add_recent(State& state, const std::string& path);

// new_scene.cpp

[[nodiscard]] Scene new_scene(Language language);
/// Whether something in the scene has this name, or is called in this language what the new thing will be.
[[nodiscard]] bool is_taken(const Scene& scene, std::string_view name, std::string_view shown, Language language);
/// The name for something new, with a number behind it where that is taken; it will be one of the `translated`.
[[nodiscard]] std::string unique_name(const Scene& scene, const std::string& wanted, Language language);

}  // namespace raywalk
