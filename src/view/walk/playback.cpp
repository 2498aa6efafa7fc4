#include "view/action.h"
#include "view/document/document.h"
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
  const int stop = breakpoints.any() && to > state.walk.position + 1
                       ? next_stop(breakpoints, state.scene(), *state.walk.timeline, state.walk.position, to)
                       : to;
  for (int rest = state.walk.position + 1; state.predictions.on && rest < stop; ++rest)
    if (rests_for_prediction(state, rest)) return rest;
  return stop;
}

/// Whether an automatic walk pauses here.
bool stops_here(const State& state) {
  return stops_at(breakpoints_in_force(state), state.scene(), *state.walk.timeline, state.walk.position) ||
         rests_for_prediction(state, state.walk.position) || question_waits(state);
}

}  // namespace

void go_to(State& state, int position) {
  state.walk.playing = false;
  state.walk.hold.reset();
  state.walk.mode = Mode::trace;
  state.walk.position = std::clamp(position, 0, state.walk.timeline->steps());
}

std::optional<action::WalkPixel> neighbour(const State& state, bool forward) {
  const std::optional<PixelWalk>& walk = state.walk.pixel;
  if (!walk || walk->camera != state.picture.camera) return std::nullopt;
  if (state.walk.position != (forward ? state.walk.timeline->steps() : 0)) return std::nullopt;
  const int next = walk->row * walk->size.width + walk->column + (forward ? 1 : -1);
  if (next < 0 || next >= walk->size.width * walk->size.height) return std::nullopt;
  return action::WalkPixel{next % walk->size.width, next / walk->size.width, walk->size};
}

namespace {

/// The answer to a lesson's question, for whoever has predicted it, or presents. Whoever may see it without a
/// prediction asks for that by Reveal.
void show_predicted(State& state) {
  if (state.lessons.guess.any() || state.lessons.presenter) return action::RevealLesson{}.apply(state);
  ask_to_predict(state);
}

}  // namespace

void action::Step::apply(State& state) const {
  if (forward && question_waits(state)) return show_predicted(state);
  // Releasing a held button does not step again.
  if (state.walk.hold) return go_to(state, state.walk.position);
  if (grain.value_or(state.walk.grain) == Grain::pixel)
    if (const auto next = neighbour(state, forward)) return next->apply(state);
  const int to = stepped(*state.walk.timeline, state.walk.position, grain.value_or(state.walk.grain), forward);
  go_to(state, forward ? stopped(state, to) : to);
}

void action::Jump::apply(State& state) const { go_to(state, position); }

void action::JumpToRay::apply(State& state) const {
  if (exists(state, {TargetKind::ray, ray}))
    go_to(state, state.walk.timeline->rays()[static_cast<std::size_t>(ray)].formed_at);
}

void action::JumpToCell::apply(State& state) const {
  walk_strip(state);
  for (const PixelRecord& pixel : state.walk.timeline->pixels())
    if (pixel.column == cell) return go_to(state, pixel.begun_at);
}

void action::RunToLine::apply(State& state) const {
  int position = state.walk.position;
  do ++position;
  while (position < state.walk.timeline->steps() && state.walk.timeline->just_run(position)->line != line);
  go_to(state, stopped(state, std::min(position, state.walk.timeline->steps())));
}

void action::RunOn::apply(State& state) const {
  const Timeline& timeline = *state.walk.timeline;
  go_to(state, forward ? stopped(state, timeline.steps())
                       : previous_stop(breakpoints_in_force(state), state.scene(), timeline, state.walk.position));
}

void action::ToggleBreakpoint::apply(State& state) const {
  bool& before = state.walk.breakpoints.before[static_cast<std::size_t>(line)];
  before = !before;
}

action::StopAt stops_chosen(const State& state) {
  const Breakpoints& now = state.walk.breakpoints;
  const std::vector<Object>& objects = state.scene().objects;
  const auto at = std::find_if(objects.begin(), objects.end(), [&](const Object& o) { return o.name == now.object; });
  return {now.depth.value_or(0), now.pixel.value_or(-1), now.total_internal_reflection,
          at == objects.end() ? -1 : static_cast<int>(at - objects.begin())};
}

