#pragma once
// What the statements of trace/beams.h about lights do, and how their shadows divide what a beam sees. Included by it
// alone.

#include "trace/beams.h"
#include "trace/part_steps.h"
#include "trace/shadow_transmittance.h"
#include "trace/spawn_ray.h"

#include <algorithm>
#include <utility>

namespace raywalk {

/// Where an edge of a shadow crosses what a part sees, it is two. Shadows on what is round are not looked for.
template <class Watcher>
void BeamTracer<Watcher>::divide_by_shadows(std::vector<BeamPart>& pieces, const Beam& beam, const BeamPart& whole) {
  std::vector<Place> edges;
  if (shows_shadows(whole.outline))
    for (const Light& light : world_.lights)
      for (const Place& edge : beam.plan->shadow_edges(beam.fan, whole, {plan(light.place), light.is_distant}))
        edges.push_back(edge);
  std::sort(edges.begin(), edges.end());
  edges.push_back(whole.end);
  std::vector<Rgbd> before;
  BeamPart rest = whole;
  for (const Place& edge : edges) {
    if (!(edge - rest.begin > 0)) continue;
    BeamPart piece = rest;
    piece.end = edge;
    rest.begin = edge;
    std::vector<Rgbd> light = edges.size() > 1 ? light_at(beam, piece) : std::vector<Rgbd>();
    // The same light as beside it: no edge of a shadow after all.
    if (piece.begin == whole.begin || light != before)
      pieces.push_back(piece);
    else
      pieces.back().end = piece.end;
    before = std::move(light);
  }
}

template <class Watcher>
bool BeamTracer<Watcher>::shows_shadows(int outline) const {
  if (outline < 0 || !outlines_[static_cast<std::size_t>(outline)].is_straight()) return false;
  const int object = outlines_[static_cast<std::size_t>(outline)].object;
  const auto& surface = world_.surface(primitives_[static_cast<std::size_t>(object)]);
  return world_.occludes && world_.effects.used(Effect::shadows) &&
         !(is_black(surface.diffuse) && is_black(surface.specular));
}

/// What of each light arrives in the middle of a piece.
template <class Watcher>
std::vector<Rgbd> BeamTracer<Watcher>::light_at(const Beam& beam, const BeamPart& piece) {
  Part part;
  static_cast<BeamPart&>(part) = piece;
  meet(part, beam);
  const SurfaceVertex<double>& at = *part.at;
  std::vector<Rgbd> arriving;
  TestCounts uncounted;
  for (const Light& light : world_.lights) {
    const Vec3d to_light = light.direction_to(light.place, at.position);
    const auto ray =
        spawn_ray<Ray<double>>(world_, at.position, at.bsdf.geometric_normal, at.departure, to_light, at.time);
    const bool faces = dot(at.bsdf.shading_normal, to_light) > 0;
    arriving.push_back(faces ? shadow_transmittance(world_, ray, light.t_far(), uncounted, filters_met_, {}, at.medium)
                                   .value_or(Rgbd(0.0))
                             : Rgbd(0.0));
  }
  return arriving;
}

template <class Watcher>
auto BeamTracer<Watcher>::lights_of(const Part& part) const -> const std::vector<Light>& {
  static const std::vector<Light> none;
  return part.at && world_.effects.used(Effect::shadows) ? world_.lights : none;
}

template <class Watcher>
auto BeamTracer<Watcher>::form_shadow_ray(int depth, const Part& part, const Beam& beam, const Light& light)
    -> std::optional<Shadow> {
  const SurfaceVertex<double>& at = *part.at;
  const Vec3d to_light = light.direction_to(light.place, at.position);
  const bool faces = dot(at.bsdf.shading_normal, to_light) > 0 || at.surface->lit_from_behind;
  const Rgbd throughput = beam.throughput * part.width() / (beam.end - beam.begin);
  if (!faces || !light.shines_along(to_light)) {
    const Ending why = faces ? Ending::outside_cone : Ending::facing_away;
    ++statistics_.ends(why);
    note(Line::beam_form_shadow_ray, depth, [&] {
      return RayNotFormed{part.number, RayKind::shadow, why, at.position, to_light, throughput, light.index};
    });
    return std::nullopt;
  }
  const Shadow shadow{
      spawn_ray<Ray<double>>(world_, at.position, at.bsdf.geometric_normal, at.departure, to_light, at.time),
      rays_formed_++, at.medium};
  ++statistics_.formed(RayKind::shadow);
  note(Line::beam_form_shadow_ray, depth, [&] {
    return RayFormed{shadow.number, part.number, RayKind::shadow, shadow.ray.origin,
                     to_light,      throughput,  light.index,     !light.is_distant};
  });
  return shadow;
}

/// As the tracer's.
template <class Watcher>
Rgbd BeamTracer<Watcher>::find_intersection(int depth, const Shadow& shadow, const Light& light) {
  const double t_max = light.t_far();
  const std::optional<Rgbd> transmittance =
      world_.occludes
          ? shadow_transmittance(world_, shadow.ray, t_max, statistics_.tests, filters_met_, {}, shadow.medium)
          : std::optional(Rgbd(1.0));
  ++statistics_.ends(transmittance ? Ending::reached_light : Ending::blocked);
  note(Line::beam_find_intersection, depth, [&] {
    const auto blocker = transmittance ? std::nullopt : first_blocker(world_, shadow.ray, t_max);
    Found found = blocker ? detail::describe(shadow.number, Ending::blocked, world_, shadow.ray, *blocker)
                          : Found{shadow.number, Ending::reached_light};
    found.transmittance = transmittance.value_or(Rgbd(0.0));
    return found;
  });
  return transmittance.value_or(Rgbd(0.0));
}

template <class Watcher>
void BeamTracer<Watcher>::add_unlit(DirectLighting& direct, const Light& light) {
  if constexpr (Observer::watches) direct.terms.push_back({light.index});
}

template <class Watcher>
void BeamTracer<Watcher>::add_light(DirectLighting& direct, const Part& part, const Light& light, const Shadow& shadow,
                                    const Rgbd& visible) {
  if (is_black(visible)) return add_unlit(direct, light);
  const auto brought = detail::light_on(*part.at, part.ray, light, shadow.ray.direction, visible);
  direct.sum += brought.diffuse + brought.specular;
  if constexpr (Observer::watches) direct.terms.push_back({light.index, brought.diffuse, brought.specular});
}

}  // namespace raywalk
