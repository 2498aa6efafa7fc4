#pragma once
// The whole state of the visualiser. It changes only through update(state, action) of view/action.h; the screen is a
// pure function of it.

#include "io/scene_file.h"
#include "math/stop.h"
#include "render/heat.h"
#include "render/world_cache.h"
#include "text/language.h"
#include "timeline/stops.h"
#include "timeline/timeline.h"
#include "view/bugs/bugs.h"
#include "view/cost/cost.h"
#include "view/document/scene_seen.h"
#include "view/drawing/display_list.h"
#include "view/export/export.h"
#include "view/lesson/lesson_sitting.h"
#include "view/predict/predict.h"
#include "view/structure/structure.h"
#include "view/walk/fault.h"
#include "view/walk/ghosts.h"
#include "view/words.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

enum class Mode { move, trace, help };
template <>
inline constexpr Word<Mode> words_of<Mode>[] = {{Mode::move, "move"}, {Mode::trace, "trace"}, {Mode::help, "help"}};
/// The length of a step: a line of pseudocode, to the next ray, to the next pixel; over a line and any SHADE that it
/// calls, out of the current SHADE.
enum class Grain { line, ray, pixel, over, out };
template <>
inline constexpr Word<Grain> words_of<Grain>[] = {
    {Grain::line, "line"}, {Grain::ray, "ray"}, {Grain::pixel, "pixel"}, {Grain::over, "over"}, {Grain::out, "out"}};
enum class Tab { image, tree, stack, legend, equation, cost, microscope, structure };
template <>
inline constexpr Word<Tab> words_of<Tab>[] = {
    {Tab::image, "image"}, {Tab::tree, "tree"},         {Tab::stack, "stack"},           {Tab::legend, "legend"},
    {Tab::cost, "cost"},   {Tab::equation, "equation"}, {Tab::microscope, "microscope"}, {Tab::structure, "structure"}};

/// The pane that shows the plan, in pixels.
struct Viewport {
  double width = 640, height = 480;
  friend bool operator==(const Viewport&, const Viewport&) = default;
};

/// Settings of the 3-D picture, not stored in the scene's file.
struct ImageSettings {
  AcceleratorKind accelerator{};           ///< automatic
  bool single_precision = false;           ///< 24-bit mantissas instead of 53, also for the walk
  int samples = 16;                        ///< final number per pixel, 1..max_image_samples
  std::optional<Integrator> integrator{};  ///< absent: the scene's own
  int walk_samples = 1;                    ///< per walked pixel, 1..max_walk_samples
  Heat heat = Heat::none;
  friend bool operator==(const ImageSettings&, const ImageSettings&) = default;
};
inline constexpr int max_image_samples = 1024, max_walk_samples = 256;

/// A pixel of the 3-D picture that is walked instead of the strip.
struct PixelWalk {
  ImageSize size;  ///< of the picture
  int column = 0, row = 0;
  std::optional<Camera> camera{};  ///< absent: the scene's own
  friend bool operator==(const PixelWalk&, const PixelWalk&) = default;
};

/// The views that can be turned by hand.
enum class SpaceView {
  image,  ///< the 3-D picture
  lines,  ///< the scene as lines in space, instead of the plan
};
template <>
inline constexpr Word<SpaceView> words_of<SpaceView>[] = {{SpaceView::image, "image"}, {SpaceView::lines, "lines"}};

/// The visible part of the plan.
struct PlanCamera {
  Vec2d centre{0.0};            ///< scene units, in the middle of the pane
  double pixels_per_unit = 50;  ///< > 0
  bool fitted = true;           ///< follows the pane's size until zoomed or panned by hand
  friend bool operator==(const PlanCamera&, const PlanCamera&) = default;
};

/// A one-line message, until the next one.
struct Notice {
  enum class Kind { info, error };
  Kind kind = Kind::info;
  std::string text;
};

/// A request made while there was unsaved work.
enum class Intent { new_scene, open, lesson, leave_lesson, quit };

