#pragma once
// What the statements of trace/pencils.h do that are not the tracer's. Included by it alone.

#include "trace/pencils.h"

namespace raywalk {

namespace detail {

template <class AnyRay>
[[nodiscard]] bool is_in_plan(const AnyRay& ray) {
  return ray.origin.z == 0 && ray.direction.z == 0;
}

/// Whether a ray leaves as the surface itself sends it: not by an interpolated normal or a relief, nor drawn at random.
[[nodiscard]] inline bool leaves_as(const Vec3d& direction, const std::optional<Vec3d>& sent) {
  constexpr double rounding = 1e-5;  // of 24 bits
  return sent && length(normalize(direction) - normalize(*sent)) < rounding;
}

}  // namespace detail

template <class Policy>
auto PencilTracer<Policy>::form_pencil(const Pixel& pixel) -> Pencil {
  Pencil primary{this->form_primary_ray(pixel), std::nullopt};
  if (detail::is_in_plan(primary.axis.ray)) primary.M = PencilSystem{};
  return primary;
}

template <class Policy>
auto PencilTracer<Policy>::transfer(int depth, const Pencil& pencil, const Hit<T>& hit) -> std::optional<PencilSystem> {
  PencilChanged changed{pencil.axis.number, {}};
  if (pencil.M) {
    changed.along = static_cast<double>(hit.t) * length(Vec3d(pencil.axis.ray.direction));
    changed.before = *pencil.M, changed.by = transferred(changed.along);
    changed.system = changed.by * changed.before;
  }
  note(Line::transfer_pencil, depth, [&] { return changed; });
  return changed.system;
}

template <class Policy>
auto PencilTracer<Policy>::surface_at(const TreeRay& axis, const Hit<T>& hit) const -> PencilSurface {
  const auto& primitives = this->world_.accelerator.primitives();
  const SurfacePoint<T> point = primitives.surface_at(hit.primitive, axis.ray, Intersection<T>{hit.t, hit.part});
  return pencil_surface(primitives, hit.primitive, hit.part, point, axis.ray.time,
                        normalize(Vec3d(axis.ray.direction)));
}

template <class Policy>
auto PencilTracer<Policy>::reflect_pencil(int depth, const std::optional<PencilSystem>& M, const TreeRay& axis,
                                          const Hit<T>& hit, const TreeRay& mirrored) -> Pencil {
  PencilChanged changed{mirrored.number, {}};
  if (M && detail::is_in_plan(mirrored.ray)) {
    const PencilSurface surface = surface_at(axis, hit);
    const Vec3d sent = reflect(normalize(Vec3d(axis.ray.direction)), surface.normal);
    if (detail::leaves_as(Vec3d(mirrored.ray.direction), sent)) {
      changed.curvature = surface.curvature, changed.cos_in = surface.cos_in;
      changed.before = *M, changed.by = mirrored_by(surface);
      changed.system = changed.by * changed.before;
    }
  }
  note(Line::reflect_pencil, depth, [&] { return changed; });
  return {mirrored, changed.system};
}

template <class Policy>
auto PencilTracer<Policy>::refract_pencil(int depth, const std::optional<PencilSystem>& M, const TreeRay& axis,
                                          const Hit<T>& hit, const Refraction<T>& at, const TreeRay& refracted)
    -> Pencil {
  PencilChanged changed{refracted.number, {}};
  if (M && detail::is_in_plan(refracted.ray)) {
    const PencilSurface surface = surface_at(axis, hit);
    const Vec3d along = normalize(Vec3d(axis.ray.direction));
    const auto exact = refraction_at(along, surface.normal, static_cast<double>(at.n1), static_cast<double>(at.n2));
    if (detail::leaves_as(Vec3d(refracted.ray.direction), refract(along, surface.normal, exact))) {
      changed.snell = snell_numbers(exact);
      changed.curvature = surface.curvature, changed.cos_in = surface.cos_in;
      changed.before = *M, changed.by = refracted_by(surface, exact.n1, exact.n2, exact.cos_out);
      changed.system = changed.by * changed.before;
    }
  }
  note(Line::refract_pencil, depth, [&] { return changed; });
  return {refracted, changed.system};
}

}  // namespace raywalk
