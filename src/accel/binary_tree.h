#pragma once
// The binary tree that a WideTree is collapsed from.

#include "accel/build_record.h"
#include "accel/lane_box.h"
#include "accel/spatial_split.h"
#include "accel/tree_item.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raywalk {

/// An inner node, whose children are at left and left + 1, or a leaf, whose items are [first, first + count).
struct BinaryNode {
  Bounds<float> box;
  ItemCounts count;
  std::uint32_t left = 0;  ///< 0: a leaf
  std::uint32_t first = 0;
  [[nodiscard]] bool leaf() const { return left == 0; }
};

/// Built top-down over bins by the surface area heuristic (MeetingChance), what both sides of a plane are expected to
/// cost as leaves (I. Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007).
struct BinaryTree {
  /// Over items with finite, non-empty boxes, at least one. With `corners`, space may be split too where the best
  /// quality is asked for.
  BinaryTree(std::vector<TreeItem> items, const BuildOptions& build, const CornersOf& corners);

  /// Levels by that cost; what is left then is halved until it fits into leaves, at most 31 times.
  static constexpr std::size_t max_depth = 64, most_levels = max_depth + 31;

  std::vector<BinaryNode> nodes;  ///< the root is the first
  std::vector<TreeItem> items;    ///< of those that were split, every part
  bool splits_space = false;      ///< somewhere; otherwise it is what it would be without `corners`
  MeetingChance chance;           ///< within the root
};

}  // namespace raywalk
