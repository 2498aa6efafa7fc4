#include "accel/binary_tree.h"

#include "accel/search_record.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace raywalk {

namespace {

constexpr std::size_t most_bins = 16;

/// Which bin an item's centre falls into, along all axes at once.
struct Binning {
  Binning(const LaneBox& centres, std::size_t bins)
      : least(centres.min), last(all_lanes(static_cast<float>(bins - 1))) {
    per_unit = all_lanes(static_cast<float>(bins)) / (centres.max - centres.min);
  }
  [[nodiscard]] LaneMask of(const TreeItem& item) const {
    const Lanes place = (LaneBox(item.box).centre() - least) * per_unit;
    // NaN, where all centres coincide, becomes 0.
    return __builtin_convertvector(min(max(place, all_lanes(0)), last), LaneMask);
  }
  Lanes least, per_unit, last;
};

/// The cheapest plane: items whose bin is below `bin` go to the left.
struct Split {
  float cost = infinity<float>;  ///< of both sides, in units of MeetingChance times tests
  std::size_t axis = 0, bin = 0;
  Bin left, right;
};

class Builder {
 public:
  Builder(BinaryTree& tree, std::vector<TreeItem> items, const BuildOptions& build, const CornersOf& corners)
      : tree_(tree), waiting_(std::move(items)), build_(build), quality_(build.quality_for(waiting_.size())) {
    BinaryNode root;
    LaneBox whole, centres;
    build_.stop.each(waiting_.begin(), waiting_.end(), [&](const TreeItem& item) {
      const LaneBox box(item.box);
      whole.include(box);
      centres.include_point(box.centre());
      root.count += ItemCounts::of(item);
    });
    root.box = whole.bounds();
    tree_.chance = MeetingChance(whole);
    // Without triangles by areas alone, at the costs of a Bvh: beams are cut in the order of its faces (wide_tree.cpp).
    if (root.count.packed == 0) tree_.chance.per_volume = 0, cost_of_split_ = ItemCounts::cost_of_node;
    if (quality_ == BuildQuality::best && corners) splitter_.emplace(corners, tree_.chance);
    tree_.items.reserve(waiting_.size());
    // About as many as there will be, so that the list is seldom copied.
    tree_.nodes.reserve(static_cast<std::size_t>(root.count.packed) / 2 +
                        3 * static_cast<std::size_t>(root.count.others) / 2 + 1);
    tree_.nodes.push_back(root);
    split(0, centres, 0, splitter_ ? waiting_.size() / 2 : 0);
  }

 private:
  [[nodiscard]] float chance(const LaneBox& box) const { return tree_.chance(box); }
  /// Fewer where there is little to tell apart: most nodes are small.
  [[nodiscard]] std::size_t bins_for(std::int32_t items) const {
    return items > 64 && quality_ != BuildQuality::fast ? most_bins : most_bins / 2;
  }

  /// Along which planes are tried: [first, end).
  struct Axes {
    std::size_t first = 0, end = 3;
  };
  [[nodiscard]] Axes axes_for(const LaneBox& centres) const {
    if (quality_ != BuildQuality::fast) return {};
    const Lanes size = centres.max - centres.min;
    const std::size_t longer = size[1] > size[0] ? 1 : 0, longest = size[2] > size[longer] ? 2 : longer;
    return {longest, longest + 1};
  }

  [[nodiscard]] Split cheapest(const BinaryNode& node, const LaneBox& centres) const {
    Split best;
    const auto begin = waiting_.end() - node.count.all(), end = waiting_.end();
    const std::size_t bins = bins_for(node.count.all());
    const Binning binning(centres, bins);
    const Axes axes = axes_for(centres);
    std::array<std::array<Bin, most_bins>, 3> all;
    build_.stop.each(begin, end, [&](const TreeItem& item) {
      const LaneMask at = binning.of(item);
      const LaneBox box(item.box);
      const ItemCounts one = ItemCounts::of(item);
      for (std::size_t axis = axes.first; axis < axes.end; ++axis) {
        Bin& bin = all[axis][static_cast<std::size_t>(at[axis])];
        bin.box.include(box);
        bin.count += one;
      }
    });
    for (std::size_t axis = axes.first; axis < axes.end; ++axis) {
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
            chance(below.box) * below.count.expected_cost() + chance(above[i].box) * above[i].count.expected_cost();
        if (cost < best.cost) best = {cost, axis, i, below, above[i]};
      }
    }
    return best;
  }

