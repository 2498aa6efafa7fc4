#pragma once
// Two levels of trees: one over the copies of meshes (accel/triangles.h), and one for each mesh in its own space, which
// all of its copies share.

#include "accel/mesh_ray.h"
#include "accel/query.h"
#include "accel/search_record.h"
#include "accel/wide_search.h"

#include <bit>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

namespace raywalk {

/// How a ray comes into the space of a copy's mesh, and how far it may be off there.
///
/// A search goes through the mesh's tree, but its hits are decided in world space, on the triangles that the copy would
/// have if it were stored. So nothing that rounding does to the ray in the mesh's space may pass over one of them. Let
/// A be the map there, as it is stored. A takes the true ray exactly to a ray that meets the images of the placed
/// triangles at the same t; these lie within `off` of the mesh's own, since a corner's image differs from the corner by
/// (A M - I) p, M being the map to the world, and by the image of its rounding in world space. What is computed of the
/// ray errs by its rounding alone, on its way up to the copy's box: |t d| <= |o| + |q| for an origin o and a point q of
/// the box. `off_at` is twice the sum of both.
class CopyPlace {
 public:
  /// `box`: of the mesh in its own space; `placed`: of the copy, whose corners are rounded to within `rounding` of
  /// themselves. `to_world` can be inverted.
  CopyPlace(const Affine<double>& to_world, const Bounds<double>& box, const Bounds<double>& placed, double rounding);

  template <class T>
  [[nodiscard]] Ray<double> taken_in(const Ray<T>& ray) const {
    return {to_mesh_.point(wide(ray.origin)), to_mesh_.direction(wide(ray.direction))};
  }
  [[nodiscard]] const Affine<double>& to_mesh() const { return to_mesh_; }
  /// Along each axis, for a ray from `origin` in world space.
  [[nodiscard]] Vec3d off_at(const Vec3d& origin) const;
  /// By how much the direction's components may err in proportion to its largest, `along` in the mesh's space.
  [[nodiscard]] double turned(const Vec3d& direction, const Vec3d& along) const;

 private:
  Affine<double> to_mesh_;
  Vec3d off_{0.0};  ///< of the mesh's triangles
  Vec3d far_{0.0};  ///< the largest coordinates of the copy
};

/// The copies of meshes among the primitives. As a part of MeshBvh, it is searched after what stands for itself.
template <class T>
class MeshCopies {
 public:
  MeshCopies(const Primitives<T>& primitives, const BuildOptions& build);

  /// `terms`: of the ray in world space, as WideSearch takes them.
  template <class Terms, class AnyRay, class Query>
  [[gnu::noinline]] void search(const Terms& terms, const AnyRay& ray, const Primitives<T>& primitives,
                                Query& query) const {
    SearchRecord* record = record_of(query);
    WideSearch<Terms> search(over_copies_, terms, Query::shortens, record);
    while (!query.over() && search.next(query.t_far()))
      for (unsigned bits = search.found().candidates; bits != 0 && !query.over(); bits &= bits - 1)
        search_copy(static_cast<std::size_t>(search.found().ids[std::countr_zero(bits)]), ray, primitives, query);
    query.count(search.nodes(), 0);
  }

  void list_nodes(std::vector<StructureNode>& nodes, std::size_t most) const { over_copies_.list_nodes(nodes, most); }
  /// A copy counts as a test, besides what its tree costs. The box is that of all copies.
  [[nodiscard]] AcceleratorStatistics statistics() const { return statistics_; }
  [[nodiscard]] Bounds<double> box() const { return wide(over_copies_.box()); }

 private:
  template <class Query>
  static SearchRecord* record_of(Query& query) {
    if constexpr (Watching<Query>) return &query.record();
    return nullptr;
  }

  template <class Query>
  void search_copy(std::size_t index, const Ray<T>& ray, const Primitives<T>& primitives, Query& query) const {
    const CopyPlace& place = places_[index];
    const Ray<double> in = place.taken_in(ray);
    const Vec3d off = place.off_at(wide(ray.origin));
    const MeshRay lanes(in, off, place.turned(wide(ray.direction), in.direction));
    if (lanes.held) return walk(index, lanes, primitives, query);
    SlabRay<double> slabs(in);
    slabs.move_out(off);
    walk(index, slabs, primitives, query);
  }
  /// As textbooks do it.
  template <class Query>
  void search_copy(std::size_t index, const NaiveRay<T>& ray, const Primitives<T>& primitives, Query& query) const {
    NaiveRay<T> in = ray;
    in.origin = Vec3<T>(places_[index].to_mesh().point(wide(ray.origin)));
    in.direction = Vec3<T>(places_[index].to_mesh().direction(wide(ray.direction)));
    walk(index, slabs_of(in, primitives), primitives, query);
  }

  template <class Terms, class Query>
  void walk(std::size_t index, const Terms& terms, const Primitives<T>& primitives, Query& query) const {
    const MeshCopy& copy = primitives.triangles().copies()[index];
    const int first = primitives.shape_count() + copy.first;
    SearchRecord* record = record_of(query);
    if (record != nullptr) record->enter_frame(copy.to_world);
    WideSearch<Terms> search(*trees_[tree_of_[index]], terms, Query::shortens, record);
    while (search.next(query.t_far()))
      if (test_pack(search, copy, first, primitives, query)) break;
    query.count(search.nodes(), search.passed_over());
    if (record != nullptr) record->leave_frame();
  }

  template <class Terms, class Query>
  static bool test_pack(const WideSearch<Terms>& search, const MeshCopy& copy, int first,
                        const Primitives<T>& primitives, Query& query) {
    const unsigned ruled_out = search.found().ruled_out;
    if constexpr (Watching<Query>) {
      for (unsigned bits = search.found().candidates | ruled_out; bits != 0; bits &= bits - 1) {
        const int lane = std::countr_zero(bits), id = first + search.found().ids[lane];
        if ((ruled_out >> lane & 1) != 0)
          query.rule_out(primitives, id);
        else if (query.test(primitives, id))
          return true;
      }
    } else {
      query.count(0, static_cast<std::uint64_t>(std::popcount(ruled_out)));
      for (unsigned bits = search.found().candidates; bits != 0; bits &= bits - 1) {
        const std::int32_t of_mesh = search.found().ids[std::countr_zero(bits)];
        if constexpr (std::is_same_v<Terms, NaiveSlabRay<T>>) {
          if (query.test(primitives, first + of_mesh)) return true;
        } else {
          if (query.test(primitives, first + of_mesh, copy.triangle<T>(of_mesh))) return true;
        }
      }
    }
    return false;
  }

  std::vector<CopyPlace> places_;                       ///< by copy
  std::vector<std::uint32_t> tree_of_;                  ///< the same: index into `trees_`
  std::vector<std::shared_ptr<const WideTree>> trees_;  ///< by mesh
  WideTree over_copies_;
  AcceleratorStatistics statistics_;
};

extern template class MeshCopies<float>;
extern template class MeshCopies<double>;

}  // namespace raywalk
