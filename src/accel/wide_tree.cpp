#include "accel/wide_tree.h"

#include "accel/binary_tree.h"
#include "accel/reinsertion.h"
#include "accel/search_record.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace raywalk {

class WideTree::Builder {
 public:
  /// Whether the collapse of the least expected cost is searched for. Not without triangles: what beams see is cut into
  /// pieces in the order in which their faces come (trace/beam_faces.h), so that another tree over them is another
  /// picture.
  static bool optimises(const BinaryTree& binary) { return binary.nodes[0].count.packed > 0; }

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
    if (optimises(binary_)) {
      shares_.resize(binary_.nodes.size());
      share(0);
    }
    tree_.nodes_.reserve(wide_nodes(0));
    collapse(0, 0);
    tree_.items_ = binary_.items.size();
    const float whole = chance_of(binary_.nodes[0]);
    tree_.expected_cost_ = whole > 0 ? cost_ / static_cast<double>(whole) : 0;
  }

 private:
  [[nodiscard]] float chance_of(const BinaryNode& node) const { return binary_.chance(LaneBox(node.box)); }

  /// Of a binary node, where it and its descendants become at most so many children of a wide node: how many of them
  /// are to the left; 0 where it is a single one. By the number of children.
  using Shares = std::array<std::uint8_t, tree_width + 1>;
  /// The least cost of that, in units of MeetingChance times tests, for 1, 2, ... 7 children.
  using Costs = std::array<float, tree_width - 1>;

  /// Finds the cheapest for the binary node at `index` and its descendants.
  Costs share(std::uint32_t index) {
    const BinaryNode& node = binary_.nodes[index];
    const float chance = chance_of(node);
    Costs costs;
    if (node.leaf()) {
      costs.fill(chance * node.count.leaf_cost());
      return costs;
    }
    build_.stop.check();
    const Costs left = share(node.left), right = share(node.left + 1);
    Shares& shares = shares_[index];
    const auto cheapest = [&](std::size_t children) {
      float least = infinity<float>;
      for (std::size_t of_left = 1; of_left < children; ++of_left) {
        const float cost = left[of_left - 1] + right[children - of_left - 1];
        if (of_left == 1 || cost < least) least = cost, shares[children] = static_cast<std::uint8_t>(of_left);
      }
      return least;
    };
    costs[0] = chance * ItemCounts::cost_of_node + cheapest(tree_width);
    for (std::size_t children = 2; children < tree_width; ++children) {
      costs[children - 1] = cheapest(children);
      if (costs[children - 1] < costs[children - 2]) continue;
      costs[children - 1] = costs[children - 2], shares[children] = shares[children - 1];
    }
    return costs;
  }

  /// The binary nodes that become the children of one wide node.
  struct Opened {
    std::array<std::uint32_t, tree_width> nodes{};
    std::size_t count = 0;
  };
  [[nodiscard]] Opened opened(std::uint32_t index) const {
    Opened all;
    if (shares_.empty())
      open_largest(index, all);
    else
      open(index, tree_width, all);
    return all;
  }
  /// The largest inner one is replaced by its own children until there are eight or only leaves.
  void open_largest(std::uint32_t index, Opened& all) const {
    all.nodes[all.count++] = index;
    while (all.count < all.nodes.size()) {
      std::uint32_t* largest = nullptr;
      float most = -1;
      for (std::size_t i = 0; i < all.count; ++i) {
        const BinaryNode& node = binary_.nodes[all.nodes[i]];
        if (node.leaf()) continue;
        if (const float chance = chance_of(node); chance > most) largest = &all.nodes[i], most = chance;
      }
      if (largest == nullptr) break;
      const std::uint32_t children = binary_.nodes[*largest].left;
      *largest = children;
      all.nodes[all.count++] = children + 1;
    }
  }
  /// The cheapest.
  void open(std::uint32_t index, std::size_t children, Opened& all) const {
    const std::uint8_t of_left = shares_[index][children];
    if (of_left == 0) {
      all.nodes[all.count++] = index;
      return;
    }
    open(binary_.nodes[index].left, of_left, all);
    open(binary_.nodes[index].left + 1, children - of_left, all);
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
    add_cost(binary_.nodes[index], ItemCounts::cost_of_node);
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
    cost_ += static_cast<double>(chance_of(node)) * static_cast<double>(tests);
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
  std::vector<Shares> shares_;  ///< by binary node
  double cost_ = 0;             ///< expected, in units of MeetingChance times tests
};

WideTree::WideTree(std::vector<TreeItem> items, const BuildOptions& build, const CornersOf& corners) {
  if (items.empty()) return;
  if (build.quality_for(items.size()) != BuildQuality::best || !corners) {
    collapse(BinaryTree(std::move(items), build, {}), build);
    return;
  }
  std::vector<TreeItem> again = items;
  BuildRecord before;
  if (build.watcher != nullptr) before = *build.watcher;
  if (!collapse(BinaryTree(std::move(items), build, corners), build)) return;
  // Each split of space looks as if it paid; whether they do together shows only at the end.
  BuildOptions good = build;
  good.quality = BuildQuality::good;
  if (build.watcher != nullptr) good.watcher = &before;
  WideTree unsplit(std::move(again), good);
  if (expected_cost_ < unsplit.expected_cost_) return;
  *this = std::move(unsplit);
  if (build.watcher != nullptr) *build.watcher = std::move(before);
}

bool WideTree::collapse(BinaryTree binary, const BuildOptions& build) {
  const bool in_haste = build.quality_for(binary.items.size()) == BuildQuality::fast;
  if (!in_haste && Builder::optimises(binary)) reinsert_subtrees(binary, build.stop);
  Builder(*this, binary, build);
  return binary.splits_space;
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
