#pragma once
// Pencil tracing: M. Shinya, T. Takahashi and S. Naito, "Principles and Applications of Pencil Tracing", SIGGRAPH 1987.
// A pencil is a ray, its axis, with a matrix M that says what becomes of the rays beside it (trace/pencil.h): of one
// that leaves EYE beside the axis, or at an angle to it, how far beside it is now, and at which angle. Each transfer,
// mirror and refraction is a matrix of its own, by which M is multiplied. Where M makes rays that come from one point
// meet in another the pencil folds: a focus, and of light a caustic.
//
// The axis is followed and shaded as the tracer does (trace/tracer.h), by the same functions, so that shades are those
// of `whitted`, bit for bit. M changes no shade and is there for an observer: without one, pictures are the tracer's.
// It is followed while the axis stays in the plan, where 2 x 2 numbers do, and the same across it.
//
// `main_algorithm` and `shade_pencil` read like trace/pseudocode.h, and a test holds them together; what their own
// statements do is in trace/pencil_steps.h.

#include "trace/pencil.h"
#include "trace/tracer.h"

namespace raywalk {

template <class Policy>
class PencilTracer : Tracer<Policy> {
  using Base = Tracer<Policy>;
  using typename Base::DirectLighting, typename Base::Light, typename Base::Nearest, typename Base::ShadedPoint,
      typename Base::TreeRay;

 public:
  using Base::Base, Base::statistics;
  using typename Base::Observer, typename Base::T;

  /// PENCIL TRACING. `pixels` yields Pixel; `put(pixel, shade)` receives each final shade.
  template <class Pixels, class Put>
  void main_algorithm(const Pixels& pixels, Put&& put) {
    // For each pixel
    for (const Pixel& pixel : pixels) {
      begin(pixel);
      // Form pencil of the pixel: M = 1
      const Pencil primary = form_pencil(pixel);
      // Find intersection of its axis
      const Nearest nearest = find_closest(Line::find_closest_intersection, 0, primary.axis);
      Rgb<T> final = background_of(primary.axis, nearest);
      // If intersect something
      if (decide_intersected(nearest)) {
        // Shade pencil (DEPTH+1, final)
        const int depth = call_shade(Line::shade_final, 0, primary.axis, nearest);
        final = shade_pencil(depth, primary, *nearest);
      }
      // Put final shade in pixel
      put_in_pixel(pixel, final, put);
    }
  }

 private:
  struct Pencil {
    TreeRay axis;
    std::optional<PencilSystem> M;  ///< none once the axis has left otherwise than as a surface sends it
  };

  /// SHADE PENCIL (DEPTH, RTNSHADE): the light that leaves the hit against the axis' direction.
  Rgb<T> shade_pencil(int depth, const Pencil& pencil, const Hit<T>& hit) {
    ShadedPoint at = prepare(pencil.axis, hit);
    // Transfer: M = T M
    const std::optional<PencilSystem> M = transfer(depth, pencil, hit);
    DirectLighting direct;
    for (const Light& light : this->world_.lights) {
      set_shadow_hints(at, light);
      for (int sample = 0; sample < samples_of(light); ++sample) {
        // Form shadow ray
        const auto shadow = form_shadow_ray(depth, at, pencil.axis, light, sample);
        if (!shadow) {
          add_unlit(direct, light);
          continue;
        }
        // Find intersection
        const Rgb<T> visible = find_intersection(depth, *shadow, light);
        add_light(direct, at, pencil.axis, light, shadow->ray, visible);
      }
    }
    Rgb<T> reflected{0}, refracted{0};
    // If reflective
    if (decide_reflective(depth, at)) {
      // Form reflected axis
      if (const auto axis = form_reflect_ray(depth, at, pencil.axis)) {
        // Reflect: M = R M
        const Pencil mirrored = reflect_pencil(depth, M, pencil.axis, hit, *axis);
        // Find intersection of its axis
        const Nearest nearest = find_closest(Line::find_reflect_intersect, depth, mirrored.axis);
        // Shade pencil (DEPTH+1, REFLSHADE)
        const int deeper = call_shade(Line::shade_reflect, depth, mirrored.axis, nearest);
        reflected =
            at.reflection() * (nearest ? shade_pencil(deeper, mirrored, *nearest) : background_along(mirrored.axis));
      }
    }
    // If transparent
    if (decide_transparent(depth, at)) {
      // Form refracted axis
      if (const auto axis = form_refract_ray(depth, at, pencil.axis)) {
        // Refract: M = S M
        const Pencil bent = refract_pencil(depth, M, pencil.axis, hit, at.refraction, *axis);
        // Find intersection of its axis
        const Nearest nearest = find_closest(Line::find_refract_intersect, depth, bent.axis);
        // Shade pencil (DEPTH+1, REFRSHADE)
        const int deeper = call_shade(Line::shade_refract, depth, bent.axis, nearest);
        refracted = at.transmission() * (nearest ? shade_pencil(deeper, bent, *nearest) : background_along(bent.axis));
      }
    }
    // Compute rtnshade
    return compute_rtnshade(depth, at, direct, reflected, refracted);
  }

  // The tracer's.
  using Base::add_light, Base::add_unlit, Base::background_along, Base::background_of, Base::begin, Base::call_shade,
      Base::compute_rtnshade, Base::decide_intersected, Base::decide_reflective, Base::decide_transparent,
      Base::find_closest, Base::find_intersection, Base::form_reflect_ray, Base::form_refract_ray,
      Base::form_shadow_ray, Base::note, Base::prepare, Base::put_in_pixel, Base::samples_of, Base::set_shadow_hints;

  Pencil form_pencil(const Pixel& pixel);
  std::optional<PencilSystem> transfer(int depth, const Pencil& pencil, const Hit<T>& hit);
  Pencil reflect_pencil(int depth, const std::optional<PencilSystem>& M, const TreeRay& axis, const Hit<T>& hit,
                        const TreeRay& mirrored);
  Pencil refract_pencil(int depth, const std::optional<PencilSystem>& M, const TreeRay& axis, const Hit<T>& hit,
                        const Refraction<T>& at, const TreeRay& refracted);
  [[nodiscard]] PencilSurface surface_at(const TreeRay& axis, const Hit<T>& hit) const;
};

}  // namespace raywalk

#include "trace/pencil_steps.h"
