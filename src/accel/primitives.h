#pragma once

#include "accel/triangles.h"
#include "math/inlining.h"
#include "math/motion.h"
#include "math/stop.h"
#include "shape/naive.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace raywalk {

/// What an accelerator is built over: shapes, each with an object transform or none, then the triangles of meshes; any
/// of them may move. A primitive's id is its index in the order of addition.
template <class T>
class Primitives {
 public:
  Primitives() = default;
  explicit Primitives(std::vector<Shape<T>> shapes) {
    for (Shape<T>& shape : shapes) add(std::move(shape));
  }

  /// Shapes must be added before meshes, whose triangles have the ids that follow.
  void add(Shape<T> shape) {
    const auto* plane = std::get_if<Plane<T>>(&shape);
    plain_.push_back(std::holds_alternative<Sphere<T>>(shape)    ? Plain::sphere
                     : plane != nullptr                          ? (is_level(*plane) ? Plain::level : Plain::plane)
                     : std::holds_alternative<Polygon<T>>(shape) ? Plain::polygon
                                                                 : Plain::bare);
    if (const auto* polygon = std::get_if<Polygon<T>>(&shape)) {
      area_vectors_.resize(shapes_.size() + 1);
      area_vectors_.back() = polygon->area_vector();
    }
    ++shape_count_;
    shapes_.push_back(std::move(shape));
    if (!transforms_.empty()) transform_of_.push_back(none);
  }
  void add(Shape<T> shape, const ObjectTransform<T>& transform) {
    transform_of_.resize(shapes_.size(), none);
    transform_of_.push_back(static_cast<std::int32_t>(transforms_.size()));
    transforms_.push_back(transform);
    plain_.push_back(Plain::transformed);
    ++shape_count_;
    shapes_.push_back(std::move(shape));
  }
  void add(const Mesh& mesh, const Affine<double>& to_world, bool smooth) { triangles_.add(mesh, to_world, smooth); }
  /// A mesh at rest whose triangles are not stored again. They come after all other primitives.
  void add_copy(std::shared_ptr<const Mesh> mesh, const Affine<double>& to_world, bool smooth) {
    triangles_.add_copy(std::move(mesh), to_world, smooth);
  }
  /// Gives the primitives [first, end), already added, a motion. An empty motion changes nothing.
  void move(int first, int end, const Motion& motion);
  /// The range of ray times: boxes enclose a primitive at all of these times.
  void set_shutter(double open, double close) { open_ = open, close_ = close; }

  [[nodiscard]] int size() const { return shape_count() + triangles_.size(); }
  /// How many there are without the triangles of copies, whose ids follow.
  [[nodiscard]] int own_size() const { return shape_count() + triangles_.own_size(); }
  [[nodiscard]] int shape_count() const { return shape_count_; }
  [[nodiscard]] const Triangles<T>& triangles() const { return triangles_; }
  /// A primitive in object space, and its object transform; null when object space is world space.
  [[nodiscard]] Shape<T> shape(int id) const {
    return id < shape_count() ? own(id) : Shape<T>(triangles_[id - shape_count()]);
  }
  [[nodiscard]] const ObjectTransform<T>* transform_of(int id) const {
    if (transform_of_.empty() || id >= shape_count() || transform_of_[static_cast<std::size_t>(id)] == none)
      return nullptr;
    return &transforms_[static_cast<std::size_t>(transform_of_[static_cast<std::size_t>(id)])];
  }
  [[nodiscard]] bool moves(int id) const { return motion_of(id) != nullptr; }
  /// Whether it is a triangle of a mesh that does not move.
  [[nodiscard]] bool still_triangle(int id) const { return id >= shape_count() && motion_of(id) == nullptr; }
  /// A sphere, plane or polygon, S, without transform or motion; null for anything else.
  template <class S>
  [[nodiscard, RAYWALK_INLINE]] const S* plain(int id) const {
    if constexpr (std::is_same_v<S, Sphere<T>>) return plain<S>(id, Plain::sphere);
    if constexpr (std::is_same_v<S, Polygon<T>>) return plain<S>(id, Plain::polygon);
    if constexpr (std::is_same_v<S, Plane<T>>) {
      const S* level = plain<S>(id, Plain::level);
      return level != nullptr ? level : plain<S>(id, Plain::plane);
    }
  }

