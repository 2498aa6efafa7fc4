#pragma once
// What SHADE needs to know of a hit, and how it is prepared. Properties of the surface are not copied, only what
// differs from them here: for most hits nothing. Included by trace/tracer.h alone.

#include "trace/shadow_transmittance.h"
#include "trace/surface_pattern.h"
#include "trace/tracer.h"

#include <optional>
#include <type_traits>

namespace raywalk {

namespace detail {

struct NoTerms {};

}  // namespace detail

template <class Policy>
struct Tracer<Policy>::ShadingPoint {
  /// The weights of the reflect and the refract ray.
  struct Weights {
    Rgb<T> reflection, transmission;
  };
  /// What the surface consists of that is of metal or rough; null: it is smooth.
  struct Facets {
    const Microsurface<T>* mirror = nullptr;
    const RoughDielectric<T>* glass = nullptr;
    const RoughDiffuse<T>* matt = nullptr;
  };
  /// The same where maps make it lie between two roughnesses: the rougher ones, and their share.
  struct RougherFacets {
    const Microsurface<T>* mirror = nullptr;
    const RoughDielectric<T>* glass = nullptr;
    T share = 0;  ///< 0: there are none
  };
  /// The factor of a checker or texture on the surface's colours.
  struct Tint {
    Rgb<T> colour{1};
  };
  /// The surface's own numbers, where maps make them others; with its pattern in ka and kd.
  struct Mapped {
    std::optional<MappedValues<T>> values;
  };

  /// As the surface has it; patterns, media and refraction change it.
  ShadingPoint(const Hit<T>& hit, const Vec3<T>& its_position, const Vec3<T>& its_normal, const Surface& its_surface,
               bool is_entering)
      : departure{hit.primitive, hit.part},
        position(its_position),
        shading_normal(its_normal),
        surface(&its_surface),
        entering(is_entering) {}

  /// The geometric normal, on the side the ray came from: what lies behind it is behind the surface.
  [[nodiscard]] const Vec3<T>& geometric_normal() const {
    return distinct_geometric_normal ? *distinct_geometric_normal : shading_normal;
  }
  /// What the surface is like here, but for its pattern.
  [[nodiscard]] const SurfaceValues<T>& values() const {
    if constexpr (Policy::effects.maps)
      if (mapped.values) return *mapped.values;
    return *surface;
  }
  [[nodiscard]] Rgb<T> ambient() const { return coloured(values().ambient); }
  [[nodiscard]] Rgb<T> diffuse() const { return coloured(values().diffuse); }
  [[nodiscard]] const Rgb<T>& reflection() const { return weights ? weights->reflection : values().reflection; }
  [[nodiscard]] const Rgb<T>& transmission() const { return weights ? weights->transmission : values().transmission; }

  Departure departure;  ///< of the rays spawned here
  Vec3<T> position;
  Vec3<T> shading_normal;  ///< unit length, on the side the ray came from unless the material's is fixed
  const Surface* surface;
  bool entering;                                     ///< the ray comes from outside
  bool smoothed = false;                             ///< the shading normal is interpolated
  std::optional<Vec3<T>> distinct_geometric_normal;  ///< where it differs from the shading normal
  std::optional<Weights> weights;                    ///< kr' and kt', where they are not the surface's kr and kt
  Refraction<T> refraction;                          ///< only set where the surface transmits
  [[no_unique_address]] Only<Policy::effects.nesting, InMedium> behind{};  ///< of a transmitting surface
  std::optional<Rgb<T>> transmittance;  ///< of the absorbing object that the ray passed through
  [[no_unique_address]] Only<Policy::effects.textures, Tint> tint{};
  [[no_unique_address]] Only<carries_differentials, Neighbours> neighbours{};
  [[no_unique_address]] Only<Policy::effects.microfacets, Facets> facets{};
  [[no_unique_address]] Only<Policy::effects.maps, RougherFacets> rougher{};
  [[no_unique_address]] Only<Policy::effects.maps, Mapped> mapped{};
  [[no_unique_address]] Only<Policy::effects.penumbra, RandomPairs> light_pairs{};  ///< sample points on lights, where
                                                                                    ///< drawn

 private:
  [[nodiscard]] Rgb<T> coloured(const Rgb<T>& own) const {
    if constexpr (Policy::effects.textures)
      return own * tint.colour;
    else
      return own;
  }
};

template <class Policy>
struct Tracer<Policy>::DirectLighting {
  Rgb<T> sum{0};
  [[no_unique_address]] std::conditional_t<Observer::watches, std::vector<LightTerm>, detail::NoTerms> terms;

