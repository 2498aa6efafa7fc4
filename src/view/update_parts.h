#pragma once
// What update() is made of. Included by the files of this folder that implement it, and by nobody else.

#include "math/overloaded.h"
#include "view/action.h"

#include <string>
#include <utility>

namespace raywalk::detail {

inline void inform(State& state, std::string text) { state.notice = Notice{Notice::Kind::info, std::move(text)}; }
inline void complain(State& state, std::string text) { state.notice = Notice{Notice::Kind::error, std::move(text)}; }

// record.cpp
/// Records the strip of the scene, and keeps the place: the same line of the same pixel as far as it still exists.
void record_again(State& state);
/// One pixel of what is walked, `column` of the strip or the picture's pixel, with other limits than the scene's.
[[nodiscard]] Timeline record_under(const State& state, int column, int samples, const TraceLimits& limits);
/// A recording of this length takes some tens of milliseconds and less than 200 MB.
inline constexpr double most_events = 400'000;

// samples_view.cpp
/// How many samples of that pixel (an index in Timeline::pixels()) were recorded.
[[nodiscard]] int samples_of_pixel(const Timeline& timeline, int pixel);

// tween.cpp
/// Begins a tween where the walk went a small step forward from this place, and ends one that is over.
void follow_with_tween(State& state, const Timeline* timeline, int position);

// ghosts.cpp
/// Keeps State::ghosts those of the pixel under way.
void follow_with_ghosts(State& state);

// history.cpp
/// Puts `next` in place of the scene without an entry of undo; records again, and lets go of what no longer exists.
void replace_scene(State& state, Scene next);
/// The same as one entry of undo; none when nothing changed.
void commit(State& state, Scene next, EditMark mark = {}, bool continues = false);
/// Adds an entry that leads back to `before`.
void remember(State& state, Scene before);
void undo(State& state);
void redo(State& state);
/// Why `scene` cannot be saved because of the parts named; empty when it can. -1: that part is not looked at.
[[nodiscard]] std::string why_refused(const Scene& scene, int object, int light);
/// Commits `next` unless the part that changed breaks a rule; then says why.
bool commit_if_valid(State& state, Scene next, int object, int light, EditMark mark = {}, bool continues = false);

// playback.cpp
void walk(State& state, const action::Step& step);
void go_to(State& state, int position);
void run_to_line(State& state, Line line);
void run_on(State& state, bool forward);
void toggle_breakpoint(State& state, Line line);
void play(State& state, double seconds);
/// The position that one step of `grain` leads to.
[[nodiscard]] int stepped(const Timeline& timeline, int position, Grain grain, bool forward);

// pointer.cpp
void pointer_moved(State& state, const action::PointerMoved& moved);
void pointer_pressed(State& state, const action::PointerPressed& pressed);
void pointer_released(State& state, const action::PointerReleased& released);
void end_drag(State& state);
void cancel_drag(State& state);
void zoom(State& state, const Vec2d& at, double factor);
void pan(State& state, const Vec2d& by);
void nudge(State& state, const action::Nudge& nudge);
void hover(State& state);

// space.cpp
void walk_pixel(State& state, const action::WalkPixel& wanted);
void walk_strip(State& state);
void orbit(State& state, const action::Orbit& by);
void shift(State& state, const action::Shift& by);
void approach(State& state, const action::Approach& by);
void reset_view(State& state, SpaceView view);
void use_image_camera(State& state);
void set_image_settings(State& state, ImageSettings settings);

// edit.cpp
void add_object(State& state, action::ObjectKind kind);
void remove_selected(State& state);
void insert_corner(State& state, const action::InsertCorner& insert);
void remove_corner(State& state, int object, int corner);
void rename(State& state, const action::Rename& rename);

// files.cpp
void show_document(State& state, SceneDocument document, std::string path);
/// Opens the dialog for a path.
void ask_path(State& state, PathPrompt prompt);
void open(State& state, const std::string& path);
void ask_or_do(State& state, Intent intent, const std::string& path);
/// Asks before a file that is there already is written over, and refuses where it is a part of what is open. Whether it
/// does either: then the file is not to be written now.
[[nodiscard]] bool asks_to_overwrite(State& state, const std::string& path, PathPrompt what);
void save(State& state);
void save_as(State& state, const std::string& path);
void answer(State& state, action::Answer answer);

// session.cpp
void autosave(State& state, double seconds);
void forget_autosave(State& state);
/// Removes an autosave of an earlier sitting, and asks about the next one.
void discard_autosave(State& state, const std::string& autosave);
void recover(State& state, const std::string& original, const std::string& autosave);
void add_recent(State& state, const std::string& path);

// lesson_steps.cpp
void show_lessons(State& state, bool shown);
void open_lesson(State& state, const std::string& name);
/// The same, now that nothing unsaved stands in its way.
void begin_lesson(State& state, const std::string& name);
/// Back to the list, and to the scene that was open before.
void leave_lesson(State& state);
/// The same, now that nothing unsaved stands in its way.
void end_lesson(State& state);
/// Back to the list, where another scene is about to take the lesson's place.
void close_lesson(State& state);
void go_to_lesson_step(State& state, int step);
void guess_choice(State& state, int choice);
void show_hands(State& state, const action::ShowHands& shown);
void guess_number(State& state, double number);
/// The arrow from the ray's origin to `towards`, in scene units.
void guess_arrow(State& state, const Vec2d& towards);
void reveal_lesson(State& state);
/// STEP while a lesson's question waits: the answer, once there is a prediction. Whether it was that.
[[nodiscard]] bool answered_by_step(State& state);
void set_lesson_options(State& state, const action::SetLessonOptions& options);

// structure_steps.cpp
/// Keeps what the Structure tab shows that of the ray in hand.
void follow_with_structure(State& state);
void choose_structure(State& state, AcceleratorKind kind);
void go_in_structure(State& state, int step);

// bug_steps.cpp
void show_bugs(State& state, bool shown);
void hunt_bug(State& state, const action::HuntBug& hunt);
void mark_line(State& state, Line line);
void judge_line(State& state);
void show_cure(State& state);
void mend_bug(State& state, bool mended);
/// Everything as it was before the hunt.
void leave_hunt(State& state);
/// Breaks the tracer, or mends it for good; records again.
void set_bug(State& state, std::optional<Fault> fault);

// new_scene.cpp
[[nodiscard]] Scene new_scene(Language language);
[[nodiscard]] std::string unique_name(const Scene& scene, const std::string& wanted);

}  // namespace raywalk::detail
