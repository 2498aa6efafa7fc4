#pragma once
// What beams and cones do alike with a part, which is shaded in one place for all of it. Included by them alone.

#include "trace/event.h"
#include "trace/optics.h"
#include "trace/spawn_ray.h"
#include "trace/surface_vertex.h"
#include "trace/world.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace raywalk::detail {

/// By object: the first of its primitives; -1 for none.
template <class T>
[[nodiscard]] std::vector<int> first_primitives(const World<T>& world) {
  std::vector<int> first;
  const auto add = [&](int id) {
    const auto object = static_cast<std::size_t>(world.object(id));
    if (object >= first.size()) first.resize(object + 1, -1);
    if (first[object] < 0) first[object] = id;
  };
  if (world.ranges.empty())
    for (int id = 0; id < world.accelerator.primitives().size(); ++id) add(id);
  for (const auto& range : world.ranges)
    if (range.first < world.accelerator.primitives().size()) add(range.first);  // the last may be an empty mesh
  return first;
}

/// The ray in the middle of a part, as `prepare_vertex` takes it.
template <class T>
struct MiddleOfPart {
  Ray<T> ray;
  int number;
  const typename World<T>::Medium* medium;
  int length = 1;
  Rgb<T> throughput{1};
};

/// Tells an observer where in its middle a part is shaded, and with which normals.
template <class Vertex>
void tell_of(BeamPiece& piece, const Vertex& at) {
  piece.point = Vec3d(at.position);
  piece.normal = Vec3d(at.outward_normal);
  piece.shaded = hit_normals(at.bsdf.shading_normal, at.bsdf.geometric_normal);
}

/// The pattern of a part, which may be the mean of a checker's squares.
template <class T>
struct PatternOfPart {
  const World<T>& world;
  bool has_mean;

  [[nodiscard]] bool filters(const typename World<T>::Surface& /*surface*/) const { return has_mean; }
  void arrive(const Vec3<T>& /*direction*/, const Hit<T>& /*hit*/, const SurfacePoint<T>& /*point*/, T /*time*/,
              const Vec3<T>& /*shading_normal*/) {}
  [[nodiscard]] Rgb<T> pattern(const Hit<T>& hit, const SurfacePoint<T>& /*point*/, T /*time*/) const {
    const auto& checker = *world.surface(hit.primitive).checker;
    return (checker.even + checker.odd) / T(2);
  }
};

/// The limit that keeps what is as wide as a part, or a ray from its middle, from being followed.
template <class T>
[[nodiscard]] std::optional<Ending> why_not_followed(const World<T>& world, int depth, const Rgb<T>& throughput) {
  if (depth + 1 > world.depth) return Ending::depth;
  if (max_component(throughput) < world.threshold) return Ending::threshold;
  return std::nullopt;
}

/// The lights that a part is asked of.
template <class T, class Part>
[[nodiscard]] const std::vector<typename World<T>::Light>& lights_on(const World<T>& world, const Part& part) {
  static const std::vector<typename World<T>::Light> none;
  return part.at && world.effects.used(Effect::shadows) ? world.lights : none;
}

/// Whether a light is as wide as it is, and casts a penumbra.
template <class T>
[[nodiscard]] bool has_extent(const World<T>& world, const typename World<T>::Light& light) {
  return !light.is_delta && !light.is_distant && world.effects.used(Effect::penumbra);
}

/// Whether light from a direction falls on the side of a place that is seen, or shows through. `to_light`: of any
/// length.
template <class T, bool with_maps>
[[nodiscard]] bool receives(const SurfaceVertex<T, true, with_maps>& at, const Vec3<T>& to_light) {
  return dot(at.bsdf.shading_normal, to_light) > 0 || at.surface->lit_from_behind;
}

/// Why nothing of a light comes to a place from a direction, whatever stands between.
template <class T, bool with_maps>
[[nodiscard]] std::optional<Ending> why_unlit(const SurfaceVertex<T, true, with_maps>& at,
                                              const typename World<T>::Light& light, const Vec3<T>& to_light) {
  if (!receives(at, to_light)) return Ending::facing_away;
  if (!light.shines_along(to_light)) return Ending::outside_cone;
  return std::nullopt;
}

template <class T>
struct PartLight {
  Rgb<T> diffuse{0}, specular{0};
};

