#pragma once
// What each statement of trace/tracer.h does, except for the preparation of a hit (trace/tracer_shading.h). Included by
// it alone.

#include "math/inlining.h"
#include "trace/describe.h"
#include "trace/representable.h"
#include "trace/shadow_transmittance.h"
#include "trace/tracer.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace raywalk {

namespace detail {

/// Always inlined: otherwise that would depend on the rest of the kernel.
[[nodiscard, RAYWALK_INLINE_WHOLE]] inline std::uint64_t path_of_child(std::uint64_t parent, RayKind kind) {
  return child_path(parent, static_cast<std::uint32_t>(kind));
}

}  // namespace detail

template <class Policy>
void Tracer<Policy>::begin(const Pixel& pixel) {
  if constexpr (draws) key_ = camera_.key(pixel, Effect::penumbra);
  if constexpr (Policy::faulty) before_pixel_.rays = rays_formed_;
  note(Line::for_each_pixel, 0, [&] { return PixelBegun{pixel.column, pixel.row, pixel.sample}; });
}

template <class Policy>
template <class FromEye>
inline auto Tracer<Policy>::form_primary_ray(FromEye& from_eye, const Pixel& pixel) -> TreeRay {
  TreeRay primary{Ray{from_eye.form(pixel, statistics_)}, RayKind::primary, Rgb<T>(1), rays_formed_++};
  if constexpr (Policy::effects.nesting) {
    if (nested_.any_around_eye()) primary.in.medium = nested_.at_eye(primary.ray, statistics_.tests);
  }
  ++statistics_.formed(RayKind::primary);
  note(Line::form_primary_ray, 0, [&] {
    return RayFormed{primary.number, -1, RayKind::primary, Vec3d(primary.ray.origin), Vec3d(primary.ray.direction),
                     Rgbd(1.0)};
  });
  return primary;
}

template <class Policy>
template <class FromEye>
auto Tracer<Policy>::find_closest(FromEye& from_eye, const TreeRay& primary) -> Nearest {
  const Nearest nearest = from_eye.closest(primary.ray, statistics_);
  end(Line::find_closest_intersection, 0, primary, nearest);
  return nearest;
}

template <class Policy>
auto Tracer<Policy>::find_closest(Line line, int depth, const TreeRay& ray) -> Nearest {
  Faultable<Ray> sought = ray.ray;
  if constexpr (Policy::faulty)
    sought.near_root_only = world_.fault == Fault::second_root_dropped && line == Line::find_refract_intersect;
  const Nearest nearest = world_.accelerator.closest(sought, infinity<T>, statistics_.tests);
  end(line, depth, ray, nearest);
  return nearest;
}

template <class Policy>
inline void Tracer<Policy>::end(Line line, int depth, const TreeRay& ray, const Nearest& nearest) {
  ++statistics_.ends(nearest ? Ending::hit : Ending::missed);
  note(line, depth, [&] {
    return nearest ? detail::describe(ray.number, Ending::hit, world_, ray.ray, *nearest)
                   : detail::describe_missed(ray.number, Ending::missed, world_, ray.ray);
  });
}

template <class Policy>
bool Tracer<Policy>::decide_intersected(const Nearest& nearest) {
  note(Line::if_intersect_something, 0, [&] { return Decided{nearest.has_value()}; });
  return nearest.has_value();
}

template <class Policy>
int Tracer<Policy>::call_shade(Line line, int depth, const TreeRay& ray, const Nearest& nearest) {
  constexpr int unasked = 4;  // levels: a tree so small is soon done
  if (depth >= unasked) check_stop();
  int called = depth + 1;
  inject<Policy>(world_, Fault::depth_not_counted, [&] {
    if (line == Line::shade_reflect) called = depth;
  });
  note(line, depth, [&] { return ShadeCalled{ray.number, !nearest, called, Rgbd(background_of(ray, nearest))}; });
  return called;
}