  /// The lowest id of a primitive with the same shape, transform and motion. All of them are one surface: the lowest is
  /// hit, and a ray that departs from it departs from all.
  [[nodiscard]] int first_equal(int id) const {
    const auto at = static_cast<std::size_t>(id);
    return at < first_equal_.size() ? first_equal_[at] : id;
  }
  /// Whether a primitive is surely another surface than the one that a ray departs from, -1 for none.
  [[nodiscard]] bool stands_apart(int departed, int id) const {
    return departed < 0 || (departed != id && !any_equal_ && triangles_.copies().empty());
  }
  /// Computes `first_equal` in O(n log n). `boxes`: of all primitives, or of all but those of copies, which then count
  /// as equal to none; a ray that departs from what one of them equals is recognised where it hits (unless_left).
  void find_equals(const std::vector<Bounds<T>>& boxes, const Stop& stop = {});

  /// The nearest intersection in (0, t_max) of the ray with one primitive, in the ray's own t. `sheared`: where the ray
  /// is kept as triangle tests need it, computed once for many tests.
  template <class Explain = NoExplanation>
  [[nodiscard]] std::optional<Intersection<T>> intersect(int id, const Ray<T>& ray, T t_max, Explain&& explain = {},
                                                         std::optional<ShearedRay<T>>* sheared = nullptr) const {
    // The most common primitives are tested inline.
    if (const auto* sphere = plain<Sphere<T>>(id))
      return raywalk::intersect(*sphere, ray, t_max, departed_part(ray, id), explain);
    if (const auto* floor = plain<Plane<T>>(id, Plain::level))
      return raywalk::intersect_level(*floor, ray, t_max, departed_part(ray, id), explain);
    if (const auto* plane = plain<Plane<T>>(id))
      return raywalk::intersect(*plane, ray, t_max, departed_part(ray, id), explain);
    if (const auto* polygon = plain<Polygon<T>>(id)) {
      const int departed = departed_part(ray, id);
      // It is flat: a ray that departs from it never hits it again.
      if (!std::decay_t<Explain>::wanted && departed != no_part) return std::nullopt;
      return raywalk::intersect(*polygon, area_vector(id), ray, t_max, departed, explain);
    }
    if (id < shape_count() && plain_[static_cast<std::size_t>(id)] == Plain::bare)
      return raywalk::intersect(own(id), ray, t_max, departed_part(ray, id), explain);
    if (id < shape_count() && plain_[static_cast<std::size_t>(id)] == Plain::transformed)
      return intersect_at_rest(id, ray, t_max, explain);
    return intersect_any(id, ray, t_max, explain, sheared);
  }
  /// The same with a triangle that neither moves nor is degenerate, given its coordinates (intersect_corners).
  template <class Coordinate, class Explain>
  [[nodiscard]] std::optional<Intersection<T>> intersect_triangle(int id, const Coordinate& coordinate,
                                                                  const ShearedRay<T>& sheared, const Ray<T>& ray,
                                                                  T t_max, Explain&& explain) const {
    const int departed = departed_part(ray, id);
    return unless_left(id, ray, [&] { return intersect_corners<true>(coordinate, sheared, t_max, departed, explain); });
  }
  /// The same with the triangle of a copy, given as it is placed.
  template <class Explain>
  [[nodiscard]] std::optional<Intersection<T>> intersect_copied(int id, const Triangle<T>& placed,
                                                                const ShearedRay<T>& sheared, const Ray<T>& ray,
                                                                T t_max, Explain&& explain) const {
    return unless_left(id, ray, [&] {
      auto found = raywalk::intersect(placed, sheared, t_max, departed_part(ray, id), explain);
      if (found && Triangles<T>::degenerate(placed)) found.reset();
      return found;
    });
  }
  /// As textbooks give it (shape/naive.h).
  template <class Explain = NoExplanation>
  [[nodiscard]] std::optional<Intersection<T>> intersect(int id, const NaiveRay<T>& ray, T t_max,
                                                         Explain&& explain = {},
                                                         std::optional<ShearedRay<T>>* /*sheared*/ = nullptr) const {
    if (const auto* sphere = plain<Sphere<T>>(id)) return raywalk::intersect(*sphere, ray, t_max, no_part, explain);
    if (const auto* plane = plain<Plane<T>>(id)) return raywalk::intersect(*plane, ray, t_max, no_part, explain);
    const Motion* motion = motion_of(id);
    const NaiveRay<T> rest = motion ? NaiveRay<T>(at_rest(*motion, ray.plain())) : ray;
    if (id >= shape_count()) return triangles_.intersect(id - shape_count(), rest, t_max, no_part, explain);
    const ObjectTransform<T>* transform = transform_of(id);
    return raywalk::intersect(own(id), transform ? into_object_space(*transform, rest) : rest, t_max, no_part, explain);
  }
  /// The number of intersections with one primitive in (0, t_max), where it can be computed directly: for a sphere
  /// without transform.
  template <class Explain = NoExplanation>
  [[nodiscard]] std::optional<int> intersection_count(int id, const Ray<T>& ray, T t_max,
                                                      Explain&& explain = {}) const {
    const auto* sphere = plain<Sphere<T>>(id);
    if (sphere == nullptr) return std::nullopt;
    return raywalk::intersection_count(*sphere, ray, t_max, departed_part(ray, id), explain);
  }
  /// Never inlined: otherwise inlining would depend on the rest of the kernel.
  [[nodiscard, gnu::noinline]] SurfacePoint<T> surface_at(int id, const Ray<T>& ray,
                                                          const Intersection<T>& intersection) const {
    if (const auto* sphere = plain<Sphere<T>>(id)) return raywalk::surface_at(*sphere, ray, intersection);
    if (const auto* floor = plain<Plane<T>>(id, Plain::level))
      return raywalk::surface_at_level(*floor, ray, intersection);
    if (const auto* plane = plain<Plane<T>>(id)) return raywalk::surface_at(*plane, ray, intersection);
    if (const auto* polygon = plain<Polygon<T>>(id))
      return raywalk::surface_at(*polygon, area_vector(id), ray, intersection);
    return surface_at_any(id, ray, intersection);
  }
  /// Where rounding put it: not projected back onto the surface.
  [[nodiscard]] SurfacePoint<T> surface_at(int id, const NaiveRay<T>& ray, const Intersection<T>& intersection) const {
    return {ray.at(intersection.t), surface_at(id, ray.plain(), intersection).normal};
  }
  /// Of a point at `time`. Always inlined for a plane, the checkered floor of most scenes, and never for others:
  /// otherwise inlining would depend on the rest of the kernel.
  [[nodiscard, RAYWALK_INLINE]] Vec2<T> uv_at(int id, const SurfacePoint<T>& at, int part, T time = 0) const {
    if (const auto* plane = plain<Plane<T>>(id)) return raywalk::uv_at(*plane, at, part);
    return uv_at_any(id, at, part, time);
  }
  /// The interpolated shading normal of a smooth mesh, on the same side as the geometric one; none where they are
  /// equal.
  [[nodiscard]] std::optional<Vec3<T>> smooth_normal(int id, const SurfacePoint<T>& at, T time = 0) const {
    if (id < shape_count()) return std::nullopt;
    return smooth_normal_of_triangle(id, at, time);
  }
  /// The same as the mesh gives it, on whichever side.
  [[nodiscard]] std::optional<Vec3<T>> given_normal(int id, const SurfacePoint<T>& at, T time = 0) const {
    if (id < shape_count()) return std::nullopt;
    return given_normal_of_triangle(id, at, time);
  }

