#pragma once
// What the statements of trace/path.h do where light leaves a body without a walk (trace/dipole_exit.h). Included by it
// alone, and compiled where a scene calls for it.

#include "trace/path_steps.h"

namespace raywalk {

namespace detail {

/// The random dimensions of Effect::scattering where light goes in. Pairs use two.
struct DipoleDimension {
  static constexpr std::uint32_t channel = 0, among = 1, place = 2;
};

}  // namespace detail

/// The dipole of the body that a direction leads into; null: it walks, if at all.
template <class Policy>
auto PathTracer<Policy>::dipole_behind(const Vertex& at, const BsdfSample& choice) const -> const Dipole<T>* {
  const bool enters = choice.lobe == Lobe::transparent && at.entering && !is_inside(at) && !world_.dipoles.empty();
  if (!enters || at.behind == nullptr || !at.behind->scatters()) return nullptr;
  return &world_.dipoles[static_cast<std::size_t>(at.behind->scattering)];
}

/// Straight on to where the light comes out. Nothing, where no surface is found.
template <class Policy>
void PathTracer<Policy>::lead_to_exit(const Vertex& at, std::optional<BsdfSample>& choice) {
  const Dipole<T>* dipole = dipole_behind(at, *choice);
  if (dipole == nullptr) return;
  using Dimension = detail::DipoleDimension;
  const auto drawn = [&](std::uint32_t dimension) {
    return draw<T>(camera_.sampler(), key_at(at.length, dimension, Effect::scattering), camera_.count());
  };
  DipoleDraws<T> draws;
  draws.channel = drawn(Dimension::channel);
  draws.among = drawn(Dimension::among);
  draws.place =
      draw_pair<T>(camera_.sampler(), key_at(at.length, Dimension::place, Effect::scattering), camera_.strata());
  statistics_.drew(Effect::scattering, 4);
  const DipoleEntry<T> entry{at.departure.primitive, at.position, at.outward_normal, at.time};
  const Rgb<T> throughput = at.throughput * choice->weight;
  choice->exit = ExitSearch<Ray, T>(world_, *dipole, entry, throughput)(draws, statistics_.tests);
  if (!choice->exit) return choice.reset();
  choice->direction = normalize(choice->exit->position - at.position);
  choice->weight *= choice->exit->weight;
}

template <class Policy>
Found PathTracer<Policy>::describe_exit(const PathRay& ray) const {
  const DipoleExit<T>& exit = *ray.exit;
  Found found{ray.number,
              Ending::scattered,
              static_cast<double>(exit.distance),
              world_.object(exit.departure.primitive),
              exit.departure.part,
              Vec3d(exit.position),
              Vec3d(exit.normal)};
  found.numbers =
      DipoleNumbers{static_cast<double>(exit.distance), Rgbd(exit.dipole->diffuse_reflectance(exit.distance)),
                    Rgbd(exit.dipole->total_reflectance())};
  found.member = world_.piece(exit.departure.primitive).member;
  found.shaded = hit_normals(exit.shading_normal, exit.normal);
  return found;
}

/// The place where light comes out: like a matt surface, but for what the boundary lets through.
template <class Policy>
auto PathTracer<Policy>::leave(const PathRay& ray) const -> Vertex {
  const DipoleExit<T>& exit = *ray.exit;
  SurfaceVertex<T, with_facets, with_maps> at{};
  at.departure = exit.departure;
  at.position = exit.position;
  at.outward_normal = exit.normal;
  at.time = ray.ray.time;
  at.surface = &world_.surface(exit.departure.primitive);
  at.number = ray.number;
  at.length = ray.length;
  at.behind = ray.medium;
  at.throughput = ray.throughput;
  at.bsdf.incident = -exit.normal;
  at.bsdf.geometric_normal = exit.normal;
  at.bsdf.shading_normal = exit.shading_normal;
  at.bsdf.diffuse = at.surface->transmission;
  if (at.surface->dielectric) at.bsdf.diffuse += at.surface->reflection;
  at.bsdf.prepare(at.throughput);
  Vertex outside(at);
  outside.left_by = exit.dipole;
  return outside;
}

}  // namespace raywalk