/// A path that the window must ask for; answered by the action of that name, or by CancelPrompt.
enum class PathPrompt { none, open, save_as, save_predictions, export_walk };

struct Question {
  enum class Kind {
    unsaved,    ///< answers: save, discard, cancel
    recover,    ///< an autosave was found at the start; answers: recover, discard, cancel (asks at the next start)
    overwrite,  ///< the file to be written exists; answers: save, cancel
  };
  Kind kind = Kind::unsaved;
  Intent intent = Intent::quit;  ///< continues with this after save or discard
  std::string path;        ///< of Intent::open, the name of a lesson, of the file that the autosave belongs to (may be
                           ///< empty), or to overwrite
  std::string autosave{};  ///< recover: the autosave
  std::string when{};      ///< recover: when it was written, as text
  PathPrompt file = PathPrompt::save_as;  ///< overwrite: the contents of the file
};

/// The state at the start of a drag, so that a drag is a pure function of the current pointer position, independent of
/// its path.
struct Drag {
  Target target;          ///< the pressed target
  bool pans = false;      ///< moves the plan under the pointer; else the target
  Vec2d grabbed_px{0.0};  ///< where the pointer was pressed, pixels
  Vec2d grabbed{0.0};     ///< the same in scene units
  PlanCamera camera;      ///< at the start
  bool aims = false;      ///< drags the arrow of a guess
  bool moved = false;     ///< beyond the jitter of a click
  /// At the start; null while nothing has moved.
  std::shared_ptr<const Scene> scene{};
};

/// STEP or BACK is held down, with increasing speed.
struct Hold {
  bool forward = true;
  double seconds = 0;  ///< so far
  double owed = 0;     ///< steps due from ticks, below 1 between ticks
};

/// A ray grows, or shrinks to its found end, after a step forward; see view/tween.h.
struct Tween {
  int ray = 0;         ///< index in Timeline::rays()
  int from = 0;        ///< the position before the step
  double seconds = 0;  ///< so far
};

/// An undo entry's edit: edits that continue each other have equal marks.
struct EditMark {
  std::size_t edit = 0;  ///< index in Action
  int index = -1;
  friend bool operator==(const EditMark&, const EditMark&) = default;
};

struct State {
  // The scene and its file.
  SceneDocument document;
  std::string path;               ///< empty: never saved
  std::optional<Scene> saved;     ///< the scene as the file holds it; absent: as document.scene
  bool dirty = false;             ///< document.scene differs from saved_scene
  std::uint64_t revision = 0;     ///< incremented with every change of document.scene, to restart the 3-D image
  std::vector<Scene> undo, redo;  ///< last in, first out; bounded (undo_entries, undo_bytes)
  std::shared_ptr<WorldCache>
      worlds;   ///< of document.scene; replaced with each change of it, so that copies may share it
  Stop stop{};  ///< cancels a long update: it throws Stopped, and the state is then invalid
  std::optional<EditMark> last_edit;
  std::vector<std::string> recent;  ///< paths, most recent first
  std::vector<std::string> keeps;   ///< files of the command line that must not be replaced, such as a demo
  /// Folder for the autosave and the list of recent files; empty: neither is kept.
  std::string state_dir;
  /// This session's autosave: a name in state_dir that was unused at the start.
  std::string autosave_file = "autosave.toml";
  double autosave_in = 0;  ///< seconds until the next autosave may be written
  std::uint64_t autosaved_revision = 0;

  // Playback.
  Mode mode = Mode::move;
  Mode before_help = Mode::trace;            ///< the mode to return to from the help
  std::shared_ptr<const Timeline> timeline;  ///< of the strip; never null once made by make_state
  int position = 0;                          ///< 0..timeline->steps()
  bool playing = false;
  double lines_per_second = 4;  ///< of AUTO; with grains ray and pixel: rays or pixels per second
  double owed = 0;              ///< steps due from ticks, below 1 between ticks
  Grain grain = Grain::line;
  std::optional<Hold> hold;
  bool tweens = false;  ///< steps are animated briefly
  std::optional<Tween> tween;
  Breakpoints breakpoints;
  bool shows_ghosts = false;             ///< in Trace: what the limits cut off in the current pixel
  std::shared_ptr<const Ghosts> ghosts;  ///< null while not shown

