#pragma once
// What the statements of trace/photons.h about pixels do. Included by it alone.

#include "trace/flat_ray.h"
#include "trace/photon_steps.h"
#include "trace/shadow_transmittance.h"

namespace raywalk {

template <class Policy>
struct PhotonTracer<Policy>::LightSample {
  Ray ray;
  int number;
  const Light* light;              ///< null: an emitter, or what lies around the scene
  Departure target;                ///< the part of the emitter that should be hit; primitive -1: none
  Rgb<T> contribution;             ///< to the pixel, if unoccluded
  bool endless = false;            ///< to what lies around the scene
  const Medium* medium = nullptr;  ///< that it starts in, and is visible in only, if known
};

template <class Policy>
void PhotonTracer<Policy>::begin(const Pixel& pixel) {
  key_ = camera_.key(pixel, Effect::indirect_light);
  pass_ = settings_.progressive ? static_cast<std::size_t>(pixel.sample - first_pass_) : 0;
  note(Line::photon_for_each_pixel, 0, [&] { return PixelBegun{pixel.column, pixel.row, pixel.sample}; });
}

template <class Policy>
auto PhotonTracer<Policy>::form_primary_ray(const Pixel& pixel) -> EyeRay {
  raywalk::Ray<T> ray = camera_.primary_ray(pixel, pixel_draws_, statistics_);
  if (settings_.flat) ray = flattened(ray);
  EyeRay primary{Ray{ray}, RayKind::primary, Rgb<T>(1), 1, rays_formed_++};
  if constexpr (Policy::effects.nesting) {
    if (nested_.any_around_eye()) primary.medium = nested_.at_eye(primary.ray, statistics_.tests);
  }
  differential_.begin(primary.ray.direction);
  ++statistics_.formed(RayKind::primary);
  note(Line::photon_form_primary_ray, 0, [&] {
    return RayFormed{primary.number, -1, RayKind::primary, Vec3d(primary.ray.origin), Vec3d(primary.ray.direction),
                     Rgbd(1.0)};
  });
  return primary;
}

template <class Policy>
auto PhotonTracer<Policy>::call(const EyeRay& primary) -> std::optional<EyeRay> {
  note(Line::gather_light, 0, [&] { return Decided{true, Rgbd(primary.throughput)}; });
  return primary;
}

template <class Policy>
bool PhotonTracer<Policy>::there_is(const std::optional<EyeRay>& ray) {
  note(Line::gather_while_ray, ray ? ray->length : 0,
       [&] { return Decided{ray.has_value(), ray ? Rgbd(ray->throughput) : Rgbd(0.0)}; });
  return ray.has_value();
}

template <class Policy>
auto PhotonTracer<Policy>::find_closest(const EyeRay& ray) -> Nearest {
  const Nearest nearest = world_.accelerator.closest(ray.ray, infinity<T>, statistics_.tests);
  ++statistics_.ends(nearest ? Ending::hit : Ending::missed);
  note(Line::gather_find_closest_intersection, ray.length, [&] {
    return nearest ? detail::describe(ray.number, Ending::hit, world_, ray.ray, *nearest)
                   : detail::describe_missed(ray.number, Ending::missed, world_, ray.ray);
  });
  return nearest;
}

template <class Policy>
bool PhotonTracer<Policy>::decide_missed(const EyeRay& ray, const Nearest& nearest) {
  note(Line::gather_if_intersect_nothing, ray.length, [&] { return Decided{!nearest}; });
  return !nearest;
}

/// From a diffuse surface on, shadow rays and the caustic map have brought this light already.
template <class Policy>
auto PhotonTracer<Policy>::add_background(const Rgb<T>& shade, const EyeRay& ray) -> Rgb<T> {
  const Rgb<T> radiance = lights_.environment(ray.ray.direction);
  const Rgb<T> added = ray.gathers ? Rgb<T>(0) : ray.throughput * transmittance_to_nothing<T>(ray.medium) * radiance;
  note(Line::gather_add_background, ray.length,
       [&] { return BackgroundAdded{ray.number, Rgbd(radiance), 0, 0, ray.gathers ? 0.0 : 1.0, Rgbd(added)}; });
  return shade + added;
}

template <class Policy>
void PhotonTracer<Policy>::add_emission(Rgb<T>& shade, const EyeRay& ray, const Vertex& at) {
  const Rgb<T>& emission = at.values().emission;
  const Rgb<T> added = ray.gathers ? Rgb<T>(0) : at.throughput * emission;
  shade += added;
  note(Line::gather_add_emission, ray.length,
       [&] { return EmissionAdded{ray.number, Rgbd(emission), 0, 0, ray.gathers ? 0.0 : 1.0, Rgbd(added)}; });
}

/// All lights of the scene, one sample of all emitters together, and one of what lies around. Highlights are those of
/// lights only: of all else, rays in the lobe find them.
template <class Policy>
int PhotonTracer<Policy>::light_count_at(const EyeRay& ray, const Vertex& at) const {
  if (ray.gathers) return 0;
  const bool diffuse = !is_black(at.bsdf.diffuse);
  const int lamps =
      diffuse || !is_black(at.specular) || at.bsdf.by_facets() ? static_cast<int>(world_.lights.size()) : 0;
  if (!diffuse) return lamps;
  return lamps + (lights_.has_emitters() ? 1 : 0) + (lights_.has_environment() ? 1 : 0);
}

template <class Policy>
auto PhotonTracer<Policy>::form_shadow_ray(const EyeRay& ray, const Vertex& at, int index)
    -> std::optional<LightSample> {
  if (static_cast<std::size_t>(index) % few_lights == few_lights - 1) stop_.check();
  const int lamps = static_cast<int>(world_.lights.size());
  const Light* light = index < lamps ? &world_.lights[static_cast<std::size_t>(index)] : nullptr;
  const bool endless = index >= lamps + (lights_.has_emitters() ? 1 : 0);
  const int shown = light ? light->index : endless ? light_of_sky : -1;
  LightSample light_sample{Ray{raywalk::Ray<T>{}}, 0, light, {}, Rgb<T>(0), endless};
  const std::optional<Ending> why_not = light     ? aim_at_light(light_sample, at)
                                        : endless ? aim_at_environment(light_sample, at)
                                                  : aim_at_emitter(light_sample, at);
  if (why_not) {
    ++statistics_.ends(*why_not);
    note(Line::gather_form_shadow_ray, ray.length, [&] {
      return RayNotFormed{ray.number,
                          RayKind::shadow,
                          *why_not,
                          Vec3d(at.position),
                          Vec3d(light_sample.ray.direction),
                          Rgbd(at.throughput),
                          shown};
    });
    return std::nullopt;
  }
  light_sample.ray =
      spawn_ray<Ray>(world_, at.position, at.outward_normal, at.departure, light_sample.ray.direction, at.time);
  light_sample.medium = dot(light_sample.ray.direction, at.bsdf.geometric_normal) < 0 ? at.behind : at.medium;
  light_sample.number = rays_formed_++;
  ++statistics_.formed(RayKind::shadow);
  note(Line::gather_form_shadow_ray, ray.length, [&] {
    return RayFormed{light_sample.number,
                     ray.number,
                     RayKind::shadow,
                     Vec3d(light_sample.ray.origin),
                     Vec3d(light_sample.ray.direction),
                     Rgbd(at.throughput),
                     shown,
                     light ? !light->is_distant : !endless};
  });
  return light_sample;
}

/// A light contributes as in the tracer: its strength times kd cos and ks (n.h)^s; behind rough glass, what that
/// transmits.
template <class Policy>
std::optional<Ending> PhotonTracer<Policy>::aim_at_light(LightSample& light_sample, const Vertex& at) {
  const Light& light = *light_sample.light;
  Vec3<T>& to_light = light_sample.ray.direction;
  Vec3<T> point = light.place;
  if (!light.is_delta) {
    const RandomKey key = key_at(at.length, light.first_dimension, Effect::penumbra);
    const Vec2<T> unit = draw_pair<T>(camera_.sampler(), key, camera_.strata());
    statistics_.drew(Effect::penumbra, 2);
    point = settings_.flat ? lights_.point_in_plane(light, unit) : light.sample(unit);
  }
  to_light = light.direction_to(point, at.position);
  const auto& bsdf = at.bsdf;
  const bool behind = bsdf.is_behind_glass(to_light);
  if (!behind && (!(dot(bsdf.shading_normal, to_light) > 0) || !(dot(bsdf.geometric_normal, to_light) > 0)))
    return Ending::facing_away;
  if (!light.shines_along(to_light)) return Ending::outside_cone;
  const T distance = light.distance(to_light);
  const Vec3<T> l = to_light * (1 / distance);
  Rgb<T> radiance = light.strength * (1 / light.attenuation(distance));
  if (!light.is_isotropic) radiance *= light.falloff(l);
  const Rgb<T> answers = answers_to_light(at, l, behind);
  light_sample.contribution = at.throughput * radiance * answers;
  return std::nullopt;
}

/// The diffuse lobe alone.
template <class Policy>
std::optional<Ending> PhotonTracer<Policy>::aim_at_emitter(LightSample& light_sample, const Vertex& at) {
  const T pick = draw<T>(camera_.sampler(), key_at(at.length, detail::PhotonDimension::pick), camera_.count());
  const Vec2<T> unit =
      draw_pair<T>(camera_.sampler(), key_at(at.length, detail::PhotonDimension::light), camera_.strata());
  statistics_.drew(Effect::indirect_light, 3);
  Vec3<T>& to_light = light_sample.ray.direction;
  T pdf = 0;  // per solid angle, or angle
  if (settings_.flat) {
    const auto point = lights_.sample_emitter(pick, unit.x);
    if (!point) return Ending::facing_away;
    to_light = point->point - at.position;
    const T distance = length(to_light);
    pdf = point->pdf * distance * distance / std::abs(dot(to_light, point->normal));
    light_sample.target = point->departure;
  } else {
    const auto point = emitters_.sample(at.position, pick, unit);
    if (!point) return Ending::facing_away;
    to_light = point->to_light;
    pdf = point->pdf;
    light_sample.target = {point->primitive, point->part};
  }
  const T cos = dot(at.bsdf.shading_normal, to_light) / length(to_light);
  if (!(cos > 0) || !(dot(at.bsdf.geometric_normal, to_light) > 0) || !(pdf > 0)) return Ending::facing_away;
  [[maybe_unused]] Rgb<T> mapped;
  if constexpr (Policy::effects.maps) mapped = world_.emission_at(light_sample.target, at.position, to_light, at.time);
  const Rgb<T>& emission = Policy::effects.maps ? mapped : world_.surface(light_sample.target.primitive).emission;
  if constexpr (Policy::effects.microfacets) {
    if (at.bsdf.matt != nullptr) {
      const Rgb<T> answer = at.bsdf.diffuse_answer(to_light * (1 / length(to_light)), cos);
      light_sample.contribution = (1 / (cosines() * pdf)) * at.throughput * answer * emission;
      return std::nullopt;
    }
  }
  light_sample.contribution = (cos / (cosines() * pdf)) * at.throughput * at.bsdf.diffuse * emission;
  return std::nullopt;
}

/// The diffuse lobe alone: a sky is aimed at by its brightness, a background by the cosine.
template <class Policy>
std::optional<Ending> PhotonTracer<Policy>::aim_at_environment(LightSample& light_sample, const Vertex& at) {
  const Vec2<T> unit =
      draw_pair<T>(camera_.sampler(), key_at(at.length, detail::PhotonDimension::environment), camera_.strata());
  statistics_.drew(Effect::sky, 2);
  Vec3<T>& direction = light_sample.ray.direction;
  if (world_.sky && !settings_.flat) {
    const auto drawn = world_.sky->sample(Vec2d(unit));
    if (!drawn) return Ending::facing_away;
    direction = Vec3<T>(drawn->direction);
    const T cos = dot(at.bsdf.shading_normal, direction);
    if (!(cos > 0) || !(dot(at.bsdf.geometric_normal, direction) > 0)) return Ending::facing_away;
    if constexpr (Policy::effects.microfacets) {
      if (at.bsdf.matt != nullptr) {
        light_sample.contribution = static_cast<T>(1 / (static_cast<double>(pi_v<T>) * drawn->pdf)) * at.throughput *
                                    at.bsdf.diffuse_answer(renormalize(direction), cos) *
                                    Rgb<T>(world_.sky->radiance(drawn->direction));
        return std::nullopt;
      }
    }
    light_sample.contribution = static_cast<T>(static_cast<double>(cos) / (static_cast<double>(pi_v<T>) * drawn->pdf)) *
                                at.throughput * at.bsdf.diffuse * Rgb<T>(world_.sky->radiance(drawn->direction));
    return std::nullopt;
  }
  const BsdfSample choice = sample_alone(at.bsdf, Lobe::diffuse, unit);
  direction = choice.direction;
  if (is_black(choice.weight)) return Ending::facing_away;
  light_sample.contribution = at.throughput * choice.weight * lights_.environment(direction);
  return std::nullopt;
}

/// The visibility of the sample. Everything blocks a light, glass too: what passes glass comes as photons. So all the
/// way is in one medium.
template <class Policy>
auto PhotonTracer<Policy>::find_intersection(const EyeRay& ray, const LightSample& light_sample) -> Rgb<T> {
  bool visible = false;
  Nearest blocker;
  if (light_sample.light) {
    visible = !world_.accelerator.occluded(light_sample.ray, light_sample.light->t_far(), statistics_.tests);
  } else {
    blocker = closest_on_the_way(world_, light_sample.ray, light_sample.target.primitive, statistics_.tests);
    visible = light_sample.endless ? !blocker
                                   : blocker && Departure{blocker->primitive, blocker->part} == light_sample.target;
  }
  const Ending ending = visible ? Ending::reached_light : Ending::blocked;
  ++statistics_.ends(ending);
  const Rgb<T> transmittance = visible ? transmittance_to(light_sample) : Rgb<T>(0);
  note(Line::gather_find_intersection, ray.length, [&] {
    TestCounts uncounted;
    if (light_sample.light && !visible)
      blocker = world_.accelerator.closest(light_sample.ray, light_sample.light->t_far(), uncounted);
    Found found = blocker ? detail::describe(light_sample.number, ending, world_, light_sample.ray, *blocker)
                  : light_sample.light ? Found{light_sample.number, ending}
                                       : detail::describe_missed(light_sample.number, ending, world_, light_sample.ray);
    if (visible) found.transmittance = Rgbd(transmittance);
    return found;
  });
  return transmittance;
}

/// Of the medium between a surface and a light that it sees.
template <class Policy>
auto PhotonTracer<Policy>::transmittance_to(const LightSample& light_sample) const -> Rgb<T> {
  const bool far = light_sample.light ? light_sample.light->is_distant : light_sample.endless;
  if (far) return transmittance_to_nothing<T>(light_sample.medium);
  if (light_sample.medium == nullptr || !light_sample.medium->absorbs) return Rgb<T>(1);
  return beer_lambert(light_sample.medium->extinction, length(light_sample.ray.direction));
}

template <class Policy>
void PhotonTracer<Policy>::add_light(Rgb<T>& shade, const EyeRay& ray, const LightSample& light_sample,
                                     const Rgb<T>& visible) {
  const Rgb<T> added = is_black(visible) ? Rgb<T>(0) : light_sample.contribution * visible;
  shade += added;
  note(Line::gather_add_light, ray.length, [&] {
    return LightAdded{light_sample.light     ? light_sample.light->index
                      : light_sample.endless ? light_of_sky
                                             : -1,
                      light_sample.light || light_sample.endless ? -1 : world_.object(light_sample.target.primitive),
                      0,
                      0,
                      1,
                      Rgbd(added)};
  });
}

template <class Policy>
PhotonCircle PhotonTracer<Policy>::circle_of(const PhotonMap& map, const Vertex& at, PhotonsFound& found) const {
  if (map.empty()) return {};
  const double squared = settings_.squared_radius(static_cast<int>(pass_) + first_pass_);
  PhotonAnswer answer;
  if constexpr (Policy::effects.microfacets) {
    if (const RoughDiffuse<T>* matt = at.bsdf.matt)
      answer = [matt, bsdf = &at.bsdf](const Photon& photon, const Vec3<float>& incident) {
        return Rgbd(photon.power) *
               Rgbd(matt->value(bsdf->diffuse, bsdf->shading_normal, -bsdf->incident, -Vec3<T>(incident)));
      };
  }
  std::optional<Vec3d> side = found.normal;
  inject<Policy>(world_, Fault::photons_from_behind, [&] { side.reset(); });
  const PhotonsNear near = settings_.progressive
                               ? map.within(found.position, side, std::sqrt(squared), answer)
                               : map.nearest(found.position, side, settings_.nearest, settings_.radius, answer);
  if (!(near.squared_radius > 0) || std::isinf(near.squared_radius)) return {};
  const double density = photon_density(near.squared_radius, settings_.flat);
  if (answer) found.answered = found.answered.value_or(Rgbd(0.0)) + near.answered * density;
  const bool at_limit = settings_.progressive || near.squared_radius == settings_.radius * settings_.radius;
  return {std::sqrt(near.squared_radius), near.count, near.power, near.power * density, at_limit};
}

/// Caustics, where the surface is seen from the eye; other light there, or where final gathering ends.
template <class Policy>
PhotonsFound PhotonTracer<Policy>::find_nearest_photons(const EyeRay& ray, const Vertex& at) {
  PhotonsFound found{ray.number, Vec3d(at.position), Vec3d(at.bsdf.geometric_normal), {}, {}, settings_.flat, {}};
  if (!is_black(at.bsdf.diffuse) && pass_ < maps_.size()) {
    const PhotonMaps& maps = maps_[pass_];
    if (!ray.gathers) found.caustic = circle_of(maps.caustic, at, found);
    if (ray.gathers || !settings_.gather) found.other = circle_of(maps.other, at, found);
  }
  note(Line::find_nearest_photons, ray.length, [&] { return found; });
  return found;
}

template <class Policy>
void PhotonTracer<Policy>::add_light_of_photons(Rgb<T>& shade, const EyeRay& ray, const Vertex& at,
                                                const PhotonsFound& photons) {
  const Rgbd irradiance = photons.caustic.irradiance + photons.other.irradiance;
  Rgb<T> added = at.throughput * at.bsdf.diffuse * Rgb<T>(irradiance) * (1 / cosines());
  if constexpr (Policy::effects.microfacets)
    if (photons.answered) added = at.throughput * Rgb<T>(*photons.answered) * (1 / cosines());
  inject<Policy>(world_, Fault::pi_forgotten, [&] { added *= cosines(); });
  shade += added;
  note(Line::add_light_of_photons, ray.length,
       [&] { return PhotonsAdded{ray.number, irradiance, Rgbd(at.bsdf.diffuse), settings_.flat, Rgbd(added)}; });
}

/// By mirrors, glass and highlights; with final gathering, once from a diffuse surface too.
template <class Policy>
auto PhotonTracer<Policy>::choose_direction(const EyeRay& ray, const Vertex& at) -> std::optional<BsdfSample> {
  auto bsdf = at.bsdf;
  if (ray.gathers || !settings_.gather) {
    bsdf.diffuse = Rgb<T>(0);
    bsdf.prepare(at.throughput);
  }
  std::optional<BsdfSample> choice;
  if (!bsdf.absorbs()) {
    T u = 0;
    if (bsdf.several()) {
      u = draw<T>(camera_.sampler(), key_at(at.length, detail::PhotonDimension::lobe), camera_.count());
      statistics_.drew(Effect::indirect_light, 1);
    }
    const Lobe lobe = bsdf.sample_lobe(u);
    Vec2<T> unit(0);
    if (bsdf.needs_direction(lobe)) {
      const Effect effect = detail::effect_of(lobe, bsdf.by_facets());
      unit = draw_pair<T>(camera_.sampler(), key_at(at.length, detail::PhotonDimension::direction, effect),
                          camera_.strata());
      statistics_.drew(effect, 2);
    }
    choice = sample_alone(bsdf, lobe, unit, u);
    choice->weight *= 1 / bsdf.probability_of_choice(lobe);
    if (is_black(choice->weight)) choice.reset();
  }
  note(Line::gather_choose_direction, ray.length, [&] {
    if (!choice) return DirectionChosen{true};
    return DirectionChosen{false, choice->lobe, Vec3d(choice->direction), static_cast<double>(choice->pdf),
                           Rgbd(at.throughput * choice->weight)};
  });
  return choice;
}

/// The probability with which the ray continues, or 0 when it has ended.
template <class Policy>
auto PhotonTracer<Policy>::decide_survival(const EyeRay& ray, const Vertex& at, const std::optional<BsdfSample>& choice)
    -> T {
  // Later than of paths (PathSettings): few rays go on here, off mirrors and through glass, and an end is seen as
  // noise.
  constexpr int roulette_from = 8;
  T survival = choice ? 1 : 0;
  std::optional<Ending> why;
  if (choice && ray.length >= roulette_from) {
    survival = std::min(max_component(at.throughput * choice->weight), static_cast<T>(detail::surest));
    const T u = draw<T>(camera_.sampler(), key_at(at.length, detail::PhotonDimension::roulette), camera_.count());
    statistics_.drew(Effect::indirect_light, 1);
    if (!(u < survival)) survival = 0, why = Ending::threshold;
  }
  if (why) ++statistics_.ends(*why);
  note(Line::gather_if_path_survives, ray.length,
       [&] { return SurvivalDecided{survival > 0, static_cast<double>(survival), why}; });
  return survival;
}

template <class Policy>
auto PhotonTracer<Policy>::form_next_ray(const EyeRay& ray, const Vertex& at, const BsdfSample& choice, T survival)
    -> EyeRay {
  stop_.check();
  const RayKind kind = choice.lobe == Lobe::transparent ? RayKind::refract : RayKind::reflect;
  const EyeRay next{spawn_ray<Ray>(world_, at.position, at.outward_normal, at.departure, choice.direction, at.time),
                    kind,
                    at.throughput * choice.weight * (1 / survival),
                    at.length + 1,
                    rays_formed_++,
                    ray.gathers || choice.lobe == Lobe::diffuse,
                    kind == RayKind::refract ? at.behind : at.medium};
  differential_.leave(at.bsdf, at.refraction, choice);
  ++statistics_.formed(kind);
  note(Line::gather_form_next_ray, at.length, [&] {
    RayFormed event{next.number,          at.number, kind, Vec3d(next.ray.origin), Vec3d(choice.direction),
                    Rgbd(next.throughput)};
    if (kind == RayKind::refract) event.snell = snell_numbers(at, choice.direction);
    return event;
  });
  return next;
}

template <class Policy>
template <class Put>
void PhotonTracer<Policy>::put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put) {
  if (!is_representable(final)) ++statistics_.not_finite;
  put(pixel, final);
  note(Line::photon_put_final_shade, 0, [&] { return PixelPut{pixel.column, pixel.row, pixel.sample, Rgbd(final)}; });
}

}  // namespace raywalk
