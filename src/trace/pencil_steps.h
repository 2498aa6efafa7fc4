#pragma once
// What the statements of trace/pencils.h do that are not the tracer's. Included by it alone.

#include "trace/pencils.h"

namespace raywalk {

namespace detail {

/// Whether a ray leaves as the surface itself sends it: not by an interpolated normal or a relief, nor drawn at random.
[[nodiscard]] inline bool leaves_as(const Vec3d& direction, const std::optional<Vec3d>& sent) {
  constexpr double rounding = 1e-5;  // of 24 bits
  return sent && length(normalize(direction) - normalize(*sent)) < rounding;
}

}  // namespace detail

template <class Policy>
auto PencilTracer<Policy>::form_pencil(const Pixel& pixel) -> Pencil {
  return {this->form_primary_ray(this->primary_rays_, pixel), PencilSystem{}};
}

template <class Policy>
auto PencilTracer<Policy>::transfer(int depth, const Pencil& pencil, const Hit<T>& hit) -> std::optional<PencilSystem> {
  PencilChanged changed{pencil.axis.number};
  if (pencil.M) {
    changed.along = static_cast<double>(hit.t) * length(Vec3d(pencil.axis.ray.direction));
    changed.system = transferred(changed.along) * *pencil.M;
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
  PencilChanged changed{mirrored.number};
  if (M) {
    const PencilSurface surface = surface_at(axis, hit);
    if (detail::leaves_as(Vec3d(mirrored.ray.direction), reflect(surface.axis, surface.normal))) {
      changed.curvature = surface.curvature, changed.cos_in = surface.cos_in;
      changed.system = mirrored_by(surface) * *M;
    }
  }
  note(Line::reflect_pencil, depth, [&] { return changed; });
  return {mirrored, changed.system};
}

template <class Policy>
auto PencilTracer<Policy>::refract_pencil(int depth, const std::optional<PencilSystem>& M, const TreeRay& axis,
                                          const Hit<T>& hit, const Refraction<T>& at, const TreeRay& refracted)
    -> Pencil {
  PencilChanged changed{refracted.number};
  if (M) {
    const PencilSurface surface = surface_at(axis, hit);
    const auto exact =
        refraction_at(surface.axis, surface.normal, static_cast<double>(at.n1), static_cast<double>(at.n2));
    if (detail::leaves_as(Vec3d(refracted.ray.direction), refract(surface.axis, surface.normal, exact))) {
      changed.snell = snell_numbers(exact);
      changed.curvature = surface.curvature, changed.cos_in = surface.cos_in;
      changed.system = refracted_by(surface, exact.n1, exact.n2, exact.cos_out) * *M;
    }
  }
  note(Line::refract_pencil, depth, [&] { return changed; });
  return {refracted, changed.system};
}

}  // namespace raywalk
