#include "accel/accelerator.h"

namespace raywalk {

/// A handful of primitives is searched faster than any structure is entered; beyond that a BVH is never far from the
/// best and never bad.
template <class T>
AcceleratorKind Accelerator<T>::resolve(AcceleratorKind kind, const Primitives<T>& primitives) {
  constexpr std::size_t few = 8;
  if (kind != AcceleratorKind::automatic) return kind;
  return primitives.bounded.size() <= few ? AcceleratorKind::none : AcceleratorKind::bvh;
}

template <class T>
auto Accelerator<T>::build(AcceleratorKind kind, const Primitives<T>& primitives) -> Structure {
  switch (kind) {
    case AcceleratorKind::automatic:
    case AcceleratorKind::none:
      return List<T>(primitives);
    case AcceleratorKind::bvh:
      return Bvh<T>(primitives);
    case AcceleratorKind::grid:
      return Grid<T>(primitives);
    case AcceleratorKind::octree:
      return Octree<T>(primitives);
    case AcceleratorKind::kdtree:
      return KdTree<T>(primitives);
  }
  return List<T>(primitives);
}

template <class T>
template <class Accept>
std::optional<Hit<T>> Accelerator<T>::closest(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept) const {
  ClosestQuery<T, Accept> query(ray, t_max, counts, accept);
  std::visit([&](const auto& structure) { structure.search(ray, primitives_, query); }, structure_);
  return query.nearest();
}

template <class T>
template <class Accept>
bool Accelerator<T>::any(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept) const {
  AnyQuery<T, Accept> query(ray, t_max, counts, accept);
  std::visit([&](const auto& structure) { structure.search(ray, primitives_, query); }, structure_);
  return query.found();
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
