#pragma once
// Short tweens: a small step forward lets the ray that it forms grow, and the one whose end it finds shrink to it.

#include "view/state.h"

namespace raywalk {

/// How far the ray under way has come, and from where: its start, or where it was drawn to before its end was known.
struct Growth {
  bool from_start = true;
  double part = 1;  ///< 0..1, eased out
};
/// Of a ray (index in Timeline::rays()) as it is drawn now; none for a ray that stands still.
[[nodiscard]] std::optional<Growth> growth_of(const State& state, int ray);

/// Seconds that a tween takes in this state: less than AUTO leaves between two steps; 0 where none is shown.
[[nodiscard]] double tween_seconds(const State& state);

}  // namespace raywalk