/// What a light brings to the middle of a part, whose ray is `ray`. `to_light`: not of unit length; `arriving`: how
/// much of the light is not held up on its way. `facets`: small ones, that show their highlight, if there are any.
template <class T, bool with_maps>
[[nodiscard]] PartLight<T> light_on(const SurfaceVertex<T, true, with_maps>& at, const Ray<T>& ray,
                                    const typename World<T>::Light& light, const Vec3<T>& to_light,
                                    const Rgb<T>& arriving, const std::optional<Bsdf<T, true, with_maps>>& facets) {
  const T distance = light.distance(to_light);
  const Vec3<T> l = to_light / distance, h = l - ray.direction;
  const Rgb<T> radiance = arriving * light.strength * (light.falloff(l) / light.attenuation(distance));
  const T cos = std::max(dot(at.bsdf.shading_normal, l), T(0));
  PartLight<T> brought{radiance * at.bsdf.diffuse * cos};
  if (at.bsdf.matt != nullptr) brought.diffuse = radiance * at.bsdf.diffuse_answer(l, cos);
  if (!is_black(at.specular))
    brought.specular =
        radiance * at.specular * power_of_cosine(dot(at.bsdf.shading_normal, h), dot(h, h), at.values().shininess);
  if (facets) brought.specular += radiance * facets->highlight_of_facets(l);
  return brought;
}

/// Of points all over a light, without random numbers, those that a part sees.
template <class T>
struct LightPoints {
  std::vector<Vec3<T>> to;  ///< from the part's middle; as `light_on` takes it
  int all = 1;              ///< that stand for the light, each for an equal share

  [[nodiscard]] double share() const { return static_cast<double>(to.size()) / all; }
};

template <class T, bool with_maps>
[[nodiscard]] PartLight<T> light_on(const SurfaceVertex<T, true, with_maps>& at, const Ray<T>& ray,
                                    const typename World<T>::Light& light, const LightPoints<T>& points,
                                    const Rgb<T>& arriving, const std::optional<Bsdf<T, true, with_maps>>& facets) {
  PartLight<T> sum;
  const Rgb<T> of_each = arriving / static_cast<T>(points.all);
  for (const Vec3<T>& to_light : points.to) {
    const PartLight<T> brought = light_on(at, ray, light, to_light, of_each, facets);
    sum.diffuse += brought.diffuse, sum.specular += brought.specular;
  }
  return sum;
}

/// How many points along each side of a light with an extent: so many that their highlights run together. `side`: of
/// the light as it is seen, in radians; `slope`: of `facets_at`.
template <class T, bool with_maps>
[[nodiscard]] int points_along_light(const SurfaceVertex<T, true, with_maps>& at, T slope, double side) {
  constexpr double few = 4, many = 24;
  // Of a highlight, as a standard deviation of half the angle between lights that show it in the same place; where
  // there is none, so that lights that are as near as they are wide are right to 2%.
  double width = 0.05;
  if (!is_black(at.specular)) width = std::min(width, 1 / std::sqrt(static_cast<double>(at.values().shininess)));
  if (slope > 0) width = std::min(width, static_cast<double>(slope) / std::numbers::sqrt2);
  return static_cast<int>(std::clamp(std::ceil(side / (2 * width)), few, many));
}

