#pragma once

#include "shape/placed.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace raywalk {

/// What an accelerator is built over: shapes, each under an affine map of its own or none. A primitive's id is its
/// place in the order of `add`.
template <class T>
class Primitives {
 public:
  Primitives() = default;
  explicit Primitives(std::vector<Shape<T>> shapes) : shapes_(std::move(shapes)) {}

  void add(Shape<T> shape) {
    shapes_.push_back(std::move(shape));
    if (!places_.empty()) place_of_.push_back(unplaced);
  }
  void add(Shape<T> shape, const Placement<T>& place) {
    place_of_.resize(shapes_.size(), unplaced);
    place_of_.push_back(static_cast<std::int32_t>(places_.size()));
    places_.push_back(place);
    shapes_.push_back(std::move(shape));
  }

  [[nodiscard]] int size() const { return static_cast<int>(shapes_.size()); }
  /// A primitive in its own space, and the map that takes it into the world; null when it stands there already.
  [[nodiscard]] const Shape<T>& shape(int id) const { return shapes_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const Placement<T>* place_of(int id) const {
    if (place_of_.empty() || place_of_[static_cast<std::size_t>(id)] == unplaced) return nullptr;
    return &places_[static_cast<std::size_t>(place_of_[static_cast<std::size_t>(id)])];
  }

  /// The lowest id of a primitive that equals this one in shape and place. All of them are one surface: the lowest is
  /// hit, and what departs from it departs from all.
  [[nodiscard]] int first_equal(int id) const {
    return first_equal_.empty() ? id : first_equal_[static_cast<std::size_t>(id)];
  }
  /// Makes `first_equal` known, in time n log n. To be called when all are added.
  void find_equals();

  /// Nearest crossing in (0, t_max) of the ray with one primitive, in the ray's own t.
  template <class Explain = NoExplanation>
  [[nodiscard]] std::optional<Crossing<T>> intersect(int id, const Ray<T>& ray, T t_max, Explain&& explain = {}) const {
    const int departed = departed_part(ray, id);
    const Placement<T>* place = place_of(id);
    return place ? raywalk::intersect(shape(id), into_shape(*place, ray), t_max, departed, explain)
                 : raywalk::intersect(shape(id), ray, t_max, departed, explain);
  }
  [[nodiscard]] SurfacePoint<T> surface_at(int id, const Ray<T>& ray, Crossing<T> crossing) const {
    const Placement<T>* place = place_of(id);
    return place ? raywalk::surface_at(shape(id), *place, ray, crossing)
                 : raywalk::surface_at(shape(id), ray, crossing);
  }
  [[nodiscard]] Vec2<T> uv_at(int id, const SurfacePoint<T>& point, int part) const {
    const Placement<T>* place = place_of(id);
    return place ? raywalk::uv_at(shape(id), *place, point, part) : raywalk::uv_at(shape(id), point, part);
  }

  /// A primitive's box in the world, widened by a few ulps so that it holds every point that rounding may report.
  [[nodiscard]] Bounds<T> box(int id) const {
    Bounds<T> box = bounds(shape(id));
    if (const Placement<T>* place = place_of(id)) box = image_of(place->to_world, box);
    for (int axis = 0; axis < 3; ++axis) {
      const T pad = 8 * std::numeric_limits<T>::epsilon() * std::fmax(std::abs(box.min[axis]), std::abs(box.max[axis]));
      box.min[axis] -= pad;
      box.max[axis] += pad;
    }
    return box;
  }

 private:
  static constexpr std::int32_t unplaced = -1;
  /// The part of primitive `id` that the ray departs from, or no_part.
  [[nodiscard]] int departed_part(const Ray<T>& ray, int id) const {
    const int from = ray.departure.primitive;
    return from == id || (from >= 0 && !first_equal_.empty() && first_equal(from) == first_equal(id))
               ? ray.departure.part
               : no_part;
  }
  [[nodiscard]] bool equal(int a, int b) const {
    const Placement<T>*place_a = place_of(a), *place_b = place_of(b);
    const bool same_place = place_a && place_b ? place_a->to_world == place_b->to_world : place_a == place_b;
    return same_place && shape(a) == shape(b);
  }

  std::vector<Shape<T>> shapes_;
  std::vector<std::int32_t> place_of_;  ///< by primitive; empty when none has a map
  std::vector<Placement<T>> places_;
  std::vector<std::int32_t> first_equal_;  ///< by primitive; empty when no two are equal
};

template <class T>
void Primitives<T>::find_equals() {
  // Equal primitives have equal boxes, so that only neighbours in the order of boxes are compared.
  std::vector<std::pair<Bounds<T>, int>> order;
  for (int id = 0; id < size(); ++id) order.emplace_back(box(id), id);
  const auto key = [](const auto& entry) {
    const Bounds<T>& box = entry.first;
    return std::tuple(box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z);
  };
  std::sort(order.begin(), order.end(), [&](const auto& a, const auto& b) {
    return std::tuple_cat(key(a), std::tuple(a.second)) < std::tuple_cat(key(b), std::tuple(b.second));
  });
  std::vector<std::int32_t> first_equal;
  for (int id = 0; id < size(); ++id) first_equal.push_back(id);
  bool some = false;
  std::vector<int> different;  // of the present box, the lowest id of each distinct primitive
  for (std::size_t i = 0; i < order.size(); ++i) {
    const int id = order[i].second;
    if (i == 0 || key(order[i]) != key(order[i - 1])) different.clear();
    const auto same = std::find_if(different.begin(), different.end(), [&](int other) { return equal(id, other); });
    if (same == different.end()) {
      different.push_back(id);
    } else {
      first_equal[static_cast<std::size_t>(id)] = *same;
      some = true;
    }
  }
  if (some) first_equal_ = std::move(first_equal);
}

/// The boxes that a structure is built from: of the primitives with a finite box; the others, which every ray is tested
/// against, are listed apart.
template <class T>
struct Boxes {
  explicit Boxes(const Primitives<T>& primitives) {
    boxes.reserve(static_cast<std::size_t>(primitives.size()));
    for (int id = 0; id < primitives.size(); ++id) {
      boxes.push_back(primitives.box(id));
      if (boxes.back().empty()) continue;  // nothing to hit: a quadric cut away whole
      if (boxes.back().bounded()) {
        bounded.push_back(id);
        whole.include(boxes.back());
      } else {
        unbounded.push_back(id);
      }
    }
  }

  [[nodiscard]] const Bounds<T>& box(int id) const { return boxes[static_cast<std::size_t>(id)]; }

  std::vector<Bounds<T>> boxes;
  std::vector<int> bounded, unbounded;  ///< ids, ascending
  Bounds<T> whole;                      ///< of all bounded primitives
};

}  // namespace raywalk