  /// How fast the outward normal turns, interpolated where that is, at a point that moves along the surface
  /// (shape/shape.h).
  [[nodiscard]] Vec3<T> normal_derivative(int id, const SurfacePoint<T>& at, int part, T time,
                                          const Vec3<T>& along) const {
    const SurfacePoint<T> point = taken_back(id, at, time);
    if (id >= shape_count()) return triangles_.normal_derivative(id - shape_count(), point, along);
    const ObjectTransform<T>* transform = transform_of(id);
    return transform ? raywalk::normal_derivative(own(id), *transform, point, part, along)
                     : raywalk::normal_derivative(own(id), point, part, along);
  }
  /// The same of `uv_at`.
  [[nodiscard]] Vec2<T> uv_derivative(int id, const SurfacePoint<T>& at, int part, T time, const Vec3<T>& along) const {
    const SurfacePoint<T> point = taken_back(id, at, time);
    if (id >= shape_count()) return triangles_.uv_derivative(id - shape_count(), point, along);
    const ObjectTransform<T>* transform = transform_of(id);
    return transform ? raywalk::uv_derivative(own(id), *transform, point, part, along)
                     : raywalk::uv_derivative(own(id), point, part, along);
  }

  /// A primitive's bounds in world space, widened by a few ulps to contain every point that rounding may report.
  [[nodiscard]] Bounds<T> box(int id) const;
  /// Whether rays are transformed into object space for some primitive, which rounds their origin.
  [[nodiscard]] bool maps_rays() const { return !transforms_.empty() || !motions_.empty(); }

