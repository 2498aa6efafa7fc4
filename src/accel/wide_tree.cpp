#include "accel/wide_tree.h"

#include "accel/binary_tree.h"
#include "accel/search_record.h"

#include <algorithm>
#include <array>
#include <utility>

namespace raywalk {

class WideTree::Builder {
 public:
  Builder(WideTree& tree, const BinaryTree& binary, const BuildOptions& build)
      : tree_(tree), binary_(binary), build_(build) {
    std::size_t packs = 0, listed = 0;
    for (const BinaryNode& node : binary_.nodes) {
      if (!node.leaf()) continue;
      packs += node.count.packed > 0 ? 1 : 0;
      listed += node.count.packed > 0 ? 0 : static_cast<std::size_t>(node.count.all());
    }
    tree_.packs_.reserve(packs);
    tree_.ids_.reserve(listed);
    tree_.nodes_.reserve(wide_nodes(0));
    collapse(0, 0);
    tree_.items_ = binary_.items.size();
    const float whole = area_of(binary_.nodes[0]);
    tree_.expected_cost_ = whole > 0 ? areas_ / static_cast<double>(whole) : 0;
  }

 private:
  [[nodiscard]] float area_of(const BinaryNode& node) const { return LaneBox(node.box).half_area(binary_.per_unit); }

  /// The binary nodes that become the children of one wide node: the largest inner one is replaced by its own children
  /// until there are eight or only leaves.
  struct Opened {
    std::array<std::uint32_t, tree_width> nodes{};
    std::size_t count = 1;
  };
  [[nodiscard]] Opened opened(std::uint32_t index) const {
    Opened all{{index}};
    while (all.count < all.nodes.size()) {
      std::uint32_t* largest = nullptr;
      float most = -1;
      for (std::size_t i = 0; i < all.count; ++i) {
        const BinaryNode& node = binary_.nodes[all.nodes[i]];
        if (node.leaf()) continue;
        if (const float area = area_of(node); area > most) largest = &all.nodes[i], most = area;
      }
      if (largest == nullptr) break;
      const std::uint32_t children = binary_.nodes[*largest].left;
      *largest = children;
      all.nodes[all.count++] = children + 1;
    }
    return all;
  }

  /// How many wide nodes the binary node at `index` and its descendants become.
  [[nodiscard]] std::size_t wide_nodes(std::uint32_t index) const {
    build_.stop.check();
    const Opened all = opened(index);
    std::size_t count = 1;
    for (std::size_t i = 0; i < all.count; ++i)
      if (!binary_.nodes[all.nodes[i]].leaf()) count += wide_nodes(all.nodes[i]);
    return count;
  }

  /// Collapses the binary node at `index` and its descendants into wide nodes; returns its index.
  std::uint32_t collapse(std::uint32_t index, int depth) {
    build_.stop.check();
    const auto [open, count] = opened(index);
    add_cost(binary_.nodes[index], Tally::cost_of_node);
    tree_.depth_ = std::max(tree_.depth_, depth);
    const std::size_t place = tree_.nodes_.size();
    WideNode& node = tree_.nodes_.emplace_back();
    node.count = static_cast<std::uint32_t>(count);
    for (unsigned lane = 0; lane < tree_width; ++lane) {
      const Bounds<float> box = lane < count ? binary_.nodes[open[lane]].box : Bounds<float>{};
      for (int axis = 0; axis < 3; ++axis)
        node.planes[axis][lane] = box.min[axis], node.planes[axis + 3][lane] = box.max[axis];
    }
    if (build_.watcher != nullptr) {
      BuildStep step{.kind = BuildStep::Kind::joined, .box = wide(binary_.nodes[index].box)};
      step.depth = depth, step.items = static_cast<int>(count);
      for (std::size_t i = 0; i < count; ++i) {
        const BinaryNode& binary = binary_.nodes[open[i]];
        step.parts.push_back({wide(binary.box), binary.leaf() ? binary.count.all() : 0});
      }
      build_.watcher->add(std::move(step));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const BinaryNode& binary = binary_.nodes[open[i]];
      const TreeChild child = binary.leaf() ? leaf(binary) : TreeChild::node(collapse(open[i], depth + 1));
      tree_.nodes_[place].children[i] = child;
    }
    return static_cast<std::uint32_t>(place);
  }

  void add_cost(const BinaryNode& node, float tests) {
    areas_ += static_cast<double>(area_of(node)) * static_cast<double>(tests);
  }

  TreeChild leaf(const BinaryNode& binary) {
    add_cost(binary, binary.count.leaf_cost());
    const TreeItem* items = &binary_.items[binary.first];
    const auto count = static_cast<std::uint32_t>(binary.count.all());
    if (binary.count.packed == 0) {
      const std::size_t first = tree_.ids_.size();
      for (std::uint32_t i = 0; i < count; ++i) tree_.ids_.push_back(items[i].id);
      return TreeChild::list(static_cast<std::uint32_t>(first), count);
    }
    const std::size_t index = tree_.packs_.size();
    TrianglePack& pack = tree_.packs_.emplace_back();
    for (std::uint32_t lane = 0; lane < tree_width; ++lane) pack.ids[lane] = items[lane < count ? lane : 0].id;
    return TreeChild::pack(static_cast<std::uint32_t>(index), count);
  }

  WideTree& tree_;
  const BinaryTree& binary_;
  const BuildOptions& build_;
  double areas_ = 0;  ///< of the expected cost
};

WideTree::WideTree(std::vector<TreeItem> items, const BuildOptions& build, const CornersOf& corners) {
  if (!items.empty()) Builder(*this, BinaryTree(std::move(items), build, corners), build);
}

void WideTree::list_nodes(std::vector<StructureNode>& nodes, std::size_t most) const {
  if (!empty()) list_nodes(nodes, most, 0, 0);
}

void WideTree::list_nodes(std::vector<StructureNode>& nodes, std::size_t most, std::uint32_t index, int depth) const {
  const WideNode& node = nodes_[index];
  if (nodes.size() < most) nodes.push_back({wide(node.whole()), depth, false, static_cast<int>(node.count)});
  for (unsigned lane = 0; lane < node.count; ++lane) {
    const TreeChild child = node.children[lane];
    if (!child.is_leaf())
      list_nodes(nodes, most, child.index(), depth + 1);
    else if (nodes.size() < most)
      nodes.push_back({wide(node.box(lane)), depth + 1, true, static_cast<int>(child.count())});
  }
}

}  // namespace raywalk
