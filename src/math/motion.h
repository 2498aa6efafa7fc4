#pragma once

#include "math/transform.h"

#include <vector>

namespace raywalk {

/// Where something is moved to at a time, in scene units from where it stands.
struct MotionKey {
  double time = 0;
  Vec3d offset{0.0};
  friend bool operator==(const MotionKey&, const MotionKey&) = default;
};

/// Straight from key to key, at rest before the first and after the last; times ascend. Without keys: at rest.
using Motion = std::vector<MotionKey>;

/// Whether it is in one place at all times: at most one key, or the same offset in all.
[[nodiscard]] bool is_at_rest(const Motion& motion);

/// Whether it is in more than one place from `open` to `close`.
[[nodiscard]] bool moves_between(const Motion& motion, double open, double close);

[[nodiscard]] Vec3d offset_at(const Motion& motion, double time);

/// The motion of what moves by `inner` inside something that is mapped by `outer` and then moves by `whole`.
[[nodiscard]] Motion moved_within(const Motion& inner, const Affine<double>& outer, const Motion& whole);

}  // namespace raywalk
