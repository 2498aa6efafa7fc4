#pragma once
// User actions. A window turns clicks and keys into actions; a demo file and tests pass them directly.

#include "view/export.h"
#include "view/microscope.h"
#include "view/state.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace raywalk {

namespace action {

// Modes and playback.
struct SetMode {
  Mode mode;
};
struct Step {
  bool forward = true;
  std::optional<Grain> grain{};
};  ///< without a grain: State::grain
struct Jump {
  int position;
};  ///< clamped to the timeline
struct JumpToRay {
  int ray;
};  ///< to just after it was formed
struct JumpToCell {
  int cell;
};  ///< to the first line of that pixel
struct RunToLine {
  Line line;
};  ///< until this line has run again, else to the end
struct RunOn {
  bool forward = true;
};  ///< to the next or previous breakpoint, else to the end or the start
struct ToggleBreakpoint {
  Line line;
};
struct SetBreakpoints {
  Breakpoints breakpoints;
};
struct Hold {
  bool forward = true;
};  ///< STEP or BACK is held down: repeats, faster and faster, until Release, a step, or a breakpoint
struct Release {};
struct PlayPause {};
struct SetSpeed {
  double lines_per_second;
};  ///< clamped
struct SetGrain {
  Grain grain;
};
struct Clear {};  ///< back to step 0: rays and cells are cleared, AUTO stops
struct Tick {
  double seconds;
};  ///< time has passed: drives AUTO and the autosave

// The pointer on the plan, in pixels of the viewport.
struct Modifiers {
  bool shift = false, control = false, alt = false;
};
enum class Button { left, middle, right };
struct ResizePlan {
  Viewport viewport;
};
struct PointerMoved {
  Vec2d at;
  Modifiers modifiers{};
};
struct PointerPressed {
  Vec2d at;
  Button button = Button::left;
  Modifiers modifiers{};
  bool double_click = false;
};
struct PointerReleased {
  Vec2d at;
  Modifiers modifiers{};
};
struct PointerLeft {};
struct CancelDrag {};  ///< undoes the drag
struct Zoom {
  Vec2d at;
  double factor;
};  ///< the point at `at` stays fixed
struct Pan {
  Vec2d by;
};  ///< pixels
struct FitView {};

// Space: the 3-D picture and the line view.
struct WalkPixel {
  int column = 0, row = 0;
  ImageSize size{};  ///< of the picture
};  ///< walks this pixel of the picture, as currently seen: to its end, with its tree; if it is on the strip: goes
    ///< there
struct WalkStrip {};  ///< back to SCREEN
struct Orbit {
  SpaceView view;
  Vec2d angles;
};  ///< radians: see orbited
struct Shift {
  SpaceView view;
  Vec2d parts;
};  ///< parts of the view's width, to the right and down
struct Approach {
  SpaceView view;
  double factor;
};
struct ResetView {
  SpaceView view;
};
struct UseImageCamera {};  ///< the picture's camera becomes the scene's; one undo entry
struct ShowLines {
  bool shown;
};
struct SetTweens {
  bool on;
};
struct ShowGhosts {
  bool shown;
};  ///< the rays that depth and threshold cut off
struct SetImageSettings {
  ImageSettings settings;
};

// Pointing at things in other panels.
struct HoverRay {
  int ray;
};  ///< -1: none
struct HoverLine {
  std::optional<Line> line;
};
struct Select {
  Target target;
};

// Edits. Each is one undo entry; with `continues` it joins the previous entry, if that was the same edit of the same
// thing (a dragged slider). An edit that would make the scene invalid is refused with a notice that says why.
enum class ObjectKind { solid_sphere, transparent_sphere, polygon, light };
struct AddObject {
  ObjectKind kind;
};
struct RemoveSelected {};  ///< an object, a light, or a corner
struct InsertCorner {
  int object;
  int edge;
  Vec2d at;
};  ///< `at` in scene units
struct RemoveCorner {
  int object;
  int corner;
};
struct Rename {
  Target target;
  std::string name;
};  ///< an object or a light
struct SetMaterial {
  int object;
  Material material;
  bool continues = false;
};
struct SetShape {
  int object;
  ObjectShape shape;
  bool continues = false;
};
struct SetLight {
  int light;
  Light value;
  bool continues = false;
};
struct SetCamera {
  Camera camera;
  bool continues = false;
};
struct SetLimits {
  TraceLimits limits;
  bool continues = false;
};
struct SetNumerics {
  Numerics numerics;
  double epsilon;
  bool continues = false;
};  ///< of the scene: affects walk, picture and file
struct SetSurroundings {
  Rgbd background, ambient;
  bool continues = false;
};
struct Nudge {
  Vec2d direction;
  bool coarse = false;
};  ///< arrow keys: one fine or coarse step, x right, y up
struct Undo {};
struct Redo {};

// Files.
struct New {};
struct Open {
  std::string path;
};
struct Save {};  ///< asks for a path if there is none
struct SaveAs {
  std::string path;
};
struct AskOpen {};
struct AskSaveAs {};
struct CancelPrompt {};
enum class Answer { save, discard, recover, cancel };
struct AnswerQuestion {
  Answer answer;
};
struct Quit {};
struct Wait {
  double seconds;
};  ///< pauses a demo

// Appearance.
struct SetTheme {
  Theme theme;
};
struct SetLanguage {
  std::string code;
};  ///< of interface, lessons and bugs: "pt"
struct SetUiScale {
  double scale;
};  ///< clamped
struct SetTab {
  Tab tab;
};
struct DismissNotice {};

// Lessons.
struct ShowLessons {
  bool shown;
};
struct OpenLesson {
  std::string name;
};  ///< at the first unfinished step; asks first if there is unsaved work
struct LeaveLesson {};  ///< back to the list, and to the previous scene
struct GoToLessonStep {
  int step;
};  ///< from 0; past the last: finished, back to the list. Not past an unanswered question
struct GuessChoice {
  int choice;
};  ///< from 0
struct GuessNumber {
  double number;
};  ///< not finite: withdrawn. Arrows are dragged
struct RevealLesson {};  ///< shows the answer to the guess; a line is guessed by MarkLine
struct ShowHands {
  int choice, hands;
};  ///< change of the number of hands for a lesson's choice
struct SetLessonOptions {
  bool presenter = false, unlocked = false, without_notes = false;
};

// Spot the bug. Actions on the scene itself (open, save, new, quit, a lesson) leave the hunt first.
struct ShowBugs {
  bool shown;
};  ///< hiding them leaves the hunt
struct HuntBug {
  int number;
  bool surprise = false;
};  ///< from 1, in all_faults
struct MarkLine {
  Line line;
};  ///< as the one at fault
struct JudgeLine {};  ///< judges the marked line
struct ShowCure {};   ///< gives up
struct MendBug {
  bool mended;
};  ///< once it is known
struct LeaveHunt {};  ///< restores the previous state

// The accelerators, stepped (view/structure.h).
struct ChooseStructure {
  AcceleratorKind kind;
};  ///< one of watched_accelerators; its search and its build are at the start, or at the end if the other was
struct ShowStructurePage {
  StructurePage page;
};
struct GoInStructure {
  int step;
};  ///< of the open page; clamped

}  // namespace action

