#pragma once

#include "accel/query.h"

#include <algorithm>
#include <array>

namespace raywalk {

/// Bounding volume hierarchy: a binary tree of boxes over the primitives.
///
/// Built top down by the surface area heuristic over 16 bins (J. Goldsmith and J. Salmon 1987; I. Wald, "On fast
/// construction of SAH-based bounding volume hierarchies", 2007). Traversed nearer child first; a subtree that begins
/// behind the nearest crossing is skipped.
template <class T>
class Bvh {
 public:
  explicit Bvh(const Boxes<T>& boxes) : ids_(boxes.bounded) {
    if (ids_.empty()) return;
    nodes_.reserve(2 * ids_.size());
    nodes_.push_back({boxes.whole, 0, static_cast<int>(ids_.size())});
    split(0, boxes, 0);
    nodes_.shrink_to_fit();
  }

  template <class Query>
  void search(const Ray<T>& ray, const Primitives<T>& primitives, Query& query) const {
    if (nodes_.empty()) return;
    const SlabRay<T> slabs(ray, primitives.maps_rays());
    struct Entry {
      int node;
      T in;
    };
    std::array<Entry, max_depth + 1> waiting;
    std::size_t count = 0;
    if (clip(slabs, nodes_[0].box, {0, query.reach()}).empty()) return;
    int at = 0;
    while (true) {
      const Node& node = nodes_[static_cast<std::size_t>(at)];
      query.enter_node();
      if (node.leaf()) {
        for (int i = node.first; i < node.first + node.count; ++i)
          if (query.test(primitives, ids_[static_cast<std::size_t>(i)])) return;
      } else {
        const Node* child = &nodes_[static_cast<std::size_t>(node.first)];
        const T reach = query.reach();
        const Stretch<T> left = clip(slabs, child[0].box, {0, reach}), right = clip(slabs, child[1].box, {0, reach});
        const bool meets_left = !left.empty(), meets_right = !right.empty();
        if (meets_left && meets_right) {
          const bool left_first = left.in <= right.in;
          at = left_first ? node.first : node.first + 1;
          waiting[count++] = left_first ? Entry{node.first + 1, right.in} : Entry{node.first, left.in};
          continue;
        }
        if (meets_left || meets_right) {
          at = meets_left ? node.first : node.first + 1;
          continue;
        }
      }
      do {
        if (count == 0) return;
        --count;
      } while (waiting[count].in > query.reach());
      at = waiting[count].node;
    }
  }

  [[nodiscard]] AcceleratorStatistics statistics() const {
    return {nodes_.size(), ids_.size(), depth_, nodes_.size() * sizeof(Node) + ids_.size() * sizeof(int)};
  }

 private:
  static constexpr int max_depth = 64, bins = 16, max_leaf = 4;

  /// A leaf holds ids_[first, first + count); an inner node has count 0 and its children at first and first + 1.
  struct Node {
    Bounds<T> box;
    int first = 0, count = 0;
    [[nodiscard]] bool leaf() const { return count > 0; }
  };

  struct Bin {
    Bounds<T> box;
    int count = 0;
  };

  /// Proportional to the chance that a ray which meets the parent meets this box too.
  static T half_area(const Bounds<T>& box) {
    if (box.empty()) return 0;
    const Vec3<T> size = box.max - box.min;
    return size.x * size.y + size.y * size.z + size.z * size.x;
  }

  void split(int index, const Boxes<T>& boxes, int depth) {
    depth_ = std::max(depth_, depth);
    const Node node = nodes_[static_cast<std::size_t>(index)];
    if (node.count == 1 || depth == max_depth - 1) return;
    const auto begin = ids_.begin() + node.first, end = begin + node.count;
    const auto centre = [&](int id, int axis) { return (boxes.box(id).min[axis] + boxes.box(id).max[axis]) / 2; };

    Bounds<T> centres;
    for (auto id = begin; id != end; ++id) centres.include(Vec3<T>(centre(*id, 0), centre(*id, 1), centre(*id, 2)));

    // The cheapest plane of all axes; the cost of a split is the areas weighted with the primitives behind them.
    T best_cost = infinity<T>;
    int best_axis = 0, best_bin = 0;
    const auto bin_of = [&](int id, int axis) {
      const T extent = centres.max[axis] - centres.min[axis];
      const T place = (centre(id, axis) - centres.min[axis]) / extent * bins;
      return std::clamp(static_cast<int>(place), 0, bins - 1);
    };
    for (int axis = 0; axis < 3; ++axis) {
      if (!(centres.max[axis] > centres.min[axis])) continue;
      std::array<Bin, bins> bin{};
      for (auto id = begin; id != end; ++id) {
        Bin& into = bin[static_cast<std::size_t>(bin_of(*id, axis))];
        into.box.include(boxes.box(*id));
        ++into.count;
      }
      std::array<T, bins> below{};  // cost of bins 0..i
      Bin sum;
      for (std::size_t i = 0; i + 1 < bins; ++i) {
        sum.box.include(bin[i].box), sum.count += bin[i].count;
        below[i] = half_area(sum.box) * static_cast<T>(sum.count);
      }
      sum = {};
      for (std::size_t i = bins - 1; i > 0; --i) {
        sum.box.include(bin[i].box), sum.count += bin[i].count;
        const T cost = below[i - 1] + half_area(sum.box) * static_cast<T>(sum.count);
        if (sum.count > 0 && sum.count < node.count && cost < best_cost)
          best_cost = cost, best_axis = axis, best_bin = static_cast<int>(i);
      }
    }
    // Entering a node costs about half a primitive test.
    const T area = half_area(node.box);
    const bool worth = best_cost + area / 2 < area * static_cast<T>(node.count);
    if (!worth && node.count <= max_leaf) return;
    auto middle =
        std::partition(begin, end, [&](int id) { return best_cost < infinity<T> && bin_of(id, best_axis) < best_bin; });
    if (middle == begin || middle == end) {  // all centres coincide: halve the list
      if (node.count <= max_leaf) return;
      middle = begin + node.count / 2;
    }
    const int left_count = static_cast<int>(middle - begin);
    const int left = static_cast<int>(nodes_.size());
    nodes_.push_back({box_of(begin, middle, boxes), node.first, left_count});
    nodes_.push_back({box_of(middle, end, boxes), node.first + left_count, node.count - left_count});
    nodes_[static_cast<std::size_t>(index)].first = left;
    nodes_[static_cast<std::size_t>(index)].count = 0;
    split(left, boxes, depth + 1);
    split(left + 1, boxes, depth + 1);
  }

  template <class Iterator>
  static Bounds<T> box_of(Iterator begin, Iterator end, const Boxes<T>& boxes) {
    Bounds<T> box;
    for (auto id = begin; id != end; ++id) box.include(boxes.box(*id));
    return box;
  }

  std::vector<int> ids_;
  std::vector<Node> nodes_;
  int depth_ = 0;
};

}  // namespace raywalk
