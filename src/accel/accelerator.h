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
  explicit Accelerator(Primitives<T> primitives, AcceleratorKind kind = AcceleratorKind::automatic);

  /// The nearest accepted crossing in (0, t_max); an exact tie in t goes to the lower id. `Accept` is AnyPrimitive or
  /// MarkedPrimitives.
  template <class Accept = AnyPrimitive>
  [[nodiscard]] std::optional<Hit<T>> closest(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept = {}) const;

  /// Whether any accepted primitive is crossed in (0, t_max).
  template <class Accept = AnyPrimitive>
  [[nodiscard]] bool any(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept = {}) const;

  /// Every accepted primitive that is crossed in (0, t_max), as ascending ids.
  void crossed(const Ray<T>& ray, T t_max, TestCounts& counts, MarkedPrimitives accept, std::vector<int>& found) const;

  [[nodiscard]] const Primitives<T>& primitives() const { return primitives_; }
  /// What was built: never `automatic`.
  [[nodiscard]] AcceleratorKind kind() const { return kind_; }
  [[nodiscard]] AcceleratorStatistics statistics() const {
    return std::visit([](const auto& structure) { return structure.statistics(); }, structure_);
  }

 private:
  using Structure = std::variant<List<T>, Bvh<T>, Grid<T>, Octree<T>, KdTree<T>>;
  template <class Query>
  void search(const Ray<T>& ray, Query& query) const;

  Primitives<T> primitives_;
  std::vector<int> unbounded_;  ///< ids that every ray is tested against
  AcceleratorKind kind_ = AcceleratorKind::none;
  Structure structure_;  ///< over the others; a List holds all
};

extern template class Accelerator<float>;
extern template class Accelerator<double>;

}  // namespace raywalk
