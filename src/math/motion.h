#pragma once

#include "math/transform.h"

#include <vector>

namespace raywalk {

/// The displacement of something at a time, in scene units from its place at rest.
struct MotionKey {
  double time = 0;
  Vec3d offset{0.0};
  friend bool operator==(const MotionKey&, const MotionKey&) = default;
};

/// Linear between keys, constant before the first and after the last; times ascend. Without keys: at rest.
using Motion = std::vector<MotionKey>;

/// Whether it never moves: at most one key, or the same offset in all keys.
[[nodiscard]] bool is_at_rest(const Motion& motion);

/// Whether it moves at all between `open` and `close`.
[[nodiscard]] bool moves_between(const Motion& motion, double open, double close);

[[nodiscard]] Vec3d offset_at(const Motion& motion, double time);

/// The motion of something that moves by `inner` inside a group that is mapped by `outer` and then moves by `whole`.
[[nodiscard]] Motion moved_within(const Motion& inner, const Affine<double>& outer, const Motion& whole);

}  // namespace raywalk