/// Small facets of a surface, although nothing is drawn of them: `slope`, their roughness, 0 for none; and the BSDF
/// with them, which shows their highlight. None of glass that bends nothing.
template <class T, bool with_maps>
struct PartFacets {
  T slope = 0;
  std::optional<Bsdf<T, true, with_maps>> shown;
};
template <class T, bool with_maps>
[[nodiscard]] PartFacets<T, with_maps> facets_at(const World<T>& world, const SurfaceVertex<T, true, with_maps>& at) {
  if (world.microsurfaces.empty()) return {};
  SurfaceVertex<T, true, with_maps> shown = at;
  if constexpr (with_maps) {
    if (at.mapped) {
      const T slope = at.mapped->roughness;
      shown.bsdf.mirror = at.mapped->reflection;
      take_facets(shown, true, *world.maps(*at.surface));
      return {slope, slope > 0 ? std::optional(shown.bsdf) : std::nullopt};
    }
  }
  const Microsurface<T>& own = world.microsurfaces[static_cast<std::size_t>(at.surface - world.surfaces.data())];
  const T slope = own.facets ? own.facets->alpha() : own.glass;
  if (!(slope > 0)) return {};
  if (own.facets) {
    shown.bsdf.facets = &own;
    shown.bsdf.mirror = at.surface->reflection;
  } else if (const auto* glass = world.rough_dielectric(*at.surface, at.refraction.n1, at.refraction.n2)) {
    shown.bsdf.take_glass(*glass, at.refraction.n1, at.refraction.cos_in,
                          at.surface->reflection + at.surface->transmission);
  } else {
    return {slope, std::nullopt};
  }
  return {slope, shown.bsdf};
}
/// The small mirrors of `facets_at`, where rough glass is taken as clear.
template <class T, bool with_maps>
[[nodiscard]] PartFacets<T, with_maps> mirrors_at(const World<T>& world, const SurfaceVertex<T, true, with_maps>& at) {
  auto facets = facets_at(world, at);
  if (facets.shown && facets.shown->glass == nullptr) return facets;
  return {};
}

/// Whether a surface shows lights, and so their shadows: what it has everywhere, without maps.
template <class T>
[[nodiscard]] bool shows_lights(const World<T>& world, const typename World<T>::Surface& surface) {
  const Microsurface<T>* own = world.microsurface(surface);
  return !is_black(surface.diffuse) || !is_black(surface.specular) || (own != nullptr && own->facets);
}

/// Of a light as it is seen along `l`, of unit length: of a disc of its area, in a flat world half its width; 0 of a
/// point.
template <class T>
[[nodiscard]] double radius_of_light(const typename World<T>::Light& light, const Vec3d& l, bool flat) {
  return flat ? light.half_extent(Vec3d(-l.y, l.x, 0)) : light.seen_radius(l);
}

/// What the middle of a part sends back but for what it reflects and transmits.
template <class T>
struct MiddleShade {
  Rgb<T> ambient{0}, emission{0}, total{0};
};

/// `direct`: what lights bring.
template <class T, class Part>
[[nodiscard]] MiddleShade<T> shade_of_middle(const World<T>& world, const Part& part, const Rgb<T>& direct) {
  MiddleShade<T> shade;
  if (part.at) {
    shade.ambient = part.ambient * world.ambient;
    shade.emission = part.at->values().emission;
    shade.total = shade.ambient + shade.emission + direct;
  } else {
    shade.total = world.background_along(part.ray.direction);
  }
  return shade;
}

/// How much of the light from a reflected or refracted ray a surface sends on.
template <class T, bool with_maps>
[[nodiscard]] const Rgb<T>& weight_of(const SurfaceVertex<T, true, with_maps>& at, RayKind kind) {
  return kind == RayKind::refract ? at.bsdf.transparent : at.bsdf.mirror;
}

/// The single ray that a surface sends out as a mirror or as glass, and what it goes through.
template <class T>
struct SentRay {
  Ray<T> ray;
  const typename World<T>::Medium* medium;
};

template <class T>
[[nodiscard]] SentRay<T> sent_ray(const World<T>& world, const SurfaceVertex<T>& at, RayKind kind) {
  const bool refracts = kind == RayKind::refract;
  return {spawn_ray<Ray<T>>(world, at.position, at.bsdf.geometric_normal, at.departure,
                            refracts ? at.bsdf.transparent_axis : at.bsdf.mirror_axis, at.time),
          refracts ? at.behind : at.medium};
}

/// What single rays from a place of a part bring, as that in its middle does. `sends(kind)`: whether it has one;
/// `tracer`: follows them.
template <class T, class Tracer, class Sends>
[[nodiscard]] Rgb<T> brought_by_rays(const World<T>& world, Tracer& tracer, int depth, const SurfaceVertex<T>& at,
                                     const Sends& sends) {
  Rgb<T> brought{0};
  for (const RayKind kind : {RayKind::reflect, RayKind::refract}) {
    if (!sends(kind) || why_not_followed(world, depth, Rgb<T>(1))) continue;
    const auto [sent, medium] = sent_ray(world, at, kind);
    brought += weight_of(at, kind) * tracer.radiance_along(sent, depth + 1, medium);
  }
  return brought;
}

}  // namespace raywalk::detail
