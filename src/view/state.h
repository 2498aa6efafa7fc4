#pragma once
// Everything that the visualiser knows. It changes only through update(state, action) of view/action.h; what is on the
// screen is a pure function of it.

#include "io/scene_file.h"
#include "math/stop.h"
#include "render/heat.h"
#include "render/worlds.h"
#include "text/language.h"
#include "timeline/stops.h"
#include "timeline/timeline.h"
#include "view/bugs.h"
#include "view/cost.h"
#include "view/display_list.h"
#include "view/export.h"
#include "view/ghosts.h"
#include "view/lesson_sitting.h"
#include "view/predict.h"
#include "view/scene_seen.h"
#include "view/structure.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

enum class Mode { move, trace, help };
/// How far one step goes: a line of pseudocode, to the next ray, to the next pixel; over a line with all of the SHADE
/// that it calls, out of the SHADE under way.
enum class Grain { line, ray, pixel, over, out };
enum class Tab { image, tree, stack, legend, equation, cost, microscope, structure };

/// The pane that shows the plan, in pixels.
struct Viewport {
  double width = 640, height = 480;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// How the 3-D picture is made. None of it is in the scene's file.
struct ImageSettings {
  AcceleratorKind accelerator{};           ///< automatic
  bool single_precision = false;           ///< numbers of 24 bits in place of 53, in the walk too
  int samples = 16;                        ///< of each pixel in the end, 1..most_image_samples
  std::optional<Integrator> integrator{};  ///< absent: the scene's own
  int walk_samples = 1;                    ///< of each pixel that is walked, 1..most_walk_samples
  Heat heat = Heat::none;
  friend bool operator==(const ImageSettings&, const ImageSettings&) = default;
};
inline constexpr int most_image_samples = 1024, most_walk_samples = 256;

/// A pixel of the 3-D picture that is walked in place of the strip.
struct PixelWalk {
  ImageSize size;  ///< of the picture
  int column = 0, row = 0;
  std::optional<Camera> camera{};  ///< absent: the scene's own
  friend bool operator==(const PixelWalk&, const PixelWalk&) = default;
};

/// The views that can be turned by hand.
enum class SpaceView {
  image,  ///< the 3-D picture
  lines,  ///< the scene as lines in space, which takes the plan's place
};

/// What of the plan is seen.
struct PlanCamera {
  Vec2d centre{0.0};            ///< scene units, in the middle of the pane
  double pixels_per_unit = 50;  ///< > 0
  bool fitted = true;           ///< until zoomed or panned by hand: follows the pane's size
  friend bool operator==(const PlanCamera&, const PlanCamera&) = default;
};

/// One line for the person, until the next action that has something to say.
struct Notice {
  enum class Kind { info, error };
  Kind kind = Kind::info;
  std::string text;
};

/// What was asked for while there was unsaved work.
enum class Intent { new_scene, open, lesson, leave_lesson, quit };

/// A path that the window has to ask for; answered by the action of that name, or taken back by CancelPrompt.
enum class PathPrompt { none, open, save_as, save_predictions, export_walk };

struct Question {
  enum class Kind {
    unsaved,    ///< answers: save, discard, cancel
    recover,    ///< an autosave was found at the start; answers: recover, discard, cancel (asks at the next start)
    overwrite,  ///< a file that exists already is to be written; answers: save, cancel
  };
  Kind kind = Kind::unsaved;
  Intent intent = Intent::quit;  ///< goes on with this after save or discard
  std::string path;        ///< of Intent::open, the name of a lesson, of the file that the autosave belongs to (may be
                           ///< empty), or to overwrite
  std::string autosave{};  ///< recover: the autosave
  std::string when{};      ///< recover: the time at which it was written, for people
  PathPrompt file = PathPrompt::save_as;  ///< overwrite: what the file is to hold
};

/// What a drag holds on to. All of it is from the moment of the press, so that a drag is a pure function of where the
/// pointer is now and does not depend on the way there.
struct Drag {
  Target target;          ///< what was pressed on
  bool pans = false;      ///< moves the plan under the pointer; else the target
  Vec2d grabbed_px{0.0};  ///< where the pointer was pressed, pixels
  Vec2d grabbed{0.0};     ///< the same in scene units
  PlanCamera camera;      ///< as it was
  bool aims = false;      ///< the arrow of a guess
  bool moved = false;     ///< beyond the few pixels that a click trembles
  /// As it was; null while nothing of it has moved.
  std::shared_ptr<const Scene> scene{};
};

/// STEP or BACK is held down: the longer, the faster it goes.
struct Hold {
  bool forward = true;
  double seconds = 0;  ///< so far
  double owed = 0;     ///< steps due from ticks, below 1 between ticks
};

/// A ray grows, or shrinks to the end that was found, after a step forward; see view/tween.h.
struct Tween {
  int ray = 0;         ///< index in Timeline::rays()
  int from = 0;        ///< the position that the step came from
  double seconds = 0;  ///< so far
};

/// Which edit an entry of undo came from: edits that continue each other have equal marks.
struct EditMark {
  std::size_t edit = 0;  ///< index in Action
  int index = -1;
  friend bool operator==(const EditMark&, const EditMark&) = default;
};

struct State {
  // The scene and where it is kept.
  SceneDocument document;
  std::string path;                ///< empty: never saved
  std::optional<Scene> saved;      ///< the scene as the file holds it; absent: as document.scene
  bool dirty = false;              ///< document.scene differs from saved_scene
  std::uint64_t revision = 0;      ///< changes with every change of document.scene: the 3-D image is rendered anew
  std::vector<Scene> undo, redo;   ///< last in, first out; bounded (undo_entries, undo_bytes)
  std::shared_ptr<Worlds> worlds;  ///< of document.scene; another with each change of it, so that copies may share it
  Stop stop{};  ///< what an update takes long for may be ended by this: it throws Stopped, and the state is of no use
                ///< then
  std::optional<EditMark> last_edit;
  std::vector<std::string> recent;  ///< paths, the latest first
  std::vector<std::string> keeps;   ///< files of the command line that nothing may replace, such as that of a demo
  /// Folder for the autosave and the list of recent files; empty: neither is kept.
  std::string state_dir;
  /// Where this sitting's autosave goes: a name in state_dir that was free at the start.
  std::string autosave_file = "autosave.toml";
  double autosave_in = 0;  ///< seconds until the next autosave may be written
  std::uint64_t autosaved_revision = 0;

