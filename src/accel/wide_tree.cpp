#include "accel/wide_tree.h"

#include "accel/search_record.h"
#include "math/lanes.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace raywalk {

namespace {

constexpr std::size_t most_bins = 16;
/// Fewer where there is little to tell apart: most nodes are small.
constexpr std::size_t bins_for(std::size_t items) { return items > 64 ? most_bins : most_bins / 2; }

/// The primitives of a leaf are tested together if they are triangles, else one by one: the cost of a leaf, in tests of
/// one primitive.
constexpr float cost_of_pack = 1, cost_of_node = 0.5F;
constexpr std::int32_t most_listed = 4;

struct Tally {
  std::int32_t packed = 0, others = 0;

  [[nodiscard]] std::int32_t all() const { return packed + others; }
  [[nodiscard]] float leaf_cost() const {
    return cost_of_pack * static_cast<float>((packed + 7) / static_cast<std::int32_t>(tree_width)) +
           static_cast<float>(others);
  }
  [[nodiscard]] bool fits_leaf() const {
    return others <= most_listed && (packed == 0 || all() <= static_cast<std::int32_t>(tree_width));
  }
  Tally& operator+=(const Tally& more) {
    packed += more.packed, others += more.others;
    return *this;
  }
};

/// A box whose corners are lanes; the last lane of each means nothing.
struct LaneBox {
  Lanes min = all_lanes(infinity<float>), max = all_lanes(-infinity<float>);

  void include(const LaneBox& other) {
    min = raywalk::min(other.min, min);
    max = raywalk::max(other.max, max);
  }
  void include_point(Lanes point) {
    min = raywalk::min(point, min);
    max = raywalk::max(point, max);
  }
  [[nodiscard]] Bounds<float> bounds() const { return {{min[0], min[1], min[2]}, {max[0], max[1], max[2]}}; }
  /// Proportional to the probability that a ray which hits a box around it hits this one. `unit`: that sizes are
  /// measured in, so that no product leaves float's range.
  [[nodiscard]] float half_area(float per_unit) const {
    const Lanes size = (max - min) * all_lanes(per_unit);
    return size[0] >= 0 ? size[0] * size[1] + size[1] * size[2] + size[2] * size[0] : 0;
  }
};

LaneBox lanes_of(const Bounds<float>& box) {
  return {Lanes{box.min.x, box.min.y, box.min.z, 0}, Lanes{box.max.x, box.max.y, box.max.z, 0}};
}
Lanes centre_of(const LaneBox& box) { return (box.min + box.max) * all_lanes(0.5F); }
Tally tally_of(const TreeItem& item) { return {item.packed, 1 - item.packed}; }

/// A node of the binary tree: items [first, first + count). An inner node's children are at left and left + 1.
struct BinaryNode {
  Bounds<float> box;
  std::uint32_t first = 0;
  Tally count;
  std::uint32_t left = 0;  ///< 0: a leaf
  [[nodiscard]] bool leaf() const { return left == 0; }
};

struct Bin {
  LaneBox box;
  Tally count;
};

/// Which bin an item's centre falls into, along all axes at once.
struct Binning {
  Binning(const LaneBox& centres, std::size_t bins)
      : least(centres.min), last(all_lanes(static_cast<float>(bins - 1))) {
    per_unit = all_lanes(static_cast<float>(bins)) / (centres.max - centres.min);
  }
  [[nodiscard]] LaneMask of(const TreeItem& item) const {
    const Lanes place = (centre_of(lanes_of(item.box)) - least) * per_unit;
    // NaN, where all centres coincide, becomes 0.
    return __builtin_convertvector(min(max(place, all_lanes(0)), last), LaneMask);
  }
  Lanes least, per_unit, last;
};

/// The cheapest plane: items whose bin is below `bin` go to the left.
struct Split {
  float cost = infinity<float>;  ///< of both sides, in units of area times tests
  std::size_t axis = 0, bin = 0;
  Bin left, right;
};

}  // namespace

