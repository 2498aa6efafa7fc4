#pragma once

#include "accel/build_record.h"
#include "accel/search_record.h"
#include "accel/slabs.h"

#include <algorithm>
#include <array>
#include <utility>

namespace raywalk {

/// Octree (A. Glassner, "Space subdivision for fast ray tracing", 1984): cubes are halved along all three axes while
/// they hold many primitives. A primitive that overlaps several cubes is listed in each; each leaf keeps the box of its
/// own cube, and children are visited in the order in which the ray enters them.
template <class T>
class Octree {
 public:
  explicit Octree(const PrimitiveBounds<T>& boxes, const BuildOptions& build = {}) {
    if (boxes.bounded.empty()) return;
    nodes_.push_back({boxes.whole, 0, 0, false});
    split(0, boxes.bounded, boxes, 0, most_listed * boxes.bounded.size(), build);
  }

  template <class AnyRay, class Query>
  void search(const AnyRay& ray, const Primitives<T>& primitives, Query& query) const {
    if (nodes_.empty()) return;
    const auto slabs = slabs_of(ray, primitives);
    StackEntry stack[7 * max_depth + 8];
    std::size_t count = 0;
    const RayInterval<T> root = clip(slabs, nodes_[0].box, {0, query.t_far()});
    if (!root.empty()) {
      stack[count++] = {0, root.in};
    } else if constexpr (Watching<Query>) {
      query.record().skipped(nodes_[0].box);
    }
    while (count > 0) {
      const StackEntry entry = stack[--count];
      const Node& node = nodes_[entry.node];
      if (entry.in > query.t_far()) {
        if constexpr (Watching<Query>) query.record().skipped(node.box);
        continue;
      }
      query.enter_node();
      if constexpr (Watching<Query>) query.record().entered(node.box, !node.inner, node.count);
      if (!node.inner) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
          if (query.test(primitives, ids_[i])) return;
        continue;
      }
      // Push the children that are hit, the farthest first.
      const std::size_t before = count;
      for (std::uint32_t child = node.first; child < node.first + node.count; ++child) {
        const RayInterval<T> met = clip(slabs, nodes_[child].box, {0, query.t_far()});
        if (!met.empty()) {
          stack[count++] = {child, met.in};
        } else if constexpr (Watching<Query>) {
          query.record().skipped(nodes_[child].box);
        }
      }
      // At most eight, for which the library's sort is too much code, and in each library takes ties in another order.
      for (std::size_t i = before + 1; i < count; ++i)
        for (std::size_t j = i; j > before && stack[j].in > stack[j - 1].in; --j) std::swap(stack[j], stack[j - 1]);
    }
  }

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most) const {
    if (!nodes_.empty()) list_nodes(nodes, most, 0, 0);
  }

  [[nodiscard]] AcceleratorStatistics statistics() const {
    return {nodes_.size(), ids_.size(), depth_, nodes_.size() * sizeof(Node) + ids_.size() * sizeof(int)};
  }

 private:
  static constexpr int max_depth = 12;
  static constexpr std::size_t max_leaf = 6;
  /// Primitives that all leaves list together, for each that there is: what lies in the same place, and in half of all
  /// octants, would be copied without end.
  static constexpr std::size_t most_listed = 100;

  /// A leaf holds ids_[first, first + count); an inner node's children (the empty ones left out) are the nodes there.
  struct Node {
    Bounds<T> box;
    std::uint32_t first, count;
    bool inner;
  };
  struct StackEntry {
    std::uint32_t node;
    T in;
  };

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most, std::uint32_t index, int depth) const {
    const Node& node = nodes_[index];
    if (nodes.size() < most) nodes.push_back({wide(node.box), depth, !node.inner, static_cast<int>(node.count)});
    for (std::uint32_t i = 0; node.inner && i < node.count; ++i) list_nodes(nodes, most, node.first + i, depth + 1);
  }

  /// `room`: how many primitives the leaves below may list together.
  void split(std::size_t index, const std::vector<int>& ids, const PrimitiveBounds<T>& boxes, int depth,
             std::size_t room, const BuildOptions& build) {
    depth_ = std::max(depth_, depth);
    const Bounds<T> box = nodes_[index].box;
    const Vec3<T> middle = box.min + (box.max - box.min) / T(2);
    std::array<std::vector<int>, 8> parts;
    std::array<Bounds<T>, 8> cubes;
    std::size_t references = 0;
    if (ids.size() > max_leaf && depth < max_depth) {
      for (std::size_t octant = 0; octant < 8; ++octant) {
        cubes[octant] = box;
        for (int axis = 0; axis < 3; ++axis)
          ((octant >> axis & 1) != 0 ? cubes[octant].min : cubes[octant].max)[axis] = middle[axis];
        build.stop.each(ids.begin(), ids.end(), [&](int id) {
          if (overlap(boxes.box(id), cubes[octant])) parts[octant].push_back(id);
        });
        references += parts[octant].size();
      }
    }
    // Splitting primitives that fill the cube only copies them: stop when most primitives land in most octants.
    if (references == 0 || references > 4 * ids.size() || references > room) {
      if (build.watcher != nullptr) {
        BuildStep step{.kind = BuildStep::Kind::leaf, .box = wide(box), .depth = depth};
        step.items = static_cast<int>(ids.size());
        step.why = ids.size() <= 1          ? LeafReason::single
                   : ids.size() <= max_leaf ? LeafReason::few
                   : depth >= max_depth     ? LeafReason::too_deep
                   : references > room      ? LeafReason::too_many_listed
                                            : LeafReason::no_gain;
        build.watcher->add(std::move(step));
      }
      nodes_[index].first = static_cast<std::uint32_t>(ids_.size());
      nodes_[index].count = static_cast<std::uint32_t>(ids.size());
      ids_.insert(ids_.end(), ids.begin(), ids.end());
      return;
    }
    const std::size_t first = nodes_.size();
    std::array<std::size_t, 8> child{};
    for (std::size_t octant = 0; octant < 8; ++octant) {
      if (parts[octant].empty()) continue;
      child[octant] = nodes_.size();
      nodes_.push_back({cubes[octant], 0, 0, false});
    }
    nodes_[index].first = static_cast<std::uint32_t>(first);
    nodes_[index].count = static_cast<std::uint32_t>(nodes_.size() - first);
    nodes_[index].inner = true;
    if (build.watcher != nullptr) {
      BuildStep step{.kind = BuildStep::Kind::eight, .box = wide(box), .depth = depth};
      step.items = static_cast<int>(ids.size());
      for (std::size_t octant = 0; octant < 8; ++octant)
        if (!parts[octant].empty()) step.parts.push_back({wide(cubes[octant]), static_cast<int>(parts[octant].size())});
      build.watcher->add(std::move(step));
    }
    for (std::size_t octant = 0; octant < 8; ++octant)
      if (!parts[octant].empty())
        split(child[octant], parts[octant], boxes, depth + 1, room * parts[octant].size() / references, build);
  }

  static bool overlap(const Bounds<T>& a, const Bounds<T>& b) {
    return a.min.x <= b.max.x && b.min.x <= a.max.x && a.min.y <= b.max.y && b.min.y <= a.max.y && a.min.z <= b.max.z &&
           b.min.z <= a.max.z;
  }

  std::vector<Node> nodes_;
  std::vector<int> ids_;
  int depth_ = 0;
};

}  // namespace raywalk
