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

/// A handful of primitives is searched faster than any structure is entered; beyond that a BVH is never far from the
/// best and never bad.
AcceleratorKind resolve(AcceleratorKind kind, std::size_t bounded) {
  constexpr std::size_t few = 8;
  if (kind != AcceleratorKind::automatic) return kind;
  return bounded <= few ? AcceleratorKind::none : AcceleratorKind::bvh;
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
  return List<T>(static_cast<int>(boxes.boxes.size()));
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
  kind_ = resolve(kind, boxes.bounded.size());
  structure_ = std::make_shared<const Structure>(Structure{build(kind_, boxes, primitives_)});
  if (kind_ != AcceleratorKind::none) unbounded_ = boxes.unbounded;
  statistics_ = std::visit([](const auto& structure) { return structure.statistics(); }, structure_->any);
  statistics_.build_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

template <class T>
template <class Query>
void Accelerator<T>::search(const Ray<T>& ray, Query& query) const {
  for (const int id : unbounded_)
    if (query.test(primitives_, id)) return;
  std::visit([&](const auto& structure) { structure.search(ray, primitives_, query); }, structure_->any);
}

template <class T>
template <class Accept>
std::optional<Hit<T>> Accelerator<T>::closest(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept) const {
  ClosestQuery<T, Accept> query(primitives_, ray, t_max, accept);
  search(ray, query);
  counts += query.counts();
  return query.nearest();
}

template <class T>
template <class Accept>
bool Accelerator<T>::any(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept, int* last) const {
  AnyQuery<T, Accept> query(primitives_, ray, t_max, accept);
  if (last == nullptr || *last < 0 || !query.test(primitives_, *last)) search(ray, query);
  if (last != nullptr) *last = query.found_id();
  counts += query.counts();
  return query.found();
}

template <class T>
void Accelerator<T>::crossed(const Ray<T>& ray, T t_max, TestCounts& counts, MarkedPrimitives accept,
                             std::vector<int>& found) const {
  found.clear();
  EveryQuery<T, MarkedPrimitives> query(primitives_, ray, t_max, accept, found);
  search(ray, query);
  counts += query.counts();
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

template class Accelerator<float>;
template class Accelerator<double>;

// Compiled here once, so that the tracer's kernels need not hold a copy of every structure each.
#define RAYWALK_QUERIES(T, Accept)                                                                     \
  template std::optional<Hit<T>> Accelerator<T>::closest(const Ray<T>&, T, TestCounts&, Accept) const; \
  template bool Accelerator<T>::any(const Ray<T>&, T, TestCounts&, Accept, int*) const;
RAYWALK_QUERIES(float, AnyPrimitive)
RAYWALK_QUERIES(float, MarkedPrimitives)
RAYWALK_QUERIES(double, AnyPrimitive)
RAYWALK_QUERIES(double, MarkedPrimitives)
#undef RAYWALK_QUERIES

}  // namespace raywalk