/// Whether the recursion has to be stopped although DEPTH is not counted.
template <class Policy>
bool Tracer<Policy>::runs_away(const TreeRay& parent) const {
  if constexpr (Policy::faulty) {
    constexpr int max_generations = 40, max_rays = 500;  // of a pixel
    if (world_.fault == Fault::depth_not_counted)
      return parent.generation.number >= max_generations || rays_formed_ - before_pixel_.rays >= max_rays;
  }
  return false;
}

/// The medium of a ray spawned at the hit.
template <class Policy>
inline auto Tracer<Policy>::medium_on_side(const ShadingPoint& at, const TreeRay& ray, bool refracted)
    -> const Medium* {
  if constexpr (Policy::effects.nesting) {
    if (at.surface->nests) return refracted ? at.behind.medium : ray.in.medium;
  }
  return medium_after(*at.surface, at.entering, refracted, ray.in.medium);
}

template <class Policy>
template <class Put>
void Tracer<Policy>::put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put) {
  if (!is_representable(final)) ++statistics_.not_finite;
  put(pixel, final);
  note(Line::put_final_shade, 0, [&] { return PixelPut{pixel.column, pixel.row, pixel.sample, Rgbd(final)}; });
}

template <class Policy>
inline auto Tracer<Policy>::form_shadow_ray(int depth, const ShadingPoint& at, const TreeRay& ray, const Light& light,
                                            int sample) -> std::optional<Shadow> {
  // Towards a point light the direction is not normalised: the light is at t = 1.
  Vec3<T> to_light = light.direction_to(light_point(at, ray, light, sample), at.position);
  inject<Policy>(world_, Fault::shadow_ray_misaimed, [&] {
    if (!light.is_distant) to_light += at.position;
  });
  const bool before =
      dot(at.shading_normal, to_light) > 0 && (!at.smoothed || dot(at.geometric_normal(), to_light) > 0);
  const bool faces = before || at.surface->lit_from_behind;
  if (!faces || !light.shines_along(to_light)) {
    const Ending why = faces ? Ending::outside_cone : Ending::facing_away;
    ++statistics_.ends(why);
    note(Line::form_shadow_ray, depth, [&] {
      return RayNotFormed{ray.number,      RayKind::shadow,      why,         Vec3d(at.position),
                          Vec3d(to_light), Rgbd(ray.throughput), light.index, sample};
    });
    return std::nullopt;
  }
  Shadow shadow{spawn_ray<Ray>(world_, at.position, at.geometric_normal(), at.departure, to_light, ray.ray.time),
                Policy::occludes(world_) ? rays_formed_++ : 0};
  if (!Policy::occludes(world_)) return shadow;  // the way to the light, along which nothing is looked for
  if constexpr (Policy::effects.refraction) shadow.in.medium = medium_on_side(at, ray, false);
  inject<Policy>(world_, Fault::epsilon_too_small, [&] { shadow.ray.origin = at.position; });
  ++statistics_.formed(RayKind::shadow);
  note(Line::form_shadow_ray, depth, [&] {
    RayFormed event{shadow.number,   ray.number,           RayKind::shadow, Vec3d(shadow.ray.origin),
                    Vec3d(to_light), Rgbd(ray.throughput), light.index,     !light.is_distant};
    event.light_sample = sample;
    return event;
  });
  return shadow;
}

/// The visibility of the light: 0 behind an opaque object.
template <class Policy>
inline auto Tracer<Policy>::find_intersection(int depth, const Shadow& shadow, const Light& light) -> Rgb<T> {
  if (!Policy::occludes(world_)) return Rgb<T>(1);
  const T t_max = light.t_far();
  const Medium* medium = nullptr;
  if constexpr (Policy::effects.refraction) medium = shadow.in.medium;
  const std::optional<Rgb<T>> transmittance =
      shadow_transmittance(world_, shadow.ray, t_max, statistics_.tests, filters_met_, hints_, medium);
  ++statistics_.ends(transmittance ? Ending::reached_light : Ending::blocked);
  note(Line::find_intersection, depth, [&] {
    // Shown up to the nearest blocker, whichever was found first; this search is only for the observer.
    const Nearest blocker = transmittance ? std::nullopt : first_blocker(world_, shadow.ray, t_max);
    Found found = blocker ? detail::describe(shadow.number, Ending::blocked, world_, shadow.ray, *blocker)
                          : Found{shadow.number, Ending::reached_light};
    found.transmittance = Rgbd(transmittance.value_or(Rgb<T>(0)));
    return found;
  });
  return transmittance.value_or(Rgb<T>(0));
}

