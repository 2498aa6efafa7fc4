#pragma once

#include "accel/triangles.h"
#include "math/motion.h"
#include "math/stop.h"
#include "shape/naive.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

namespace raywalk {

/// What an accelerator is built over: shapes, each under an affine map of its own or none, then the triangles of
/// meshes; any of them may move. A primitive's id is its place in the order in which they were added.
template <class T>
class Primitives {
 public:
  Primitives() = default;
  explicit Primitives(std::vector<Shape<T>> shapes) {
    for (Shape<T>& shape : shapes) add(std::move(shape));
  }

  /// Shapes are added before meshes, whose triangles have the ids that follow.
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
    if (!places_.empty()) place_of_.push_back(none);
  }
  void add(Shape<T> shape, const Placement<T>& place) {
    place_of_.resize(shapes_.size(), none);
    place_of_.push_back(static_cast<std::int32_t>(places_.size()));
    places_.push_back(place);
    plain_.push_back(Plain::placed);
    ++shape_count_;
    shapes_.push_back(std::move(shape));
  }
  void add(const Mesh& mesh, const Affine<double>& to_world, bool smooth) { triangles_.add(mesh, to_world, smooth); }
  /// Makes the primitives [first, end), which have been added, move. At rest, they stay as they are.
  void move(int first, int end, const Motion& motion);
  /// The times that rays have: boxes hold all places in which a primitive then is.
  void set_shutter(double open, double close) { open_ = open, close_ = close; }

  [[nodiscard]] int size() const { return shape_count() + triangles_.size(); }
  [[nodiscard]] int shape_count() const { return shape_count_; }
  [[nodiscard]] const Triangles<T>& triangles() const { return triangles_; }
  /// A primitive in its own space, and the map that takes it into the world; null when it stands there already.
  [[nodiscard]] Shape<T> shape(int id) const {
    return id < shape_count() ? own(id) : Shape<T>(triangles_[id - shape_count()]);
  }
  [[nodiscard]] const Placement<T>* place_of(int id) const {
    if (place_of_.empty() || id >= shape_count() || place_of_[static_cast<std::size_t>(id)] == none) return nullptr;
    return &places_[static_cast<std::size_t>(place_of_[static_cast<std::size_t>(id)])];
  }
  [[nodiscard]] bool moves(int id) const { return motion_of(id) != nullptr; }
  [[nodiscard]] bool triangles_move() const { return triangles_move_; }
  /// A sphere, plane or polygon, S, that stands in the world as it is, neither mapped nor moving; null for all else.
  template <class S>
  [[nodiscard]] const S* plain(int id) const {
    if constexpr (std::is_same_v<S, Sphere<T>>) return plain<S>(id, Plain::sphere);
    if constexpr (std::is_same_v<S, Polygon<T>>) return plain<S>(id, Plain::polygon);
    if constexpr (std::is_same_v<S, Plane<T>>) {
      const S* level = plain<S>(id, Plain::level);
      return level != nullptr ? level : plain<S>(id, Plain::plane);
    }
  }

  /// The lowest id of a primitive that equals this one in shape, place and motion. All of them are one surface: the
  /// lowest is hit, and what departs from it departs from all.
  [[nodiscard]] int first_equal(int id) const {
    return first_equal_.empty() ? id : first_equal_[static_cast<std::size_t>(id)];
  }
  /// Makes `first_equal` known, in time n log n. `boxes` are those of all primitives.
  void find_equals(const std::vector<Bounds<T>>& boxes, const Stop& stop = {});

