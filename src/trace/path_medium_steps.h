#pragma once
// What the statements of trace/path.h do inside of bodies that scatter light (trace/medium_walk.h). Included by it
// alone, and compiled where a scene calls for it.

#include "trace/path_steps.h"

#include <algorithm>

namespace raywalk {

namespace detail {

/// The random dimensions of Effect::scattering at the end of a ray. Pairs use two.
struct MediumDimension {
  static constexpr std::uint32_t channel = 0, distance = 1, direction = 2;
};

/// A primitive of the body that a medium is in; -1 if none.
template <class T>
[[nodiscard]] int primitive_of(const World<T>& world, const typename World<T>::Medium* medium) {
  for (int id = 0; id < world.accelerator.primitives().own_size(); ++id) {
    if (!world.surface(id).scatters()) continue;
    if (world.bodies.empty() ? medium == &world.surface(id)
                             : NestedMedia<T>::bodies_in(medium).back() == world.bodies.of_primitive(id))
      return id;
  }
  return -1;
}

}  // namespace detail

/// How far the path would go inside of the body that it is in, if that scatters.
template <class Policy>
auto PathTracer<Policy>::draw_free_path(const PathRay& ray) -> Free {
  if constexpr (media) {
    if (ray.medium == nullptr || !ray.medium->scatters()) return {};
    if constexpr (dipoles)
      if (ray.exit) return {};
    const T choice = draw<T>(camera_.sampler(),
                             key_at(ray.length, detail::MediumDimension::channel, Effect::scattering), camera_.count());
    const T u = draw<T>(camera_.sampler(), key_at(ray.length, detail::MediumDimension::distance, Effect::scattering),
                        camera_.count());
    statistics_.drew(Effect::scattering, 2);
    return Free(*ray.medium, world_.scatterings[static_cast<std::size_t>(ray.medium->scattering)], ray.throughput,
                choice, u);
  } else {
    return {};
  }
}

/// Whether the ray scatters before it gets to the hit; if not, what it counts for having got there. Rounding may put
/// a path that scatters close to the surface on its other side, where it is no longer inside.
template <class Policy>
bool PathTracer<Policy>::scatters_before(PathRay& ray, Free& free, const Nearest& nearest) const {
  if (free.medium == nullptr) return false;
  const bool outside =
      nearest ? bounds_medium<T, NestedMedia<T>>(world_, free.medium, nearest->primitive) &&
                    dot(world_.accelerator.primitives()
                            .surface_at(nearest->primitive, ray.ray, Intersection<T>{nearest->t, nearest->part})
                            .normal,
                        ray.ray.direction) <= 0
              : !free.medium->endless;
  if (outside) {
    free = {};
    ray.medium = nullptr;
    return false;
  }
  if (free.length < (nearest ? nearest->t : infinity<T>)) return true;
  // To a surface, `prepare` takes the transmittance into account.
  const T distance = nearest ? nearest->t : infinity<T>;
  ray.throughput *= free.weight_at_surface(distance);
  if (!nearest) ray.throughput *= free.transmittance(distance);
  return false;
}

/// Where the path scatters, ready to go on.
template <class Policy>
auto PathTracer<Policy>::scatter(const PathRay& ray, const Free& free) const -> Vertex {
  SurfaceVertex<T, with_facets, with_maps> at{};
  at.position = ray.ray.origin + free.length * ray.ray.direction;
  at.time = ray.ray.time;
  at.number = ray.number;
  at.length = ray.length;
  at.medium = at.behind = ray.medium;
  at.throughput = ray.throughput * free.weight_where_scattered();
  Vertex inside(at);
  inside.phase = PhaseFunction<T>{ray.ray.direction, free.scattering.anisotropy, settings_.flat};
  return inside;
}

template <class Policy>
Found PathTracer<Policy>::describe_scattered(const PathRay& ray, const Free& free) const {
  Found found{ray.number, Ending::scattered, static_cast<double>(free.length)};
  if (const int of_body = detail::primitive_of(world_, free.medium); of_body >= 0) {
    found.object = world_.object(of_body);
    found.member = world_.piece(of_body).member;
  }
  found.point = Vec3d(ray.ray.origin + free.length * ray.ray.direction);
  found.normal = -Vec3d(ray.ray.direction);
  return found;
}

template <class Policy>
auto PathTracer<Policy>::sample_phase(const Vertex& at) -> raywalk::BsdfSample<T> {
  const Vec2<T> unit = draw_pair<T>(
      camera_.sampler(), key_at(at.length, detail::MediumDimension::direction, Effect::scattering), camera_.strata());
  statistics_.drew(Effect::scattering, 2);
  const Vec3<T> direction = at.phase->sample(unit);
  return {Lobe::phase, direction, Rgb<T>(1), (*at.phase)(direction)};
}

/// The first thing that a shadow ray hits other than what is seamless, and the transmittance up to there. Seamless
/// surfaces do not bend it, but the medium changes there. Where it does not end, nothing gets through.
template <class Policy>
auto PathTracer<Policy>::closest_through_media(const LightSample& light_sample, Rgb<T>& transmittance) -> Nearest {
  struct Straight {
    Ray ray;
    const Medium* medium;
  };
  Straight rest{light_sample.ray, light_sample.medium};
  rest.ray.direction = normalize(rest.ray.direction);
  for (int crossings = 0; crossings < crossings_limit; ++crossings) {
    stop_.check();
    Nearest nearest = world_.accelerator.closest(rest.ray, infinity<T>, statistics_.tests);
    if (!nearest) {
      transmittance *= transmittance_to_nothing<T>(rest.medium);
      return nearest;
    }
    const Surface& met = world_.surface(nearest->primitive);
    const SurfacePoint<T> point = world_.accelerator.primitives().surface_at(
        nearest->primitive, rest.ray, Intersection<T>{nearest->t, nearest->part});
    const bool entering = dot(point.normal, rest.ray.direction) <= 0;
    if (const auto left = transmittance_to_hit(rest.medium, met, entering, nearest->t)) transmittance *= *left;
    const auto from_the_start = [&] {
      nearest->t =
          dot(point.position - light_sample.ray.origin, rest.ray.direction) / length(light_sample.ray.direction);
      return nearest;
    };
    if (!met.seamless) return from_the_start();
    const Medium* beyond = entering ? static_cast<const Medium*>(&met) : nullptr;
    if constexpr (Policy::effects.nesting) {
      if (met.nests) {
        const auto sides = nested_.across(rest.ray, *nearest, point.position, entering, rest.medium, statistics_.tests);
        if (nested_.index(sides.before) != nested_.index(sides.beyond)) return from_the_start();
        beyond = sides.beyond;
      }
    }
    rest = {spawn_ray<Ray>(world_, point.position, point.normal, {nearest->primitive, nearest->part},
                           rest.ray.direction, rest.ray.time),
            beyond};
  }
  transmittance = Rgb<T>(0);
  return std::nullopt;
}

}  // namespace raywalk