template <class Policy>
void Tracer<Policy>::add_unlit(DirectLighting& direct, const Light& light) {
  if constexpr (Observer::watches) direct.add(light, Rgb<T>(0), Rgb<T>(0));
}

template <class Policy>
inline void Tracer<Policy>::add_light(DirectLighting& direct, const ShadingPoint& at, const TreeRay& ray,
                                      const Light& light, const Ray& shadow, const Rgb<T>& visible) {
  if (is_black(visible)) return add_unlit(direct, light);
  const T distance = light.distance(shadow.direction);
  T attenuation = light.attenuation(distance);
  inject<Policy>(world_, Fault::attenuation_forgotten, [&] { attenuation = 1; });
  Rgb<T> radiance = visible * light.strength;
  if (attenuation != 1) radiance *= 1 / attenuation;
  const Vec3<T> l = shadow.direction * (1 / distance);
  if (!light.is_isotropic) radiance *= light.falloff(l);
  if constexpr (Policy::effects.penumbra) radiance *= light.sample_weight;
  const T n_l = std::max(dot(at.shading_normal, l), T(0));  // below 0 only where lights behind may show
  Rgb<T> specular{0};
  if (!is_black(at.values().specular)) {
    // Blinn's half vector, between the light and the origin of this ray.
    const Vec3<T> h = l - ray.ray.direction;
    specular =
        radiance * at.values().specular * power_of_cosine(dot(at.shading_normal, h), dot(h, h), at.values().shininess);
  }
  if constexpr (Policy::effects.microfacets) {
    if (at.facets.mirror || at.facets.glass) {
      const FacetValue shown = evaluate_facets(at, ray, l);
      specular += pi_v<T> * radiance * shown.weight * shown.value;
    }
    if (at.facets.matt) {
      const Rgb<T> sent = at.facets.matt->value(at.diffuse(), at.shading_normal, -ray.ray.direction, l);
      return direct.add(light, radiance * sent * n_l, specular);
    }
  }
  direct.add(light, radiance * at.diffuse() * n_l, specular);
}

template <class Policy>
bool Tracer<Policy>::decide_reflective(int depth, const ShadingPoint& at) {
  const bool holds = !is_black(at.reflection());
  note(Line::if_reflective, depth, [&] { return Decided{holds, Rgbd(at.reflection())}; });
  return holds;
}

template <class Policy>
bool Tracer<Policy>::decide_transparent(int depth, const ShadingPoint& at) {
  const bool holds = !is_black(at.transmission());
  bool total = at.surface->transmits && at.refraction.total();
  if constexpr (Policy::effects.microfacets) total = total && !holds;  // some facets let it through
  if (total) ++statistics_.ends(Ending::total_internal_reflection);
  note(Line::if_transparent, depth, [&] {
    Decided event{holds, Rgbd(at.transmission())};
    if (total) event.why = Ending::total_internal_reflection, event.snell = snell_numbers(at.refraction);
    return event;
  });
  return holds;
}

template <class Policy>
auto Tracer<Policy>::form_reflect_ray(int depth, ShadedPoint& at, const TreeRay& ray) -> std::optional<TreeRay> {
  Vec3<T> direction = renormalize(reflect(ray.ray.direction, at.shading_normal));
  inject<Policy>(world_, Fault::reflection_flipped, [&] {
    const Vec3<T>& incident = ray.ray.direction;
    direction = normalize(incident + 2 * dot(incident, at.shading_normal) * at.shading_normal);
  });
  return form_secondary_ray(Line::form_reflect_ray, depth, at, ray, RayKind::reflect, direction, at.reflection(), [&] {
    if constexpr (Policy::effects.microfacets)
      if (draws_facet(at, RayKind::reflect)) return sample_facet(at, ray, RayKind::reflect);
    return sample_cone(ray, direction, at.values().gloss, at.geometric_normal(), Effect::gloss);
  });
}

