#include "accel/accelerator.h"

#include "accel/bvh.h"
#include "accel/grid.h"
#include "accel/kdtree.h"
#include "accel/list.h"
#include "accel/octree.h"
#include "accel/volumes.h"

#include <algorithm>
#include <chrono>
#include <variant>

namespace raywalk {

namespace {

/// Two or three spheres are searched faster than a structure is entered; beyond that a BVH is never far from the best
/// and never bad. Other shapes are so much dearer to test that even one is better kept in a box.
template <class T>
AcceleratorKind resolve(AcceleratorKind kind, const Boxes<T>& boxes, const Primitives<T>& primitives) {
  if (kind != AcceleratorKind::automatic) return kind;
  const auto sphere = [&](int id) { return primitives.template plain<Sphere<T>>(id) != nullptr; };
  const bool few = boxes.bounded.size() <= 3 && std::all_of(boxes.bounded.begin(), boxes.bounded.end(), sphere);
  return few ? AcceleratorKind::none : AcceleratorKind::bvh;
}

template <class T>
using AnyStructure = std::variant<List<T>, Volumes<T>, Bvh<T>, Grid<T>, Octree<T>, KdTree<T>>;

template <class T>
AnyStructure<T> build(AcceleratorKind kind, const Boxes<T>& boxes, const Primitives<T>& primitives) {
  switch (kind) {
    case AcceleratorKind::automatic:
    case AcceleratorKind::none:
      break;
    case AcceleratorKind::spheres:
      return Volumes<T>(boxes, primitives, VolumeKind::sphere);
    case AcceleratorKind::ellipsoids:
      return Volumes<T>(boxes, primitives, VolumeKind::ellipsoid);
    case AcceleratorKind::boxes:
      return Volumes<T>(boxes, primitives, VolumeKind::box);
    case AcceleratorKind::bvh:
      return Bvh<T>(boxes);
    case AcceleratorKind::grid:
      return Grid<T>(boxes);
    case AcceleratorKind::octree:
      return Octree<T>(boxes);
    case AcceleratorKind::kdtree:
      return KdTree<T>(boxes);
  }
  return List<T>(primitives.size());
}

}  // namespace

template <class T>
struct Accelerator<T>::Structure {
  AnyStructure<T> any;
};

template <class T>
Accelerator<T>::Accelerator(Primitives<T> primitives, AcceleratorKind kind) : primitives_(std::move(primitives)) {
  const auto begin = std::chrono::steady_clock::now();
  const Boxes<T> boxes(primitives_);
  primitives_.find_equals(boxes.boxes);
  kind_ = resolve(kind, boxes, primitives_);
  structure_ = std::make_shared<const Structure>(Structure{build(kind_, boxes, primitives_)});
  if (kind_ != AcceleratorKind::none) unbounded_ = boxes.unbounded;
  statistics_ = std::visit([](const auto& structure) { return structure.statistics(); }, structure_->any);
  statistics_.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <class T>
template <class AnyRay, class Query>
void Accelerator<T>::search(const AnyRay& ray, Query& query) const {
  for (const int id : unbounded_)
    if (query.test(primitives_, id)) return;
  std::visit([&](const auto& structure) { structure.search(ray, primitives_, query); }, structure_->any);
}

template <class T>
template <class AnyRay, class Accept>
std::optional<Hit<T>> Accelerator<T>::closest(const AnyRay& ray, T t_max, TestCounts& counts, Accept accept) const {
  ClosestQuery<T, Accept, AnyRay> query(primitives_, ray, t_max, accept);
  search(ray, query);
  counts += query.counts();
  return query.nearest();
}

template <class T>
template <class AnyRay, class Query>
bool Accelerator<T>::found(Query& query, const AnyRay& ray, TestCounts& counts, int* last) const {
  if (last == nullptr || *last < 0 || !query.test(primitives_, *last)) search(ray, query);
  if (last != nullptr) *last = query.found_id();
  counts += query.counts();
  return query.found();
}

template <class T>
template <class AnyRay>
bool Accelerator<T>::any(const AnyRay& ray, T t_max, TestCounts& counts, int* last) const {
  AnyQuery<T, AnyRay> query(primitives_, ray, t_max);
  return found(query, ray, counts, last);
}

template <class T>
template <class AnyRay>
bool Accelerator<T>::any_stop(const AnyRay& ray, T t_max, TestCounts& counts, const std::vector<ShadowRole>& roles,
                              std::vector<int>& filters, int* last) const {
  filters.clear();
  ShadowQuery<T, AnyRay> query(primitives_, ray, t_max, roles, filters);
  const bool stopped = found(query, ray, counts, last);
  if (filters.size() > 1) {
    std::sort(filters.begin(), filters.end());
    filters.erase(std::unique(filters.begin(), filters.end()), filters.end());
  }
  return stopped;
}

template class Accelerator<float>;
template class Accelerator<double>;

// Compiled here once, so that the tracer's kernels need not hold a copy of every structure each.
#define RAYWALK_SEARCHES(T, AnyRay)                                                                             \
  template std::optional<Hit<T>> Accelerator<T>::closest(const AnyRay<T>&, T, TestCounts&, AnyPrimitive) const; \
  template std::optional<Hit<T>> Accelerator<T>::closest(const AnyRay<T>&, T, TestCounts&, StopsShadows) const; \
  template bool Accelerator<T>::any(const AnyRay<T>&, T, TestCounts&, int*) const;                              \
  template bool Accelerator<T>::any_stop(const AnyRay<T>&, T, TestCounts&, const std::vector<ShadowRole>&,      \
                                         std::vector<int>&, int*) const;
RAYWALK_SEARCHES(float, Ray)
RAYWALK_SEARCHES(double, Ray)
RAYWALK_SEARCHES(float, NaiveRay)
RAYWALK_SEARCHES(double, NaiveRay)
#undef RAYWALK_SEARCHES

}  // namespace raywalk
