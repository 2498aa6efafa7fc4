#pragma once
// The list of shapes: a new primitive is one header beside this one and one entry here.

#include "shape/plane.h"
#include "shape/prism.h"
#include "shape/sphere.h"

#include <variant>

namespace raywalk {

template <class T>
using Shape = std::variant<Sphere<T>, Plane<T>, Prism<T>>;

template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Crossing<T>> intersect(const Shape<T>& shape, const Ray<T>& ray, T t_max,
                                                   int departed_part = no_part, Explain&& explain = {}) {
  return std::visit([&](const auto& s) { return intersect(s, ray, t_max, departed_part, explain); }, shape);
}

/// The point of `shape` at a crossing that its `intersect` returned for this very ray.
template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Shape<T>& shape, const Ray<T>& ray, Crossing<T> crossing) {
  return std::visit([&](const auto& s) { return surface_at(s, ray, crossing); }, shape);
}

/// Coordinates of a point of part `part`: lengths along the surface in scene units, from an origin and in directions
/// fixed to the shape.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Shape<T>& shape, const SurfacePoint<T>& point, int part) {
  return std::visit([&](const auto& s) { return uv_at(s, point, part); }, shape);
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Shape<T>& shape) {
  return std::visit([](const auto& s) { return bounds(s); }, shape);
}

/// The same shape in another scalar type: each number rounded once.
template <class To, class From>
[[nodiscard]] Shape<To> shape_cast(const Shape<From>& shape);

namespace detail {

template <class To, class From>
Shape<To> cast_shape(const Sphere<From>& s) {
  return Sphere<To>{Vec3<To>(s.centre), static_cast<To>(s.radius)};
}
template <class To, class From>
Shape<To> cast_shape(const Plane<From>& p) {
  return Plane<To>{Vec3<To>(p.point), Vec3<To>(p.normal)};
}
template <class To, class From>
Shape<To> cast_shape(const Prism<From>& p) {
  Prism<To> prism;
  for (const auto& corner : p.corners) prism.corners.emplace_back(corner);
  prism.height = static_cast<To>(p.height);
  return prism;
}

}  // namespace detail

template <class To, class From>
Shape<To> shape_cast(const Shape<From>& shape) {
  return std::visit([](const auto& s) { return detail::cast_shape<To>(s); }, shape);
}

}  // namespace raywalk
