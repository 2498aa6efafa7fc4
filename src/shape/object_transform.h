#pragma once
// Shapes under an affine map: the ray is transformed into object space, where t keeps its value because the direction
// is not normalised again.

#include "math/transform.h"
#include "shape/shape.h"

namespace raywalk {

/// Object space to world space, and back.
template <class T>
struct ObjectTransform {
  Affine<T> to_world, to_object;
};

/// None when the map is singular.
template <class T>
[[nodiscard]] std::optional<ObjectTransform<T>> object_transform(const Affine<double>& to_world) {
  const auto to_object = inverse(to_world);
  if (!to_object) return std::nullopt;
  const auto rounded = [](const Affine<double>& m) {
    return Affine<T>{Vec3<T>(m.x), Vec3<T>(m.y), Vec3<T>(m.z), Vec3<T>(m.move)};
  };
  return ObjectTransform<T>{rounded(to_world), rounded(*to_object)};
}

/// Inlined wherever it is asked for: a call for each primitive costs more than the transform.
template <class T>
[[nodiscard, gnu::always_inline]] inline Ray<T> into_object_space(const ObjectTransform<T>& transform,
                                                                  const Ray<T>& ray) {
  return {transform.to_object.point(ray.origin), transform.to_object.direction(ray.direction), ray.departure, ray.time};
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Shape<T>& shape, const ObjectTransform<T>& transform, const Ray<T>& ray,
                                         const Intersection<T>& intersection) {
  const SurfacePoint<T> own = surface_at(shape, into_object_space(transform, ray), intersection);
  return {transform.to_world.point(own.position), normalize(transform.to_world.normal(own.normal))};
}

template <class T>
[[nodiscard]] SurfacePoint<T> into_object_space(const ObjectTransform<T>& transform, const SurfacePoint<T>& point) {
  const Vec3<T> own_normal = transform.to_object.normal(point.normal);
  return {transform.to_object.point(point.position), normalize(own_normal)};
}

/// In object space lengths.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Shape<T>& shape, const ObjectTransform<T>& transform, const SurfacePoint<T>& point,
                            int part) {
  return uv_at(shape, into_object_space(transform, point), part);
}

template <class T>
[[nodiscard]] Vec3<T> normal_derivative(const Shape<T>& shape, const ObjectTransform<T>& transform,
                                        const SurfacePoint<T>& point, int part, const Vec3<T>& along) {
  const SurfacePoint<T> own = into_object_space(transform, point);
  const Vec3<T> turned = normal_derivative(shape, own, part, transform.to_object.direction(along));
  return derivative_of_unit(transform.to_world.normal(own.normal), transform.to_world.normal(turned));
}

template <class T>
[[nodiscard]] Vec2<T> uv_derivative(const Shape<T>& shape, const ObjectTransform<T>& transform,
                                    const SurfacePoint<T>& point, int part, const Vec3<T>& along) {
  return uv_derivative(shape, into_object_space(transform, point), part, transform.to_object.direction(along));
}

}  // namespace raywalk
