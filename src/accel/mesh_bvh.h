#pragma once

#include "accel/mesh_copies.h"
#include "accel/packet_search.h"
#include "accel/search_record.h"
#include "accel/wide_search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <type_traits>

namespace raywalk {

/// Bounding volume hierarchy over primitives that are mostly triangles: a tree of boxes, eight per node, which are
/// tested together, as are the triangles of a leaf (accel/wide_tree.h, accel/lane_tests.h). Traversed nearest child
/// first; a subtree that begins beyond the nearest hit is skipped. Copies of meshes have trees of their own, which come
/// after it. Other scenes have a Bvh (structures.cpp).
template <class T>
class MeshBvh {
 public:
  MeshBvh(const PrimitiveBounds<T>& boxes, const Primitives<T>& primitives, const BuildOptions& build = {});

  template <class Query>
  [[gnu::noinline]] void search(const Ray<T>& ray, const Primitives<T>& primitives, Query& query) const {
    const MeshRay lanes(ray);
    if (lanes.held)
      search_all(lanes, ray, primitives, query);
    else
      walk_beyond_float(ray, primitives, query);
  }
  template <class Query>
  [[gnu::noinline]] void search(const NaiveRay<T>& ray, const Primitives<T>& primitives, Query& query) const {
    search_all(slabs_of(ray, primitives), ray, primitives, query);
  }

  /// The same for several queries with the same TestCounts, RayPacket::most at most: each has the answer that it has
  /// alone. Neighbours that are coherent are searched together (accel/packet_search.h).
  template <class Query>
  [[gnu::noinline]] void search(std::span<std::optional<Query>> queries, const Primitives<T>& primitives) const {
    const auto ray = [&](unsigned i) -> const Ray<T>& { return queries[i]->ray(); };
    const auto count = static_cast<unsigned>(queries.size());
    if (longest_run(count, ray) < fewest_together) {
      for (unsigned i = 0; i < count; ++i)
        if (!queries[i]->over()) search(ray(i), primitives, *queries[i]);
      return;
    }
    const RaysAbreast rays(count, ray);
    for (unsigned first = 0, end = 0; first < count; first = end) {
      const auto run = static_cast<unsigned>(std::countr_one(rays.coherent(first, near_each_other_) >> first));
      end = first + std::max(run, 1U);
      const bool together = run >= fewest_together;
      if (together) walk(rays, (1U << end) - (1U << first), primitives, queries);
      for (unsigned i = first; i < end; ++i) {
        Query& query = *queries[i];
        if (query.over()) continue;
        if (!together)
          search(ray(i), primitives, query);
        else if (copies_)
          copies_->search(MeshRay(ray(i)), ray(i), primitives, query);
      }
    }
  }

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most) const {
    tree_.list_nodes(nodes, most);
    if (copies_) copies_->list_nodes(nodes, most);
  }

  [[nodiscard]] AcceleratorStatistics statistics() const;

 private:
  template <class Query>
  [[gnu::noinline, gnu::cold]] void walk_beyond_float(const Ray<T>& ray, const Primitives<T>& primitives,
                                                      Query& query) const {
    // In double, where the inverse of every float's slope is finite.
    SlabRay<double> slabs(Ray<double>{wide(ray.origin), wide(ray.direction)});
    if (primitives.maps_rays()) {
      const Vec3d& from = slabs.from_in;
      const double size = std::abs(from.x) + std::abs(from.y) + std::abs(from.z);
      slabs.move_out(Vec3d(16 * static_cast<double>(std::numeric_limits<T>::epsilon()) * size));
    }
    search_all(slabs, ray, primitives, query);
  }

  template <class Terms, class AnyRay, class Query>
  void search_all(const Terms& terms, const AnyRay& ray, const Primitives<T>& primitives, Query& query) const {
    walk(terms, primitives, query);
    if (copies_ && !query.over()) copies_->search(terms, ray, primitives, query);
  }

