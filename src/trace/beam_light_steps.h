#pragma once
// What the statements of trace/beams.h about lights do, and how their shadows divide what a beam sees. Included by it
// alone.

#include "trace/beams.h"
#include "trace/part_steps.h"
#include "trace/plan_marks.h"
#include "trace/shadow_transmittance.h"
#include "trace/spawn_ray.h"

#include <algorithm>
#include <utility>

namespace raywalk {

/// Where an edge of a shadow, the rim of a spot light or a line of a checker crosses what is seen, it is two parts.
template <class Watcher>
void BeamTracer<Watcher>::divide(std::vector<Part>& pieces, const Beam& beam, const BeamPart& seen) {
  Part rest;
  static_cast<BeamPart&>(rest) = seen;
  std::vector<Place> edges;
  if (seen.outline >= 0) {
    edges = edges_of_light(beam, seen);
    for (const Place& edge : edges_of_total_reflection(beam, rest)) edges.push_back(edge);
    const std::optional<std::vector<Place>> squares = edges_of_squares(beam, seen);
    rest.has_mean = !squares;
    if (squares) edges.insert(edges.end(), squares->begin(), squares->end());
  }
  std::sort(edges.begin(), edges.end());
  edges.push_back(seen.end);
  std::vector<Rgbd> before;
  for (const Place& edge : edges) {
    if (!(edge - rest.begin > 0)) continue;
    Part piece = rest;
    piece.end = edge;
    rest.begin = edge;
    std::vector<Rgbd> look = edges.size() > 1 ? look_of(beam, piece) : std::vector<Rgbd>();
    // The same as beside it: no edge after all.
    if (piece.begin == seen.begin || look != before)
      pieces.push_back(piece);
    else
      pieces.back().end = piece.end;
    before = std::move(look);
  }
}

template <class Watcher>
bool BeamTracer<Watcher>::is_lit(int outline) const {
  const int object = outlines_[static_cast<std::size_t>(outline)].object;
  const auto& surface = world_.surface(primitives_[static_cast<std::size_t>(object)]);
  return world_.effects.used(Effect::shadows) && detail::shows_lights(world_, surface);
}

template <class Watcher>
std::vector<Place> BeamTracer<Watcher>::edges_of_light(const Beam& beam, const BeamPart& part) const {
  std::vector<Place> edges;
  if (!is_lit(part.outline)) return edges;
  const Outline& outline = outlines_[static_cast<std::size_t>(part.outline)];
  const auto add = [&](const std::vector<Place>& more) { edges.insert(edges.end(), more.begin(), more.end()); };
  for (const Light& light : world_.lights) {
    if (detail::has_extent(world_, light)) continue;  // a penumbra has no edge
    if (const auto* spot = std::get_if<SpotLight::Prepared<double>>(&light.kind))
      add(beam.plan->places_of(beam.fan, part, spot_rims(outline, plan(light.place), *spot)));
    if (!world_.occludes) continue;
    const PlanLight in_plan{plan(light.place), light.is_distant};
    if (const auto* circle = std::get_if<OutlineCircle>(&outline.shape))
      add(beam.plan->places_of(beam.fan, part, shadows_on_circle(*circle, outlines_, in_plan)));
    else
      add(beam.plan->shadow_edges(beam.fan, part, in_plan, stop_));
  }
  return edges;
}

/// Where the rays of a part come to a straight face at the critical angle.
template <class Watcher>
std::vector<Place> BeamTracer<Watcher>::edges_of_total_reflection(const Beam& beam, const Part& whole) {
  const Outline& outline = outlines_[static_cast<std::size_t>(whole.outline)];
  if (!outline.is_straight() || !world_.surface(primitives_[static_cast<std::size_t>(outline.object)]).transmits)
    return {};
  Part part = whole;
  const Statistics counted = statistics_;
  meet(part, beam, part.middle());
  statistics_ = counted;
  const Refraction<double>& bends = part.at->refraction;
  if (!(bends.n1 > bends.n2)) return {};
  return beam.plan->places_of(beam.fan, whole, seen_at_sine(outline, beam.plan->virtual_eye(), bends.n2 / bends.n1));
}

/// None where the squares are too many to be cut.
template <class Watcher>
std::optional<std::vector<Place>> BeamTracer<Watcher>::edges_of_squares(const Beam& beam, const BeamPart& part) const {
  const Outline& outline = outlines_[static_cast<std::size_t>(part.outline)];
  const int primitive = primitives_[static_cast<std::size_t>(outline.object)];
  const auto& surface = world_.surface(primitive);
  std::vector<Place> none;
  if (!surface.checker || world_.maps(surface)) return none;
  OutlineStretch stretch;
  for (const Vec3d& at : area_of(beam, part).ends) stretch.push_back(plan(at));
  const auto uv = [&](const Vec2d& at) {
    Vec3d normal(0.0);
    if (const auto* wall = std::get_if<OutlineWall>(&outline.shape)) normal = normalize(detail::in_plan(wall->normal));
    return world_.accelerator.primitives().uv_at(primitive, SurfacePoint<double>{detail::in_plan(at), normal},
                                                 outline.part, camera_.shutter_open());
  };
  const auto lines = checker_lines(outline, stretch, surface.checker->size, most_squares, uv);
  if (!lines) return surface.texture ? std::optional(none) : std::nullopt;
  return beam.plan->places_of(beam.fan, part, *lines);
}

/// What the middle of a piece has of its checker, and of each light without an extent: whether it arrives, and whether
/// in full.
template <class Watcher>
std::vector<Rgbd> BeamTracer<Watcher>::look_of(const Beam& beam, const Part& piece) {
  Part part = piece;
  const Statistics counted = statistics_;
  meet(part, beam, part.middle());
  statistics_ = counted;
  const SurfaceVertex<double>& at = *part.at;
  std::vector<Rgbd> look{at.bsdf.diffuse, part.ambient, Rgbd(is_black(at.bsdf.transparent))};
  TestCounts uncounted;
  for (const Light& light : world_.lights) {
    if (detail::has_extent(world_, light)) continue;
    const Vec3d to_light = light.direction_to(light.place, at.position);
    const auto ray =
        spawn_ray<Ray<double>>(world_, at.position, at.bsdf.geometric_normal, at.departure, to_light, at.time);
    const bool arrives = !detail::why_unlit(at, light, to_light);
    const bool in_full = arrives && !(light.falloff(normalize(to_light)) < 1);
    look.emplace_back(in_full);
    look.push_back(arrives && world_.occludes
                       ? shadow_transmittance(world_, ray, light.t_far(), uncounted, filters_met_, {}, at.medium)
                             .value_or(Rgbd(0.0))
                       : Rgbd(arrives));
  }
  return look;
}

template <class Watcher>
auto BeamTracer<Watcher>::shadow_to(const SurfaceVertex<double>& at, const LightSeen& seen, int number) const
    -> Shadow {
  return {spawn_ray<Ray<double>>(world_, at.position, at.bsdf.geometric_normal, at.departure, seen.to_light, at.time),
          number, at.medium, seen.fan, seen.share};
}

template <class Watcher>
auto BeamTracer<Watcher>::form_shadow_ray(int depth, const Part& part, const Beam& beam, const Light& light)
    -> std::optional<Shadow> {
  const SurfaceVertex<double>& at = *part.at;
  const LightSeen seen = seen_of(light, at);
  const Vec3d& to_light = seen.to_light;
  const Rgbd throughput = beam.throughput * part.width() / (beam.end - beam.begin);
  if (const auto why = detail::why_unlit(at, light, to_light)) {
    ++statistics_.ends(*why);
    note(Line::beam_form_shadow_ray, depth, [&] {
      return RayNotFormed{part.number, RayKind::shadow, *why, at.position, to_light, throughput, light.index};
    });
    return std::nullopt;
  }
  const Shadow shadow = shadow_to(at, seen, rays_formed_++);
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

/// What a ray of a part brings. `mirrored`, `beyond`: what a beam finds there, if the part sends one.
template <class Watcher>
Rgbd BeamTracer<Watcher>::shade_beside(int depth, const Part& beside, const Rgbd& mirrored, const Rgbd& beyond) {
  if (!beside.at) return detail::shade_of_middle(world_, beside, Rgbd(0.0)).total;
  const SurfaceVertex<double>& at = *beside.at;
  Rgbd direct{0.0};
  for (const Light& light : detail::lights_on(world_, beside)) {
    const LightSeen seen = seen_of(light, at);
    if (detail::why_unlit(at, light, seen.to_light)) continue;
    const Shadow shadow = shadow_to(at, seen, 0);
    const Rgbd visible = light_through(beside, shadow, light).transmittance;
    if (is_black(visible)) continue;
    const detail::PartLight<double> brought = light_on(beside, light, shadow, visible);
    direct += brought.diffuse + brought.specular;
  }
  const Rgbd followed =
      detail::brought_by_rays(world_, tracer_, depth, at, [&](RayKind kind) { return sends(beside, kind); });
  const Rgbd by_beams = at.bsdf.mirror * mirrored + at.bsdf.transparent * beyond;
  return at.throughput * (detail::shade_of_middle(world_, beside, direct).total + followed + by_beams);
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

/// How much of a light arrives, and of one that is wide, what covers it.
template <class Watcher>
Found BeamTracer<Watcher>::light_through(const Part& part, const Shadow& shadow, const Light& light) {
  if (shadow.fan && world_.occludes) return find_uncovered(part, shadow, light);
  const std::optional<Rgbd> transmittance =
      world_.occludes
          ? shadow_transmittance(world_, shadow.ray, light.t_far(), statistics_.tests, filters_met_, {}, shadow.medium)
          : std::optional(Rgbd(shadow.share));
  Found found{shadow.number, transmittance ? Ending::reached_light : Ending::blocked};
  found.transmittance = transmittance.value_or(Rgbd(0.0));
  return found;
}

/// As the tracer's; of a light with an extent, how much is uncovered.
template <class Watcher>
Rgbd BeamTracer<Watcher>::find_intersection(int depth, const Part& part, const Shadow& shadow, const Light& light) {
  const Found through = light_through(part, shadow, light);
  ++statistics_.ends(through.ending);
  note(Line::beam_find_intersection, depth, [&] {
    if (shadow.fan && world_.occludes) return through;
    const auto blocker =
        through.ending == Ending::blocked ? first_blocker(world_, shadow.ray, light.t_far()) : std::nullopt;
    Found found =
        blocker ? detail::describe(shadow.number, Ending::blocked, world_, shadow.ray, *blocker) : Found(through);
    found.transmittance = through.transmittance;
    return found;
  });
  return through.transmittance;
}

/// Of a light with an extent the mean over what of it lies before the surface.
template <class Watcher>
detail::PartLight<double> BeamTracer<Watcher>::light_on(const Part& part, const Light& light, const Shadow& shadow,
                                                        const Rgbd& visible) const {
  const auto mirrors = detail::mirrors_at(world_, *part.at);
  detail::LightPoints<double> points;
  if (shadow.fan) {
    const Vec2d across = shadow.fan->end - shadow.fan->begin;
    points.all = detail::points_along_light(*part.at, mirrors.slope, length(across) / length(shadow.ray.direction));
    for (int i = 0; i < points.all; ++i)
      points.to.emplace_back(shadow.fan->begin + ((i + 0.5) / points.all) * across,
                             light.place.z - part.at->position.z);
  } else {
    points.to = {shadow.ray.direction};
  }
  return detail::light_on(*part.at, part.ray, light, points, visible, mirrors.shown);
}

template <class Watcher>
void BeamTracer<Watcher>::add_unlit(DirectLighting& direct, const Light& light) {
  if constexpr (Observer::watches) direct.terms.push_back({light.index});
}

template <class Watcher>
void BeamTracer<Watcher>::add_light(DirectLighting& direct, const Part& part, const Light& light, const Shadow& shadow,
                                    const Rgbd& visible) {
  if (is_black(visible)) return add_unlit(direct, light);
  const detail::PartLight<double> brought = light_on(part, light, shadow, visible);
  direct.sum += brought.diffuse + brought.specular;
  if constexpr (Observer::watches) direct.terms.push_back({light.index, brought.diffuse, brought.specular});
}

}  // namespace raywalk
