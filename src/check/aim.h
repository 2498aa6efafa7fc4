#pragma once

#include "check/traits_flat.h"
#include "shape/object_transform.h"

#include <optional>

namespace raywalk::check {

/// A ray from near `eye` through near `target`, as stored; none if rounding leaves a zero direction.
template <class T>
[[nodiscard]] std::optional<Ray<T>> ray_towards(const Vec3d& eye, const Vec3d& target, Random& random) {
  Ray<T> ray{Vec3<T>(eye), Vec3<T>(0)};
  Vec3d d = target - Vec3d(ray.origin);
  const double size = length(d);
  if (!(size > 0) || !std::isfinite(size)) return std::nullopt;
  // Unit directions as from a camera, or of any length as after a transform.
  const int form = random.whole(0, 2);
  if (form == 1) d /= size;
  if (form == 2) d *= random.magnitude(-3, 3) / size;
  ray.direction = Vec3<T>(d);
  if (ray.direction == Vec3<T>(0)) return std::nullopt;
  return ray;
}

/// The object-space ray of a shape placed at `centre`: its origin keeps only the digits that it has there.
template <class T>
[[nodiscard]] Ray<T> brought_back(Ray<T> ray, const Vec3d& centre) {
  const Vec3<T> world(Vec3d(ray.origin) + centre);
  ray.origin = world - Vec3<T>(centre);
  return ray;
}

/// Case `number` of a stratum; none if the drawn numbers give no valid shape or ray.
template <class S, class T>
[[nodiscard]] std::optional<Case<S, T>> aim(Stratum stratum, Random& random) {
  using B = ShapeTraits<S>;
  if (stratum == Stratum::exactly_tangent) {
    Case<S, T> whole = B::exactly_tangent(random);
    if (whole.ray.direction == Vec3<T>(0)) return std::nullopt;
    return whole;
  }
  const double scale = stratum == Stratum::scales         ? random.magnitude(-6, 9)
                       : stratum == Stratum::translations ? random.magnitude(-2, 6)
                                                          : 1;
  const Vec3d centre = stratum == Stratum::translations ? 1e9 * random.in_box() : Vec3d(0.0);
  const S shape = B::make(random, scale, centre);
  const double size = B::size(shape);
  const double distance = stratum == Stratum::far ? random.magnitude(0, 15) : random.magnitude(0.2, 2);
  Vec3d eye = B::centre(shape) + size * distance * random.unit();
  const auto beside = [&](const Vec3d& p, int least, int most) {
    return p + std::ldexp(size, -random.whole(least, most)) * random.unit();
  };
  const auto edge = [&] { return beside(B::silhouette(shape, random, eye), 1, 60); };
  const auto mixed = [&] { return random.coin() ? edge() : B::interior(shape, random); };

  std::optional<Ray<T>> ray;
  switch (stratum) {
    case Stratum::random:
      ray = ray_towards<T>(eye, B::centre(shape) + 2 * size * random.in_box(), random);
      break;
    case Stratum::tangent:
    case Stratum::far:
      ray = ray_towards<T>(eye, edge(), random);
      break;
    case Stratum::exactly_tangent:
      break;
    case Stratum::scales:
    case Stratum::translations:
      ray = ray_towards<T>(eye, mixed(), random);
      break;
    case Stratum::zero_components: {
      const Vec3d target = mixed();
      const int axis = random.whole(0, 2), more = random.coin() ? (axis + 1) % 3 : axis;
      eye[axis] = target[axis], eye[more] = target[more];
      ray = ray_towards<T>(eye, target, random);
      if (!ray) break;
      for (const int a : {axis, more}) ray->direction[a] = random.coin() ? T(0) : -T(0);
      break;
    }
    case Stratum::on_surface: {
      eye = B::surface(shape, random);
      const int where = random.whole(0, 2);
      const Vec3d target = where == 0   ? B::surface(shape, random)
                           : where == 1 ? B::interior(shape, random)
                                        : eye + size * random.unit();
      ray = ray_towards<T>(eye, target, random);
      break;
    }
    case Stratum::inside:
      eye = B::interior(shape, random);
      ray = ray_towards<T>(eye, random.coin() ? eye + size * random.unit() : edge(), random);
      break;
    case Stratum::apex_and_rim:
      ray = ray_towards<T>(eye, random.coin() ? B::special(shape, random) : beside(B::special(shape, random), 1, 60),
                           random);
      break;
    case Stratum::parallel: {
      Vec3d d = B::parallel(shape, random);
      if (random.coin()) d += std::ldexp(length(d), -random.whole(1, 60)) * random.unit();
      const Vec3d target = random.coin() ? B::surface(shape, random) : B::interior(shape, random);
      const double size_of_d = length(d);
      if (!(size_of_d > 0)) break;
      const double back = random.real(-2, 5) * size / size_of_d;
      ray = Ray<T>{Vec3<T>(target - back * d), Vec3<T>(d)};
      break;
    }
    case Stratum::subnormal: {
      // Some components of the ray nearly vanish, others do not.
      const Vec3d target = mixed();
      const int axis = random.whole(0, 2);
      if (random.coin()) eye[axis] = target[axis];
      ray = ray_towards<T>(eye, target, random);
      if (!ray) break;
      const T least = std::numeric_limits<T>::denorm_min();
      const T tiny = static_cast<T>(random.whole(1, 9999)) * least * (random.coin() ? T(1) : T(-1));
      if (random.coin()) ray->direction[axis] = tiny;
      if (random.coin()) ray->origin[random.coin() ? axis : (axis + 1) % 3] = tiny;
      break;
    }
  }
  if (!ray || ray->direction == Vec3<T>(0) || !is_finite(ray->direction) || !is_finite(ray->origin))
    return std::nullopt;
  if (B::placed && stratum == Stratum::translations) ray = brought_back(*ray, centre);
  return Case<S, T>{shape, *ray};
}

}  // namespace raywalk::check
