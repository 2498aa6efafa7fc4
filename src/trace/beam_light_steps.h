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
    for (const Light& light : world_.lights) {
      if (detail::has_extent(world_, light)) continue;  // a penumbra has no edge
      for (const Place& edge : beam.plan->shadow_edges(beam.fan, whole, {plan(light.place), light.is_distant}, stop_))
        edges.push_back(edge);
    }
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

/// What of each light without an extent arrives in the middle of a piece.
template <class Watcher>
std::vector<Rgbd> BeamTracer<Watcher>::light_at(const Beam& beam, const BeamPart& piece) {
  Part part;
  static_cast<BeamPart&>(part) = piece;
  meet(part, beam, part.middle());
  const SurfaceVertex<double>& at = *part.at;
  std::vector<Rgbd> arriving;
  TestCounts uncounted;
  for (const Light& light : world_.lights) {
    if (detail::has_extent(world_, light)) continue;
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
auto BeamTracer<Watcher>::form_shadow_ray(int depth, const Part& part, const Beam& beam, const Light& light)
    -> std::optional<Shadow> {
  const SurfaceVertex<double>& at = *part.at;
  const auto [to_light, fan, share] = seen_of(light, at);
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
      rays_formed_++, at.medium, fan, share};
  ++statistics_.formed(RayKind::shadow);
  note(Line::beam_form_shadow_ray, depth, [&] {
    RayFormed formed{shadow.number, part.number, RayKind::shadow, shadow.ray.origin,
                     to_light,      throughput,  light.index,     !light.is_distant};
    if (shadow.fan)
      formed.end_radius =
          std::abs(cross(shadow.fan->end - shadow.fan->begin, plan(to_light))) / (2 * length(plan(to_light)));
    return formed;
  });
  return shadow;
}

/// Where a surface's plane crosses a light with an extent, the light ends there.
template <class Watcher>
auto BeamTracer<Watcher>::seen_of(const Light& light, const SurfaceVertex<double>& at) const -> LightSeen {
  LightSeen seen{light.direction_to(light.place, at.position), fan_to(light, at.position)};
  if (!seen.fan || at.surface->lit_from_behind) return seen;
  const Vec2d normal = plan(at.bsdf.shading_normal);
  const double first = dot(normal, seen.fan->begin), last = dot(normal, seen.fan->end);
  if ((first > 0) == (last > 0)) return seen;
  const double horizon = first / (first - last);
  const Vec2d edge = seen.fan->begin + horizon * (seen.fan->end - seen.fan->begin);
  (first > 0 ? seen.fan->end : seen.fan->begin) = edge;
  seen.share = first > 0 ? horizon : 1 - horizon;
  seen.to_light = detail::in_plan((seen.fan->begin + seen.fan->end) / 2.0);
  return seen;
}

/// From a place to both ends of a light with an extent: of a rectangle that stands upright its edge, of others as wide
/// as they are seen. The rays between them meet the light at t = 1.
template <class Watcher>
std::optional<PixelFan> BeamTracer<Watcher>::fan_to(const Light& light, const Vec3d& from) const {
  if (!detail::has_extent(world_, light)) return std::nullopt;
  const Vec2d to = plan(light.place - from);
  if (!(length(to) > 0)) return std::nullopt;
  const Vec2d aside = Vec2d(-to.y, to.x) / length(to);
  const Vec2d none{0.0};
  Vec2d half = detail::radius_of_light<double>(light, detail::in_plan(to / length(to)), true) * aside;
  const auto* rectangle = std::get_if<RectangleLight::Prepared<double>>(&light.kind);
  if (rectangle != nullptr && plan(rectangle->v) == none)
    half = plan(rectangle->u) / 2.0;
  else if (rectangle != nullptr && plan(rectangle->u) == none)
    half = plan(rectangle->v) / 2.0;
  if (!(length(half) > 0)) return std::nullopt;
  return PixelFan{to - half, to + half};
}

/// What of a light with an extent is seen from the middle of a part: the light's width is cut as a pixel's is.
template <class Watcher>
Found BeamTracer<Watcher>::find_uncovered(const Part& part, const Shadow& shadow, const Light& light) {
  std::vector<Outline> others = outlines_;
  others.erase(others.begin() + part.outline);  // the middle lies on its own outline, which is convex
  const Vec2d from = plan(shadow.ray.origin);
  const UnfoldedPlan seen(others, from);
  Found found{shadow.number, Ending::blocked};
  found.transmittance = Rgbd(0.0);
  double widest = 0;
  for (const BeamPart& piece : seen.cut(*shadow.fan, {0, 0}, {1, 0}, stop_)) {
    const Vec2d direction = shadow.fan->at(piece.middle());
    const Vec2d met = piece.outline < 0 ? from : seen.end(*shadow.fan, piece, piece.middle());
    const bool before = piece.outline >= 0 && length(met - from) < length(direction);
    const int object = before ? others[static_cast<std::size_t>(piece.outline)].object : -1;
    std::optional<Rgbd> through(Rgbd(1.0));
    if (before && role_of(world_.shadow_roles, primitives_[static_cast<std::size_t>(object)]) == ShadowRole::stops) {
      through.reset();
    } else if (before || world_.absorbs || !part.at->entering) {  // inside, its own outline may hide the light
      const Ray<double> ray{shadow.ray.origin, detail::in_plan(direction), shadow.ray.departure, shadow.ray.time};
      through = shadow_transmittance(world_, ray, light.t_far(), statistics_.tests, filters_met_, {}, shadow.medium);
    }
    if (through) {
      found.transmittance += shadow.share * piece.width() * *through;
      found.ending = Ending::reached_light;
    } else if (before && piece.width() > widest) {
      widest = piece.width();
      found.object = object;
      found.point = detail::in_plan(met), found.normal = -normalize(detail::in_plan(direction));
      found.t = length(met - from) / length(direction);
    }
  }
  return found;
}

/// As the tracer's; of a light with an extent, how much is uncovered.
template <class Watcher>
Rgbd BeamTracer<Watcher>::find_intersection(int depth, const Part& part, const Shadow& shadow, const Light& light) {
  if (shadow.fan && world_.occludes) {
    const Found found = find_uncovered(part, shadow, light);
    ++statistics_.ends(found.ending);
    note(Line::beam_find_intersection, depth, [&] { return found; });
    return found.transmittance;
  }
  const double t_max = light.t_far();
  const std::optional<Rgbd> transmittance =
      world_.occludes
          ? shadow_transmittance(world_, shadow.ray, t_max, statistics_.tests, filters_met_, {}, shadow.medium)
          : std::optional(Rgbd(shadow.share));
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
