#pragma once
// What the statements of trace/path.h about lights do. Included by it alone.

#include "trace/passage.h"
#include "trace/path_steps.h"

namespace raywalk {

/// All lamps of the scene, and one point of all the objects that emit.
template <class Policy>
int PathTracer<Policy>::lights_at(const Vertex& at) const {
  const bool objects = !lights_.empty() && settings_.strategy != PathStrategy::directions && !at.lobes.all_sharp();
  return static_cast<int>(world_.lamps.size()) + (objects ? 1 : 0);
}

template <class Policy>
auto PathTracer<Policy>::form_shadow_ray(const Traced& ray, const Vertex& at, int light) -> std::optional<Way> {
  constexpr unsigned unasked = 64;  // lamps
  if (static_cast<unsigned>(light) % unasked == unasked - 1) stop_.check();
  const bool object = light == static_cast<int>(world_.lamps.size());
  const typename World<T>::Lamp* lamp = object ? nullptr : &world_.lamps[static_cast<std::size_t>(light)];
  Way way{Ray{}, 0, lamp, {}, Rgb<T>(0), 0, 0, 1};
  const auto not_formed = [&](Ending why) {
    ++statistics_.ends(why);
    note(Line::path_form_shadow_ray, ray.length, [&] {
      return RayNotFormed{ray.number,     RayKind::shadow,        why, Vec3d(at.position), Vec3d(way.ray.direction),
                          Rgbd(at.share), lamp ? lamp->index : -1};
    });
    return std::nullopt;
  };
  if (settings_.max_length > 0 && ray.length + 1 > settings_.max_length) return not_formed(Ending::path_length);
  const std::optional<Ending> why_not = lamp ? aim_at_lamp(way, at) : aim_at_object(way, at);
  if (why_not) return not_formed(*why_not);
  way.ray = leaving<Ray>(world_, at.position, at.outwards, at.departure, way.ray.direction, at.time);
  way.number = rays_formed_++;
  ++statistics_.formed(RayKind::shadow);
  note(Line::path_form_shadow_ray, ray.length, [&] {
    return RayFormed{way.number,
                     ray.number,
                     RayKind::shadow,
                     Vec3d(way.ray.origin),
                     Vec3d(way.ray.direction),
                     Rgbd(at.share),
                     lamp ? lamp->index : -1,
                     !lamp || !lamp->directional};
  });
  return way;
}

/// A lamp shines as for the tracer: its strength times kd cos and ks (n.h)^s.
template <class Policy>
std::optional<Ending> PathTracer<Policy>::aim_at_lamp(Way& way, const Vertex& at) {
  const typename World<T>::Lamp& lamp = *way.lamp;
  way.medium = at.medium;  // only lamps before the surface light it
  Vec3<T>& to_light = way.ray.direction;
  if (lamp.directional) {
    to_light = lamp.place;
  } else if (lamp.extent == World<T>::Extent::none) {
    to_light = lamp.place - at.position;
  } else {
    const RandomKey key = key_at(at.length, lamp.first_dimension, Effect::penumbra);
    const Vec2<T> unit = draw_pair<T>(camera_.sampler(), key, camera_.strata());
    statistics_.drew(Effect::penumbra, 2);
    to_light = lamp.point_at(unit) - at.position;
  }
  const Lobes<T>& lobes = at.lobes;
  if (!(dot(lobes.normal, to_light) > 0) || !(dot(lobes.side, to_light) > 0)) return Ending::facing_away;
  if (lamp.spot && !lamp.shines_along(to_light)) return Ending::outside_cone;
  const T distance = lamp.directional ? T(1) : length(to_light);
  const T attenuation = lamp.constant + distance * (lamp.linear + distance * lamp.quadratic);
  const Vec3<T> l = to_light * (1 / distance);
  Rgb<T> light = lamp.strength * (1 / attenuation);
  if (lamp.spot) light *= spot_falloff(-dot(l, lamp.axis), lamp.cos_inner, lamp.cos_outer);
  Rgb<T> answers = lobes.diffuse * dot(lobes.normal, l);
  if (!is_black(at.specular)) {
    const Vec3<T> h = l - lobes.incident;
    const T n_h = std::max(dot(lobes.normal, h) / length(h), T(0));
    answers += at.specular * power(n_h, lobes.shininess);
  }
  way.brings = at.share * light * answers;
  return std::nullopt;
}

template <class Policy>
std::optional<Ending> PathTracer<Policy>::aim_at_object(Way& way, const Vertex& at) {
  T pick = 0;
  if (lights_.several()) {
    pick = draw<T>(camera_.sampler(), key_at(at.length, detail::PathDimension::pick), camera_.count());
    statistics_.drew(Effect::indirect_light, 1);
  }
  const Vec2<T> unit =
      draw_pair<T>(camera_.sampler(), key_at(at.length, detail::PathDimension::light), camera_.strata());
  statistics_.drew(Effect::indirect_light, 2);
  const auto drawn = lights_.draw(at.position, pick, unit);
  if (!drawn) return Ending::facing_away;
  way.ray.direction = drawn->way;
  way.medium = dot(drawn->way, at.lobes.side) < 0 ? at.behind : at.medium;
  const auto answers = at.lobes.evaluate(normalize(drawn->way));
  if (!(answers.density > 0)) return Ending::facing_away;
  way.target = {drawn->primitive, drawn->part};
  way.direction_density = answers.density;
  way.light_density = drawn->density;
  if (settings_.strategy == PathStrategy::both) way.weight = power_heuristic(drawn->density, answers.density);
  const Rgb<T>& emission = world_.surface(drawn->primitive).emission;
  way.brings = (way.weight / drawn->density) * at.share * answers.value * emission;
  return std::nullopt;
}

/// What is left of the light of an object on its way from the hit.
template <class Policy>
auto PathTracer<Policy>::left_of(const Way& way, const Hit<T>& hit) const -> Rgb<T> {
  const Surface& met = world_.surface(hit.primitive);
  if (!met.absorbs && (way.medium == nullptr || !way.medium->absorbs)) return Rgb<T>(1);
  const Vec3<T> outwards =
      world_.accelerator.primitives().surface_at(hit.primitive, way.ray, Crossing<T>{hit.t, hit.part}).normal;
  const T distance = hit.t * length(way.ray.direction);
  return left_on_way(way.medium, met, dot(outwards, way.ray.direction) <= 0, distance).value_or(Rgb<T>(1));
}

/// The share of the light that arrives. A lamp is dimmed as for the tracer. An object is seen where it is the first
/// thing that the ray meets: exactly where a ray that leads there by chance would find it.
template <class Policy>
auto PathTracer<Policy>::find_intersection(const Traced& ray, const Way& way) -> Rgb<T> {
  Rgb<T> visible{0};
  Nearest blocker;
  if (way.lamp) {
    const T t_max = way.lamp->directional ? infinity<T> : T(1);
    visible =
        light_through(world_, way.ray, t_max, statistics_.tests, filters_met_, {}, way.medium).value_or(Rgb<T>(0));
  } else {
    blocker = world_.accelerator.closest(way.ray, infinity<T>, statistics_.tests);
    if (blocker && Departure{blocker->primitive, blocker->part} == way.target) visible = left_of(way, *blocker);
  }
  const Ending ending = is_black(visible) ? Ending::blocked : Ending::reached_light;
  ++statistics_.ends(ending);
  note(Line::path_find_intersection, ray.length, [&] {
    if (way.lamp && ending == Ending::blocked)
      blocker = first_blocker(world_, way.ray, way.lamp->directional ? infinity<T> : T(1));
    Found found = blocker ? detail::describe(way.number, ending, world_, way.ray, *blocker) : Found{way.number, ending};
    found.passed = Rgbd(visible);
    return found;
  });
  return visible;
}

template <class Policy>
void PathTracer<Policy>::add_light(Rgb<T>& shade, const Traced& ray, const Way& way, const Rgb<T>& visible) {
  const Rgb<T> added = way.brings * visible;
  shade += added;
  note(Line::add_light, ray.length, [&] {
    return LightAdded{way.lamp ? way.lamp->index : -1,
                      way.lamp ? -1 : world_.object(way.target.primitive),
                      static_cast<double>(way.direction_density),
                      static_cast<double>(way.light_density),
                      static_cast<double>(way.weight),
                      Rgbd(added)};
  });
}

}  // namespace raywalk
