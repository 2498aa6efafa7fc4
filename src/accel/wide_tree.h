#pragma once
// The tree that MeshBvh searches, in float for rays of either precision. Eight boxes a node and eight triangles a pack,
// on every processor: how many of them are tested at a time (accel/width.h) changes no node that a ray meets.

#include "accel/binary_tree.h"
#include "accel/build_record.h"
#include "accel/large_pages.h"
#include "math/bounds.h"

#include <array>
#include <cassert>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

namespace raywalk {

/// What a node's box holds, in 32 bits: a node; a leaf of up to eight triangles, which is a pack; or a leaf of other
/// primitives.
class TreeChild {
 public:
  TreeChild() = default;  ///< means nothing: stacks of searches are not filled
  static TreeChild node(std::uint32_t index) {
    assert(index <= most);
    return TreeChild(index);
  }
  static TreeChild pack(std::uint32_t index, std::uint32_t count) { return leaf(packed, index, count); }
  static TreeChild list(std::uint32_t first, std::uint32_t count) { return leaf(listed, first, count); }

  [[nodiscard]] bool is_leaf() const { return (bits_ & (packed | listed)) != 0; }
  [[nodiscard]] bool is_pack() const { return (bits_ & packed) != 0; }
  /// Of the node, of the pack, or of the first listed id.
  [[nodiscard]] std::uint32_t index() const { return bits_ & most; }
  [[nodiscard]] std::uint32_t count() const { return (bits_ >> shift & 7) + 1; }  ///< primitives of a leaf

  static constexpr std::uint32_t most = (1U << 27) - 1;  ///< the largest index

 private:
  static constexpr std::uint32_t packed = 1U << 31, listed = 1U << 30, shift = 27;
  explicit TreeChild(std::uint32_t bits) : bits_(bits) {}
  static TreeChild leaf(std::uint32_t kind, std::uint32_t index, std::uint32_t count) {
    assert(index <= most && count - 1 < tree_width);
    return TreeChild(kind | (count - 1) << shift | index);
  }
  std::uint32_t bits_;
};

struct alignas(64) WideNode {
  float planes[6][tree_width];  ///< of the boxes: the least x, y and z, then the greatest; missing boxes are empty
  TreeChild children[tree_width];
  std::uint32_t count;  ///< boxes held, from lane 0

  [[nodiscard]] Bounds<float> box(unsigned lane) const {
    return {{planes[0][lane], planes[1][lane], planes[2][lane]}, {planes[3][lane], planes[4][lane], planes[5][lane]}};
  }
  /// The bounds of all.
  [[nodiscard]] Bounds<float> whole() const {
    Bounds<float> whole;
    for (unsigned lane = 0; lane < count; ++lane) whole.include(box(lane));
    return whole;
  }
};

/// Up to eight primitives of a leaf, at least one of them a triangle. Corners that are NaN belong to something else, to
/// a triangle that moves or to a degenerate one: it can be ruled out only by its own test.
struct alignas(64) TrianglePack {
  float corners[3][3][tree_width];  ///< by corner and axis; of missing lanes as in lane 0
  std::int32_t ids[tree_width];
};

/// Bounding volume hierarchy.
///
/// Built as a binary tree (accel/binary_tree.h; accel/reinsertion.h), which is then collapsed into a wide one (H.
/// Dammertz, J. Hanika and A. Keller, "Shallow bounding volume hierarchies for fast SIMD ray tracing of incoherent
/// rays", 2008): the cheapest that keeps its leaves (H. Ylitie, T. Karras and S. Laine, "Efficient Incoherent Ray
/// Traversal on GPUs Through Compressed Wide BVHs", 2017).
class WideTree {
 public:
  WideTree() = default;
  /// Over items with finite, non-empty boxes. The packs' corners are left to fill_packs.
  /// `corners`: see BinaryTree.
  explicit WideTree(std::vector<TreeItem> items, const BuildOptions& build = {}, const CornersOf& corners = {});

  static constexpr std::size_t most_levels = BinaryTree::most_levels;

  [[nodiscard]] bool empty() const { return nodes_.empty(); }
  [[nodiscard]] const WideNode* nodes() const { return nodes_.data(); }
  [[nodiscard]] const TrianglePack& pack(std::uint32_t index) const { return packs_[index]; }
  [[nodiscard]] const std::int32_t* listed(std::uint32_t first) const { return &ids_[first]; }
  /// Whether the packs' corners are those of the triangles, unrounded, as of a mesh whose file is in float.
  [[nodiscard]] bool packs_are_exact() const { return packs_are_exact_; }
  /// Asks the memory for what will soon be wanted of a child.
  [[gnu::always_inline]] void fetch(TreeChild child) const {
    if (child.is_pack())
      fetch_lines(packs_.data() + child.index());
    else if (!child.is_leaf())
      fetch_lines(nodes_.data() + child.index());
  }
  /// `corners(id)`: those of a triangle, in double; none where only its own test can rule it out.
  template <class Corners>
  void fill_packs(const Stop& stop, const Corners& corners);

  [[nodiscard]] std::size_t node_count() const { return nodes_.size(); }
  [[nodiscard]] std::size_t item_count() const { return items_; }
  [[nodiscard]] int depth() const { return depth_; }
  /// The bounds of all.
  [[nodiscard]] Bounds<float> box() const { return empty() ? Bounds<float>{} : nodes_.front().whole(); }
  /// As AcceleratorStatistics has it.
  [[nodiscard]] double expected_cost() const { return expected_cost_; }
  [[nodiscard]] std::size_t bytes() const {
    return nodes_.size() * sizeof(WideNode) + packs_.size() * sizeof(TrianglePack) + ids_.size() * sizeof(std::int32_t);
  }
  /// Parents before children, at most `most`.
  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most) const;

 private:
  class Builder;
  /// Makes it from a binary tree; returns whether that splits space.
  bool collapse(BinaryTree binary, const BuildOptions& build);
  template <class Lines>
  [[gnu::always_inline]] static void fetch_lines(const Lines* what) {
    constexpr std::size_t line = alignof(Lines);
    for (std::size_t at = 0; at < sizeof *what; at += line)
      __builtin_prefetch(reinterpret_cast<const char*>(what) + at);
  }
  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most, std::uint32_t index, int depth) const;

  LargeArray<WideNode> nodes_;
  LargeArray<TrianglePack> packs_;
  std::vector<std::int32_t> ids_;  ///< of leaves without triangles
  bool packs_are_exact_ = true;
  std::size_t items_ = 0;
  int depth_ = 0;
  double expected_cost_ = 0;
};

template <class Corners>
void WideTree::fill_packs(const Stop& stop, const Corners& corners) {
  stop.each(packs_.begin(), packs_.end(), [&](TrianglePack& pack) {
    for (std::size_t lane = 0; lane < tree_width; ++lane) {
      const std::optional<std::array<Vec3d, 3>> at = corners(pack.ids[lane]);
      for (std::size_t corner = 0; corner < 3; ++corner)
        for (int axis = 0; axis < 3; ++axis) {
          const double exact = at ? (*at)[corner][axis] : std::numeric_limits<double>::quiet_NaN();
          const auto rounded = static_cast<float>(exact);
          pack.corners[corner][axis][lane] = rounded;
          if (at && static_cast<double>(rounded) != exact) packs_are_exact_ = false;
        }
    }
  });
}

}  // namespace raywalk
