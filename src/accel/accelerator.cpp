#include "accel/accelerator.h"

#include <algorithm>

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
std::variant<List<T>, Bvh<T>, Grid<T>, Octree<T>, KdTree<T>> build(AcceleratorKind kind, const Boxes<T>& boxes) {
  switch (kind) {
    case AcceleratorKind::automatic:
    case AcceleratorKind::none:
      return List<T>(static_cast<int>(boxes.boxes.size()));
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
Accelerator<T>::Accelerator(Primitives<T> primitives, AcceleratorKind kind)
    : primitives_(std::move(primitives)), structure_(List<T>(0)) {
  const Boxes<T> boxes(primitives_);
  primitives_.find_equals(boxes.boxes);
  kind_ = resolve(kind, boxes.bounded.size());
  structure_ = build(kind_, boxes);
  if (kind_ != AcceleratorKind::none) unbounded_ = boxes.unbounded;
}

template <class T>
template <class Query>
void Accelerator<T>::search(const Ray<T>& ray, Query& query) const {
  for (const int id : unbounded_)
    if (query.test(primitives_, id)) return;
  std::visit([&](const auto& structure) { structure.search(ray, primitives_, query); }, structure_);
}

template <class T>
template <class Accept>
std::optional<Hit<T>> Accelerator<T>::closest(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept) const {
  ClosestQuery<T, Accept> query(ray, t_max, counts, accept);
  search(ray, query);
  return query.nearest();
}

template <class T>
template <class Accept>
bool Accelerator<T>::any(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept) const {
  AnyQuery<T, Accept> query(ray, t_max, counts, accept);
  search(ray, query);
  return query.found();
}

template <class T>
void Accelerator<T>::crossed(const Ray<T>& ray, T t_max, TestCounts& counts, MarkedPrimitives accept,
                             std::vector<int>& found) const {
  found.clear();
  EveryQuery<T, MarkedPrimitives> query(ray, t_max, counts, accept, found);
  search(ray, query);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
}

template class Accelerator<float>;
template class Accelerator<double>;

// Compiled here once, so that the tracer's kernels need not hold a copy of every structure each.
#define RAYWALK_QUERIES(T, Accept)                                                                     \
  template std::optional<Hit<T>> Accelerator<T>::closest(const Ray<T>&, T, TestCounts&, Accept) const; \
  template bool Accelerator<T>::any(const Ray<T>&, T, TestCounts&, Accept) const;
RAYWALK_QUERIES(float, AnyPrimitive)
RAYWALK_QUERIES(float, MarkedPrimitives)
RAYWALK_QUERIES(double, AnyPrimitive)
RAYWALK_QUERIES(double, MarkedPrimitives)
#undef RAYWALK_QUERIES

}  // namespace raywalk
