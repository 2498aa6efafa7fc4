#pragma once
// How the queries of an accelerator search its structure. Compiled once for robust rays (accelerator.cpp), for naive
// ones (accelerator_naive.cpp) and in single precision (accelerator_float.cpp), so that not every kernel of the tracer
// contains a copy of every structure.

#include "accel/accelerator.h"
#include "accel/bounding_volumes.h"
#include "accel/bvh.h"
#include "accel/grid.h"
#include "accel/kdtree.h"
#include "accel/list.h"
#include "accel/mesh_bvh.h"
#include "accel/octree.h"

#include <algorithm>
#include <variant>

namespace raywalk {

template <class T>
using AnyStructure = std::variant<List<T>, BoundingVolumes<T>, Bvh<T>, Grid<T>, Octree<T>, KdTree<T>, MeshBvh<T>>;

/// Compiled in structures.cpp.
template <class T>
AnyStructure<T> build_structure(AcceleratorKind kind, const PrimitiveBounds<T>& boxes, const Primitives<T>& primitives,
                                const BuildOptions& build = {});
extern template AnyStructure<float> build_structure(AcceleratorKind, const PrimitiveBounds<float>&,
                                                    const Primitives<float>&, const BuildOptions&);
extern template AnyStructure<double> build_structure(AcceleratorKind, const PrimitiveBounds<double>&,
                                                     const Primitives<double>&, const BuildOptions&);

template <class T>
struct Accelerator<T>::Structure {
  AnyStructure<T> any;
};

template <class T>
template <class AnyRay, class Query>
inline void Accelerator<T>::search(const AnyRay& ray, Query& query) const {
  // The list, which holds all primitives, comes first: its scenes are so small that an extra call would show.
  if (const auto* list = std::get_if<List<T>>(&structure_->any)) return list->search(ray, primitives_, query);
  search_structure(ray, query);
}

template <class T>
template <class AnyRay, class Query>
[[gnu::noinline]] void Accelerator<T>::search_structure(const AnyRay& ray, Query& query) const {
  for (const int id : unbounded_)
    if (query.test(primitives_, id)) return;
  std::visit([&](const auto& structure) { structure.search(ray, primitives_, query); }, structure_->any);
}

template <class T>
template <class AnyRay, class Accept>
std::optional<Hit<T>> Accelerator<T>::closest(const AnyRay& ray, T t_max, TestCounts& counts, Accept accept) const {
  ClosestQuery<T, Accept, AnyRay> query(ray, t_max, counts, accept);
  search(ray, query);
  return query.nearest();
}

template <class T>
std::optional<Hit<T>> Accelerator<T>::closest_likely(const Ray<T>& ray, int likely, TestCounts& counts) const {
  ClosestQuery<T, AnyPrimitive, Ray<T>> query(ray, infinity<T>, counts, {});
  static_cast<void>(query.test(primitives_, likely));
  search(ray, query);
  return query.nearest();
}

template <class T>
template <class AnyRay, class Query>
inline bool Accelerator<T>::found(Query& query, const AnyRay& ray, const ShadowHints& hints) const {
  const auto seek = [&] {
    if (hints.candidates == nullptr) return search(ray, query);
    for (const int id : *hints.candidates)
      if (query.test(primitives_, id)) return;
  };
  if (hints.last == nullptr || *hints.last < 0 || !query.test(primitives_, *hints.last)) seek();
  if (hints.last != nullptr) *hints.last = query.found_id();
  return query.found();
}

template <class T>
template <class AnyRay>
bool Accelerator<T>::occluded(const AnyRay& ray, T t_max, TestCounts& counts, const ShadowHints& hints) const {
  OcclusionQuery<T, AnyRay> query(ray, t_max, counts);
  return found(query, ray, hints);
}

template <class T>
template <class AnyRay>
bool Accelerator<T>::occluded_or_filtered(const AnyRay& ray, T t_max, TestCounts& counts,
                                          const std::vector<ShadowRole>& roles, std::vector<int>& filters,
                                          const ShadowHints& hints) const {
  filters.clear();
  FilteredOcclusionQuery<T, AnyRay> query(ray, t_max, counts, roles, filters);
  const bool stopped = found(query, ray, hints);
  if (filters.size() > 1) {
    std::sort(filters.begin(), filters.end());
    filters.erase(std::unique(filters.begin(), filters.end()), filters.end());
  }
  return stopped;
}

/// Instantiates the queries of Accelerator<T> for one kind of ray.
#define RAYWALK_SEARCHES(T, AnyRay)                                                                                    \
  template std::optional<Hit<T>> Accelerator<T>::closest(const AnyRay<T>&, T, TestCounts&, AnyPrimitive) const;        \
  template std::optional<Hit<T>> Accelerator<T>::closest(const AnyRay<T>&, T, TestCounts&, StopsShadows) const;        \
  template std::optional<Hit<T>> Accelerator<T>::closest(const AnyRay<T>&, T, TestCounts&, OfBodies) const;            \
  template bool Accelerator<T>::occluded(const AnyRay<T>&, T, TestCounts&, const ShadowHints&) const;                  \
  template bool Accelerator<T>::occluded_or_filtered(const AnyRay<T>&, T, TestCounts&, const std::vector<ShadowRole>&, \
                                                     std::vector<int>&, const ShadowHints&) const;

}  // namespace raywalk