  // Space.
  std::optional<PixelWalk> walk;             ///< absent: the strip is walked
  bool planar = true;                        ///< the scene's strip is a row of its picture
  std::optional<Camera> image_camera;        ///< the picture's own camera; absent: the scene's
  std::optional<Camera> lines_camera;        ///< absent: shows the whole scene
  std::optional<bool> lines_wanted;          ///< chosen by hand; absent: lines if the plan cannot show the walk
  SpaceView turned_last = SpaceView::image;  ///< or selected last: what the keys turn
  ImageSettings image;
  std::uint64_t image_revision = 0;  ///< changes with every change of image_camera and image

  // Pointing.
  Viewport viewport;
  PlanCamera camera;
  Target selected;
  Target hovered;                    ///< under the pointer in the plan
  int hovered_ray = -1;              ///< hovered in plan or tree; highlighted in plan, tree and code
  std::optional<Line> hovered_line;  ///< hovered in the code; highlights its ray in plan and tree
  std::optional<Vec2d> pointer;      ///< pixels of the plan; none if it is elsewhere
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

  std::optional<Bug> bug;  ///< the tracer's current fault: from a hunt or a lesson's step
  BugSitting bugs;

  // Talk.
  std::optional<Question> question;
  PathPrompt prompt = PathPrompt::none;
  std::optional<WindowExport> window_export;  ///< pending in the window
  std::optional<Intent> after_save;           ///< continues with this once SaveAs has succeeded
  std::string after_save_path;                ///< of Intent::open
  std::optional<Notice> notice;
  bool quit = false;  ///< the window closes now

  [[nodiscard]] const Scene& scene() const { return document.scene; }
};

inline constexpr double min_ui_scale = 1, max_ui_scale = 3;
inline constexpr double min_speed = 0.25, max_speed = 2000;  ///< lines per second
inline constexpr std::size_t undo_entries = 256;
inline constexpr std::size_t undo_bytes = 64 << 20;  ///< of undo and redo together, roughly
inline constexpr double autosave_every = 5;          ///< seconds

/// A state that shows `document`, fitted to the viewport, at position 0.
[[nodiscard]] State make_state(SceneDocument document, std::string path = {}, std::string state_dir = {},
                               const Stop& stop = {});

/// Reads the list of recent files and looks for an autosave in state.state_dir; if there is one, asks whether to
/// recover it. To be called once at the start.
void restore_session(State& state);

/// The scene as stored in the file.
[[nodiscard]] const Scene& saved_scene(const State& state);
/// The camera of the 3-D picture.
[[nodiscard]] const Camera& image_camera(const State& state);
/// Overrides the scene's settings with the user's choices. With a bug, numerics are naive: faults exist only there.
void choose(const State& state, RenderChoices& choices);
/// The scene of the 3-D picture.
[[nodiscard]] SceneSeen pictured_scene(const State& state);
/// The scene of the walk.
[[nodiscard]] SceneSeen walked_scene(const State& state);
/// Whether the scene is shown as lines in space instead of the plan.
[[nodiscard]] bool shows_lines(const State& state);

/// Steps per second after holding STEP for this long.
[[nodiscard]] double hold_rate(double seconds);
/// The active breakpoints: none if the open lesson has disabled them.
[[nodiscard]] Breakpoints breakpoints_in_force(const State& state);

/// The strip's column of the current pixel (or the one just put), or -1; also -1 while a pixel of the picture is
/// walked.
[[nodiscard]] int current_cell(const State& state);

/// Whether there is unsaved work that is not in the autosave. The scene of a hunt does not count.
[[nodiscard]] bool wants_autosave(const State& state);

/// The file's name for the title bar: without folders, "Untitled" if never saved, with "*" in front if dirty.
[[nodiscard]] std::string document_title(const State& state);

}  // namespace raywalk
