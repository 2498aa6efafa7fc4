#pragma once

#include "accel/build_record.h"
#include "accel/search_record.h"
#include "accel/slabs.h"
#include "math/power.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

namespace raywalk {

/// kd-tree: space split by axis-parallel planes, chosen by the surface area heuristic among the faces of the
/// primitives' boxes (J. MacDonald and K. Booth 1990; V. Havran 2000), sorted once for all nodes (I. Wald and V. Havran
/// 2006). A primitive that touches a plane is listed on both sides; a ray in or near the plane, within rounding, visits
/// both.
template <class T>
class KdTree {
 public:
  explicit KdTree(const PrimitiveBounds<T>& boxes, const BuildOptions& build = {}) {
    if (boxes.bounded.empty()) return;
    box_ = boxes.whole;
    const int count = static_cast<int>(boxes.bounded.size());
    limit_ = std::min(max_depth, 8 + std::ilogb(whole_power(static_cast<double>(count), 13)) / 10);
    nodes_.emplace_back();
    split(0, boxes.bounded, sorted_edges(boxes, build.stop), box_, boxes, 0, 0, most_listed * boxes.bounded.size(),
          build);
  }

  template <class AnyRay, class Query>
  void search(const AnyRay& ray, const Primitives<T>& primitives, Query& query) const {
    if (nodes_.empty()) return;
    const auto slabs = slabs_of(ray, primitives);
    const RayInterval<T> inside = clip(slabs, box_, {0, query.t_far()});
    if (inside.empty()) {
      if constexpr (Watching<Query>) query.record().skipped(box_);
      return;
    }
    // How far off a primitive's map may round the ray, in space and in t; mostly 0.
    Vec3<T> off, off_in_t;
    for (int axis = 0; axis < 3; ++axis) {
      off[axis] = slack_along(slabs, axis);
      off_in_t[axis] = off[axis] > 0 ? off[axis] * std::abs(slabs.inverse[axis]) : T(0);
    }
    struct StackEntry {
      std::uint32_t node;
      T in, out;
      [[no_unique_address]] WatchedOnly<Query, Bounds<T>> box{};
    };
    std::array<StackEntry, max_depth + 2> stack;
    std::size_t count = 0;
    stack[count++] = {0, inside.in, inside.out};
    if constexpr (Watching<Query>) stack[0].box.value = box_;
    while (count > 0) {
      StackEntry at = stack[--count];
      if (at.in > query.t_far()) {
        if constexpr (Watching<Query>) query.record().skipped(at.box.value);
        continue;
      }
      while (true) {
        const Node& node = nodes_[at.node];
        query.enter_node();
        if constexpr (Watching<Query>)
          query.record().entered(at.box.value, node.axis == leaf, node.axis == leaf ? node.count : 2);
        if (node.axis == leaf) {
          for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (query.test(primitives, ids_[i])) return;
          break;
        }
        const int axis = node.axis;
        const T t = (node.plane - ray.origin[axis]) * slabs.inverse[axis];
        // Rounding may move the crossing across either end of the interval: widen it, and visit both children if in
        // doubt.
        const T gap = std::abs(node.plane - ray.origin[axis]);
        const T slack = std::isinf(t) ? (gap <= off[axis] ? infinity<T> : T(0))
                                      : 16 * std::numeric_limits<T>::epsilon() * std::abs(t) + off_in_t[axis];
        // A ray that starts in the plane crosses it at t = 0, so the child that it enters is the far one.
        const bool below_first =
            ray.origin[axis] < node.plane || (ray.origin[axis] == node.plane && !slabs.negative[axis]);
        const std::uint32_t near = below_first ? node.first : node.first + 1;
        const std::uint32_t far = below_first ? node.first + 1 : node.first;
        [[maybe_unused]] WatchedOnly<Query, std::array<Bounds<T>, 2>> sides;  // the nearer one first
        if constexpr (Watching<Query>) {
          sides.value = {at.box.value, at.box.value};
          (below_first ? sides.value[0].max : sides.value[0].min)[axis] = node.plane;
          (below_first ? sides.value[1].min : sides.value[1].max)[axis] = node.plane;
        }
        if (std::isnan(t)) {  // in the plane, without slope
          stack[count++] = {far, at.in, at.out};
          at.node = near;
          if constexpr (Watching<Query>) stack[count - 1].box.value = sides.value[1], at.box.value = sides.value[0];
        } else if (t - slack > at.out || (t < 0 && t + slack < at.in)) {
          at.node = near;
          if constexpr (Watching<Query>) query.record().skipped(sides.value[1]), at.box.value = sides.value[0];
        } else if (t + slack < at.in) {
          at.node = far;
          if constexpr (Watching<Query>) query.record().skipped(sides.value[0]), at.box.value = sides.value[1];
        } else {
          // What lies behind may be ahead by that rounding: then it is the far child that the ray leaves there.
          const T until = std::fmin(at.out, t + slack);
          stack[count++] = {far, t < 0 ? at.in : std::fmax(at.in, t - slack), t < 0 ? until : at.out};
          at = {near, at.in, t < 0 ? at.out : until};
          if constexpr (Watching<Query>) stack[count - 1].box.value = sides.value[1], at.box.value = sides.value[0];
        }
      }
    }
  }

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most) const {
    if (!nodes_.empty()) list_nodes(nodes, most, 0, wide(box_), 0);
  }

