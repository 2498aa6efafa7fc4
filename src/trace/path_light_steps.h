#pragma once
// What the statements of trace/path.h about lights do. Included by it alone.

#include "trace/path_steps.h"
#include "trace/shadow_transmittance.h"

namespace raywalk {

/// All lights of the scene, one sample of all emitters together, and one of the sky, the last.
template <class Policy>
int PathTracer<Policy>::light_count_at(const Vertex& at) const {
  const bool objects = !emitters_.empty() && settings_.strategy != PathStrategy::directions && !all_sharp(at);
  return static_cast<int>(world_.lights.size()) + (objects ? 1 : 0) + (samples_sky(at) ? 1 : 0);
}

template <class Policy>
bool PathTracer<Policy>::samples_sky(const Vertex& at) const {
  if constexpr (Policy::effects.sky)
    return world_.sky && settings_.strategy != PathStrategy::directions && !all_sharp(at);
  return false;
}

template <class Policy>
auto PathTracer<Policy>::form_shadow_ray(const PathRay& ray, const Vertex& at, int index)
    -> std::optional<LightSample> {
  if (static_cast<std::size_t>(index) % few_lights == few_lights - 1) stop_.check();
  const bool lamp = index < static_cast<int>(world_.lights.size());
  const bool sky = samples_sky(at) && index == light_count_at(at) - 1;
  const typename World<T>::Light* light = lamp ? &world_.lights[static_cast<std::size_t>(index)] : nullptr;
  LightSample light_sample{Ray{raywalk::Ray<T>{}}, 0, light, {}, Rgb<T>(0), 0, 0, 1};
  const auto not_formed = [&](Ending why) {
    ++statistics_.ends(why);
    note(Line::path_form_shadow_ray, ray.length, [&] {
      return RayNotFormed{ray.number,
                          RayKind::shadow,
                          why,
                          Vec3d(at.position),
                          Vec3d(light_sample.ray.direction),
                          Rgbd(at.throughput),
                          light ? light->index
                          : sky ? light_of_sky
                                : -1};
    });
    return std::nullopt;
  };
  if (settings_.max_length > 0 && ray.length + 1 > settings_.max_length) return not_formed(Ending::path_length);
  std::optional<Ending> why_not = light ? aim_at_light(light_sample, at)
                                  : sky ? aim_at_sky(light_sample, at)
                                        : aim_at_emitter(light_sample, at);
  inject<Policy>(world_, Fault::second_side_black, [&] {
    if (!at.entering) why_not = Ending::facing_away;
  });
  if (why_not) return not_formed(*why_not);
  light_sample.ray = spawn(at, light_sample.ray.direction);
  light_sample.number = rays_formed_++;
  ++statistics_.formed(RayKind::shadow);
  note(Line::path_form_shadow_ray, ray.length, [&] {
    return RayFormed{light_sample.number,
                     ray.number,
                     RayKind::shadow,
                     Vec3d(light_sample.ray.origin),
                     Vec3d(light_sample.ray.direction),
                     Rgbd(at.throughput),
                     light ? light->index
                     : sky ? light_of_sky
                           : -1,
                     light ? !light->is_distant : !sky};
  });
  return light_sample;
}

/// A light contributes as in the tracer: its strength times kd cos and ks (n.h)^s, and what small mirrors have of it.
/// Inside of a medium, the phase function is in the place of kd / pi cos. A light behind the surface shows in rough
/// glass only, and not where its shadow is filtered, for then the light of lamps is what the filter lets through.
template <class Policy>
std::optional<Ending> PathTracer<Policy>::aim_at_light(LightSample& light_sample, const Vertex& at) {
  const typename World<T>::Light& light = *light_sample.light;
  Vec3<T>& to_light = light_sample.ray.direction;
  Vec3<T> point = light.place;
  if (!light.is_delta) {
    const RandomKey key = key_at(at.length, light.first_dimension, Effect::penumbra);
    const Vec2<T> unit = draw_pair<T>(camera_.sampler(), key, camera_.strata());
    statistics_.drew(Effect::penumbra, 2);
    point = light.sample(unit);
  }
  to_light = light.direction_to(point, at.position);
  const auto& bsdf = at.bsdf;
  const bool behind = !is_inside(at) && bsdf.is_behind_glass(to_light) && !at.surface->filters_shadows;
  if (!is_inside(at) && !behind &&
      (!(dot(bsdf.shading_normal, to_light) > 0) || !(dot(bsdf.geometric_normal, to_light) > 0)))
    return Ending::facing_away;
  light_sample.medium = behind ? at.behind : at.medium;
  if (!light.shines_along(to_light)) return Ending::outside_cone;
  const T distance = light.distance(to_light);
  const Vec3<T> l = to_light * (1 / distance);
  Rgb<T> radiance = light.strength * (1 / light.attenuation(distance));
  if (!light.is_isotropic) radiance *= light.falloff(l);
  if (is_inside(at)) {
    light_sample.contribution = at.throughput * radiance * (pi_v<T> * evaluate(at, l).value);
    return std::nullopt;
  }
  Rgb<T> answers = answers_to_light(at, l, behind);
  if constexpr (dipoles) answers *= leaving(at, l);
  light_sample.contribution = at.throughput * radiance * answers;
  return std::nullopt;
}

template <class Policy>
std::optional<Ending> PathTracer<Policy>::aim_at_emitter(LightSample& light_sample, const Vertex& at) {
  T pick = 0;
  if (emitters_.several()) {
    pick = draw<T>(camera_.sampler(), key_at(at.length, detail::PathDimension::pick), camera_.count());
    statistics_.drew(Effect::indirect_light, 1);
  }
  const Vec2<T> unit =
      draw_pair<T>(camera_.sampler(), key_at(at.length, detail::PathDimension::light), camera_.strata());
  statistics_.drew(Effect::indirect_light, 2);
  auto drawn = emitters_.sample(at.position, pick, unit);
  if (!drawn) return Ending::facing_away;
  inject<Policy>(world_, Fault::emitter_area_forgotten, [&] {
    for (const auto& emitter : emitters_.all())
      if (emitter.primitive == drawn->primitive && emitter.part == drawn->part)
        drawn->pdf *= static_cast<T>(emitter.area);
  });
  light_sample.ray.direction = drawn->to_light;
  light_sample.medium = dot(drawn->to_light, at.bsdf.geometric_normal) < 0 ? at.behind : at.medium;
  const auto answers = evaluate(at, normalize(drawn->to_light));
  if (!(answers.pdf > 0)) return Ending::facing_away;
  light_sample.target = {drawn->primitive, drawn->part};
  light_sample.direction_pdf = answers.pdf;
  light_sample.light_pdf = drawn->pdf;
  if (settings_.strategy == PathStrategy::both) light_sample.weight = power_heuristic(drawn->pdf, answers.pdf);
  [[maybe_unused]] Rgb<T> mapped;
  if constexpr (Policy::effects.maps)
    mapped = world_.emission_at(light_sample.target, at.position, drawn->to_light, at.time);
  const Rgb<T>& emission = Policy::effects.maps ? mapped : world_.surface(drawn->primitive).emission;
  light_sample.contribution = (light_sample.weight / drawn->pdf) * at.throughput * answers.value * emission;
  return std::nullopt;
}

template <class Policy>
std::optional<Ending> PathTracer<Policy>::aim_at_sky(LightSample& light_sample, const Vertex& at) {
  const Vec2<T> unit = draw_pair<T>(camera_.sampler(), key_at(at.length, 0, Effect::sky), camera_.strata());
  statistics_.drew(Effect::sky, 2);
  const auto drawn = world_.sky->sample(Vec2d(unit), settings_.sky);
  if (!drawn) return Ending::facing_away;
  const Vec3<T> direction(drawn->direction);
  light_sample.ray.direction = direction;
  light_sample.medium = dot(direction, at.bsdf.geometric_normal) < 0 ? at.behind : at.medium;
  const auto answers = evaluate(at, renormalize(direction));
  if (!(answers.pdf > 0)) return Ending::facing_away;
  light_sample.direction_pdf = answers.pdf;
  light_sample.light_pdf = static_cast<T>(drawn->pdf);
  if (settings_.strategy == PathStrategy::both)
    light_sample.weight = power_heuristic(light_sample.light_pdf, answers.pdf);
  const Rgb<T> radiance(world_.sky->radiance(drawn->direction));
  light_sample.contribution = (light_sample.weight / light_sample.light_pdf) * at.throughput * answers.value * radiance;
  return std::nullopt;
}

/// The transmittance between the vertex and a sampled emitter.
template <class Policy>
auto PathTracer<Policy>::emitter_transmittance(const LightSample& light_sample, const Hit<T>& hit) const -> Rgb<T> {
  const Surface& met = world_.surface(hit.primitive);
  if (!met.absorbs && (light_sample.medium == nullptr || !light_sample.medium->absorbs)) return Rgb<T>(1);
  const Vec3<T> outward_normal = world_.accelerator.primitives()
                                     .surface_at(hit.primitive, light_sample.ray, Intersection<T>{hit.t, hit.part})
                                     .normal;
  const T distance = hit.t * length(light_sample.ray.direction);
  return transmittance_to_hit(light_sample.medium, met, dot(outward_normal, light_sample.ray.direction) <= 0, distance)
      .value_or(Rgb<T>(1));
}

/// The visibility of the light sample. A light is attenuated as in the tracer. An emitter is visible where it is the
/// first thing that the ray hits, the sky where the ray hits nothing: exactly where BSDF sampling would find them.
template <class Policy>
auto PathTracer<Policy>::find_intersection(const PathRay& ray, const LightSample& light_sample) -> Rgb<T> {
  Rgb<T> visible{0};
  Nearest blocker;
  const bool by_media = media && world_.effects.used(Effect::scattering);
  if (light_sample.light) {
    const T t_max = light_sample.light->t_far();
    visible =
        shadow_transmittance(world_, light_sample.ray, t_max, statistics_.tests, filters_met_, {}, light_sample.medium)
            .value_or(Rgb<T>(0));
  } else if (Policy::effects.sky && is_sky(light_sample) && !by_media) {
    if (!world_.accelerator.occluded(light_sample.ray, infinity<T>, statistics_.tests))
      visible = transmittance_to_nothing<T>(light_sample.medium);
  } else {
    Rgb<T> through{1};
    blocker = by_media ? closest_through_media(light_sample, through)
                       : closest_on_the_way(world_, light_sample.ray, light_sample.target.primitive, statistics_.tests);
    if (blocker && Departure{blocker->primitive, blocker->part} == light_sample.target)
      visible = by_media ? through : emitter_transmittance(light_sample, *blocker);
    if (Policy::effects.sky && !blocker && is_sky(light_sample)) visible = through;
  }
  const Ending ending = is_black(visible) ? Ending::blocked : Ending::reached_light;
  ++statistics_.ends(ending);
  note(Line::path_find_intersection, ray.length, [&] {
    if (light_sample.light && ending == Ending::blocked)
      blocker = first_blocker(world_, light_sample.ray, light_sample.light->t_far());
    if (is_sky(light_sample) && !by_media && ending == Ending::blocked) {
      TestCounts uncounted;
      blocker = world_.accelerator.closest(light_sample.ray, infinity<T>, uncounted);
    }
    Found found = blocker ? detail::describe(light_sample.number, ending, world_, light_sample.ray, *blocker)
                  : light_sample.light ? Found{light_sample.number, ending}
                                       : detail::describe_missed(light_sample.number, ending, world_, light_sample.ray);
    found.transmittance = Rgbd(visible);
    return found;
  });
  return visible;
}

template <class Policy>
void PathTracer<Policy>::add_light(Rgb<T>& shade, const PathRay& ray, const LightSample& light_sample,
                                   const Rgb<T>& visible) {
  const Rgb<T> added = light_sample.contribution * visible;
  shade += added;
  note(Line::add_light, ray.length, [&] {
    return LightAdded{light_sample.light     ? light_sample.light->index
                      : is_sky(light_sample) ? light_of_sky
                                             : -1,
                      light_sample.light || is_sky(light_sample) ? -1 : world_.object(light_sample.target.primitive),
                      static_cast<double>(light_sample.direction_pdf),
                      static_cast<double>(light_sample.light_pdf),
                      static_cast<double>(light_sample.weight),
                      Rgbd(added)};
  });
}

}  // namespace raywalk
