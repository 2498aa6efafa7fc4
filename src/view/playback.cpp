#include "view/text.h"
#include "view/update_parts.h"

#include <algorithm>
#include <cmath>

namespace raywalk::detail {

int stepped(const Timeline& timeline, int position, Grain grain, bool forward) {
  switch (grain) {
    case Grain::line:
      return std::clamp(position + (forward ? 1 : -1), 0, timeline.steps());
    case Grain::ray:
      return forward ? timeline.next_ray(position) : timeline.previous_ray(position);
    case Grain::pixel:
      return forward ? timeline.next_pixel(position) : timeline.previous_pixel(position);
  }
  return position;
}

void go_to(State& state, int position) {
  state.playing = false;
  state.mode = Mode::trace;
  state.position = std::clamp(position, 0, state.timeline->steps());
}

void walk(State& state, const action::Step& step) {
  go_to(state, stepped(*state.timeline, state.position, step.grain.value_or(state.grain), step.forward));
}

void run_to_line(State& state, Line line) {
  int position = state.position;
  do ++position;
  while (position < state.timeline->steps() && state.timeline->just_run(position)->line != line);
  go_to(state, position);
}

void play(State& state, double seconds) {
  if (!state.playing) return;
  // A window that was held up for long does not make up for all of it.
  state.owed += std::min(seconds, 1.0) * state.lines_per_second;
  while (state.owed >= 1 && state.playing) {
    state.owed -= 1;
    state.position = stepped(*state.timeline, state.position, state.grain, true);
    if (state.position == state.timeline->steps()) state.playing = false;
  }
}

}  // namespace raywalk::detail