  [[nodiscard]] AcceleratorStatistics statistics() const {
    return {nodes_.size(), ids_.size(), depth_, nodes_.size() * sizeof(Node) + ids_.size() * sizeof(int)};
  }

 private:
  static constexpr int max_depth = 48;
  /// How often a primitive may be listed, on average. Meshes need 3 to 6; where triangles all meet in one corner, as in
  /// a fan, most planes cut most of them, and the lists would double from level to level.
  static constexpr std::size_t most_listed = 32;
  static constexpr int leaf = 3;

  /// A leaf holds ids_[first, first + count). An inner node's children are at first (below the plane) and first + 1.
  struct Node {
    T plane = 0;
    int axis = leaf;
    std::uint32_t first = 0, count = 0;
  };

  /// A face of a primitive's box: a candidate for the splitting plane.
  struct BoundEdge {
    T place;
    int id;
    bool begins;
  };
  /// Those of some primitives along each axis, by place; where boxes touch, the one that begins comes first.
  using BoundEdges = std::array<std::vector<BoundEdge>, 3>;

  static BoundEdges sorted_edges(const PrimitiveBounds<T>& boxes, const Stop& stop) {
    BoundEdges edges;
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<BoundEdge>& along = edges[static_cast<std::size_t>(axis)];
      along.reserve(2 * boxes.bounded.size());
      stop.each(boxes.bounded.begin(), boxes.bounded.end(), [&](int id) {
        along.push_back({boxes.box(id).min[axis], id, true});
        along.push_back({boxes.box(id).max[axis], id, false});
      });
      stop.sort(along.begin(), along.end(), [](const BoundEdge& a, const BoundEdge& b) {
        return a.place < b.place || (a.place == b.place && a.begins && !b.begins);
      });
    }
    return edges;
  }

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most, std::uint32_t index, const Bounds<double>& box,
                  int depth) const {
    const Node& node = nodes_[index];
    const bool is_leaf = node.axis == leaf;
    if (nodes.size() < most) nodes.push_back({box, depth, is_leaf, is_leaf ? static_cast<int>(node.count) : 2});
    if (is_leaf) return;
    Bounds<double> low = box, high = box;
    low.max[node.axis] = high.min[node.axis] = static_cast<double>(node.plane);
    list_nodes(nodes, most, node.first, low, depth + 1);
    list_nodes(nodes, most, node.first + 1, high, depth + 1);
  }

  /// `edges`: of these `ids`. `room`: how many primitives the leaves below may list together.
  void split(std::size_t index, const std::vector<int>& ids, BoundEdges edges, const Bounds<T>& box,
             const PrimitiveBounds<T>& boxes, int depth, int bad_cuts, std::size_t room, const BuildOptions& build) {
    depth_ = std::max(depth_, depth);
    constexpr T cost_of_node = T(0.8), bonus_for_empty = T(0.2);
    const T count = static_cast<T>(ids.size()), area = half_area(box);
    T best_cost = infinity<T>, plane = 0;
    int best_axis = leaf;
    if (ids.size() > 1 && depth < limit_ && area > 0) {
      for (int axis = 0; axis < 3; ++axis) {
        const std::vector<BoundEdge>& along = edges[static_cast<std::size_t>(axis)];
        T below = 0, above = count;
        build.stop.each(along.begin(), along.end(), [&](const BoundEdge& edge) {
          if (!edge.begins) above -= 1;
          if (edge.place > box.min[axis] && edge.place < box.max[axis]) {
            Bounds<T> low = box, high = box;
            low.max[axis] = high.min[axis] = edge.place;
            const T empty = below == 0 || above == 0 ? 1 - bonus_for_empty : T(1);
            const T cost = cost_of_node + empty * (half_area(low) * below + half_area(high) * above) / area;
            if (cost < best_cost) best_cost = cost, best_axis = axis, plane = edge.place;
          }
          if (edge.begins) below += 1;
        });
      }
    }
    if (best_cost > count) ++bad_cuts;
    std::optional<BuildStep> told;
    if (build.watcher != nullptr) {
      told = {.kind = BuildStep::Kind::leaf, .box = wide(box), .depth = depth};
      told->items = static_cast<int>(ids.size());
      if (best_axis != leaf)
        told->split_cost = static_cast<double>(best_cost), told->leaf_cost = static_cast<double>(count);
    }
    const auto is_low = [&](int id) { return boxes.box(id).min[best_axis] <= plane; };
    const auto is_high = [&](int id) { return boxes.box(id).max[best_axis] >= plane; };
    std::vector<int> low_ids, high_ids;
    if (best_axis != leaf)
      build.stop.each(ids.begin(), ids.end(), [&](int id) {
        if (is_low(id)) low_ids.push_back(id);
        if (is_high(id)) high_ids.push_back(id);
      });
    const bool dear = bad_cuts > 2 || (best_cost > 4 * count && count < 16);
    if (best_axis == leaf || dear || low_ids.size() + high_ids.size() > room) {
      if (told) {
        told->why = ids.size() <= 1     ? LeafReason::single
                    : depth >= limit_   ? LeafReason::too_deep
                    : best_axis == leaf ? LeafReason::same_place
                    : dear              ? LeafReason::split_costs_more
                                        : LeafReason::too_many_listed;
        build.watcher->add(std::move(*told));
      }
      nodes_[index].first = static_cast<std::uint32_t>(ids_.size());
      nodes_[index].count = static_cast<std::uint32_t>(ids.size());
      ids_.insert(ids_.end(), ids.begin(), ids.end());
      return;
    }
    Bounds<T> low = box, high = box;
    low.max[best_axis] = high.min[best_axis] = plane;
    if (told) {
      told->kind = BuildStep::Kind::split;
      told->axis = best_axis, told->plane = static_cast<double>(plane);
      told->parts = {{wide(low), static_cast<int>(low_ids.size())}, {wide(high), static_cast<int>(high_ids.size())}};
      build.watcher->add(std::move(*told));
    }
    BoundEdges low_edges, high_edges;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_edges[axis].reserve(2 * low_ids.size());
      high_edges[axis].reserve(2 * high_ids.size());
      build.stop.each(edges[axis].begin(), edges[axis].end(), [&](const BoundEdge& edge) {
        if (is_low(edge.id)) low_edges[axis].push_back(edge);
        if (is_high(edge.id)) high_edges[axis].push_back(edge);
      });
      edges[axis] = {};
    }
    const std::size_t first = nodes_.size();
    nodes_.resize(first + 2);
    nodes_[index] = {plane, best_axis, static_cast<std::uint32_t>(first), 0};
    // Each side takes its share of the room, which is at least what it lists.
    const std::size_t low_room = room * low_ids.size() / (low_ids.size() + high_ids.size());
    split(first, low_ids, std::move(low_edges), low, boxes, depth + 1, bad_cuts, low_room, build);
    split(first + 1, high_ids, std::move(high_edges), high, boxes, depth + 1, bad_cuts, room - low_room, build);
  }

  Bounds<T> box_;
  std::vector<Node> nodes_;
  std::vector<int> ids_;
  int depth_ = 0, limit_ = 0;
};

}  // namespace raywalk