class WideTree::Builder {
 public:
  Builder(WideTree& tree, std::vector<TreeItem> items, const BuildOptions& build)
      : tree_(tree), items_(std::move(items)), build_(build) {
    BinaryNode root;
    LaneBox whole, centres;
    build_.stop.each(items_.begin(), items_.end(), [&](const TreeItem& item) {
      const LaneBox box = lanes_of(item.box);
      whole.include(box);
      centres.include_point(centre_of(box));
      root.count += tally_of(item);
    });
    root.box = whole.bounds();
    per_unit_ = 1 / std::max(max_component(root.box.max - root.box.min), std::numeric_limits<float>::min());
    // About as many as there will be, so that the list is seldom copied.
    nodes_.reserve(static_cast<std::size_t>(root.count.packed) / 2 +
                   3 * static_cast<std::size_t>(root.count.others) / 2 + 1);
    nodes_.push_back(root);
    split(0, centres, 0);
    std::size_t packs = 0, listed = 0;
    for (const BinaryNode& node : nodes_) {
      if (!node.leaf()) continue;
      packs += node.count.packed > 0 ? 1 : 0;
      listed += node.count.packed > 0 ? 0 : static_cast<std::size_t>(node.count.all());
    }
    tree_.packs_.reserve(packs);
    tree_.ids_.reserve(listed);
    tree_.nodes_.reserve(wide_nodes(0));
    collapse(0, 0);
  }

 private:
  [[nodiscard]] float half_area(const LaneBox& box) const { return box.half_area(per_unit_); }