  // Playback.
  Mode mode = Mode::move;
  Mode before_help = Mode::trace;            ///< where one goes back to from the help
  std::shared_ptr<const Timeline> timeline;  ///< of the strip; never null once made by make_state
  int position = 0;                          ///< 0..timeline->steps()
  bool playing = false;
  double lines_per_second = 4;  ///< of AUTO; in grains ray and pixel: rays or pixels a second
  double owed = 0;              ///< steps due from ticks, below 1 between ticks
  Grain grain = Grain::line;
  std::optional<Hold> hold;
  bool tweens = false;  ///< steps are shown in motion, for a moment
  std::optional<Tween> tween;
  Breakpoints breakpoints;
  bool shows_ghosts = false;             ///< in Trace: what the limits cut off of the pixel under way
  std::shared_ptr<const Ghosts> ghosts;  ///< these; null while they are not shown

  // Space.
  std::optional<PixelWalk> walk;       ///< absent: the strip is walked
  bool planar = true;                  ///< the scene's strip is a row of its picture
  std::optional<Camera> image_camera;  ///< the picture seen from elsewhere; absent: as the scene's camera sees it
  std::optional<Camera> lines_camera;  ///< absent: the whole scene, overlooked
  std::optional<bool> lines_wanted;    ///< chosen by hand; absent: lines where the plan cannot show what is walked
  SpaceView turned_last = SpaceView::image;  ///< or asked for last: what the keys turn
  ImageSettings image;
  std::uint64_t image_revision = 0;  ///< changes with every change of image_camera and image

