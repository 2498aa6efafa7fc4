#pragma once
// What the statements of trace/cones.h about lights do. Included by it alone.

#include "trace/cones.h"
#include "trace/medium_walk.h"
#include "trace/part_steps.h"
#include "trace/shadow_transmittance.h"
#include "trace/spawn_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace raywalk {

/// Of a light with an extent those that light the part.
template <class T, class Watcher, bool with_maps>
detail::LightPoints<T> ConeTracer<T, Watcher, with_maps>::points_of(const Part& part, const Light& light) const {
  const Vertex& at = *part.at;
  const Vec3<T> to_middle = light.direction_to(light.place, at.position);
  detail::LightPoints<T> points;
  const auto add = [&](const Vec3<T>& to_light) {
    if (!detail::why_unlit(at, light, to_light)) points.to.push_back(to_light);
  };
  const double distance = length(Vec3d(to_middle));
  if (!detail::has_extent(world_, light) || !(distance > 0)) {
    add(to_middle);
    return points;
  }
  const Vec3d l = Vec3d(to_middle) / distance;
  const double radius = detail::radius_of_light<T>(light, l, flat_);
  const double side = 2 * (flat_ ? radius : static_cast<double>(light.reach)) / distance;
  const int edge = detail::points_along_light(at, static_cast<T>(part.slope), side);
  points.all = flat_ ? edge : edge * edge;
  const Vec3d across = radius * Vec3d(-l.y, l.x, 0);
  for (int i = 0; i < points.all; ++i)
    add(flat_ ? to_middle + Vec3<T>(((2 * i + 1.0) / edge - 1) * across)
              : light.direction_to(light.regular(i, edge), at.position));
  return points;
}

/// From the part's width at the surface to that of what is seen of the light.
template <class T, class Watcher, bool with_maps>
auto ConeTracer<T, Watcher, with_maps>::form_shadow_cone(int depth, const Part& part, const Cone& cone,
                                                         const Light& light) -> std::optional<Shadow> {
  const Vertex& at = *part.at;
  Vec3<T> to_light = light.direction_to(light.place, at.position);
  const Rgb<T> throughput = cone.throughput * static_cast<T>(part.share);
  detail::LightPoints<T> points = points_of(part, light);
  if (points.to.empty()) {
    const Ending why = detail::why_unlit(at, light, to_light).value_or(Ending::facing_away);
    ++statistics_.ends(why);
    note(Line::form_shadow_cone, depth, [&] {
      return RayNotFormed{part.number,     RayKind::shadow,  why,        Vec3d(at.position),
                          Vec3d(to_light), Rgbd(throughput), light.index};
    });
    return std::nullopt;
  }
  const double seen = points.share();
  if (seen < 1) to_light = std::accumulate(points.to.begin(), points.to.end(), Vec3<T>(0)) / T(points.to.size());
  const Vec3d whole(to_light);
  const double distance = length(whole);
  const Vec3d l = whole / distance;
  const double end = light.is_distant ? part.width.radius
                                      : (flat_ ? seen : std::sqrt(seen)) * detail::radius_of_light<T>(light, l, flat_);
  const Shadow shadow{cone_about(Vec3d(at.position), l, part.width.radius, (end - part.width.radius) / distance, flat_),
                      to_light, std::move(points), rays_formed_++};
  ++statistics_.formed(RayKind::shadow);
  note(Line::form_shadow_cone, depth, [&] {
    RayFormed formed{shadow.number, part.number,      RayKind::shadow, shadow.cone.origin,
                     whole,         Rgbd(throughput), light.index,     !light.is_distant};
    formed.radius = part.width.radius, formed.end_radius = end;
    return formed;
  });
  return shadow;
}