  /// Nearest crossing in (0, t_max) of the ray with one primitive, in the ray's own t. For one of many tests of a ray,
  /// what triangles need of it may have been computed already: `sheared`, where no triangle moves.
  template <class Explain = NoExplanation>
  [[nodiscard]] std::optional<Crossing<T>> intersect(int id, const Ray<T>& ray, T t_max, Explain&& explain = {},
                                                     const std::optional<ShearedRay<T>>& sheared = {}) const {
    // The primitives that scenes are full of are tested in place.
    if (const auto* sphere = plain<Sphere<T>>(id))
      return raywalk::intersect(*sphere, ray, t_max, departed_part(ray, id), explain);
    if (const auto* floor = plain<Plane<T>>(id, Plain::level))
      return raywalk::intersect_level(*floor, ray, t_max, departed_part(ray, id), explain);
    if (const auto* plane = plain<Plane<T>>(id))
      return raywalk::intersect(*plane, ray, t_max, departed_part(ray, id), explain);
    if (const auto* polygon = plain<Polygon<T>>(id)) {
      const int departed = departed_part(ray, id);
      // It is flat: what leaves it never meets it again.
      if (!std::decay_t<Explain>::wanted && departed != no_part) return std::nullopt;
      return raywalk::intersect(*polygon, area_vector(id), ray, t_max, departed, explain);
    }
    if (id < shape_count() && plain_[static_cast<std::size_t>(id)] == Plain::bare)
      return raywalk::intersect(own(id), ray, t_max, departed_part(ray, id), explain);
    if (id < shape_count() && plain_[static_cast<std::size_t>(id)] == Plain::placed)
      return intersect_at_rest(id, ray, t_max, explain);
    if (sheared && id >= shape_count())
      return unless_left(id, ray,
                         triangles_.intersect(id - shape_count(), *sheared, t_max, departed_part(ray, id), explain));
    return intersect_any(id, ray, t_max, explain);
  }
  /// As books print it (shape/naive.h).
  template <class Explain = NoExplanation>
  [[nodiscard]] std::optional<Crossing<T>> intersect(int id, const NaiveRay<T>& ray, T t_max, Explain&& explain = {},
                                                     const std::optional<ShearedRay<T>>& /*sheared*/ = {}) const {
    if (const auto* sphere = plain<Sphere<T>>(id)) return raywalk::intersect(*sphere, ray, t_max, no_part, explain);
    if (const auto* plane = plain<Plane<T>>(id)) return raywalk::intersect(*plane, ray, t_max, no_part, explain);
    const Motion* motion = motion_of(id);
    const NaiveRay<T> rest = motion ? NaiveRay<T>{at_rest(*motion, ray)} : ray;
    if (id >= shape_count()) return triangles_.intersect(id - shape_count(), rest, t_max, no_part, explain);
    const Placement<T>* place = place_of(id);
    return raywalk::intersect(own(id), place ? into_shape(*place, rest) : rest, t_max, no_part, explain);
  }
  /// How often the ray crosses one primitive in (0, t_max), where that can be told at once: of a plain sphere.
  template <class Explain = NoExplanation>
  [[nodiscard]] std::optional<int> crossings(int id, const Ray<T>& ray, T t_max, Explain&& explain = {}) const {
    const auto* sphere = plain<Sphere<T>>(id);
    if (sphere == nullptr) return std::nullopt;
    return raywalk::crossings(*sphere, ray, t_max, departed_part(ray, id), explain);
  }
  /// Never inlined: whether it was would hang on what other code a kernel holds.
  [[nodiscard, gnu::noinline]] SurfacePoint<T> surface_at(int id, const Ray<T>& ray, Crossing<T> crossing) const {
    if (const auto* sphere = plain<Sphere<T>>(id)) return raywalk::surface_at(*sphere, ray, crossing);
    if (const auto* floor = plain<Plane<T>>(id, Plain::level)) return raywalk::surface_at_level(*floor, ray, crossing);
    if (const auto* plane = plain<Plane<T>>(id)) return raywalk::surface_at(*plane, ray, crossing);
    if (const auto* polygon = plain<Polygon<T>>(id))
      return raywalk::surface_at(*polygon, area_vector(id), ray, crossing);
    return surface_at_any(id, ray, crossing);
  }
  /// Where rounding put it: nothing is pulled back onto the surface.
  [[nodiscard]] SurfacePoint<T> surface_at(int id, const NaiveRay<T>& ray, Crossing<T> crossing) const {
    return {ray.at(crossing.t), surface_at(id, static_cast<const Ray<T>&>(ray), crossing).normal};
  }
  /// Of a point at `time`.
  [[nodiscard]] Vec2<T> uv_at(int id, const SurfacePoint<T>& at, int part, T time = 0) const {
    if (const auto* plane = plain<Plane<T>>(id)) return raywalk::uv_at(*plane, at, part);
    return uv_at_any(id, at, part, time);
  }
  /// The normal that a smooth mesh is shaded with, on the outside as the point's own; none where they are the same.
  [[nodiscard]] std::optional<Vec3<T>> smooth_normal(int id, const SurfacePoint<T>& at, T time = 0) const {
    if (id < shape_count()) return std::nullopt;
    return smooth_normal_of_triangle(id, at, time);
  }
  /// The same as the mesh gives it, whichever side that is.
  [[nodiscard]] std::optional<Vec3<T>> given_normal(int id, const SurfacePoint<T>& at, T time = 0) const {
    if (id < shape_count()) return std::nullopt;
    return given_normal_of_triangle(id, at, time);
  }

