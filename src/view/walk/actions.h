#pragma once
// Actions on the walk: modes, steps, playback, breakpoints.

#include "view/fields.h"
#include "view/state.h"

#include <optional>

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
  std::optional<Grain> grain{};  ///< absent: State::grain
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
struct SetBreakpoints {
  Breakpoints breakpoints;
  static void fields(auto& f, auto& a) { f(a.breakpoints, Unwritten{}); }
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

using OfWalk = Types<SetMode, Step, Jump, JumpToRay, JumpToCell, RunToLine, RunOn, ToggleBreakpoint, SetBreakpoints,
                     Hold, Release, PlayPause, SetSpeed, SetGrain, Clear, Tick, Wait, ShowGhosts, SetTweens>;

}  // namespace raywalk::action
