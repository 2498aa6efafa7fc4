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
  if (!state.tweens || state.hold || state.mode != Mode::trace) return 0;
  const double seconds = state.playing ? std::min(usual, share / state.lines_per_second) : usual;
  return seconds < least ? 0 : seconds;
}

std::optional<Growth> growth_of(const State& state, int ray) {
  if (!state.tween || state.tween->ray != ray) return std::nullopt;
  const RayRecord& record = state.timeline->rays()[static_cast<std::size_t>(ray)];
  const double seconds = tween_seconds(state);
  const double left = seconds > 0 ? 1 - std::clamp(state.tween->seconds / seconds, 0.0, 1.0) : 0;
  return Growth{record.formed_at > state.tween->from, 1 - left * left};
}

void follow_with_tween(State& state, const Timeline* timeline, int position) {
  if (state.timeline.get() != timeline || state.position != position) {
    state.tween.reset();
    const bool forward = state.timeline.get() == timeline && state.position > position;
    if (!forward || !(tween_seconds(state) > 0) || state.window_export) return;
    if (const auto ray = changed_ray(*state.timeline, position, state.position)) state.tween = Tween{*ray, position};
  } else if (state.tween && state.tween->seconds >= tween_seconds(state)) {
    state.tween.reset();
  }
}

}  // namespace raywalk