using Action = std::variant<
    action::SetMode, action::Step, action::Jump, action::JumpToRay, action::JumpToCell, action::RunToLine,
    action::RunOn, action::ToggleBreakpoint, action::SetBreakpoints, action::Hold, action::Release, action::PlayPause,
    action::SetSpeed, action::SetGrain, action::Clear, action::Tick, action::ResizePlan, action::PointerMoved,
    action::PointerPressed, action::PointerReleased, action::PointerLeft, action::CancelDrag, action::Zoom, action::Pan,
    action::FitView, action::WalkPixel, action::WalkStrip, action::Orbit, action::Shift, action::Approach,
    action::ResetView, action::UseImageCamera, action::ShowLines, action::ShowGhosts, action::SetTweens,
    action::SetImageSettings, action::HoverRay, action::HoverLine, action::Select, action::AddObject,
    action::RemoveSelected, action::InsertCorner, action::RemoveCorner, action::Rename, action::SetMaterial,
    action::SetShape, action::SetLight, action::SetCamera, action::SetLimits, action::SetNumerics,
    action::SetSurroundings, action::Nudge, action::Undo, action::Redo, action::New, action::Open, action::Save,
    action::SaveAs, action::AskOpen, action::AskSaveAs, action::CancelPrompt, action::AnswerQuestion, action::Quit,
    action::SetTheme, action::SetLanguage, action::SetUiScale, action::SetTab, action::DismissNotice,
    action::ShowLessons, action::OpenLesson, action::LeaveLesson, action::GoToLessonStep, action::GuessChoice,
    action::GuessNumber, action::RevealLesson, action::ShowHands, action::SetLessonOptions, action::SetCostKnobs,
    action::TryCost, action::ForgetCosts, action::ChooseCost, action::ShowCosts, action::ShowCostPage, action::ShowBugs,
    action::HuntBug, action::MarkLine, action::JudgeLine, action::ShowCure, action::MendBug, action::LeaveHunt,
    action::Magnify, action::SetPredictions, action::GuessWay, action::GuessEnd, action::AskSavePredictions,
    action::AskExport, action::Export, action::FinishExport, action::Wait, action::SavePredictions,
    action::ChooseStructure, action::ShowStructurePage, action::GoInStructure>;

/// Applies an action. Any action in any state leads to a valid state (view/state.h), with a scene that could be saved.
/// Numbers that are not finite are ignored. While a question or a path prompt is open, only answers, appearance, ticks
/// and resizing have an effect.
void update(State& state, const Action& action);

/// Whether `target` exists in the state's scene and timeline.
[[nodiscard]] bool exists(const State& state, const Target& target);

}  // namespace raywalk
