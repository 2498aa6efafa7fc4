#pragma once
// Shapes under an affine map: the ray is taken into the shape's own space, where t stays what it was because its
// direction is not made unit length again.

#include "math/transform.h"
#include "shape/shape.h"

namespace raywalk {

/// Both ways between a shape's own space and the world's.
template <class T>
struct Placement {
  Affine<T> to_world, to_shape;
};

/// None when the map is singular.
template <class T>
[[nodiscard]] std::optional<Placement<T>> placement(const Affine<double>& to_world) {
  const auto to_shape = inverse(to_world);
  if (!to_shape) return std::nullopt;
  const auto rounded = [](const Affine<double>& m) {
    return Affine<T>{Vec3<T>(m.x), Vec3<T>(m.y), Vec3<T>(m.z), Vec3<T>(m.move)};
  };
  return Placement<T>{rounded(to_world), rounded(*to_shape)};
}

template <class T>
[[nodiscard]] Ray<T> into_shape(const Placement<T>& place, const Ray<T>& ray) {
  return {place.to_shape.point(ray.origin), place.to_shape.direction(ray.direction), ray.departure, ray.time};
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Shape<T>& shape, const Placement<T>& place, const Ray<T>& ray,
                                         Crossing<T> crossing) {
  const SurfacePoint<T> own = surface_at(shape, into_shape(place, ray), crossing);
  return {place.to_world.point(own.position), normalize(place.to_world.normal(own.normal))};
}

/// In the shape's own lengths.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Shape<T>& shape, const Placement<T>& place, const SurfacePoint<T>& point, int part) {
  const Vec3<T> own_normal = place.to_shape.normal(point.normal);
  return uv_at(shape, SurfacePoint<T>{place.to_shape.point(point.position), normalize(own_normal)}, part);
}

}  // namespace raywalk