  void add(const Light& light, const Rgb<T>& diffuse, const Rgb<T>& specular) {
    sum += diffuse + specular;
    if constexpr (Observer::watches) {
      if (terms.empty() || terms.back().light != light.index) terms.push_back({light.index});
      terms.back().diffuse += Rgbd(diffuse);
      terms.back().specular += Rgbd(specular);
    }
  }
};

template <class Policy>
inline auto Tracer<Policy>::prepare(const TreeRay& ray, const Hit<T>& hit) -> ShadingPoint {
  const Primitives<T>& primitives = world_.accelerator.primitives();
  const Surface& surface = world_.surface(hit.primitive);
  const SurfacePoint<T> point = primitives.surface_at(hit.primitive, ray.ray, Intersection<T>{hit.t, hit.part});
  const bool entering = dot(point.normal, ray.ray.direction) <= 0;  // 0: a tangent ray counts as outside
  const Vec3<T> geometric_normal = entering ? point.normal : -point.normal;
  ShadingPoint at(hit, point.position, geometric_normal, surface, entering);
  if (surface.fixed_normal) {
    at.shading_normal = primitives.given_normal(hit.primitive, point, ray.ray.time).value_or(point.normal);
    at.distinct_geometric_normal = geometric_normal;
  } else if (const auto smooth = primitives.smooth_normal(hit.primitive, point, ray.ray.time)) {
    at.shading_normal = consistent_shading_normal(ray.ray.direction, geometric_normal, entering ? *smooth : -*smooth);
    at.distinct_geometric_normal = geometric_normal;
    at.smoothed = true;
  }
  [[maybe_unused]] const SurfaceMaps<T>* maps = nullptr;
  if constexpr (Policy::effects.maps) {
    maps = world_.maps(surface);
    if (maps != nullptr && maps->bends()) {
      const auto smooth = primitives.smooth_normal(hit.primitive, point, ray.ray.time);
      const Vec3<T> bent =
          maps->bent(primitives, hit.primitive, point, hit.part, ray.ray.time, smooth.value_or(point.normal));
      at.shading_normal = clamped_shading_normal(ray.ray.direction, geometric_normal, entering ? bent : -bent);
      at.distinct_geometric_normal = geometric_normal;
      at.smoothed = true;
    }
  }
  if constexpr (Policy::effects.penumbra) at.light_pairs = RandomPairs(light_key(ray));
  [[maybe_unused]] bool filtered = false;
  if constexpr (Policy::effects.filtering) {
    filtered = Policy::effects.textures && world_.filters(surface);
    if (filtered || (carries_differentials && world_.filters())) {
      const Vec3<T>& D = ray.ray.direction;
      RayDifferential<T> arrived;
      if constexpr (carries_differentials) {
        arrived = ray.kind == RayKind::primary ? camera_.differential_at_hit(D, hit.t, point.normal)
                                               : transfer(ray.neighbours.differential, D, hit.t, point.normal);
        at.neighbours.differential = arrived;
      } else {
        arrived = camera_.differential_at_hit(D, hit.t, point.normal);
      }
      if constexpr (Policy::effects.textures)
        if (filtered) at.tint.colour = filtered_pattern(world_, hit_differential(arrived), hit, point, ray.ray.time);
    }
  }
  if constexpr (Policy::effects.textures) {
    if (!filtered) apply_pattern(at.tint.colour, surface, primitives, hit.primitive, point, hit.part, ray.ray.time);
  }
  if constexpr (Policy::effects.maps) {
    if (maps != nullptr) {
      auto mixture = maps->at(primitives.uv_at(hit.primitive, point, hit.part, ray.ray.time));
      if constexpr (Policy::effects.textures) {
        mixture.first.ambient *= at.tint.colour;
        mixture.first.diffuse *= at.tint.colour;
        at.tint.colour = Rgb<T>(1);
      }
      at.mapped.values = maps->mixed(mixture);
    }
  }
  if constexpr (Policy::effects.refraction) {
    at.transmittance = transmittance_to_hit(ray.in.medium, surface, entering, hit.t);
    if (surface.transmits) {
      T n1 = entering ? T(1) : surface.ior, n2 = entering ? surface.ior : T(1);
      if constexpr (Policy::effects.nesting) {
        if (surface.nests) {
          const auto sides = nested_.across(ray.ray, hit, at.position, entering, ray.in.medium, statistics_.tests);
          if (sides.before != ray.in.medium)
            at.transmittance = transmittance_to_hit(sides.before, surface, entering, hit.t);
          at.behind.medium = sides.beyond;
          n1 = nested_.index(sides.before), n2 = nested_.index(sides.beyond);
        }
      }
      at.refraction = refraction_at(ray.ray.direction, at.shading_normal, n1, n2);
      if (at.refraction.total() || surface.dielectric) {
        const Rgb<T> both = at.values().reflection + at.values().transmission;
        const T reflected = at.refraction.fresnel();
        at.weights = {reflected * both, (1 - reflected) * both};
      }
    }
  }
  if constexpr (Policy::effects.microfacets) {
    at.facets = {world_.microsurface(surface), nullptr, world_.rough_diffuse(surface)};
    [[maybe_unused]] MappedFacets<T> here;
    if constexpr (Policy::effects.maps) {
      if (maps != nullptr) {
        here = maps->facets(*at.mapped.values, surface.transmits ? &at.refraction : nullptr);
        at.facets = {here.mirror, nullptr, maps->matt(*at.mapped.values)};
        at.rougher = {here.rougher, here.rougher_glass, here.share};
      }
    }
    if (at.facets.mirror) {
      const T cos = std::clamp(-dot(ray.ray.direction, at.shading_normal), T(0), T(1));
      at.weights = {at.facets.mirror->reflectance(cos) * at.values().reflection, at.values().transmission};
    }
    if (surface.transmits) {
      const Refraction<T>& through = at.refraction;
      at.facets.glass = maps == nullptr ? world_.rough_dielectric(surface, through.n1, through.n2) : here.glass;
      if (at.facets.glass && world_.draws) {
        const Rgb<T> both = at.values().reflection + at.values().transmission;
        const auto side = at.facets.glass->side_of(through.n1);
        T reflected = at.facets.glass->reflectance(side, through.cos_in);
        if constexpr (Policy::effects.maps)
          if (here.rougher_glass)
            reflected += here.share * (here.rougher_glass->reflectance(side, through.cos_in) - reflected);
        at.weights = {reflected * both, (1 - reflected) * both};
      }
    }
  }
  return at;
}

}  // namespace raywalk