  [[nodiscard]] Split cheapest(const BinaryNode& node, const LaneBox& centres) const {
    Split best;
    const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(node.first), end = begin + node.count.all();
    const std::size_t bins = bins_for(static_cast<std::size_t>(node.count.all()));
    const Binning binning(centres, bins);
    std::array<std::array<Bin, most_bins>, 3> all;
    build_.stop.each(begin, end, [&](const TreeItem& item) {
      const LaneMask at = binning.of(item);
      const LaneBox box = lanes_of(item.box);
      const Tally one = tally_of(item);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        Bin& bin = all[axis][static_cast<std::size_t>(at[axis])];
        bin.box.include(box);
        bin.count += one;
      }
    });
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!(centres.max[axis] > centres.min[axis])) continue;
      const std::array<Bin, most_bins>& bin = all[axis];
      std::array<Bin, most_bins> above;  // bins i and up
      above[bins - 1] = bin[bins - 1];
      for (std::size_t i = bins - 1; i-- > 1;) {
        above[i] = above[i + 1];
        above[i].box.include(bin[i].box), above[i].count += bin[i].count;
      }
      Bin below;
      for (std::size_t i = 1; i < bins; ++i) {
        below.box.include(bin[i - 1].box), below.count += bin[i - 1].count;
        if (below.count.all() == 0 || above[i].count.all() == 0) continue;
        const float cost =
            half_area(below.box) * below.count.leaf_cost() + half_area(above[i].box) * above[i].count.leaf_cost();
        if (cost < best.cost) best = {cost, axis, i, below, above[i]};
      }
    }
    return best;
  }

  /// `centres`: the bounds of the items' centres.
  void split(std::size_t index, const LaneBox& centres, std::size_t depth) {
    build_.stop.check();
    const BinaryNode node = nodes_[index];
    std::optional<BuildStep> told;
    if (build_.watcher != nullptr) {
      told = {.kind = BuildStep::Kind::leaf, .box = wide(node.box), .depth = static_cast<int>(depth)};
      told->items = node.count.all();
    }
    const auto tell_leaf = [&](LeafReason why) {
      if (!told) return;
      told->why = why;
      build_.watcher->add(std::move(*told));
    };
    if (node.count.all() == 1) return tell_leaf(LeafReason::single);
    Split best;
    if (depth < max_depth - 1) best = cheapest(node, centres);
    const bool found = best.cost < infinity<float>;
    const float area = half_area(lanes_of(node.box));
    if (told && found && area > 0) {
      told->split_cost = static_cast<double>(best.cost / area + cost_of_node);
      told->leaf_cost = static_cast<double>(node.count.leaf_cost());
      told->axis = static_cast<int>(best.axis);
      const float low = centres.min[told->axis], high = centres.max[told->axis];
      told->plane = static_cast<double>(low + (high - low) * static_cast<float>(best.bin) /
                                                  static_cast<float>(bins_for(static_cast<std::size_t>(told->items))));
    }
    if (node.count.fits_leaf() && !(best.cost / area + cost_of_node < node.count.leaf_cost()))
      return tell_leaf(found ? LeafReason::split_costs_more : LeafReason::same_place);

    Bin left, right;
    LaneBox left_centres, right_centres;
    if (found) {
      left = best.left, right = best.right;
      part(node, centres, best, left_centres, right_centres);
    } else {  // all centres coincide: halve the list
      const auto begin = items_.begin() + static_cast<std::ptrdiff_t>(node.first), end = begin + node.count.all();
      const auto middle = begin + node.count.all() / 2;
      for (auto item = begin; item != end; ++item) {
        Bin& side = item < middle ? left : right;
        side.box.include(lanes_of(item->box));
        side.count += tally_of(*item);
        (item < middle ? left_centres : right_centres).include_point(centre_of(lanes_of(item->box)));
      }
      if (told) told->axis = -1;
    }
    const std::size_t children = nodes_.size();
    nodes_[index].left = static_cast<std::uint32_t>(children);
    nodes_.push_back({left.box.bounds(), node.first, left.count});
    nodes_.push_back({right.box.bounds(), node.first + static_cast<std::uint32_t>(left.count.all()), right.count});
    if (told) {
      told->kind = BuildStep::Kind::split;
      for (const Bin* side : {&left, &right}) told->parts.push_back({wide(side->box.bounds()), side->count.all()});
      build_.watcher->add(std::move(*told));
    }
    split(children, left_centres, depth + 1);
    split(children + 1, right_centres, depth + 1);
  }

  /// Moves the items of `node` to their sides of the plane, and bounds their centres.
  void part(const BinaryNode& node, const LaneBox& centres, const Split& plane, LaneBox& left_centres,
            LaneBox& right_centres) {
    const Binning binning(centres, bins_for(static_cast<std::size_t>(node.count.all())));
    const auto is_left = [&](const TreeItem& item) {
      return static_cast<std::size_t>(binning.of(item)[plane.axis]) < plane.bin;
    };
    auto low = items_.begin() + static_cast<std::ptrdiff_t>(node.first), high = low + node.count.all();
    while (low != high) {
      const Lanes centre = centre_of(lanes_of(low->box));
      if (is_left(*low)) {
        left_centres.include_point(centre);
        ++low;
      } else {
        right_centres.include_point(centre);
        std::swap(*low, *--high);
      }
    }
  }

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
        const BinaryNode& node = nodes_[all.nodes[i]];
        if (node.leaf()) continue;
        if (const float area = half_area(lanes_of(node.box)); area > most) largest = &all.nodes[i], most = area;
      }
      if (largest == nullptr) break;
      const std::uint32_t children = nodes_[*largest].left;
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
      if (!nodes_[all.nodes[i]].leaf()) count += wide_nodes(all.nodes[i]);
    return count;
  }

  /// Collapses the binary node at `index` and its descendants into wide nodes; returns its index.
  std::uint32_t collapse(std::uint32_t index, int depth) {
    build_.stop.check();
    const auto [open, count] = opened(index);
    tree_.depth_ = std::max(tree_.depth_, depth);
    const std::size_t place = tree_.nodes_.size();
    WideNode& node = tree_.nodes_.emplace_back();
    node.count = static_cast<std::uint32_t>(count);
    for (unsigned lane = 0; lane < tree_width; ++lane) {
      const Bounds<float> box = lane < count ? nodes_[open[lane]].box : Bounds<float>{};
      for (int axis = 0; axis < 3; ++axis)
        node.planes[axis][lane] = box.min[axis], node.planes[axis + 3][lane] = box.max[axis];
    }
    if (build_.watcher != nullptr) {
      BuildStep step{.kind = BuildStep::Kind::joined, .box = wide(nodes_[index].box)};
      step.depth = depth, step.items = static_cast<int>(count);
      for (std::size_t i = 0; i < count; ++i) {
        const BinaryNode& binary = nodes_[open[i]];
        step.parts.push_back({wide(binary.box), binary.leaf() ? binary.count.all() : 0});
      }
      build_.watcher->add(std::move(step));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const BinaryNode& binary = nodes_[open[i]];
      const TreeChild child = binary.leaf() ? leaf(binary) : TreeChild::node(collapse(open[i], depth + 1));
      tree_.nodes_[place].children[i] = child;
    }
    return static_cast<std::uint32_t>(place);
  }

  TreeChild leaf(const BinaryNode& binary) {
    const TreeItem* items = &items_[binary.first];
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
  std::vector<TreeItem> items_;
  const BuildOptions& build_;
  std::vector<BinaryNode> nodes_;
  float per_unit_ = 1;  ///< lengths are measured by this in areas
};

WideTree::WideTree(std::vector<TreeItem> items, const BuildOptions& build) : items_(items.size()) {
  if (!items.empty()) Builder(*this, std::move(items), build);
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