  // Pointing.
  Viewport viewport;
  PlanCamera camera;
  Target selected;
  Target hovered;                    ///< under the pointer in the plan
  int hovered_ray = -1;              ///< pointed at in plan or tree; lights up in plan, tree and code
  std::optional<Line> hovered_line;  ///< pointed at in the code; lights up its ray in plan and tree
  std::optional<Vec2d> pointer;      ///< pixels of the plan; none when it is elsewhere
  std::optional<Drag> drag;

  // Appearance.
  Theme theme = Theme::dark;
  Language language{};
  double ui_scale = 1;  ///< min_ui_scale..max_ui_scale
  Tab tab = Tab::image;
  CostState cost;
  double magnified = 0;  ///< of the microscope: see action::Magnify
  StructureSitting structure;

  LessonSitting lessons;
  Predictions predictions;

  std::optional<Bug> bug;  ///< what is wrong with the tracer now: put there by a hunt or by a lesson's step
  BugSitting bugs;

  // Talk.
  std::optional<Question> question;
  PathPrompt prompt = PathPrompt::none;
  std::optional<WindowExport> window_export;  ///< the window writes this as soon as it can
  std::optional<Intent> after_save;           ///< goes on with this once SaveAs has succeeded
  std::string after_save_path;                ///< of Intent::open
  std::optional<Notice> notice;
  bool quit = false;  ///< the window closes now

  [[nodiscard]] const Scene& scene() const { return document.scene; }
};

inline constexpr double min_ui_scale = 1, max_ui_scale = 3;
inline constexpr double min_speed = 0.25, max_speed = 2000;  ///< lines a second
inline constexpr std::size_t undo_entries = 256;
inline constexpr std::size_t undo_bytes = 64 << 20;  ///< of undo and redo together, roughly
inline constexpr double autosave_every = 5;          ///< seconds

/// A state that shows `document`, fitted to the viewport, at position 0.
[[nodiscard]] State make_state(SceneDocument document, std::string path = {}, std::string state_dir = {},
                               const Stop& stop = {});

/// Reads the list of recent files and looks for an autosave in state.state_dir; when there is one, asks whether to
/// recover it. To be called once at the start.
void restore_session(State& state);

/// The scene as the file holds it.
[[nodiscard]] const Scene& saved_scene(const State& state);
/// The camera of the 3-D picture.
[[nodiscard]] const Camera& image_camera(const State& state);
/// Puts what was chosen in place of what the scene says. Beside a bug everything is naive: that is what it breaks.
void choose(const State& state, RenderChoices& choices);
/// The scene as the 3-D picture shows it.
[[nodiscard]] SceneSeen pictured_scene(const State& state);
/// The scene as it is walked.
[[nodiscard]] SceneSeen walked_scene(const State& state);
/// Whether the scene is shown as lines in space where the plan stands otherwise.
[[nodiscard]] bool shows_lines(const State& state);

/// Steps a second after STEP has been held for so long.
[[nodiscard]] double hold_rate(double seconds);
/// The breakpoints that stop a walk now: none where the lesson that is open has switched them off.
[[nodiscard]] Breakpoints breakpoints_in_force(const State& state);

/// The strip's column of the pixel under way (or just put), or -1; -1 also while a pixel of the picture is walked.
[[nodiscard]] int current_cell(const State& state);

/// Whether there is unsaved work that the autosave does not hold. The scene of a hunt is nobody's work.
[[nodiscard]] bool wants_autosave(const State& state);

/// The file's name as a title bar shows it: without folders, "Untitled" when never saved, "*" in front when dirty.
[[nodiscard]] std::string document_title(const State& state);

}  // namespace raywalk