template <class Policy>
auto Tracer<Policy>::form_refract_ray(int depth, ShadedPoint& seen, const TreeRay& ray) -> std::optional<TreeRay> {
  Faultable<ShadingPoint> at = seen;
  if constexpr (Policy::faulty) {
    if (world_.fault == Fault::refraction_inverted) {
      at.refraction = refraction_at(ray.ray.direction, at.shading_normal, at.refraction.n2, at.refraction.n1);
      // Where the inverted law has no solution, the ray continues straight on.
      if (at.refraction.total()) at.refraction = refraction_at(ray.ray.direction, at.shading_normal, T(1), T(1));
    }
  }
  if constexpr (Policy::effects.microfacets) {
    if (draws_facet(seen, RayKind::refract)) {
      if constexpr (Policy::faulty) seen.refraction = at.refraction;
      const auto sharp = refract(ray.ray.direction, seen.shading_normal, seen.refraction);
      return form_secondary_ray(Line::form_refract_ray, depth, seen, ray, RayKind::refract,
                                renormalize(sharp.value_or(ray.ray.direction)), seen.transmission(),
                                [&] { return sample_facet(seen, ray, RayKind::refract); });
    }
  }
  // decide_transparent saw a weight, so the refraction is not total and the direction exists.
  Vec3<T> direction = renormalize(*refract(ray.ray.direction, at.shading_normal, at.refraction));
  if (at.smoothed && !(dot(direction, at.geometric_normal()) < 0))  // the interpolated normal would send it back out
    direction =
        renormalize(refract(ray.ray.direction, at.geometric_normal(),
                            refraction_at(ray.ray.direction, at.geometric_normal(), at.refraction.n1, at.refraction.n2))
                        .value_or(ray.ray.direction));
  return form_secondary_ray(
      Line::form_refract_ray, depth, at, ray, RayKind::refract, direction, at.transmission(), [&] {
        return sample_cone(ray, direction, at.values().translucency, -at.geometric_normal(), Effect::translucency);
      });
}

/// Both limits are tested before the ray is formed, and before random numbers are drawn for it: `sharp` is the axis of
/// its lobe.
template <class Policy>
template <class Draw>
inline auto Tracer<Policy>::form_secondary_ray(Line line, int depth, const ShadingPoint& at, const TreeRay& parent,
                                               RayKind kind, const Vec3<T>& sharp, const Rgb<T>& weight,
                                               Draw draw_direction) -> std::optional<TreeRay> {
  const auto weighed = [&] {
    return (at.transmittance ? parent.throughput * *at.transmittance : parent.throughput) * weight;
  };
  Rgb<T> throughput = weighed();
  const bool too_deep = depth + 1 > world_.depth || runs_away(parent);
  const auto not_formed = [&](Ending why) {
    ++statistics_.ends(why);
    note(line, depth,
         [&] { return RayNotFormed{parent.number, kind, why, Vec3d(at.position), Vec3d(sharp), Rgbd(throughput)}; });
    return std::nullopt;
  };
  if (too_deep || max_component(throughput) < world_.threshold)
    return not_formed(too_deep ? Ending::depth : Ending::threshold);
  const Vec3<T> direction = draw_direction();
  if constexpr (Policy::effects.microfacets) {
    if (draws_facet(at, kind)) {
      throughput = weighed();
      if (is_black(weight)) return not_formed(Ending::wrong_side);
    }
  }
  TreeRay formed(spawn_ray<Ray>(world_, at.position, at.geometric_normal(), at.departure, direction, parent.ray.time),
                 kind, throughput, rays_formed_++);
  inject<Policy>(world_, Fault::epsilon_wrong_side, [&] {
    if (kind == RayKind::reflect) formed.ray.origin = at.position - (formed.ray.origin - at.position);
  });
  if constexpr (draws) formed.branch.path = detail::path_of_child(parent.branch.path, kind);
  if constexpr (Policy::faulty) formed.generation.number = parent.generation.number + 1;
  if constexpr (Policy::effects.refraction) formed.in.medium = medium_on_side(at, parent, kind == RayKind::refract);
  if constexpr (carries_differentials) {
    if (world_.filters()) formed.neighbours.differential = differential_after(at, parent, kind, direction);
  }
  ++statistics_.formed(kind);
  note(line, depth, [&] {
    RayFormed event{formed.number, parent.number, kind, Vec3d(formed.ray.origin), Vec3d(direction), Rgbd(throughput)};
    if (kind == RayKind::refract) event.snell = snell_numbers(at.refraction);
    if constexpr (Policy::effects.microfacets)
      if (kind == RayKind::refract && draws_facet(at, kind))
        event.snell = snell_at_facet(*at.facets.glass, at.refraction, parent.ray.direction, direction);
    return event;
  });
  return formed;
}

