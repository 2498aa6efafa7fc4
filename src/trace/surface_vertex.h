#pragma once
// A surface that light arrives at, made ready: where it is, how it scatters, what is on both of its sides.

#include "math/inlining.h"
#include "trace/bsdf.h"
#include "trace/media.h"
#include "trace/policy.h"
#include "trace/statistics.h"
#include "trace/surface_pattern.h"

#include <algorithm>
#include <optional>

namespace raywalk {

namespace detail {
/// The most that Russian roulette lets survive at a surface, so that each path ends some time.
inline constexpr double surest = 0.95;
}  // namespace detail

namespace detail {

/// The effect that a lobe's direction is drawn for.
[[nodiscard]] constexpr Effect effect_of(Lobe lobe, bool by_facets) {
  switch (lobe) {
    case Lobe::diffuse:
    case Lobe::highlight:
      break;
    case Lobe::phase:
      return Effect::scattering;
    case Lobe::mirror:
      return by_facets ? Effect::microfacets : Effect::gloss;
    case Lobe::transparent:
      return by_facets ? Effect::microfacets : Effect::translucency;
  }
  return Effect::indirect_light;
}

}  // namespace detail

/// A surface's own numbers at a vertex, where maps make them others.
template <class T>
struct MappedVertex {
  std::optional<MappedValues<T>> mapped;  ///< with its pattern in ka and kd
};
struct UnmappedVertex {};

/// A vertex of a path from the eye or of a photon's way from a light. `with_facets`, `with_maps`: see Bsdf.
template <class T, bool with_facets = true, bool with_maps = true>
struct SurfaceVertex : std::conditional_t<with_maps, MappedVertex<T>, UnmappedVertex> {
  using Surface = typename World<T>::Surface;
  using Medium = typename World<T>::Medium;
  Departure departure;  ///< of the rays spawned here
  Vec3<T> position;
  Vec3<T> outward_normal;  ///< unit normal
  bool entering;
  T time;
  const Surface* surface;
  int number;            ///< of the ray that led here
  int length;            ///< number of rays of the path up to here
  const Medium* medium;  ///< on the side the ray came from, if known
  const Medium* behind;  ///< behind it
  /// The factor with which light that leaves here against the ray contributes to the pixel; of a photon, its power.
  Rgb<T> throughput;
  Rgb<T> specular;           ///< ks, for the lights' highlights
  Refraction<T> refraction;  ///< only set where the surface transmits
  Bsdf<T, with_facets, with_facets && with_maps> bsdf;

