#pragma once
// The one interface to all accelerators. They differ in what they cost, never in what they answer.

#include "accel/bvh.h"
#include "accel/grid.h"
#include "accel/kdtree.h"
#include "accel/list.h"
#include "accel/octree.h"

#include <string_view>
#include <variant>

namespace raywalk {

enum class AcceleratorKind { automatic, none, bvh, grid, octree, kdtree };

[[nodiscard]] constexpr std::string_view accelerator_name(AcceleratorKind kind) {
  switch (kind) {
    case AcceleratorKind::automatic:
      return "auto";
    case AcceleratorKind::none:
      return "none";
    case AcceleratorKind::bvh:
      return "bvh";
    case AcceleratorKind::grid:
      return "grid";
    case AcceleratorKind::octree:
      return "octree";
    case AcceleratorKind::kdtree:
      return "kdtree";
  }
  return "";
}

/// Primitives ready to be searched by rays. A primitive's id is its place in the list it was built from.
template <class T>
class Accelerator {
 public:
  explicit Accelerator(std::vector<Shape<T>> shapes, AcceleratorKind kind = AcceleratorKind::automatic)
      : primitives_(std::move(shapes)), kind_(resolve(kind, primitives_)), structure_(build(kind_, primitives_)) {}

  /// The nearest accepted crossing in (0, t_max); an exact tie in t goes to the lower id. `Accept` is AnyPrimitive or
  /// MarkedPrimitives.
  template <class Accept = AnyPrimitive>
  [[nodiscard]] std::optional<Hit<T>> closest(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept = {}) const;

  /// Whether any accepted primitive is crossed in (0, t_max).
  template <class Accept = AnyPrimitive>
  [[nodiscard]] bool any(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept = {}) const;

  [[nodiscard]] int size() const { return static_cast<int>(primitives_.shapes.size()); }
  [[nodiscard]] const Shape<T>& shape(int primitive) const {
    return primitives_.shapes[static_cast<std::size_t>(primitive)];
  }
  /// What was built: never `automatic`.
  [[nodiscard]] AcceleratorKind kind() const { return kind_; }
  [[nodiscard]] AcceleratorStatistics statistics() const {
    return std::visit([](const auto& structure) { return structure.statistics(); }, structure_);
  }

 private:
  using Structure = std::variant<List<T>, Bvh<T>, Grid<T>, Octree<T>, KdTree<T>>;
  static AcceleratorKind resolve(AcceleratorKind kind, const Primitives<T>& primitives);
  static Structure build(AcceleratorKind kind, const Primitives<T>& primitives);

  Primitives<T> primitives_;
  AcceleratorKind kind_;
  Structure structure_;
};

extern template class Accelerator<float>;
extern template class Accelerator<double>;

}  // namespace raywalk