  /// The node's items are the last ones that wait. `centres`: the bounds of their centres; `spare`: how many more may
  /// be listed because space is split.
  void split(std::size_t index, const LaneBox& centres, std::size_t depth, std::size_t spare) {
    build_.stop.check();
    const BinaryNode node = tree_.nodes[index];
    std::optional<BuildStep> told;
    if (build_.watcher != nullptr) {
      told = {.kind = BuildStep::Kind::leaf, .box = wide(node.box), .depth = static_cast<int>(depth)};
      told->items = node.count.all();
    }
    const auto end_as_leaf = [&](LeafReason why) {
      tree_.nodes[index].first = static_cast<std::uint32_t>(tree_.items.size());
      tree_.items.insert(tree_.items.end(), waiting_.end() - node.count.all(), waiting_.end());
      waiting_.resize(waiting_.size() - static_cast<std::size_t>(node.count.all()));
      if (!told) return;
      told->why = why;
      build_.watcher->add(std::move(*told));
    };
    if (node.count.all() == 1) return end_as_leaf(LeafReason::single);
    Split best;
    if (depth < BinaryTree::max_depth - 1) best = cheapest(node, centres);
    // Not for the few of a leaf, which are tested together.
    const bool may_split_space = spare > 0 && !node.count.fits_leaf() && depth < BinaryTree::max_depth - 1;
    const SpatialPlane plane = may_split_space ? plane_for(node, best) : SpatialPlane{};
    const float cost = std::min(best.cost, plane.cost);
    const bool found = cost < infinity<float>;
    const float own_chance = chance(LaneBox(node.box));
    if (told && found && own_chance > 0) {
      told->split_cost = static_cast<double>(cost / own_chance + cost_of_split_);
      told->leaf_cost = static_cast<double>(node.count.leaf_cost());
      told->axis = plane.cost < best.cost ? plane.axis : static_cast<int>(best.axis);
      const float low = centres.min[told->axis], high = centres.max[told->axis];
      told->plane =
          static_cast<double>(plane.cost < best.cost ? plane.at
                                                     : low + (high - low) * static_cast<float>(best.bin) /
                                                                 static_cast<float>(bins_for(node.count.all())));
    }
    if (node.count.fits_leaf() && !(cost / own_chance + cost_of_split_ < node.count.leaf_cost()))
      return end_as_leaf(found ? LeafReason::split_costs_more : LeafReason::same_place);

    Bin left, right;
    LaneBox left_centres, right_centres;
    bool parted = false;
    if (plane.cost < best.cost) {
      const std::size_t more = part_space(node, plane, spare, left, right, left_centres, right_centres);
      parted = more <= spare;
      if (parted) spare -= more, tree_.splits_space = true;
    }
    if (!parted && best.cost < infinity<float>) {
      left = best.left, right = best.right;
      part(node, centres, best, left_centres, right_centres);
    } else if (!parted) {  // all centres coincide: halve the list
      const auto begin = waiting_.end() - node.count.all(), middle = waiting_.end() - node.count.all() / 2;
      for (auto item = begin; item != waiting_.end(); ++item) {
        Bin& side = item < middle ? right : left;
        const LaneBox box(item->box);
        side.box.include(box);
        side.count += ItemCounts::of(*item);
        (item < middle ? right_centres : left_centres).include_point(box.centre());
      }
      if (told) told->axis = -1;
    }
    const std::size_t children = tree_.nodes.size();
    tree_.nodes[index].left = static_cast<std::uint32_t>(children);
    tree_.nodes.push_back({left.box.bounds(), left.count});
    tree_.nodes.push_back({right.box.bounds(), right.count});
    if (told) {
      told->kind = BuildStep::Kind::split;
      for (const Bin* side : {&left, &right}) told->parts.push_back({wide(side->box.bounds()), side->count.all()});
      build_.watcher->add(std::move(*told));
    }
    const std::size_t spare_left = spare * static_cast<std::size_t>(left.count.all()) /
                                   static_cast<std::size_t>(left.count.all() + right.count.all());
    split(children, left_centres, depth + 1, spare_left);
    split(children + 1, right_centres, depth + 1, spare - spare_left);
  }

