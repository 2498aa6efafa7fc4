#pragma once
// What SHADE needs to know of a hit, and how it is made ready. What the surface says is not copied, only what differs
// from it here: most hits have none of that. Included by trace/tracer.h alone.

#include "trace/passage.h"
#include "trace/tracer.h"

#include <optional>
#include <type_traits>

namespace raywalk {

namespace detail {

struct Nothing {};

}  // namespace detail

template <class Policy>
struct Tracer<Policy>::Shading {
  /// What a mirrored and a transmitted ray count.
  struct Weights {
    Rgb<T> reflection, transmission;
  };
  /// What a pattern makes of the surface's colours.
  struct Tint {
    Rgb<T> colour{1};
  };

  /// As the surface says; a pattern, a medium and refraction change it.
  Shading(const Hit<T>& hit, const Vec3<T>& its_position, const Vec3<T>& its_normal, const Surface& its_surface,
          bool is_entering)
      : departure{hit.primitive, hit.part},
        position(its_position),
        normal(its_normal),
        surface(&its_surface),
        entering(is_entering) {}

  /// The surface's own normal, not smoothed, on the side the ray came from: what lies behind it is behind the surface.
  [[nodiscard]] const Vec3<T>& side() const { return other_side ? *other_side : normal; }
  [[nodiscard]] Rgb<T> ambient() const { return coloured(surface->ambient); }
  [[nodiscard]] Rgb<T> diffuse() const { return coloured(surface->diffuse); }
  [[nodiscard]] const Rgb<T>& reflection() const { return weights ? weights->reflection : surface->reflection; }
  [[nodiscard]] const Rgb<T>& transmission() const { return weights ? weights->transmission : surface->transmission; }

  Departure departure;  ///< of the rays that leave from here
  Vec3<T> position;
  Vec3<T> normal;  ///< unit length, on the side the ray came from unless the surface keeps its own
  const Surface* surface;
  bool entering;                      ///< the ray comes from outside
  bool smoothed = false;              ///< the normal is
  std::optional<Vec3<T>> other_side;  ///< `side`, where it is not the normal
  std::optional<Weights> weights;     ///< kr' and kt', where they are not the surface's kr and kt
  Refraction<T> refraction;           ///< where the surface transmits; else not set
  [[no_unique_address]] Only<Policy::effects.nesting, InMedium> behind{};  ///< a surface that transmits
  std::optional<Rgb<T>> passed;  ///< what the ray's way through an object that absorbs leaves
  [[no_unique_address]] Only<Policy::effects.textures, Tint> tint{};
  [[no_unique_address]] Only<Policy::effects.penumbra, RandomPairs> light_pairs{};  ///< places on lights, where drawn

 private:
  [[nodiscard]] Rgb<T> coloured(const Rgb<T>& own) const {
    if constexpr (Policy::effects.textures)
      return own * tint.colour;
    else
      return own;
  }
};

template <class Policy>
struct Tracer<Policy>::Direct {
  Rgb<T> sum{0};
  [[no_unique_address]] std::conditional_t<Observer::watches, std::vector<LightTerm>, detail::Nothing> terms;

  void add(const Lamp& lamp, const Rgb<T>& diffuse, const Rgb<T>& specular) {
    sum += diffuse + specular;
    if constexpr (Observer::watches) {
      if (terms.empty() || terms.back().light != lamp.index) terms.push_back({lamp.index});
      terms.back().diffuse += Rgbd(diffuse);
      terms.back().specular += Rgbd(specular);
    }
  }
};

template <class Policy>
inline auto Tracer<Policy>::prepare(const Traced& ray, const Hit<T>& hit) -> Shading {
  const Primitives<T>& primitives = world_.accelerator.primitives();
  const Surface& surface = world_.surface(hit.primitive);
  const SurfacePoint<T> point = primitives.surface_at(hit.primitive, ray.ray, Crossing<T>{hit.t, hit.part});
  const bool entering = dot(point.normal, ray.ray.direction) <= 0;  // 0: a tangent ray, which touches from outside
  const Vec3<T> side = entering ? point.normal : -point.normal;
  Shading at(hit, point.position, side, surface, entering);
  if (surface.fixed_normal) {
    at.normal = primitives.given_normal(hit.primitive, point, ray.ray.time).value_or(point.normal);
    at.other_side = side;
  } else if (const auto smooth = primitives.smooth_normal(hit.primitive, point, ray.ray.time)) {
    at.normal = smooth_normal_towards(ray.ray.direction, side, entering ? *smooth : -*smooth);
    at.other_side = side;
    at.smoothed = true;
  }
  if constexpr (Policy::effects.penumbra) at.light_pairs = RandomPairs(light_key(ray));
  if constexpr (Policy::effects.textures) {
    if (surface.checker) {
      const bool even =
          even_square(primitives.uv_at(hit.primitive, point, hit.part, ray.ray.time), surface.checker->size);
      at.tint.colour = even ? surface.checker->even : surface.checker->odd;
    }
    if (surface.picture)
      at.tint.colour *= surface.picture->at(primitives.uv_at(hit.primitive, point, hit.part, ray.ray.time));
  }
  if constexpr (Policy::effects.refraction) {
    at.passed = left_on_way(ray.in.medium, surface, entering, hit.t);
    if (surface.transmits) {
      T n1 = entering ? T(1) : surface.ior, n2 = entering ? surface.ior : T(1);
      if constexpr (Policy::effects.nesting) {
        if (surface.nests) {
          const auto sides = nested_.across(ray.ray, hit, at.position, entering, ray.in.medium, statistics_.tests);
          if (sides.before != ray.in.medium) at.passed = left_on_way(sides.before, surface, entering, hit.t);
          at.behind.medium = sides.beyond;
          n1 = nested_.index(sides.before), n2 = nested_.index(sides.beyond);
        }
      }
      at.refraction = refraction_at(ray.ray.direction, at.normal, n1, n2);
      if (at.refraction.total() || surface.dielectric) {
        const Rgb<T> both = surface.reflection + surface.transmission;
        const T reflected = at.refraction.fresnel();
        at.weights = {reflected * both, (1 - reflected) * both};
      }
    }
  }
  return at;
}

}  // namespace raywalk
