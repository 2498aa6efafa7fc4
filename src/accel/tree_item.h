#pragma once
// What trees over boxes in float are built from.

#include "math/bounds.h"

#include <cstdint>

namespace raywalk {

inline constexpr unsigned tree_width = 8;  ///< boxes in a node, triangles in a pack

/// A primitive, or the part of one that lies in a box.
struct alignas(32) TreeItem {
  Bounds<float> box;  ///< rounded out
  std::int32_t id;
  std::int32_t packed;  ///< 1 for a triangle that packs hold, else 0
};

/// How many items there are of each kind, and what a leaf of them costs, in tests of one primitive: triangles are
/// tested together, others one by one.
struct ItemCounts {
  std::int32_t packed = 0, others = 0;

  static ItemCounts of(const TreeItem& item) { return {item.packed, 1 - item.packed}; }
  [[nodiscard]] std::int32_t all() const { return packed + others; }
  [[nodiscard]] float leaf_cost() const {
    constexpr auto lanes = static_cast<std::int32_t>(tree_width);
    return cost_of_pack * static_cast<float>((packed + lanes - 1) / lanes) + static_cast<float>(others);
  }
  /// Of what may be split further: how many of the last pack's places will be left empty is not known.
  [[nodiscard]] float expected_cost() const {
    constexpr auto width = static_cast<float>(tree_width);
    if (packed <= static_cast<std::int32_t>(tree_width)) return leaf_cost();
    return cost_of_pack * (static_cast<float>(packed) + (width - 1) / 2) / width + static_cast<float>(others);
  }
  [[nodiscard]] bool fits_leaf() const {
    return others <= most_listed && (packed == 0 || all() <= static_cast<std::int32_t>(tree_width));
  }
  ItemCounts& operator+=(const ItemCounts& more) {
    packed += more.packed, others += more.others;
    return *this;
  }
  ItemCounts& operator-=(const ItemCounts& fewer) {
    packed -= fewer.packed, others -= fewer.others;
    return *this;
  }

  static constexpr float cost_of_pack = 1, cost_of_node = 0.5F;
  static constexpr std::int32_t most_listed = 4;
};

}  // namespace raywalk