  template <class Terms, class Query>
  void walk(const Terms& terms, const Primitives<T>& primitives, Query& query) const {
    SearchRecord* record = nullptr;
    if constexpr (Watching<Query>) record = &query.record();
    WideSearch<Terms> search(tree_, terms, Query::shortens, record);
    while (search.next(query.t_far()))
      if (test_leaf<Terms>(search.found(), primitives, query, tree_.packs_are_exact())) break;
    query.count(search.nodes(), search.passed_over());
  }

  static constexpr unsigned fewest_together = 4;  ///< rays that a packet pays for

  /// The most neighbours whose slopes have the same signs, without which they are not coherent: what is asked first,
  /// since it costs least.
  template <class RayOf>
  static unsigned longest_run(unsigned count, const RayOf& ray) {
    unsigned longest = 0, run = 0, last = 8;
    for (unsigned i = 0; i < count; ++i) {
      const Vec3<T>& slope = ray(i).direction;
      unsigned signs = 0;
      for (int axis = 0; axis < 3; ++axis) signs |= static_cast<unsigned>(std::signbit(slope[axis])) << axis;
      run = signs == last ? run + 1 : 1, last = signs;
      longest = std::max(longest, run);
    }
    return longest;
  }

  template <class Query>
  void walk(const RaysAbreast& rays, unsigned members, const Primitives<T>& primitives,
            std::span<std::optional<Query>> queries) const {
    PacketSearch search(tree_, rays, members, Query::shortens);
    for (unsigned bits = members; bits != 0; bits &= bits - 1) {
      const auto ray = static_cast<unsigned>(std::countr_zero(bits));
      if (!queries[ray]->over()) search.set_far(ray, queries[ray]->t_far());
    }
    while (search.next())
      for (unsigned bits = search.rays(); bits != 0; bits &= bits - 1) {
        const auto ray = static_cast<unsigned>(std::countr_zero(bits));
        Query& query = *queries[ray];
        if (test_leaf<MeshRay>(search.found(ray), primitives, query, tree_.packs_are_exact()))
          search.finish(ray);
        else if constexpr (Query::shortens)
          search.set_far(ray, query.t_far());
      }
    queries[0]->count(search.nodes(), search.passed_over());
  }

  /// Tests what the search has found; true when it is over. `exact`: WideTree::packs_are_exact.
  template <class Terms, class Query>
  [[gnu::flatten]] static bool test_leaf(const FoundLeaf& leaf, const Primitives<T>& primitives, Query& query,
                                         bool exact) {
    const unsigned ruled_out = leaf.ruled_out;
    if constexpr (Watching<Query>) {
      for (unsigned bits = leaf.candidates | ruled_out; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits), id = leaf.ids[lane];
        if ((ruled_out >> lane & 1) != 0)
          query.rule_out(primitives, id);
        else if (query.test(primitives, id))
          return true;
      }
    } else {
      for (unsigned bits = leaf.candidates; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits);
        if (!test_lane<Terms>(leaf, static_cast<std::size_t>(lane), primitives, query, exact)) continue;
        query.count(0, bit_counts[ruled_out & ((1U << lane) - 1)]);
        return true;
      }
      query.count(0, bit_counts[ruled_out]);
    }
    return false;
  }

  template <class Terms, class Query>
  static bool test_lane(const FoundLeaf& leaf, std::size_t lane, const Primitives<T>& primitives, Query& query,
                        [[maybe_unused]] bool exact) {
    const int id = leaf.ids[lane];
    const TrianglePack* pack = leaf.pack;
    if constexpr (std::is_same_v<Terms, MeshRay>) {  // naive rays test triangles by other means
      if (pack == nullptr || std::isnan(pack->corners[0][0][lane])) return query.test(primitives, id);
      if constexpr (!Query::shortens)
        if ((leaf.certain >> lane & 1) != 0 && query.take(primitives, id)) return true;
      if constexpr (std::is_same_v<T, float>) {
        return query.test(primitives, id, [=](int corner, int axis) { return pack->corners[corner][axis][lane]; });
      } else {
        const Corners at = exact ? corners_in(*pack, lane) : corners_of(primitives, id);
        return query.test(primitives, id,
                          [&](int corner, int axis) { return at[static_cast<std::size_t>(3 * corner + axis)]; });
      }
    }
    return query.test(primitives, id);
  }

  /// The coordinates of a triangle's corners, three each: as its pack has them, where it is exact, whose memory the
  /// search has just read; or as the mesh has them.
  using Corners = std::array<T, 9>;
  static Corners corners_in(const TrianglePack& pack, std::size_t lane) {
    Corners all;
    for (std::size_t corner = 0; corner < 3; ++corner)
      for (std::size_t axis = 0; axis < 3; ++axis)
        all[3 * corner + axis] = static_cast<T>(pack.corners[corner][axis][lane]);
    return all;
  }
  static Corners corners_of(const Primitives<T>& primitives, int id) {
    const Triangle<T> at = primitives.triangles()[id - primitives.shape_count()];
    return {at.a.x, at.a.y, at.a.z, at.b.x, at.b.y, at.b.z, at.c.x, at.c.y, at.c.z};
  }

  /// By eight bits: not every processor has an instruction for it.
  static constexpr std::array<std::uint8_t, 256> bit_counts = [] {
    std::array<std::uint8_t, 256> counts{};
    for (unsigned bits = 0; bits < counts.size(); ++bits) counts[bits] = static_cast<std::uint8_t>(std::popcount(bits));
    return counts;
  }();

  WideTree tree_;
  float near_each_other_ = 0;                    ///< how far the origins of coherent rays may be apart
  std::shared_ptr<const MeshCopies<T>> copies_;  ///< null for none
};

