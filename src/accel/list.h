#pragma once

#include "shape/shape.h"

#include <cstdint>
#include <vector>

namespace raywalk {

/// The nearest crossing among all primitives: a primitive's id is its place in the list it was built from.
template <class T>
struct Hit {
  T t;
  int primitive;
  int part;
};

/// What a query cost.
struct TestCounts {
  std::uint64_t nodes = 0;       ///< nodes or cells of a structure entered
  std::uint64_t primitives = 0;  ///< ray-primitive tests made
};

/// Accepts every primitive.
struct AnyPrimitive {
  constexpr bool operator()(int /*primitive*/) const { return true; }
};

/// No structure: every ray is tested against every primitive. The oracle for all others.
template <class T>
class List {
 public:
  List() = default;
  explicit List(std::vector<Shape<T>> shapes) : shapes_(std::move(shapes)) {}

  /// The nearest accepted crossing in (0, t_max); an exact tie in t goes to the lower id.
  template <class Accept = AnyPrimitive>
  [[nodiscard]] std::optional<Hit<T>> closest(const Ray<T>& ray, T t_max, TestCounts& counts,
                                              Accept accept = {}) const {
    std::optional<Hit<T>> nearest;
    for (int id = 0; id < size(); ++id) {
      if (!accept(id)) continue;
      ++counts.primitives;
      if (const auto crossing = intersect(shape(id), ray, nearest ? nearest->t : t_max, departed_part(ray, id)))
        nearest = Hit<T>{crossing->t, id, crossing->part};
    }
    return nearest;
  }

  /// Whether any accepted primitive is crossed in (0, t_max).
  template <class Accept = AnyPrimitive>
  [[nodiscard]] bool any(const Ray<T>& ray, T t_max, TestCounts& counts, Accept accept = {}) const {
    for (int id = 0; id < size(); ++id) {
      if (!accept(id)) continue;
      ++counts.primitives;
      if (intersect(shape(id), ray, t_max, departed_part(ray, id))) return true;
    }
    return false;
  }

  [[nodiscard]] int size() const { return static_cast<int>(shapes_.size()); }
  [[nodiscard]] const Shape<T>& shape(int primitive) const { return shapes_[static_cast<std::size_t>(primitive)]; }
  [[nodiscard]] static int departed_part(const Ray<T>& ray, int primitive) {
    return ray.departure.primitive == primitive ? ray.departure.part : no_part;
  }

 private:
  std::vector<Shape<T>> shapes_;
};

}  // namespace raywalk
