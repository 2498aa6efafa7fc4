#pragma once

#include "accel/box_lanes.h"
#include "accel/build_record.h"
#include "accel/search_record.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <utility>

namespace raywalk {

/// Bounding volume hierarchy: a tree of boxes over the primitives, four per node, which are tested together.
///
/// Built top-down as a binary tree by the surface area heuristic over 16 bins (J. Goldsmith and J. Salmon 1987; I.
/// Wald, "On fast construction of SAH-based bounding volume hierarchies", 2007), which is then collapsed into a wide
/// one (H. Dammertz, J. Hanika and A. Keller, "Shallow bounding volume hierarchies for fast SIMD ray tracing of
/// incoherent rays", 2008). Traversed nearest child first; a subtree that begins beyond the nearest hit is skipped.
///
/// For primitives that are tested one by one. Meshes have a MeshBvh, whose rays cost more before the first box and less
/// from then on (structures.cpp).
template <class T>
class Bvh {
 public:
  explicit Bvh(const PrimitiveBounds<T>& boxes, const BuildOptions& build = {}) : ids_(boxes.bounded) {
    if (ids_.empty()) return;
    std::vector<SplitNode> split_nodes;
    split_nodes.reserve(2 * ids_.size());
    split_nodes.push_back({boxes.whole, 0, static_cast<int>(ids_.size())});
    split(split_nodes, 0, boxes, 0, build);
    collapse(split_nodes, 0, 0, build);
    nodes_.shrink_to_fit();
  }

  template <class Query>
  [[gnu::flatten]] void search(const Ray<T>& ray, const Primitives<T>& primitives, Query& query) const {
    if (nodes_.empty()) return;
    const LaneRay<T> lanes(ray);
    if (lanes.held())
      search(lanes, primitives, query);
    else
      search_wide(ray, primitives, query);
  }
  template <class Query>
  void search(const NaiveRay<T>& ray, const Primitives<T>& primitives, Query& query) const {
    if (!nodes_.empty()) search(WideLaneRay<T, NaiveSlabRay<T>>(slabs_of(ray, primitives)), primitives, query);
  }

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most) const {
    if (!nodes_.empty()) list_nodes(nodes, most, 0, 0);
  }

  [[nodiscard]] AcceleratorStatistics statistics() const {
    return {nodes_.size(), ids_.size(), depth_, nodes_.size() * sizeof(Node) + ids_.size() * sizeof(int)};
  }

 private:
  static constexpr int max_depth = 64, bins = 16, max_leaf = 4;

  /// A leaf holds ids_[first, first + count); an inner node, nodes_[first], has count 0.
  struct Child {
    std::int32_t first, count;
  };
  struct alignas(64) Node {
    BoxLanes boxes;
    std::array<Child, 4> children{};

    /// The bounds of all four.
    [[nodiscard]] Bounds<float> whole() const {
      Bounds<float> whole;
      for (std::size_t lane = 0; lane < 4; ++lane) whole.include(boxes.box(lane));
      return whole;
    }
    [[nodiscard]] std::size_t child_count() const {
      std::size_t count = 0;
      for (std::size_t lane = 0; lane < 4; ++lane) count += boxes.box(lane).empty() ? 0 : 1;
      return count;
    }
  };
  /// A node of the binary tree, with a box in T, where those of a BinaryTree are in float. A leaf has count > 0; an
  /// inner node's children are at first and first + 1.
  struct SplitNode {
    Bounds<T> box;
    int first = 0, count = 0;
    [[nodiscard]] bool leaf() const { return count > 0; }
  };

  /// Separate, as few rays exceed the range of float.
  template <class Query>
  [[gnu::noinline, gnu::cold]] void search_wide(const Ray<T>& ray, const Primitives<T>& primitives,
                                                Query& query) const {
    search(WideLaneRay<T, SlabRay<T>>(slabs_of(ray, primitives)), primitives, query);
  }

