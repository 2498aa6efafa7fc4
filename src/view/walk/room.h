#pragma once
// The walk: modes, steps, playback, breakpoints.

#include "scene/scene.h"
#include "timeline/stops.h"
#include "timeline/timeline.h"
#include "view/fields.h"
#include "view/room.h"
#include "view/walk/fault.h"
#include "view/walk/ghosts.h"

#include <memory>
#include <optional>

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
/// A pixel of the 3-D picture that is walked instead of the strip.
struct PixelWalk {
  ImageSize size;  ///< of the picture
  int column = 0, row = 0;
  std::optional<Camera> camera{};  ///< absent: the scene's own
  friend bool operator==(const PixelWalk&, const PixelWalk&) = default;
};

/// STEP or BACK is held down, with increasing speed.
struct Hold {
  bool forward = true;
  double seconds = 0;  ///< so far
  double owed = 0;     ///< steps due from ticks, below 1 between ticks
};

/// A ray grows, or shrinks to its found end, after a step forward; see view/walk/tween.h.
struct Tween {
  int ray = 0;         ///< index in Timeline::rays()
  int from = 0;        ///< the position before the step
  double seconds = 0;  ///< so far
};

inline constexpr double min_speed = 0.25, max_speed = 2000;  ///< lines per second

}  // namespace raywalk

namespace raywalk::action {

struct SetMode {
  static constexpr std::string_view word = "mode";
  Mode mode;
  static void fields(auto& f, auto& a) { f(a.mode); }
  void apply(State& state) const;
};
struct Step {
  static constexpr std::string_view word = "step";
  bool forward = true;
  std::optional<Grain> grain{};  ///< absent: WalkRoom::grain
  static void fields(auto& f, auto& a) { f(a.forward, forward_or_back), f(a.grain); }
  void apply(State& state) const;
};
struct Jump {
  static constexpr std::string_view word = "jump";
  int position;  ///< clamped to the timeline
  static void fields(auto& f, auto& a) { f(a.position); }
  void apply(State& state) const;
};
/// To just after it was formed.
struct JumpToRay {
  static constexpr std::string_view word = "jump-to-ray";
  int ray;
  static void fields(auto& f, auto& a) { f(a.ray); }
  void apply(State& state) const;
};
/// To the first line of that pixel.
struct JumpToCell {
  static constexpr std::string_view word = "jump-to-cell";
  int cell;
  static void fields(auto& f, auto& a) { f(a.cell); }
  void apply(State& state) const;
};
/// Until this line has run again, else to the end.
struct RunToLine {
  static constexpr std::string_view word = "run-to-line";
  Line line;
  static void fields(auto& f, auto& a) { f(a.line); }
  void apply(State& state) const;
};
/// To the next or previous breakpoint, else to the end or the start.
struct RunOn {
  static constexpr std::string_view word = "run-on";
  bool forward = true;
  static void fields(auto& f, auto& a) { f(a.forward, forward_or_back); }
  void apply(State& state) const;
};
struct ToggleBreakpoint {
  static constexpr std::string_view word = "breakpoint";
  Line line;
  static void fields(auto& f, auto& a) { f(a.line); }
  void apply(State& state) const;
};
/// Where else a walk stops: at a call of SHADE with a depth, where a pixel begins, under total internal reflection,
/// where a ray hits an object.
struct StopAt {
  static constexpr std::string_view word = "stop-at";
  int depth = 0;   ///< 0: nowhere
  int pixel = -1;  ///< -1: nowhere
  bool total_internal_reflection = false;
  int object = -1;  ///< -1: nowhere
  static void fields(auto& f, auto& a) {
    f(a.depth), f(a.pixel), f(a.total_internal_reflection, on_or_off), f(a.object);
  }
  void apply(State& state) const;
};
struct RemoveBreakpoints {
  static constexpr std::string_view word = "remove-breakpoints";
  void apply(State& state) const;
};
/// STEP or BACK is held down: repeats, faster and faster, until Release, a step, or a breakpoint.
struct Hold {
  static constexpr std::string_view word = "hold";
  bool forward = true;
  static void fields(auto& f, auto& a) { f(a.forward, forward_or_back); }
  void apply(State& state) const;
};
struct Release {
  static constexpr std::string_view word = "let-go";
  void apply(State& state) const;
};
struct PlayPause {
  static constexpr std::string_view word = "play-pause";
  void apply(State& state) const;
};
struct SetSpeed {
  static constexpr std::string_view word = "speed";
  double lines_per_second;  ///< clamped
  static void fields(auto& f, auto& a) { f(a.lines_per_second); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};
struct SetGrain {
  static constexpr std::string_view word = "grain";
  Grain grain;
  static void fields(auto& f, auto& a) { f(a.grain); }
  static constexpr Traits traits{.keeps_drag = true};
  void apply(State& state) const;
};
/// Back to step 0: rays and cells are cleared, AUTO stops.
struct Clear {
  static constexpr std::string_view word = "clear";
  void apply(State& state) const;
};
/// Time has passed: drives AUTO and the autosave.
struct Tick {
  static constexpr std::string_view word = "tick";
  double seconds;
  static void fields(auto& f, auto& a) { f(a.seconds, Number::not_negative); }
  static constexpr Traits traits{.keeps_drag = true, .keeps_tween = true, .always = true};
  void apply(State& state) const;
};
/// Pauses a demo.
struct Wait {
  static constexpr std::string_view word = "wait";
  double seconds;
  static void fields(auto& f, auto& a) { f(a.seconds, Number::any); }
  void apply(State&) const {}
};
/// The rays that depth and threshold cut off.
struct ShowGhosts {
  static constexpr std::string_view word = "ghosts";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  void apply(State& state) const;
};
struct SetTweens {
  static constexpr std::string_view word = "tweens";
  bool on;
  static void fields(auto& f, auto& a) { f(a.on, on_or_off); }
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// The recorded walk, the position in it, and how it is played.
struct WalkRoom {
  using Actions =
      Types<action::SetMode, action::Step, action::Jump, action::JumpToRay, action::JumpToCell, action::RunToLine,
            action::RunOn, action::ToggleBreakpoint, action::StopAt, action::RemoveBreakpoints, action::Hold,
            action::Release, action::PlayPause, action::SetSpeed, action::SetGrain, action::Clear, action::Tick,
            action::Wait, action::ShowGhosts, action::SetTweens>;
  static Commands commands();
  static void follow(State& state, const Before& before);

  Mode mode = Mode::move;
  Mode before_help = Mode::trace;            ///< the mode to return to from the help
  std::shared_ptr<const Timeline> timeline;  ///< of the strip or of `pixel`; never null once made by make_state
  std::optional<PixelWalk> pixel;            ///< absent: the strip is walked
  bool planar = true;                        ///< the scene's strip is a row of its picture
  std::optional<Bug> bug;                    ///< the tracer's current fault: from a hunt or a lesson's step
  int position = 0;                          ///< 0..timeline->steps()
  int strip_position = 0;                    ///< while `pixel` is walked: where the walk of the strip was
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
};

}  // namespace raywalk
