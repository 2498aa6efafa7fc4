#pragma once

#include "math/exact.h"
#include "math/inlining.h"
#include "shape/intersection.h"

#include <cmath>

namespace raywalk {

template <class T>
struct Plane {
  Vec3<T> point{0};
  Vec3<T> normal{0, 0, 1};  ///< towards the front; any length but 0
  friend bool operator==(const Plane&, const Plane&) = default;
};

namespace detail {

template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] PlaneIntersection exact_intersection(const Plane<T>& plane, const Ray<T>& ray) {
  return intersect_plane_exactly(wide(plane.normal), wide(plane.point), wide(ray.origin), wide(ray.direction));
}

}  // namespace detail

/// Whether all of it lies at the height of `point`.
template <class T>
[[nodiscard]] bool is_level(const Plane<T>& plane) {
  return plane.normal.x == 0 && plane.normal.y == 0;
}

/// `intersect` for a level plane, the floor of most scenes: its height above the origin over the ray's rate of climb,
/// both of correct sign.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect_level(const Plane<T>& plane, const Ray<T>& ray, T t_max,
                                                             int departed_part = no_part, Explain&& explain = {}) {
  constexpr bool explained = std::decay_t<Explain>::wanted;
  if (!explained && departed_part != no_part) return std::nullopt;
  const double above = static_cast<double>(plane.point.z) - static_cast<double>(ray.origin.z);
  const double climb = static_cast<double>(ray.direction.z);
  if constexpr (explained) {
    const double up = static_cast<double>(plane.normal.z);
    explain.plane(up * above, up * climb);
    if (departed_part != no_part) return std::nullopt;
  }
  if ((above > 0) != (climb > 0)) return std::nullopt;  // a plane behind is rejected without the division
  return detail::intersection_ahead(above / climb, t_max);
}

/// t in (0, t_max) at which the ray crosses the plane, in double even for float rays. A ray in the plane or parallel to
/// it does not hit it, and one that departs from it never hits it again. The side of the origin and the sense of the
/// ray are certain: where rounding could decide, exact arithmetic does.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Plane<T>& plane, const Ray<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {}) {
  if (is_level(plane)) return intersect_level(plane, ray, t_max, departed_part, explain);
  // Early out: a ray that departs from the plane cannot hit it again.
  constexpr bool explained = std::decay_t<Explain>::wanted;
  if (!explained && departed_part != no_part) return std::nullopt;
  const Vec3d normal = wide(plane.normal), point = wide(plane.point), o = wide(ray.origin), d = wide(ray.direction);
  RoundedSum numerator = estimate_dot_of_difference(normal, point, o), denominator = estimate_dot(normal, d);
  double quotient = 0;
  if (numerator.certain() && denominator.certain()) {
    // A plane behind is rejected without the division.
    if ((numerator.value > 0) == (denominator.value > 0)) quotient = numerator.value / denominator.value;
  } else {
    note_exact(explain);
    const PlaneIntersection met = detail::exact_intersection(plane, ray);
    numerator.value = met.numerator.value, denominator.value = met.denominator.value, quotient = met.t;
  }
  if constexpr (explained) explain.plane(numerator.value, denominator.value);
  if (explained && departed_part != no_part) return std::nullopt;
  return detail::intersection_ahead(quotient, t_max);
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at_level(const Plane<T>& plane, const Ray<T>& ray,
                                               const Intersection<T>& intersection) {
  const Vec3<T> computed = ray.at(intersection.t);
  return {{computed.x, computed.y, plane.point.z}, {0, 0, std::copysign(T(1), plane.normal.z)}};
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Plane<T>& plane, const Ray<T>& ray,
                                         const Intersection<T>& intersection) {
  if (is_level(plane)) return surface_at_level(plane, ray, intersection);
  const T square = dot(plane.normal, plane.normal);
  const Vec3<T> normal = square == 1 ? plane.normal : plane.normal / std::sqrt(square);  // most have unit length
                                                                                         // already
  const Vec3<T> position = ray.at(intersection.t);
  return {position - dot(position - plane.point, normal) * normal, normal};
}

/// Along the plane's own two axes, from its `point`; for a level plane these are x and y.
template <class T>
[[nodiscard, RAYWALK_INLINE]] inline Vec2<T> uv_at(const Plane<T>& plane, const SurfacePoint<T>& point, int /*part*/) {
  return in_plane(point.position - plane.point, point.normal);
}

template <class T>
[[nodiscard]] Vec3<T> normal_derivative(const Plane<T>& /*plane*/, const SurfacePoint<T>& /*point*/, int /*part*/,
                                        const Vec3<T>& /*along*/) {
  return Vec3<T>(0);
}

template <class T>
[[nodiscard]] Vec2<T> uv_derivative(const Plane<T>& /*plane*/, const SurfacePoint<T>& point, int /*part*/,
                                    const Vec3<T>& along) {
  return in_plane(along, point.normal);
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Plane<T>& plane) {
  Bounds<T> box{Vec3<T>(-infinity<T>), Vec3<T>(infinity<T>)};
  for (int axis = 0; axis < 3; ++axis) {
    const bool flat = plane.normal[(axis + 1) % 3] == 0 && plane.normal[(axis + 2) % 3] == 0;
    if (flat) box.min[axis] = box.max[axis] = plane.point[axis];
  }
  return box;
}

template <class T>
[[nodiscard]] constexpr bool has_inside(const Plane<T>& /*shape*/) {
  return false;
}

template <class Cutter>
void cut(Cutter& /*to*/, const Plane<double>& /*plane*/) {}

}  // namespace raywalk
