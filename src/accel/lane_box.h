#pragma once
// Boxes and counts as builds of trees handle them.

#include "accel/tree_item.h"
#include "math/lanes.h"
#include "math/ray.h"

namespace raywalk {

/// A box whose corners are lanes; the last lane of each means nothing.
struct LaneBox {
  Lanes min = all_lanes(infinity<float>), max = all_lanes(-infinity<float>);

  LaneBox() = default;
  explicit LaneBox(const Bounds<float>& box)
      : min{box.min.x, box.min.y, box.min.z, 0}, max{box.max.x, box.max.y, box.max.z, 0} {}

  void include(const LaneBox& other) {
    min = raywalk::min(other.min, min);
    max = raywalk::max(other.max, max);
  }
  void include_point(Lanes point) {
    min = raywalk::min(point, min);
    max = raywalk::max(point, max);
  }
  [[nodiscard]] Lanes centre() const { return (min + max) * all_lanes(0.5F); }
  [[nodiscard]] Bounds<float> bounds() const { return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}}; }
  /// Proportional to the probability that a ray which hits a box around it hits this one; 0 where it is empty.
  /// `per_unit`: what lengths are multiplied by, so that no product leaves float's range.
  [[nodiscard]] float half_area(float per_unit) const {
    const Lanes size = (max - min) * all_lanes(per_unit);
    return size[0] >= 0 && size[1] >= 0 && size[2] >= 0 ? size[0] * size[1] + size[1] * size[2] + size[2] * size[0] : 0;
  }
};

/// A side of a split, or a part of it.
struct Bin {
  LaneBox box;
  Tally count;
};

}  // namespace raywalk
