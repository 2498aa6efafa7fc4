#include "view/walk/tween.h"

#include "view/walk/walk.h"

#include <algorithm>

namespace raywalk {

namespace {

/// The ray that a step from `from` to `to` has formed or ended, if it formed only one: several are not animated.
std::optional<int> changed_ray(const Timeline& timeline, int from, int to) {
  const int ray = timeline.current_ray(to);
  if (ray < 0 || timeline.rays_at(to).size() > timeline.rays_at(from).size() + 1) return std::nullopt;
  const RayRecord& record = timeline.rays()[static_cast<std::size_t>(ray)];
  const auto lies = [&](int position) { return from < position && position <= to; };
  if (!record.formed || !(lies(record.formed_at) || lies(record.found_at))) return std::nullopt;
  return ray;
}

}  // namespace

double tween_seconds(const State& state) {
  constexpr double usual = 0.25, share = 0.6, least = 0.05;
  if (!state.walk.tweens || state.walk.hold || state.walk.mode != Mode::trace) return 0;
  const double seconds = state.walk.playing ? std::min(usual, share / state.walk.lines_per_second) : usual;
  return seconds < least ? 0 : seconds;
}

std::optional<Growth> growth_of(const State& state, int ray) {
  if (!state.walk.tween || state.walk.tween->ray != ray) return std::nullopt;
  const RayRecord& record = state.walk.timeline->rays()[static_cast<std::size_t>(ray)];
  const double seconds = tween_seconds(state);
  const double left = seconds > 0 ? 1 - std::clamp(state.walk.tween->seconds / seconds, 0.0, 1.0) : 0;
  return Growth{record.formed_at > state.walk.tween->from, 1 - left * left};
}

/// Begins a tween if the walk went a small step forward from there, and ends one that is over.
void WalkRoom::follow(State& state, const Before& before) {
  follow_with_ghosts(state);
  const Timeline* const timeline = before.timeline.get();
  const int position = before.position;
  if (state.walk.timeline.get() != timeline || state.walk.position != position) {
    state.walk.tween.reset();
    const bool forward = state.walk.timeline.get() == timeline && state.walk.position > position;
    if (!forward || !(tween_seconds(state) > 0) || state.exports.window) return;
    if (const auto ray = changed_ray(*state.walk.timeline, position, state.walk.position))
      state.walk.tween = Tween{*ray, position};
  } else if (state.walk.tween && state.walk.tween->seconds >= tween_seconds(state)) {
    state.walk.tween.reset();
  }
}

}  // namespace raywalk