void action::StopAt::apply(State& state) const {
  Breakpoints& next = state.walk.breakpoints;
  const std::vector<Object>& objects = state.scene().objects;
  next.depth = depth > 0 ? std::optional(depth) : std::nullopt;
  next.pixel = pixel >= 0 ? std::optional(pixel) : std::nullopt;
  next.total_internal_reflection = total_internal_reflection;
  const bool is_there = object >= 0 && object < static_cast<int>(objects.size());
  next.object = is_there ? objects[static_cast<std::size_t>(object)].name : std::string();
}

void action::RemoveBreakpoints::apply(State& state) const { state.walk.breakpoints = {}; }

void action::SetMode::apply(State& state) const {
  if (mode == Mode::help && state.walk.mode != Mode::help) state.walk.before_help = state.walk.mode;
  state.walk.mode = mode;
  if (mode != Mode::trace) {
    state.walk.playing = false;
    state.walk.hold.reset();
  }
  hover(state);
}

void action::Hold::apply(State& state) const {
  if (forward && question_waits(state)) return;
  go_to(state, state.walk.position);
  state.walk.hold = raywalk::Hold{forward};
}

void action::Release::apply(State& state) const { state.walk.hold.reset(); }

void action::PlayPause::apply(State& state) const {
  if (!state.walk.playing && question_waits(state)) return show_predicted(state);
  state.walk.owed = 0;
  state.walk.hold.reset();
  state.walk.mode = Mode::trace;
  const bool at_end = state.walk.position == state.walk.timeline->steps();
  state.walk.playing = !state.walk.playing && !at_end;
}

void action::SetSpeed::apply(State& state) const {
  state.walk.lines_per_second = std::clamp(lines_per_second, min_speed, max_speed);
}

void action::SetGrain::apply(State& state) const { state.walk.grain = grain; }

void action::Clear::apply(State& state) const { go_to(state, 0); }

void action::ShowGhosts::apply(State& state) const {
  state.walk.shows_ghosts = shown;
  if (shown) state.walk.mode = Mode::trace;
}

void action::SetTweens::apply(State& state) const { state.walk.tweens = on; }

namespace {

void play_held(State& state, double seconds) {
  Hold& hold = *state.walk.hold;
  hold.seconds += seconds;
  hold.owed += seconds * hold_rate(hold.seconds);
  const Timeline& timeline = *state.walk.timeline;
  const bool forward = hold.forward;
  const int end = forward ? timeline.steps() : 0;
  for (; hold.owed >= 1 && state.walk.position != end; hold.owed -= 1) {
    const int to = stepped(timeline, state.walk.position, state.walk.grain, forward);
    const int rest = forward ? stopped(state, to) : to;
    state.walk.position = rest;
    if (forward && (rest != to || stops_here(state))) return state.walk.hold.reset();
  }
  if (state.walk.position == end) state.walk.hold.reset();
}

/// AUTO, or a button that is held down.
void play(State& state, double seconds) {
  // After a long delay, not all of it is made up for.
  seconds = std::min(seconds, 1.0);
  if (state.walk.hold) return play_held(state, seconds);
  if (!state.walk.playing) return;
  state.walk.owed += seconds * state.walk.lines_per_second;
  while (state.walk.owed >= 1 && state.walk.playing) {
    state.walk.owed -= 1;
    const int to = stepped(*state.walk.timeline, state.walk.position, state.walk.grain, true);
    const int rest = stopped(state, to);
    state.walk.position = rest;
    if (rest == state.walk.timeline->steps() || rest != to || stops_here(state)) state.walk.playing = false;
  }
}

}  // namespace

void action::Tick::apply(State& state) const {
  if (state.walk.tween) state.walk.tween->seconds += seconds;
  play(state, seconds);
  autosave(state, seconds);
}

double hold_rate(double seconds) {
  // Starts at clicking speed, doubled every second.
  constexpr double slowest = 6, fastest = 600;
  return std::min(slowest * std::exp2(seconds), fastest);
}

Breakpoints breakpoints_here(const State& state) {
  Breakpoints here = state.walk.breakpoints;
  if (stops_chosen(state).object < 0) here.object.clear();
  return here;
}

Breakpoints breakpoints_in_force(const State& state) {
  const PlayedStep* step = state.lessons.shown ? state.lessons.at() : nullptr;
  return step != nullptr && !step->step->breakpoints ? Breakpoints{} : breakpoints_here(state);
}

}  // namespace raywalk