  /// A plane that splits space, where the boxes of the best split of the list overlap so much that it may pay.
  [[nodiscard]] SpatialPlane plane_for(const BinaryNode& node, const Split& best) const {
    constexpr float enough = 0.01F;  // of the root's, after Stich et al.
    if (best.cost < infinity<float>) {
      LaneBox overlap;
      overlap.min = max(best.left.box.min, best.right.box.min);
      overlap.max = min(best.left.box.max, best.right.box.max);
      if (!(chance(overlap) > enough * chance(LaneBox(tree_.nodes[0].box)))) return {};
    }
    return splitter_->cheapest(items_of(node), node.box);
  }
  [[nodiscard]] std::span<const TreeItem> items_of(const BinaryNode& node) const {
    return std::span(waiting_).last(static_cast<std::size_t>(node.count.all()));
  }

  /// Moves the items of `node` to their sides of the plane, the right ones first, and bounds their centres.
  void part(const BinaryNode& node, const LaneBox& centres, const Split& plane, LaneBox& left_centres,
            LaneBox& right_centres) {
    const Binning binning(centres, bins_for(node.count.all()));
    const auto is_left = [&](const TreeItem& item) {
      return static_cast<std::size_t>(binning.of(item)[plane.axis]) < plane.bin;
    };
    auto low = waiting_.end() - node.count.all(), high = waiting_.end();
    while (low != high) {
      const Lanes centre = LaneBox(low->box).centre();
      if (is_left(*low)) {
        left_centres.include_point(centre);
        std::swap(*low, *--high);
      } else {
        right_centres.include_point(centre);
        ++low;
      }
    }
  }

  /// The same where space is split. Returns how many items are listed twice, or more than `spare` and has done nothing.
  std::size_t part_space(const BinaryNode& node, const SpatialPlane& plane, std::size_t spare, Bin& left, Bin& right,
                         LaneBox& left_centres, LaneBox& right_centres) {
    const auto all = static_cast<std::size_t>(node.count.all());
    const SpatialSplitter::Sides sides = splitter_->part(items_of(node), plane);
    const std::size_t of_left = sides.left_items.size(), of_right = sides.right_items.size();
    if (of_left + of_right - all > spare || of_left == 0 || of_right == 0 || std::max(of_left, of_right) == all)
      return spare + 1;
    left = sides.left, right = sides.right;
    waiting_.resize(waiting_.size() - all);
    for (const TreeItem& item : sides.right_items) right_centres.include_point(LaneBox(item.box).centre());
    for (const TreeItem& item : sides.left_items) left_centres.include_point(LaneBox(item.box).centre());
    waiting_.insert(waiting_.end(), sides.right_items.begin(), sides.right_items.end());
    waiting_.insert(waiting_.end(), sides.left_items.begin(), sides.left_items.end());
    return of_left + of_right - all;
  }

  BinaryTree& tree_;
  std::vector<TreeItem> waiting_;
  const BuildOptions& build_;
  BuildQuality quality_;
  float cost_of_split_ = 0.2F;  ///< in tests of one primitive: most splits only fill a wide node, few make another one
  std::optional<SpatialSplitter> splitter_;
};

}  // namespace

BuildQuality BuildOptions::quality_for(std::size_t triangles) const {
  if (quality != BuildQuality::automatic) return quality;
  // What is saved in building a triangle, so many rays lose (tests/benchmark/README.md).
  constexpr double few = 10;
  const bool hurry = expected_rays > 0 && expected_rays < few * static_cast<double>(triangles);
  return hurry ? BuildQuality::fast : BuildQuality::good;
}

BinaryTree::BinaryTree(std::vector<TreeItem> all, const BuildOptions& build, const CornersOf& corners)
    : chance(LaneBox{}) {
  Builder(*this, std::move(all), build, corners);
}

}  // namespace raywalk
