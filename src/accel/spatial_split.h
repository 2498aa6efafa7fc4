#pragma once
// Splits of space rather than of a list: a triangle that lies on both sides of a plane is listed on both, each time in
// the box of its part there.
//
// M. Stich, H. Friedrich and A. Dietrich, "Spatial Splits in Bounding Volume Hierarchies", HPG 2009.

#include "accel/lane_box.h"

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace raywalk {

/// The corners of a triangle that packs hold, by its id, in double.
using CornersOf = std::function<std::array<Vec3d, 3>(std::int32_t id)>;

/// A plane, and the expected cost of both its sides in units of MeetingChance times tests.
struct SpatialPlane {
  float cost = infinity<float>;
  int axis = 0;
  float at = 0;
};

class SpatialSplitter {
 public:
  SpatialSplitter(const CornersOf& corners, const MeetingChance& chance) : corners_(corners), chance_(chance) {}

  /// The cheapest of some planes that cut `box`, the items' own; of infinite cost where none parts them.
  [[nodiscard]] SpatialPlane cheapest(std::span<const TreeItem> items, const Bounds<float>& box) const;

  /// What lies on each side. What both have is listed once, and makes that side's box larger, where this is cheaper.
  struct Sides {
    std::vector<TreeItem> left_items, right_items;
    Bin left, right;
  };
  [[nodiscard]] Sides part(std::span<const TreeItem> items, const SpatialPlane& plane) const;

 private:
  /// The box of the part of an item between two planes, rounded out; empty where nothing of it lies there.
  [[nodiscard]] Bounds<float> clipped(const TreeItem& item, int axis, float low, float high) const;
  [[nodiscard]] float cost(const LaneBox& box, const ItemCounts& count) const {
    return chance_(box) * count.expected_cost();
  }

  const CornersOf& corners_;
  MeetingChance chance_;
};

}  // namespace raywalk
