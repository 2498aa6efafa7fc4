#pragma once
// The parts of update(). Included only by the files of this folder that implement it.

#include "math/overloaded.h"
#include "view/action.h"

#include <string>
#include <utility>

namespace raywalk {

inline void inform(State& state, std::string text) { state.notice = Notice{Notice::Kind::info, std::move(text)}; }
inline void complain(State& state, std::string text) { state.notice = Notice{Notice::Kind::error, std::move(text)}; }

// record.cpp
/// Records the strip of the scene, and keeps the position: the same line of the same pixel, if it still exists.
void record_again(State& state);
/// One pixel of the walk, `column` of the strip or the picture's pixel, with other limits than the scene's.
[[nodiscard]] Timeline record_under(const State& state, int column, int samples, const TraceLimits& limits);
/// A recording of this length takes some tens of milliseconds and less than 200 MB.
inline constexpr double max_events = 400'000;

// samples_view.cpp
/// The number of recorded samples of that pixel (an index in Timeline::pixels()).
[[nodiscard]] int samples_of_pixel(const Timeline& timeline, int pixel);

// tween.cpp
/// Begins a tween if the walk went a small step forward from here, and ends one that is over.
void follow_with_tween(State& state, const Timeline* timeline, int position);

// ghosts.cpp
/// Updates State::ghosts for the current pixel.
void follow_with_ghosts(State& state);

// history.cpp
/// Replaces the scene by `next` without an undo entry; records again, and drops references to what no longer exists.
void replace_scene(State& state, Scene next);
/// The same with one undo entry; none if nothing changed.
void commit(State& state, Scene next, EditMark mark = {}, bool continues = false);
/// Adds an undo entry that restores `before`.
void remember(State& state, Scene before);
/// Why `scene` cannot be saved because of the given parts; empty if it can. -1: not checked.
[[nodiscard]] std::string why_refused(const Scene& scene, int object, int light);
/// Commits `next` unless the changed part is invalid; then reports why.
bool commit_if_valid(State& state, Scene next, int object, int light, EditMark mark = {}, bool continues = false);

// playback.cpp
void go_to(State& state, int position);
/// The position after one step of `grain`.
[[nodiscard]] int stepped(const Timeline& timeline, int position, Grain grain, bool forward);

// pointer.cpp
void end_drag(State& state);
void hover(State& state);
/// After a change of the pane, or of what is as wide as the theme wants it.
void refit(State& state);

// space.cpp
void walk_strip(State& state);

// files.cpp
void show_document(State& state, SceneDocument document, std::string path);
/// Opens the dialog for a path.
void ask_path(State& state, PathPrompt prompt);
void ask_or_do(State& state, Intent intent, const std::string& path);
/// Asks before overwriting an existing file, and refuses if it is in use. Returns whether it did either: then the file
/// must not be written now.
[[nodiscard]] bool asks_to_overwrite(State& state, const std::string& path, PathPrompt what);

// session.cpp
void autosave(State& state, double seconds);
void forget_autosave(State& state);
/// Removes an autosave of an earlier session, and asks about the next one.
void discard_autosave(State& state, const std::string& autosave);
void recover(State& state, const std::string& original, const std::string& autosave);
void add_recent(State& state, const std::string& path);

// lesson_steps.cpp
/// Opens the lesson, once unsaved work is settled.
void begin_lesson(State& state, const std::string& name);
/// Back to the list, and to the previous scene, once unsaved work is settled.
void end_lesson(State& state);
/// Back to the list, when another scene is about to replace the lesson's.
void close_lesson(State& state);
/// The arrow from the ray's origin to `towards`, in scene units.
void guess_arrow(State& state, const Vec2d& towards);
/// STEP while a lesson's question waits: shows the answer, once there is a prediction. Returns whether it did.
[[nodiscard]] bool answered_by_step(State& state);

// structure_steps.cpp
/// Updates the Structure tab for the current ray.
void follow_with_structure(State& state);

// bug_steps.cpp
/// Restores the state before the hunt.
void leave_hunt(State& state);
/// Injects a fault, or removes it; records again.
void set_bug(State& state, std::optional<Fault> fault);

// new_scene.cpp
[[nodiscard]] Scene new_scene(Language language);
[[nodiscard]] std::string unique_name(const Scene& scene, const std::string& wanted);

}  // namespace raywalk