 private:
  /// Shapes without transform or motion: spheres, level and other planes, polygons and all others. Then those with a
  /// transform, and those that move, with or without one.
  enum class Plain : std::uint8_t { sphere, level, plane, polygon, bare, transformed, moving };
  static constexpr std::int32_t none = -1;
  [[nodiscard]] const Shape<T>& own(int id) const { return shapes_[static_cast<std::size_t>(id)]; }
  template <class S>
  [[nodiscard, RAYWALK_INLINE]] const S* plain(int id, Plain kind) const {
    if (id >= shape_count() || plain_[static_cast<std::size_t>(id)] != kind) return nullptr;
    const S* shape = std::get_if<S>(&own(id));
    if (shape == nullptr) __builtin_unreachable();
    return shape;
  }
  [[nodiscard]] const Vec3<T>& area_vector(int id) const { return area_vectors_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const Motion* motion_of(int id) const {
    const bool may =
        id < shape_count() ? plain_[static_cast<std::size_t>(id)] == Plain::moving : triangles_move_ && any_motion(id);
    return may ? &motions_[static_cast<std::size_t>(motion_of_[static_cast<std::size_t>(id)])] : nullptr;
  }
  [[nodiscard]] bool any_motion(int id) const {
    return static_cast<std::size_t>(id) < motion_of_.size() && motion_of_[static_cast<std::size_t>(id)] != none;
  }
  /// The ray in the moving primitive's frame.
  static Ray<T> at_rest(const Motion& motion, const Ray<T>& ray) {
    Ray<T> moved = ray;
    moved.origin -= Vec3<T>(offset_at(motion, static_cast<double>(ray.time)));
    return moved;
  }
  /// A point moved back to where the primitive is at rest.
  [[nodiscard]] SurfacePoint<T> taken_back(int id, SurfacePoint<T> point, T time) const {
    if (const Motion* motion = motion_of(id)) point.position -= Vec3<T>(offset_at(*motion, static_cast<double>(time)));
    return point;
  }
  // The next five are not inlined, so that the tracer's loops are the same with and without motion compiled in.
  template <class Explain>
  [[nodiscard, gnu::noinline]] std::optional<Intersection<T>> intersect_any(
      int id, const Ray<T>& ray, T t_max, Explain&& explain, std::optional<ShearedRay<T>>* sheared) const {
    // Asked of all triangles at once: where none moves, none is asked.
    if (sheared != nullptr && id >= shape_count() && !triangles_move_) {
      if (!*sheared) sheared->emplace(ray);
      return unless_left(id, ray, [&] {
        return triangles_.intersect(id - shape_count(), **sheared, t_max, departed_part(ray, id), explain);
      });
    }
    if (const Motion* motion = motion_of(id)) return intersect_at_rest(id, at_rest(*motion, ray), t_max, explain);
    return intersect_at_rest(id, ray, t_max, explain);
  }
  [[nodiscard, gnu::noinline]] SurfacePoint<T> surface_at_any(int id, const Ray<T>& ray,
                                                              const Intersection<T>& intersection) const {
    const Motion* motion = motion_of(id);
    if (!motion) return surface_at_rest(id, ray, intersection);
    SurfacePoint<T> point = surface_at_rest(id, at_rest(*motion, ray), intersection);
    point.position += Vec3<T>(offset_at(*motion, static_cast<double>(ray.time)));
    return point;
  }
  [[nodiscard, gnu::noinline]] std::optional<Vec3<T>> smooth_normal_of_triangle(int id, const SurfacePoint<T>& at,
                                                                                T time) const {
    return triangles_.smooth_normal(id - shape_count(), taken_back(id, at, time));
  }
  [[nodiscard, gnu::noinline]] std::optional<Vec3<T>> given_normal_of_triangle(int id, const SurfacePoint<T>& at,
                                                                               T time) const {
    return triangles_.given_normal(id - shape_count(), taken_back(id, at, time));
  }
  [[nodiscard, gnu::noinline]] Vec2<T> uv_at_any(int id, const SurfacePoint<T>& at, int part, T time) const {
    const SurfacePoint<T> point = taken_back(id, at, time);
    if (id >= shape_count()) return triangles_.uv_at(id - shape_count(), point);
    const ObjectTransform<T>* transform = transform_of(id);
    return transform ? raywalk::uv_at(own(id), *transform, point, part) : raywalk::uv_at(own(id), point, part);
  }
  template <class Explain>
  [[nodiscard, gnu::noinline]] std::optional<Intersection<T>> intersect_at_rest(int id, const Ray<T>& ray, T t_max,
                                                                                Explain&& explain) const {
    const int departed = departed_part(ray, id);
    if (id >= shape_count())
      return unless_left(id, ray,
                         [&] { return triangles_.intersect(id - shape_count(), ray, t_max, departed, explain); });
    const ObjectTransform<T>* transform = transform_of(id);
    return transform ? raywalk::intersect(own(id), into_object_space(*transform, ray), t_max, departed, explain)
                     : raywalk::intersect(own(id), ray, t_max, departed, explain);
  }
  [[nodiscard]] SurfacePoint<T> surface_at_rest(int id, const Ray<T>& ray, const Intersection<T>& intersection) const {
    if (id >= shape_count()) return raywalk::surface_at(triangles_[id - shape_count()], ray, intersection);
    const ObjectTransform<T>* transform = transform_of(id);
    return transform ? raywalk::surface_at(own(id), *transform, ray, intersection)
                     : raywalk::surface_at(own(id), ray, intersection);
  }
  /// The intersection with triangle `id` that `find` finds, unless it is only at the shared edge or corner: when a ray
  /// departs from a neighbour, on the same side of both, its origin may be rounded to the wrong side of this one. Nor
  /// if one of a copy is the surface that the ray departs from. (It is never copied: what is stored in pieces and
  /// loaded as a whole stalls the processor.)
  template <class Find>
  [[nodiscard, gnu::always_inline]] std::optional<Intersection<T>> unless_left(int id, const Ray<T>& ray,
                                                                               const Find& find) const {
    auto intersection = find();
    const int from = ray.departure.primitive;
    if (intersection && from >= shape_count() && leaves_at_once(from, id, ray, intersection->t)) intersection.reset();
    return intersection;
  }
  [[nodiscard]] bool leaves_at_once(int from, int id, const Ray<T>& ray, T t) const {
    const int left = from - shape_count(), met = id - shape_count();
    return triangles_.leaves_by_edge(left, met, ray, t) ||
           (std::max(from, id) >= own_size() && triangles_.equal(left, met));
  }
  /// The part of primitive `id` that the ray departs from, or no_part.
  [[nodiscard]] int departed_part(const Ray<T>& ray, int id) const {
    const int from = ray.departure.primitive;
    return from == id || (any_equal_ && same_surface(from, id)) ? ray.departure.part : no_part;
  }
  [[nodiscard, gnu::noinline]] bool same_surface(int from, int id) const {
    return from >= 0 && first_equal(from) == first_equal(id);
  }
  [[nodiscard]] bool equal(int a, int b) const;

  std::vector<Shape<T>> shapes_;
  std::vector<Plain> plain_;           ///< by shape
  std::vector<Vec3<T>> area_vectors_;  ///< by shape, up to the last plain polygon: computed once
  int shape_count_ = 0;
  Triangles<T> triangles_;
  std::vector<std::int32_t> transform_of_;  ///< by shape; empty when none has a map
  std::vector<ObjectTransform<T>> transforms_;
  std::vector<std::int32_t> motion_of_;  ///< by primitive; those past its end are at rest
  std::vector<Motion> motions_;
  double open_ = 0, close_ = 1;
  bool any_equal_ = false;
  bool triangles_move_ = false;            ///< some of them
  std::vector<std::int32_t> first_equal_;  ///< by primitive; empty when no two are equal
};

/// The bounds that a structure is built from: of the primitives with finite bounds; the others, which every ray is
/// tested against, are listed separately.
template <class T>
struct PrimitiveBounds {
  /// With `copies`, of their triangles too; a structure that knows of copies does without.
  explicit PrimitiveBounds(const Primitives<T>& primitives, bool copies, const Stop& stop = {}) {
    const int count = copies ? primitives.size() : primitives.own_size();
    boxes.reserve(static_cast<std::size_t>(count));
    for (int id = 0; id < count; ++id) {
      stop.check();
      boxes.push_back(primitives.box(id));
      if (boxes.back().empty()) continue;  // nothing to hit: a quadric clipped away entirely
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

extern template class Primitives<float>;
extern template class Primitives<double>;

}  // namespace raywalk