  /// What the surface is like here.
  [[nodiscard]] const SurfaceValues<T>& values() const {
    if constexpr (with_maps)
      if (this->mapped) return *this->mapped;
    return *surface;
  }
};

/// What the surface sends back along the path of a lamp's light from `l`, of unit length: kd cos and ks (n.h)^s, and
/// what small mirrors have of it. `behind` rough glass, what that transmits.
template <class T, bool with_facets, bool with_maps>
[[nodiscard, RAYWALK_INLINE]] inline Rgb<T> answers_to_light(const SurfaceVertex<T, with_facets, with_maps>& at,
                                                             const Vec3<T>& l, bool behind) {
  const auto& bsdf = at.bsdf;
  Rgb<T> answers = behind ? Rgb<T>(0) : bsdf.diffuse_answer(l, dot(bsdf.shading_normal, l));
  if (!behind && !is_black(at.specular)) {
    const Vec3<T> h = l - bsdf.incident;
    const T n_h = std::max(dot(bsdf.shading_normal, h) / length(h), T(0));
    answers += at.specular * power(n_h, bsdf.shininess);
  }
  if constexpr (with_facets) answers += bsdf.highlight_of_facets(l);
  return answers;
}

/// Of a ray that goes on beyond the surface; of rough glass at the facet that turns it there, if one does.
template <class T, bool with_facets, bool with_maps>
[[nodiscard]] std::optional<SnellNumbers> snell_numbers(const SurfaceVertex<T, with_facets, with_maps>& at,
                                                        const Vec3<T>& direction) {
  if constexpr (with_facets)
    if (at.bsdf.glass != nullptr) return snell_at_facet(*at.bsdf.glass, at.refraction, at.bsdf.incident, direction);
  return snell_numbers(at.refraction);
}

/// A clear refracted ray that an interpolated or bent normal would send back out goes as the surface itself bends it.
template <class T, bool with_facets, bool with_maps>
void keep_below(Bsdf<T, with_facets, with_maps>& bsdf, const Refraction<T>& at) {
  if (is_black(bsdf.transparent) || dot(bsdf.transparent_axis, bsdf.geometric_normal) < 0) return;
  const auto own = refraction_at(bsdf.incident, bsdf.geometric_normal, at.n1, at.n2);
  bsdf.transparent_axis = renormalize(refract(bsdf.incident, bsdf.geometric_normal, own).value_or(bsdf.incident));
}

/// What a vertex of a mapped surface has of metal, of small facets and of roughness.
template <class T>
void take_facets(SurfaceVertex<T>& at, bool draws, const SurfaceMaps<T>& maps) {
  auto& bsdf = at.bsdf;
  bsdf.matt = maps.matt(*at.mapped);
  const MappedFacets<T> here = maps.facets(*at.mapped, at.surface->transmits ? &at.refraction : nullptr);
  if (here.glass != nullptr && draws) {
    bsdf.take_glass(*here.glass, at.refraction.n1, at.refraction.cos_in,
                    at.mapped->reflection + at.mapped->transmission);
    if (here.rougher_glass != nullptr) bsdf.mix_glass(*here.rougher_glass, here.share, at.refraction.cos_in);
  }
  if (here.mirror == nullptr || is_black(bsdf.mirror)) return;
  if (here.mirror->facets && draws) {
    bsdf.facets = here.mirror;
    bsdf.rougher = here.rougher;
    bsdf.rougher_share = here.share;
  } else {
    bsdf.mirror *= here.mirror->reflectance(std::clamp(-dot(bsdf.incident, bsdf.shading_normal), T(0), T(1)));
  }
}

/// `AnyRay`: a ray with its number, length, throughput and medium. `nested`: the media where bodies nest.
/// `differential`: the ray's, which is transferred to the hit (trace/pattern_filter.h).
template <class Policy, class T, class AnyRay, class Nested, class Differential>
auto prepare_vertex(const World<T>& world, [[maybe_unused]] Nested& nested, const AnyRay& ray, const Hit<T>& hit,
                    [[maybe_unused]] Statistics& statistics, Differential& differential)
    -> SurfaceVertex<T, Policy::effects.microfacets, Policy::effects.maps> {
  using Surface = typename World<T>::Surface;
  using Medium = typename World<T>::Medium;
  const Primitives<T>& primitives = world.accelerator.primitives();
  const Surface& surface = world.surface(hit.primitive);
  const SurfacePoint<T> point = primitives.surface_at(hit.primitive, ray.ray, Intersection<T>{hit.t, hit.part});
  SurfaceVertex<T, Policy::effects.microfacets, Policy::effects.maps> at;
  at.departure = {hit.primitive, hit.part};
  at.position = point.position;
  at.outward_normal = point.normal;
  at.entering = dot(point.normal, ray.ray.direction) <= 0;
  at.time = ray.ray.time;
  at.surface = &surface;
  at.number = ray.number;
  at.length = ray.length;
  at.throughput = ray.throughput;
  const Medium* through = ray.medium;
  at.medium = medium_after(surface, at.entering, false, ray.medium);
  at.behind = medium_after(surface, at.entering, true, ray.medium);
  if constexpr (Policy::effects.nesting) {
    if (surface.nests) at.medium = at.behind = ray.medium;
    if (surface.nests && surface.transmits) {
      const auto sides = nested.across(ray.ray, hit, at.position, at.entering, ray.medium, statistics.tests);
      through = sides.before;
      at.behind = sides.beyond;
    }
  }
  if (const auto left = transmittance_to_hit(through, surface, at.entering, hit.t)) at.throughput *= *left;
  auto& bsdf = at.bsdf;
  bsdf.incident = ray.ray.direction;
  bsdf.shading_normal = bsdf.geometric_normal = at.entering ? point.normal : -point.normal;
  if (const auto smooth = primitives.smooth_normal(hit.primitive, point, at.time))
    bsdf.shading_normal =
        consistent_shading_normal(ray.ray.direction, bsdf.geometric_normal, at.entering ? *smooth : -*smooth);
  [[maybe_unused]] const SurfaceMaps<T>* maps = nullptr;
  const SurfaceValues<T>* its = &surface;
  if constexpr (Policy::effects.maps) {
    maps = world.maps(surface);
    if (maps != nullptr && maps->bends()) {
      const auto smooth = primitives.smooth_normal(hit.primitive, point, at.time);
      const Vec3<T> bent =
          maps->bent(primitives, hit.primitive, point, hit.part, at.time, smooth.value_or(point.normal));
      bsdf.shading_normal =
          clamped_shading_normal(ray.ray.direction, bsdf.geometric_normal, at.entering ? bent : -bent);
    }
  }
  differential.arrive(ray.ray.direction, hit, point, at.time, bsdf.shading_normal);
  if constexpr (Policy::effects.maps) {
    if (maps != nullptr) {
      auto mixture = maps->at(primitives.uv_at(hit.primitive, point, hit.part, at.time));
      for (Rgb<T>* colour : {&mixture.first.ambient, &mixture.first.diffuse}) {
        if (differential.filters(surface))
          *colour *= differential.pattern(hit, point, at.time);
        else
          apply_pattern(*colour, surface, primitives, hit.primitive, point, hit.part, at.time);
      }
      its = &at.mapped.emplace(maps->mixed(mixture));
    }
  }
  bsdf.diffuse = its->diffuse;
  if (maps == nullptr) {
    if (differential.filters(surface))
      bsdf.diffuse *= differential.pattern(hit, point, at.time);
    else
      apply_pattern(bsdf.diffuse, surface, primitives, hit.primitive, point, hit.part, at.time);
  }
  if constexpr (Policy::effects.microfacets) bsdf.matt = world.rough_diffuse(surface);
  at.specular = its->specular;
  if (!is_black(its->specular)) {
    bsdf.shininess = its->shininess;
    bsdf.highlight = highlight_scale(its->shininess) * its->specular;
  }
  bsdf.mirror = its->reflection;
  if (surface.transmits) {
    T n1 = at.entering ? T(1) : surface.ior, n2 = at.entering ? surface.ior : T(1);
    if constexpr (Policy::effects.nesting) {
      if (surface.nests) n1 = nested.index(through), n2 = nested.index(at.behind);
    }
    at.refraction = refraction_at(ray.ray.direction, bsdf.shading_normal, n1, n2);
    const Rgb<T> both = its->reflection + its->transmission;
    if (at.refraction.total()) {
      bsdf.mirror = both;
    } else {
      bsdf.transparent = its->transmission;
      if (surface.dielectric) {
        const T reflected = at.refraction.fresnel();
        bsdf.transparent = (1 - reflected) * both;
        bsdf.mirror = reflected * both;
      }
      bsdf.transparent_axis = renormalize(*refract(ray.ray.direction, bsdf.shading_normal, at.refraction));
      bsdf.transparent_width = its->translucency;
    }
    if constexpr (Policy::effects.microfacets) {
      if (const RoughDielectric<T>* glass = maps == nullptr ? world.rough_dielectric(surface, n1, n2) : nullptr;
          glass != nullptr && world.draws)
        bsdf.take_glass(*glass, n1, at.refraction.cos_in, both);
    }
    if (bsdf.shading_normal != bsdf.geometric_normal) keep_below(bsdf, at.refraction);
  }
  if (!is_black(bsdf.mirror)) {
    bsdf.mirror_axis = renormalize(reflect(ray.ray.direction, bsdf.shading_normal));
    bsdf.mirror_width = its->gloss;
    if constexpr (Policy::effects.microfacets) {
      if (const Microsurface<T>* own = maps == nullptr ? world.microsurface(surface) : nullptr) {
        if (own->facets && world.draws)
          bsdf.facets = own;
        else
          bsdf.mirror *= own->reflectance(std::clamp(-dot(ray.ray.direction, bsdf.shading_normal), T(0), T(1)));
      }
    }
  }
  if constexpr (Policy::effects.maps && Policy::effects.microfacets)
    if (maps != nullptr) take_facets(at, world.draws, *maps);
  bsdf.prepare(at.throughput);
  return at;
}

}  // namespace raywalk