template <class T>
MeshBvh<T>::MeshBvh(const PrimitiveBounds<T>& boxes, const Primitives<T>& primitives, const BuildOptions& build) {
  std::vector<TreeItem> items;
  items.reserve(boxes.bounded.size());
  build.stop.each(boxes.bounded.begin(), boxes.bounded.end(), [&](int id) {
    items.push_back({rounded_out(boxes.box(id)), id, primitives.still_triangle(id) ? 1 : 0});
  });
  tree_ = WideTree(std::move(items), build, [&](std::int32_t id) {
    const Triangle<T> triangle = primitives.triangles()[id - primitives.shape_count()];
    return std::array{wide(triangle.a), wide(triangle.b), wide(triangle.c)};
  });
  const Vec3<float> size = tree_.box().max - tree_.box().min;
  near_each_other_ = 0.125F * std::max({size.x, size.y, size.z});
  if (!primitives.triangles().copies().empty()) copies_ = std::make_shared<const MeshCopies<T>>(primitives, build);
  tree_.fill_packs(build.stop, [&](std::int32_t id) -> std::optional<std::array<Vec3d, 3>> {
    if (!primitives.still_triangle(id)) return std::nullopt;
    const Triangle<T> triangle = primitives.triangles()[id - primitives.shape_count()];
    if (Triangles<T>::degenerate(triangle)) return std::nullopt;
    return std::array{wide(triangle.a), wide(triangle.b), wide(triangle.c)};
  });
}

template <class T>
AcceleratorStatistics MeshBvh<T>::statistics() const {
  AcceleratorStatistics own{tree_.node_count(), tree_.item_count(), tree_.depth(), tree_.bytes(),
                            tree_.expected_cost()};
  if (!copies_) return own;
  // A ray that meets the box of both meets either with the chance that their areas say.
  const Bounds<double> box = wide(tree_.box());
  Bounds<double> both = box;
  both.include(copies_->box());
  AcceleratorStatistics all = copies_->statistics();
  all.expected_cost = (half_area(box) * own.expected_cost + half_area(copies_->box()) * all.expected_cost) /
                      std::max(half_area(both), std::numeric_limits<double>::min());
  all.nodes += own.nodes, all.references += own.references, all.bytes += own.bytes;
  all.depth = std::max(all.depth, own.depth);
  return all;
}

}  // namespace raywalk
