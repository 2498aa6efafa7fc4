#pragma once
// Boxes and counts as builds of trees handle them.

#include "accel/tree_item.h"
#include "math/lanes.h"
#include "math/ray.h"

#include <algorithm>
#include <limits>

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
};

/// How likely a ray is to meet a box within another, as the surface area heuristic wants to know: the less a tree costs
/// by it, the better it is.
///
/// Of the lines through the outer box, as many meet the inner one as its part of the area says (J. Goldsmith and J.
/// Salmon 1987). A ray is only what lies ahead of its origin, and most begin within the scene. Anywhere on its line,
/// the origin is not yet past the inner box with a chance of (1 + p) / 2, where p is that box's part of the line. Since
/// a box's mean part of a line that meets it is 4 volume / area, the chance of both is the mean of the parts of the
/// area and of the volume. (What B. Fabianowski, C. Fowler and J. Dingliana integrate in "A Cost Metric for
/// Scene-Interior Ray Origins", 2009.) By the area alone, the walls of a room would best be one leaf, as large as the
/// room.
struct MeetingChance {
  explicit MeetingChance(const LaneBox& outer) {
    const Lanes size = outer.max - outer.min;
    per_unit = 1 / std::max(std::max(std::max(size[0], size[1]), size[2]), std::numeric_limits<float>::min());
    const float area = (*this)(outer), volume = size[0] * per_unit * (size[1] * per_unit) * (size[2] * per_unit);
    constexpr float flat = 1e-30F;
    if (volume > flat) per_volume = area / volume;
  }
  /// In proportion to the chance; 0 where the box is empty.
  [[nodiscard]] float operator()(const LaneBox& box) const {
    const Lanes size = (box.max - box.min) * all_lanes(per_unit);
    if (!(size[0] >= 0 && size[1] >= 0 && size[2] >= 0)) return 0;
    const float base = size[0] * size[1];
    return base + size[1] * size[2] + size[2] * size[0] + per_volume * base * size[2];
  }

  float per_unit;        ///< what lengths are multiplied by, so that no product leaves float's range
  float per_volume = 0;  ///< 0 where the outer box is flat
};

/// A side of a split, or a part of it.
struct Bin {
  LaneBox box;
  ItemCounts count;
};

}  // namespace raywalk