  /// A primitive's box in the world, widened by a few ulps so that it holds every point that rounding may report.
  [[nodiscard]] Bounds<T> box(int id) const;
  /// Whether rays are taken into a space of some primitive's own, which rounds where they start.
  [[nodiscard]] bool maps_rays() const { return !places_.empty() || !motions_.empty(); }

 private:
  /// Shapes that stand in the world as they are, at rest: spheres, level and other planes, polygons and all others.
  /// Those under a map, and those that move, mapped or not.
  enum class Plain : std::uint8_t { sphere, level, plane, polygon, bare, placed, moving };
  static constexpr std::int32_t none = -1;
#ifdef RAYWALK_WITHOUT_MOTION  // set only by the benchmark that measures what motion costs where nothing moves
  static constexpr bool moves_compiled = false;
#else
  static constexpr bool moves_compiled = true;
#endif
  [[nodiscard]] const Shape<T>& own(int id) const { return shapes_[static_cast<std::size_t>(id)]; }
  template <class S>
  [[nodiscard]] const S* plain(int id, Plain kind) const {
    if (id >= shape_count() || plain_[static_cast<std::size_t>(id)] != kind) return nullptr;
    const S* shape = std::get_if<S>(&own(id));
    if (shape == nullptr) __builtin_unreachable();
    return shape;
  }
  [[nodiscard]] const Vec3<T>& area_vector(int id) const { return area_vectors_[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const Motion* motion_of(int id) const {
    const bool may =
        id < shape_count() ? plain_[static_cast<std::size_t>(id)] == Plain::moving : triangles_move_ && any_motion(id);
    return moves_compiled && may ? &motions_[static_cast<std::size_t>(motion_of_[static_cast<std::size_t>(id)])]
                                 : nullptr;
  }
  [[nodiscard]] bool any_motion(int id) const {
    return static_cast<std::size_t>(id) < motion_of_.size() && motion_of_[static_cast<std::size_t>(id)] != none;
  }
  /// The ray as what moves sees it.
  static Ray<T> at_rest(const Motion& motion, const Ray<T>& ray) {
    Ray<T> moved = ray;
    moved.origin -= Vec3<T>(offset_at(motion, static_cast<double>(ray.time)));
    return moved;
  }
  /// A point of it as it is at rest.
  [[nodiscard]] SurfacePoint<T> taken_back(int id, SurfacePoint<T> point, T time) const {
    if (const Motion* motion = motion_of(id)) point.position -= Vec3<T>(offset_at(*motion, static_cast<double>(time)));
    return point;
  }
  // The five that follow stand apart, so that what the tracer has in its loops is the same whether motion is compiled
  // or not.
  template <class Explain>
  [[nodiscard, gnu::noinline]] std::optional<Crossing<T>> intersect_any(int id, const Ray<T>& ray, T t_max,
                                                                        Explain&& explain) const {
    if (const Motion* motion = motion_of(id)) return intersect_at_rest(id, at_rest(*motion, ray), t_max, explain);
    return intersect_at_rest(id, ray, t_max, explain);
  }
  [[nodiscard, gnu::noinline]] SurfacePoint<T> surface_at_any(int id, const Ray<T>& ray, Crossing<T> crossing) const {
    const Motion* motion = motion_of(id);
    if (!motion) return surface_at_rest(id, ray, crossing);
    SurfacePoint<T> point = surface_at_rest(id, at_rest(*motion, ray), crossing);
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
    const Placement<T>* place = place_of(id);
    return place ? raywalk::uv_at(own(id), *place, point, part) : raywalk::uv_at(own(id), point, part);
  }
  template <class Explain>
  [[nodiscard, gnu::noinline]] std::optional<Crossing<T>> intersect_at_rest(int id, const Ray<T>& ray, T t_max,
                                                                            Explain&& explain) const {
    const int departed = departed_part(ray, id);
    if (id >= shape_count())
      return unless_left(id, ray, triangles_.intersect(id - shape_count(), ray, t_max, departed, explain));
    const Placement<T>* place = place_of(id);
    return place ? raywalk::intersect(own(id), into_shape(*place, ray), t_max, departed, explain)
                 : raywalk::intersect(own(id), ray, t_max, departed, explain);
  }
  [[nodiscard]] SurfacePoint<T> surface_at_rest(int id, const Ray<T>& ray, Crossing<T> crossing) const {
    if (id >= shape_count()) return raywalk::surface_at(triangles_[id - shape_count()], ray, crossing);
    const Placement<T>* place = place_of(id);
    return place ? raywalk::surface_at(own(id), *place, ray, crossing) : raywalk::surface_at(own(id), ray, crossing);
  }
  /// A crossing of triangle `id`, unless that is only the edge or corner that the ray leaves it by: a ray that departs
  /// from a neighbour on the same side of both, its origin rounded to the wrong side of this one.
  [[nodiscard]] std::optional<Crossing<T>> unless_left(int id, const Ray<T>& ray,
                                                       const std::optional<Crossing<T>>& crossing) const {
    const int from = ray.departure.primitive;
    if (!crossing || from < shape_count() ||
        !triangles_.leaves_by_edge(from - shape_count(), id - shape_count(), ray, crossing->t))
      return crossing;
    return std::nullopt;
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
  std::vector<Vec3<T>> area_vectors_;  ///< by shape, up to the last plain polygon: theirs, worked out once
  int shape_count_ = 0;
  Triangles<T> triangles_;
  std::vector<std::int32_t> place_of_;  ///< by shape; empty when none has a map
  std::vector<Placement<T>> places_;
  std::vector<std::int32_t> motion_of_;  ///< by primitive, those behind its end are at rest
  std::vector<Motion> motions_;
  double open_ = 0, close_ = 1;
  bool any_equal_ = false;
  bool triangles_move_ = false;            ///< some of them
  std::vector<std::int32_t> first_equal_;  ///< by primitive; empty when no two are equal
};

/// The boxes that a structure is built from: of the primitives with a finite box; the others, which every ray is tested
/// against, are listed apart.
template <class T>
struct Boxes {
  explicit Boxes(const Primitives<T>& primitives, const Stop& stop = {}) {
    boxes.reserve(static_cast<std::size_t>(primitives.size()));
    for (int id = 0; id < primitives.size(); ++id) {
      stop.check();
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

extern template class Primitives<float>;
extern template class Primitives<double>;

}  // namespace raywalk
