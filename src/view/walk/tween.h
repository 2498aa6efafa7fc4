#pragma once
// Short animations: after a small step forward, a formed ray grows, and a ray shrinks to its found end.

#include "view/state.h"

namespace raywalk {

/// The progress of the current ray, and from where: its start, or its drawn end before its end was known.
struct Growth {
  bool from_start = true;
  double part = 1;  ///< 0..1, eased out
};
/// Of a ray (index in Timeline::rays()); none if it is not animated.
[[nodiscard]] std::optional<Growth> growth_of(const State& state, int ray);

/// Duration of a tween in seconds: less than between two steps of AUTO; 0 if none is shown.
[[nodiscard]] double tween_seconds(const State& state);

}  // namespace raywalk