  template <class AnyLaneRay, class Query>
  [[gnu::flatten]] void search(const AnyLaneRay& ray, const Primitives<T>& primitives, Query& query) const {
    struct StackEntry {
      Child child;
      float in;
      [[no_unique_address]] WatchedOnly<Query, Bounds<float>> box{};
    };
    std::array<StackEntry, 3 * max_depth + 4> stack;
    std::size_t count = 0;
    Child at{0, 0};
    LaneFar<T> t_far(query.t_far());
    [[maybe_unused]] WatchedOnly<Query, Bounds<float>> box;  // of `at`
    while (true) {
      if (at.count == 0) {
        const Node& node = nodes_[static_cast<std::size_t>(at.first)];
        query.enter_node();
        LaneHits met = ray.intersect(node.boxes, t_far);
        if constexpr (Watching<Query>) tell(query, node, met);
        if (met.bits != 0) {
          // The nearest child is next; the others go onto the stack, nearer ones on top if the search can shorten.
          const std::size_t before = count;
          auto next = static_cast<std::size_t>(std::countr_zero(met.bits));
          while ((met.bits &= met.bits - 1) != 0) {
            auto waits = static_cast<std::size_t>(std::countr_zero(met.bits));
            std::size_t place = count++;
            if constexpr (Query::shortens) {
              if (met.in[waits] <= met.in[next]) std::swap(waits, next);
              for (; place > before && stack[place - 1].in < met.in[waits]; --place) stack[place] = stack[place - 1];
            } else {
              std::swap(waits, next);
            }
            stack[place].child = node.children[waits];
            stack[place].in = met.in[waits];
            if constexpr (Watching<Query>) stack[place].box.value = node.boxes.box(waits);
          }
          at = node.children[next];
          if constexpr (Watching<Query>) box.value = node.boxes.box(next);
          continue;
        }
      } else {
        if constexpr (Watching<Query>) query.record().opened(box.value, static_cast<std::size_t>(at.count));
        for (std::int32_t i = at.first; i < at.first + at.count; ++i)
          if (query.test(primitives, ids_[static_cast<std::size_t>(i)])) return;
        if constexpr (Query::shortens) t_far = LaneFar<T>(query.t_far());
      }
      while (true) {
        if (count == 0) return;
        --count;
        // A box hit before t_far is still hit, unless t_far has become shorter.
        if (!Query::shortens || !beyond(stack[count].in, query.t_far())) break;
        if constexpr (Watching<Query>) query.record().skipped(stack[count].box.value);
      }
      at = stack[count].child;
      if constexpr (Watching<Query>) box = stack[count].box;
    }
  }

