#pragma once
// What an observer is told of what a ray meets: only then are its numbers gathered.

#include "trace/event.h"
#include "trace/optics.h"
#include "trace/world.h"

#include <optional>

namespace raywalk::detail {

/// Keeps the numbers of one intersection test for an event.
struct Explanation {
  static constexpr bool wanted = true;
  IntersectionNumbers numbers;
  void quadratic(double a, double b, double c, double discriminant, double t0, double t1) {
    numbers = QuadraticNumbers{a, b, c, discriminant, t0, t1};
  }
  void plane(double numerator, double denominator) { numbers = PlaneNumbers{numerator, denominator}; }
};

/// With which normals a hit of a ray of unit length is shaded, as `prepare` (trace/tracer_shading.h) and
/// `prepare_vertex` (trace/surface_vertex.h) choose them thereafter.
template <class T, class AnyRay>
[[nodiscard]] HitNormals hit_normals_of(const World<T>& world, const AnyRay& ray, const Hit<T>& hit,
                                        const SurfacePoint<T>& point) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  const auto& surface = world.surface(hit.primitive);
  const Vec3<T> D(ray.direction);
  const bool entering = dot(point.normal, D) <= 0;
  const auto towards_ray = [&](const Vec3<T>& outward) { return entering ? outward : -outward; };
  const Vec3<T> geometric = towards_ray(point.normal);
  const auto smooth = primitives.smooth_normal(hit.primitive, point, ray.time);
  if (const SurfaceMaps<T>* maps = world.maps(surface); maps != nullptr && maps->bends()) {
    const Vec3<T> bent =
        maps->bent(primitives, hit.primitive, point, hit.part, ray.time, smooth.value_or(point.normal));
    return hit_normals(clamped_shading_normal(D, geometric, towards_ray(bent)), geometric);
  }
  if (surface.fixed_normal)
    return hit_normals(primitives.given_normal(hit.primitive, point, ray.time).value_or(point.normal), geometric);
  return hit_normals(smooth ? consistent_shading_normal(D, geometric, towards_ray(*smooth)) : geometric, geometric);
}

/// Describes a hit for an event. What ends a shadow ray is not shaded.
template <class T, class AnyRay>
Found describe(int ray_number, Ending ending, const World<T>& world, const AnyRay& ray, const Hit<T>& hit) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  const SurfacePoint<T> point = primitives.surface_at(hit.primitive, ray, Intersection<T>{hit.t, hit.part});
  Explanation explanation;
  static_cast<void>(primitives.intersect(hit.primitive, ray, infinity<T>, explanation));
  const auto& surface = world.surface(hit.primitive);
  const auto smooth = surface.fixed_normal ? primitives.given_normal(hit.primitive, point, ray.time)
                                           : primitives.smooth_normal(hit.primitive, point, ray.time);
  Vec3<T> normal = smooth.value_or(point.normal);
  if (const SurfaceMaps<T>* maps = world.maps(surface); maps != nullptr && maps->bends())
    normal = maps->bent(primitives, hit.primitive, point, hit.part, ray.time, normal);
  const typename World<T>::Piece piece = world.piece(hit.primitive);
  return {ray_number,
          ending,
          static_cast<double>(hit.t),
          world.object(hit.primitive),
          hit.part,
          Vec3d(point.position),
          Vec3d(normal),
          Rgbd(1.0),
          explanation.numbers,
          piece.triangle,
          piece.member,
          ending == Ending::hit ? hit_normals_of(world, ray, hit, point) : HitNormals{}};
}

/// Describes that nothing was hit.
template <class T, class AnyRay>
Found describe_missed(int ray_number, Ending ending, const World<T>& world, const AnyRay& ray) {
  Found found{ray_number, ending};
  if (!world.sky) return found;
  const Vec3d direction(ray.direction);
  const SkyLight::Place place = world.sky->place(direction);
  found.numbers = SkyNumbers{place.elevation, place.azimuth, world.sky->pdf(direction), world.sky->radiance(direction)};
  return found;
}

}  // namespace raywalk::detail
