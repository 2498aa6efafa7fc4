#include "view/action.h"
#include "view/document/document.h"
#include "view/lesson/lesson.h"
#include "view/plan/pointer.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

int stepped(const Timeline& timeline, int position, Grain grain, bool forward) {
  switch (grain) {
    case Grain::line:
      return std::clamp(position + (forward ? 1 : -1), 0, timeline.steps());
    case Grain::ray:
      return forward ? timeline.next_ray(position) : timeline.previous_ray(position);
    case Grain::pixel:
      return forward ? timeline.next_pixel(position) : timeline.previous_pixel(position);
    case Grain::over:
      return forward ? step_over(timeline, position) : step_back_over(timeline, position);
    case Grain::out:
      return forward ? step_out(timeline, position) : step_back_out(timeline, position);
  }
  return position;
}

namespace {

/// Where a step forward to `to` stops: at a breakpoint before it, or where a ray is to be predicted.
int stopped(const State& state, int to) {
  const Breakpoints breakpoints = breakpoints_in_force(state);
  const int stop = breakpoints.any() && to > state.position + 1
                       ? next_stop(breakpoints, state.scene(), *state.timeline, state.position, to)
                       : to;
  for (int rest = state.position + 1; state.predictions.on && rest < stop; ++rest)
    if (rests_for_prediction(state, rest)) return rest;
  return stop;
}

/// Whether an automatic walk pauses here.
bool stops_here(const State& state) {
  return stops_at(breakpoints_in_force(state), state.scene(), *state.timeline, state.position) ||
         rests_for_prediction(state, state.position) || question_waits(state);
}

}  // namespace

void go_to(State& state, int position) {
  state.playing = false;
  state.hold.reset();
  state.mode = Mode::trace;
  state.position = std::clamp(position, 0, state.timeline->steps());
}

void action::Step::apply(State& state) const {
  if (forward && answered_by_step(state)) return;
  // Releasing a held button does not step again.
  if (state.hold) return go_to(state, state.position);
  const int to = stepped(*state.timeline, state.position, grain.value_or(state.grain), forward);
  go_to(state, forward ? stopped(state, to) : to);
}

void action::Jump::apply(State& state) const { go_to(state, position); }

void action::JumpToRay::apply(State& state) const {
  if (exists(state, {TargetKind::ray, ray}))
    go_to(state, state.timeline->rays()[static_cast<std::size_t>(ray)].formed_at);
}

void action::JumpToCell::apply(State& state) const {
  walk_strip(state);
  for (const PixelRecord& pixel : state.timeline->pixels())
    if (pixel.column == cell) return go_to(state, pixel.begun_at);
}

void action::RunToLine::apply(State& state) const {
  int position = state.position;
  do ++position;
  while (position < state.timeline->steps() && state.timeline->just_run(position)->line != line);
  go_to(state, stopped(state, std::min(position, state.timeline->steps())));
}

void action::RunOn::apply(State& state) const {
  const Timeline& timeline = *state.timeline;
  go_to(state, forward ? stopped(state, timeline.steps())
                       : previous_stop(breakpoints_in_force(state), state.scene(), timeline, state.position));
}

void action::ToggleBreakpoint::apply(State& state) const {
  bool& before = state.breakpoints.before[static_cast<std::size_t>(line)];
  before = !before;
}

void action::SetBreakpoints::apply(State& state) const { state.breakpoints = breakpoints; }

void action::SetMode::apply(State& state) const {
  if (mode == Mode::help && state.mode != Mode::help) state.before_help = state.mode;
  state.mode = mode;
  if (mode != Mode::trace) {
    state.playing = false;
    state.hold.reset();
  }
  hover(state);
}

void action::Hold::apply(State& state) const {
  if (forward && question_waits(state)) return;
  go_to(state, state.position);
  state.hold = raywalk::Hold{forward};
}

void action::Release::apply(State& state) const { state.hold.reset(); }

void action::PlayPause::apply(State& state) const {
  if (!state.playing && answered_by_step(state)) return;
  state.owed = 0;
  state.hold.reset();
  state.mode = Mode::trace;
  const bool at_end = state.position == state.timeline->steps();
  state.playing = !state.playing && !at_end;
}

void action::SetSpeed::apply(State& state) const {
  state.lines_per_second = std::clamp(lines_per_second, min_speed, max_speed);
}

void action::SetGrain::apply(State& state) const { state.grain = grain; }

void action::Clear::apply(State& state) const { go_to(state, 0); }

void action::ShowGhosts::apply(State& state) const {
  state.shows_ghosts = shown;
  if (shown) state.mode = Mode::trace;
}

void action::SetTweens::apply(State& state) const { state.tweens = on; }

namespace {

void play_held(State& state, double seconds) {
  Hold& hold = *state.hold;
  hold.seconds += seconds;
  hold.owed += seconds * hold_rate(hold.seconds);
  const Timeline& timeline = *state.timeline;
  const bool forward = hold.forward;
  const int end = forward ? timeline.steps() : 0;
  for (; hold.owed >= 1 && state.position != end; hold.owed -= 1) {
    const int to = stepped(timeline, state.position, state.grain, forward);
    const int rest = forward ? stopped(state, to) : to;
    state.position = rest;
    if (forward && (rest != to || stops_here(state))) return state.hold.reset();
  }
  if (state.position == end) state.hold.reset();
}

/// AUTO, or a button that is held down.
void play(State& state, double seconds) {
  // After a long delay, not all of it is made up for.
  seconds = std::min(seconds, 1.0);
  if (state.hold) return play_held(state, seconds);
  if (!state.playing) return;
  state.owed += seconds * state.lines_per_second;
  while (state.owed >= 1 && state.playing) {
    state.owed -= 1;
    const int to = stepped(*state.timeline, state.position, state.grain, true);
    const int rest = stopped(state, to);
    state.position = rest;
    if (rest == state.timeline->steps() || rest != to || stops_here(state)) state.playing = false;
  }
}

}  // namespace

void action::Tick::apply(State& state) const {
  if (state.tween) state.tween->seconds += seconds;
  play(state, seconds);
  autosave(state, seconds);
}

double hold_rate(double seconds) {
  // Starts at clicking speed, doubled every second.
  constexpr double slowest = 6, fastest = 600;
  return std::min(slowest * std::exp2(seconds), fastest);
}

Breakpoints breakpoints_in_force(const State& state) {
  const PlayedStep* step = state.lessons.shown ? state.lessons.at() : nullptr;
  return step != nullptr && !step->step->breakpoints ? Breakpoints{} : state.breakpoints;
}

}  // namespace raywalk