  template <class Query>
  static void tell(const Query& query, const Node& node, const LaneHits& met) {
    query.record().entered(node.whole(), false, node.child_count());
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Bounds<float> box = node.boxes.box(lane);
      if (!box.empty() && (met.bits >> lane & 1U) == 0) query.record().skipped(box);
    }
  }

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most, std::size_t index, int depth) const {
    const Node& node = nodes_[index];
    if (nodes.size() < most) nodes.push_back({wide(node.whole()), depth, false, static_cast<int>(node.child_count())});
    for (std::size_t lane = 0; lane < 4; ++lane) {
      const Bounds<float> box = node.boxes.box(lane);
      const Child& child = node.children[lane];
      if (box.empty()) continue;
      if (child.count == 0)
        list_nodes(nodes, most, static_cast<std::size_t>(child.first), depth + 1);
      else if (nodes.size() < most)
        nodes.push_back({wide(box), depth + 1, true, child.count});
    }
  }

  /// Whether a box entered at `in`, up to rounding, lies beyond t_far.
  static bool beyond(float in, T t_far) {
    return static_cast<T>(in * (1 - 8 * std::numeric_limits<float>::epsilon())) > t_far;
  }

  /// Collapses the binary node at `index` and its descendants into wide nodes; returns its index.
  std::int32_t collapse(const std::vector<SplitNode>& split_nodes, int index, int depth, const BuildOptions& build) {
    build.stop.check();
    // The largest inner node is replaced by its children until there are four nodes or only leaves.
    std::array<int, 4> open{index};
    std::size_t count = 1;
    while (count < open.size()) {
      int* largest = nullptr;
      for (std::size_t i = 0; i < count; ++i) {
        const auto binary = [&](int at) -> const SplitNode& { return split_nodes[static_cast<std::size_t>(at)]; };
        if (binary(open[i]).leaf()) continue;
        if (largest == nullptr || half_area(binary(open[i]).box) > half_area(binary(*largest).box)) largest = &open[i];
      }
      if (largest == nullptr) break;
      const int children = split_nodes[static_cast<std::size_t>(*largest)].first;
      *largest = children;
      open[count++] = children + 1;
    }
    depth_ = std::max(depth_, depth);
    const auto place = nodes_.size();
    nodes_.emplace_back();
    if (build.watcher != nullptr) {
      BuildStep step{.kind = BuildStep::Kind::joined, .box = wide(split_nodes[static_cast<std::size_t>(index)].box)};
      step.depth = depth, step.items = static_cast<int>(count);
      for (std::size_t i = 0; i < count; ++i) {
        const SplitNode& binary = split_nodes[static_cast<std::size_t>(open[i])];
        step.parts.push_back({wide(binary.box), binary.count});
      }
      build.watcher->add(std::move(step));
    }
    for (std::size_t i = 0; i < count; ++i) {
      const SplitNode& binary = split_nodes[static_cast<std::size_t>(open[i])];
      nodes_[place].boxes.set(i, binary.box);
      const Child child = binary.leaf() ? Child{binary.first, binary.count}
                                        : Child{collapse(split_nodes, open[i], depth + 1, build), 0};
      nodes_[place].children[i] = child;
    }
    return static_cast<std::int32_t>(place);
  }

  struct Bin {
    Bounds<T> box;
    int count = 0;
  };

  void split(std::vector<SplitNode>& split_nodes, int index, const PrimitiveBounds<T>& boxes, int depth,
             const BuildOptions& build) {
    const SplitNode node = split_nodes[static_cast<std::size_t>(index)];
    std::optional<BuildStep> told;
    if (build.watcher != nullptr) {
      told = {.kind = BuildStep::Kind::leaf, .box = wide(node.box), .depth = depth};
      told->items = node.count;
    }
    const auto tell_leaf = [&](LeafReason why) {
      if (!told) return;
      told->why = why;
      build.watcher->add(std::move(*told));
    };
    if (node.count == 1 || depth == max_depth - 1)
      return tell_leaf(node.count == 1 ? LeafReason::single : LeafReason::too_deep);
    const auto begin = ids_.begin() + node.first, end = begin + node.count;
    const auto centre = [&](int id, int axis) { return (boxes.box(id).min[axis] + boxes.box(id).max[axis]) / 2; };

    Bounds<T> centres;
    build.stop.each(begin, end, [&](int id) { centres.include(Vec3<T>(centre(id, 0), centre(id, 1), centre(id, 2))); });

    // The cheapest plane over all axes; the cost of a split is the sum of area times number of primitives.
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
      build.stop.each(begin, end, [&](int id) {
        Bin& into = bin[static_cast<std::size_t>(bin_of(id, axis))];
        into.box.include(boxes.box(id));
        ++into.count;
      });
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
    // Entering a node costs about half as much as a primitive test.
    const T area = half_area(node.box);
    const bool worth = best_cost + area / 2 < area * static_cast<T>(node.count);
    if (told && best_cost < infinity<T> && area > 0) {
      told->split_cost = static_cast<double>(best_cost / area) + 0.5, told->leaf_cost = node.count;
      told->axis = best_axis;
      told->plane = static_cast<double>(centres.min[best_axis] + (centres.max[best_axis] - centres.min[best_axis]) *
                                                                     static_cast<T>(best_bin) / T(bins));
    }
    if (!worth && node.count <= max_leaf)
      return tell_leaf(best_cost < infinity<T> ? LeafReason::split_costs_more : LeafReason::same_place);
    auto middle =
        std::partition(begin, end, [&](int id) { return best_cost < infinity<T> && bin_of(id, best_axis) < best_bin; });
    if (middle == begin || middle == end) {  // all centres coincide: halve the list
      if (node.count <= max_leaf) return tell_leaf(LeafReason::same_place);
      middle = begin + node.count / 2;
      if (told) told->axis = -1;
    }
    const int left_count = static_cast<int>(middle - begin);
    const int left = static_cast<int>(split_nodes.size());
    split_nodes.push_back({box_of(begin, middle, boxes), node.first, left_count});
    split_nodes.push_back({box_of(middle, end, boxes), node.first + left_count, node.count - left_count});
    split_nodes[static_cast<std::size_t>(index)].first = left;
    split_nodes[static_cast<std::size_t>(index)].count = 0;
    if (told) {
      told->kind = BuildStep::Kind::split;
      for (const int side : {left, left + 1}) {
        const SplitNode& binary = split_nodes[static_cast<std::size_t>(side)];
        told->parts.push_back({wide(binary.box), binary.count});
      }
      build.watcher->add(std::move(*told));
    }
    split(split_nodes, left, boxes, depth + 1, build);
    split(split_nodes, left + 1, boxes, depth + 1, build);
  }

  template <class Iterator>
  static Bounds<T> box_of(Iterator begin, Iterator end, const PrimitiveBounds<T>& boxes) {
    Bounds<T> box;
    for (auto id = begin; id != end; ++id) box.include(boxes.box(*id));
    return box;
  }

  std::vector<int> ids_;
  std::vector<Node> nodes_;
  int depth_ = 0;
};

}  // namespace raywalk