/// Of a ray spawned at the hit, into a lobe's axis or, where the lobe is rough, about it.
template <class Policy>
auto Tracer<Policy>::differential_after(const ShadingPoint& at, const TreeRay& ray, RayKind kind,
                                        const Vec3<T>& direction) const -> RayDifferential<T> {
  const RayDifferential<T>& arrived = at.neighbours.differential;
  const Vec3<T>&D = ray.ray.direction, &N = at.shading_normal;
  const SurfacePoint<T> point{at.position, at.entering ? at.geometric_normal() : -at.geometric_normal()};
  const NormalDifferential<T> normal =
      normal_differential(hit_differential(arrived), world_.accelerator.primitives(), at.departure.primitive, point,
                          at.departure.part, ray.ray.time, N);
  const bool reflects = kind == RayKind::reflect;
  RayDifferential<T> sharp = arrived;
  if (reflects)
    sharp = reflect(arrived, D, N, normal);
  else if (!at.refraction.total())  // some facets let it through
    sharp = refract(arrived, D, N, normal, at.refraction);
  if constexpr (Policy::effects.microfacets)
    if (draws_facet(at, kind))
      return scattered(sharp, direction, evaluate_facets(at, ray, direction).pdf, camera_.spacing());
  const T rough = reflects ? at.values().gloss : at.values().translucency;
  return rough > 0 ? scattered(sharp, direction, uniform_cone_pdf(rough), camera_.spacing()) : sharp;
}

template <class Policy>
auto Tracer<Policy>::compute_rtnshade(int depth, const ShadingPoint& at, const DirectLighting& direct,
                                      const Rgb<T>& reflected, const Rgb<T>& refracted) -> Rgb<T> {
  Rgb<T> ambient = at.ambient() * world_.ambient;
  [[maybe_unused]] std::optional<Rgbd> irradiance;
  if constexpr (Policy::effects.bounced) {
    if (bounced_.light != nullptr) {
      irradiance =
          bounced_.light->irradiance_at(at.departure.primitive, Vec3d(at.position), Vec3d(at.geometric_normal()));
      ambient = at.diffuse() * Rgb<T>(*irradiance * (1 / pi_v<double>));
    }
  }
  Rgb<T> total = ambient + at.values().emission + direct.sum + reflected + refracted;
  if (Policy::effects.refraction && at.transmittance) total *= *at.transmittance;
  if constexpr (Observer::watches)
    note(Line::compute_rtnshade, depth, [&] {
      return ShadeComputed{Rgbd(ambient),
                           Rgbd(at.values().emission),
                           direct.terms,
                           Rgbd(reflected),
                           Rgbd(refracted),
                           Rgbd(total),
                           Rgbd(at.transmittance.value_or(Rgb<T>(1))),
                           irradiance};
    });
  return total;
}

}  // namespace raywalk