/// Each object covers its share of what those beside it leave: in which order makes no difference.
template <class T, class Watcher, bool with_maps>
Rgb<T> ConeTracer<T, Watcher, with_maps>::find_uncovered(int depth, const Part& part, const Shadow& shadow,
                                                         const Light& light) {
  Rgb<T> uncovered{1};
  std::optional<ConePart> most;
  if (world_.occludes) {
    const double far = light.is_distant ? infinity<double> : length(Vec3d(shadow.to_light));
    const std::vector<ConePart> blockers =
        meet_cone(bodies_, shadow.cone, {part.object, part.part}, far, statistics_.tests);
    const Vertex& at = *part.at;
    const Medium* begins_in = dot(at.bsdf.geometric_normal, shadow.to_light) < 0 ? at.behind : at.medium;
    const auto together = inside_each_other(blockers, part, shadow, light, begins_in);
    if (together) uncovered *= together->transmittance;
    bool leaves = together.has_value();  // the medium that it begins in, which has absorbed then
    for (std::size_t first = 0; first < blockers.size();) {
      double cover = 0;
      std::size_t last = first, widest = first;
      for (; last < blockers.size() && blockers[last].body == blockers[first].body; ++last) {
        cover += blockers[last].cover;
        if (blockers[last].cover > blockers[widest].cover) widest = last;
      }
      const int primitive = primitive_of(blockers[widest]);
      const bool counted = together && std::ranges::count(together->primitives, primitive) > 0;
      const bool bounds = begins_in != nullptr && bounds_medium<T, NestedMedia<T>>(world_, begins_in, primitive);
      leaves = leaves || bounds;
      if (!counted) {
        const Rgb<T> through = transmittance_of(blockers[widest], part, shadow, light, bounds ? begins_in : nullptr);
        uncovered *= Rgb<T>(1) - static_cast<T>(std::min(cover, 1.0)) * (Rgb<T>(1) - through);
      }
      if (!most || blockers[widest].cover > most->cover) most = blockers[widest];
      first = last;
    }
    if (!leaves && begins_in != nullptr && begins_in->absorbs)
      uncovered *= beer_lambert(begins_in->extinction,
                                static_cast<T>(std::min(far, static_cast<double>(std::numeric_limits<T>::max()))));
  }
  const bool blocked = is_black(uncovered);
  ++statistics_.ends(blocked ? Ending::blocked : Ending::reached_light);
  note(Line::find_uncovered, depth, [&] {
    Found found{shadow.number, blocked ? Ending::blocked : Ending::reached_light};
    found.transmittance = Rgbd(uncovered);
    if (blocked && most) {
      found.t = most->t / length(Vec3d(shadow.to_light));
      found.object = bodies_[most->body].object;
      found.part = most->part;
      found.point = shadow.cone.start(most->place) + most->t * shadow.cone.direction(most->place);
      found.normal = -shadow.cone.axis;
    }
    return found;
  });
  return uncovered;
}

template <class T, class Watcher, bool with_maps>
bool ConeTracer<T, Watcher, with_maps>::filters(const ConePart& blocker) const {
  return role_of(world_.shadow_roles, primitive_of(blocker)) == ShadowRole::filters;
}

/// Of an object between a part and a light: 0, unless its material filters shadows. `medium`: the one that the shadow
/// cone begins in, if it is the object's.
template <class T, class Watcher, bool with_maps>
Rgb<T> ConeTracer<T, Watcher, with_maps>::transmittance_of(const ConePart& blocker, const Part& part,
                                                           const Shadow& shadow, const Light& light,
                                                           const Medium* medium) {
  if (!filters(blocker)) return Rgb<T>(0);
  const int primitive = primitive_of(blocker);
  const Vertex& at = *part.at;
  const double distance = length(Vec3d(shadow.to_light));
  const Vec3<T> along(distance * shadow.cone.direction(blocker.place));
  const auto ray = spawn_ray<Ray<T>>(world_, Vec3<T>(shadow.cone.start(blocker.place)), at.bsdf.geometric_normal,
                                     at.departure, along, at.time);
  if (world_.absorbs)
    return absorbing_transmittance(world_, ray, light.t_far(), statistics_.tests, {primitive}, medium);
  return primitive_transmittance(world_, ray, light.t_far(), statistics_.tests, primitive);
}

template <class T, class Watcher, bool with_maps>
auto ConeTracer<T, Watcher, with_maps>::inside_each_other(const std::vector<ConePart>& blockers, const Part& part,
                                                          const Shadow& shadow, const Light& light,
                                                          const Medium* medium) -> std::optional<Together> {
  if (!world_.absorbs || world_.bodies.empty()) return std::nullopt;
  const Vertex& at = *part.at;
  const auto ray =
      spawn_ray<Ray<T>>(world_, at.position, at.bsdf.geometric_normal, at.departure, shadow.to_light, at.time);
  std::vector<int> met;
  for (const ConePart& blocker : blockers) {
    const int primitive = primitive_of(blocker);
    if (!filters(blocker) || std::ranges::count(met, primitive) > 0) continue;
    if (world_.accelerator.primitives().intersect(primitive, ray, light.t_far())) met.push_back(primitive);
  }
  const auto left =
      nested_transmittance(world_, ray, light.t_far(), statistics_.tests, met, NestedMedia<T>::bodies_in(medium));
  if (!left) return std::nullopt;
  return Together{*left, met};
}

template <class T, class Watcher, bool with_maps>
void ConeTracer<T, Watcher, with_maps>::add_unlit(DirectLighting& direct, const Light& light) {
  if constexpr (Observer::watches) direct.terms.push_back({light.index});
}

template <class T, class Watcher, bool with_maps>
void ConeTracer<T, Watcher, with_maps>::add_light(DirectLighting& direct, const Part& part, const Light& light,
                                                  const Shadow& shadow, const Rgb<T>& uncovered) {
  if (is_black(uncovered)) return add_unlit(direct, light);
  const detail::PartLight<T> brought =
      detail::light_on(*part.at, part.ray, light, shadow.points, uncovered, part.facets);
  direct.sum += brought.diffuse + brought.specular;
  if constexpr (Observer::watches) direct.terms.push_back({light.index, Rgbd(brought.diffuse), Rgbd(brought.specular)});
}

}  // namespace raywalk
