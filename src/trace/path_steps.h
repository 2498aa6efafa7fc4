#pragma once
// What each statement of trace/path.h does, except those about lights (trace/path_light_steps.h) and media
// (trace/path_medium_steps.h). Included by it alone.

#include "trace/flat_ray.h"
#include "trace/path.h"
#include "trace/representable.h"
#include "trace/spawn_ray.h"
#include "trace/tracer.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace detail {

/// The random dimensions at one vertex of a path. Pairs use two.
struct PathDimension {
  static constexpr std::uint32_t direction = 0, lobe = 2, roulette = 3, pick = 4, light = 6;
};

}  // namespace detail

template <class Policy>
struct PathTracer<Policy>::LightSample {
  Ray ray;
  int number;
  const typename World<T>::Light* light;  ///< null: an emitter, or the sky
  Departure target;                       ///< the part of the emitter that should be hit; none of the sky
  Rgb<T> contribution;                    ///< to the pixel, if unoccluded
  T direction_pdf, light_pdf, weight;
  const Medium* medium = nullptr;  ///< that it starts in, if known
};

template <class Policy>
auto PathTracer<Policy>::call(const PathRay& primary) -> std::optional<PathRay> {
  note(Line::follow_path, 0, [&] { return Decided{true, Rgbd(primary.throughput)}; });
  return primary;
}

template <class Policy>
void PathTracer<Policy>::begin(const Pixel& pixel) {
  key_ = camera_.key(pixel, Effect::indirect_light);
  note(Line::path_for_each_pixel, 0, [&] { return PixelBegun{pixel.column, pixel.row, pixel.sample}; });
}

template <class Policy>
auto PathTracer<Policy>::form_primary_ray(const Pixel& pixel) -> PathRay {
  raywalk::Ray<T> from_eye =
      !few_kernels && ahead_ ? ahead_->form(pixel, statistics_) : primary_rays_.form(pixel, statistics_);
  if constexpr (media) {
    if (settings_.flat) from_eye = flattened(from_eye);
  }
  PathRay primary{Ray{from_eye}, RayKind::primary, Rgb<T>(1), 1, 0, rays_formed_++};
  if constexpr (Policy::effects.nesting) {
    if (nested_.any_around_eye()) primary.medium = nested_.at_eye(primary.ray, statistics_.tests);
  }
  if constexpr (media) primary.scattered_at = primary.ray.origin;
  differential_.begin(primary.ray.direction);
  ++statistics_.formed(RayKind::primary);
  note(Line::path_form_primary_ray, 0, [&] {
    return RayFormed{primary.number, -1, RayKind::primary, Vec3d(primary.ray.origin), Vec3d(primary.ray.direction),
                     Rgbd(1.0)};
  });
  return primary;
}

template <class Policy>
bool PathTracer<Policy>::there_is(const std::optional<PathRay>& ray) {
  note(Line::while_ray, ray ? ray->length : 0,
       [&] { return Decided{ray.has_value(), ray ? Rgbd(ray->throughput) : Rgbd(0.0)}; });
  return ray.has_value();
}

template <class Policy>
auto PathTracer<Policy>::find_closest(PathRay& ray, [[maybe_unused]] Free& free) -> Arrival {
  if constexpr (dipoles) {
    if (ray.exit) {
      Arrival at_exit{};
      at_exit.scattered = true;
      ++statistics_.ends(Ending::scattered);
      note(Line::path_find_closest_intersection, ray.length, [&] { return describe_exit(ray); });
      return at_exit;
    }
  }
  Arrival arrival{!few_kernels && ahead_ && ahead_->searched()
                      ? ahead_->closest(ray.ray, statistics_)
                      : world_.accelerator.closest(ray.ray, infinity<T>, statistics_.tests)};
  if constexpr (media) {
    if (scatters_before(ray, free, arrival)) {
      arrival.scattered = true;
      ++statistics_.ends(Ending::scattered);
      note(Line::path_find_closest_intersection, ray.length, [&] { return describe_scattered(ray, free); });
      return arrival;
    }
  }
  ++statistics_.ends(arrival ? Ending::hit : Ending::missed);
  note(Line::path_find_closest_intersection, ray.length, [&] {
    return arrival ? detail::describe(ray.number, Ending::hit, world_, ray.ray, *arrival)
                   : detail::describe_missed(ray.number, Ending::missed, world_, ray.ray);
  });
  return arrival;
}

template <class Policy>
bool PathTracer<Policy>::decide_missed(const PathRay& ray, const Arrival& arrival) {
  bool missed = !arrival;
  if constexpr (media) missed = missed && !arrival.scattered;
  note(Line::if_intersect_nothing, ray.length, [&] { return Decided{missed}; });
  return missed;
}

template <class Policy>
auto PathTracer<Policy>::add_background(const Rgb<T>& shade, const PathRay& ray) -> Rgb<T> {
  if constexpr (Policy::effects.sky)
    if (world_.sky) return add_sky(shade, ray);
  const Rgb<T> added = ray.throughput * transmittance_to_nothing<T>(ray.medium) * world_.background;
  note(Line::add_background, ray.length,
       [&] { return BackgroundAdded{ray.number, Rgbd(world_.background), 0, 0, 1, Rgbd(added)}; });
  return shade + added;
}

/// A sky that light sampling at the previous vertex could have found is weighted against it.
template <class Policy>
auto PathTracer<Policy>::add_sky(const Rgb<T>& shade, const PathRay& ray) -> Rgb<T> {
  const Vec3d direction(ray.ray.direction);
  const Rgb<T> radiance(world_.sky->radiance(direction));
  T light_pdf = 0;
  if (ray.pdf > 0 && settings_.strategy != PathStrategy::directions)
    light_pdf = static_cast<T>(world_.sky->pdf(direction, settings_.sky));
  T weight = 1;
  if (light_pdf > 0) weight = settings_.strategy == PathStrategy::lights ? T(0) : power_heuristic(ray.pdf, light_pdf);
  const Rgb<T> added = weight * ray.throughput * transmittance_to_nothing<T>(ray.medium) * radiance;
  note(Line::add_background, ray.length, [&] {
    return BackgroundAdded{ray.number,
                           Rgbd(radiance),
                           static_cast<double>(ray.pdf),
                           static_cast<double>(light_pdf),
                           static_cast<double>(weight),
                           Rgbd(added)};
  });
  return shade + added;
}

template <class Policy>
auto PathTracer<Policy>::prepare(const PathRay& ray, const Arrival& arrival, [[maybe_unused]] const Free& free)
    -> Vertex {
  if constexpr (dipoles) {
    if (ray.exit) {
      differential_.arrive_inside(ray.exit->distance);
      return leave(ray);
    }
  }
  if constexpr (media) {
    if (arrival.scattered) {
      differential_.arrive_inside(free.length);
      return scatter(ray, free);
    }
    Vertex at = prepare_vertex<Policy>(world_, nested_, ray, *arrival, statistics_, differential_);
    at.seamless = at.surface->seamless && at.refraction.n1 == at.refraction.n2;
    at.scattered_at = ray.scattered_at;
    at.pdf = ray.pdf;
    return at;
  } else {
    return prepare_vertex<Policy>(world_, nested_, ray, *arrival, statistics_, differential_);
  }
}

/// Emission that light sampling at the previous vertex could have found is weighted against it.
template <class Policy>
void PathTracer<Policy>::add_emission(Rgb<T>& shade, const PathRay& ray, const Vertex& at) {
  if (is_inside(at)) return;
  if constexpr (dipoles)
    if (at.left_by != nullptr) return;
  const Rgb<T>& emission = at.values().emission;
  if (is_black(emission) && !Observer::watches) return;
  T light_pdf = 0;
  if (ray.pdf > 0 && !is_black(emission) && settings_.strategy != PathStrategy::directions)
    light_pdf =
        emitters_.pdf(seen_from(ray), at.departure.primitive, at.departure.part, at.position, at.outward_normal);
  T weight = 1;
  if (light_pdf > 0) weight = settings_.strategy == PathStrategy::lights ? T(0) : power_heuristic(ray.pdf, light_pdf);
  inject<Policy>(world_, Fault::emission_not_weighted, [&] { weight = 1; });
  const Rgb<T> added = weight * at.throughput * emission;
  shade += added;
  note(Line::add_emission, ray.length, [&] {
    return EmissionAdded{ray.number,
                         Rgbd(emission),
                         static_cast<double>(ray.pdf),
                         static_cast<double>(light_pdf),
                         static_cast<double>(weight),
                         Rgbd(added)};
  });
}

template <class Policy>
auto PathTracer<Policy>::choose_direction(const PathRay& ray, const Vertex& at) -> std::optional<BsdfSample> {
  const bool last = settings_.max_length > 0 && ray.length + 1 > settings_.max_length;
  std::optional<BsdfSample> choice;
  if (is_inside(at)) {
    if constexpr (media)
      if (!absorbs(at) && !last) choice = sample_phase(at);
  } else if (!at.bsdf.absorbs() && !last) {
    T u = 0;
    if (at.bsdf.several()) {
      u = draw<T>(camera_.sampler(), key_at(at.length, detail::PathDimension::lobe), camera_.count());
      statistics_.drew(Effect::indirect_light, 1);
    }
    const Lobe lobe = at.bsdf.sample_lobe(u);
    Vec2<T> unit(0);
    if (at.bsdf.needs_direction(lobe)) {
      const Effect effect = detail::effect_of(lobe, at.bsdf.by_facets());
      unit = draw_pair<T>(camera_.sampler(), key_at(at.length, detail::PathDimension::direction, effect),
                          camera_.strata());
      statistics_.drew(effect, 2);
    }
    choice = at.bsdf.sample(lobe, unit, u);
    inject<Policy>(world_, Fault::cosine_counted_twice, [&] {
      if (lobe == Lobe::diffuse) choice->weight *= std::abs(dot(at.bsdf.shading_normal, choice->direction));
    });
    if constexpr (dipoles) {
      choice->weight *= leaving(at, choice->direction);
      lead_to_exit(at, choice);
    }
    if (choice && is_black(choice->weight)) choice.reset();
  }
  note(Line::choose_direction, ray.length, [&] {
    if (!choice) return DirectionChosen{true};
    return DirectionChosen{false, choice->lobe, Vec3d(choice->direction), static_cast<double>(choice->pdf),
                           Rgbd(at.throughput * choice->weight)};
  });
  return choice;
}

/// The probability with which the path continues, or 0 when it has ended.
template <class Policy>
auto PathTracer<Policy>::decide_survival(const PathRay& ray, const Vertex& at, const std::optional<BsdfSample>& choice)
    -> T {
  T survival = 0;
  std::optional<Ending> why;
  if (settings_.max_length > 0 && ray.length + 1 > settings_.max_length && !absorbs(at)) {
    why = Ending::path_length;
  } else if (choice) {
    survival = 1;
    if (ray.length >= settings_.roulette_from) {
      // So that every path terminates. Inside of a medium it gets out some time; few are the paths that go far, and
      // these must not count for many.
      const T most = is_inside(at) ? T(1) : static_cast<T>(detail::surest);
      survival = std::min(max_component(at.throughput * choice->weight), most);
      const T u = draw<T>(camera_.sampler(), key_at(at.length, detail::PathDimension::roulette), camera_.count());
      statistics_.drew(Effect::indirect_light, 1);
      if (!(u < survival)) survival = 0, why = Ending::threshold;
    }
  }
  if (why) ++statistics_.ends(*why);
  note(Line::if_path_survives, ray.length,
       [&] { return SurvivalDecided{survival > 0, static_cast<double>(survival), why}; });
  return survival;
}

template <class Policy>
auto PathTracer<Policy>::form_next_ray(const Vertex& at, const BsdfSample& choice, T survival) -> PathRay {
  stop_.check();
  const RayKind kind = choice.lobe == Lobe::transparent ? RayKind::refract : RayKind::reflect;
  PathRay next{spawn(at, choice.direction),
               kind,
               at.throughput * choice.weight * (1 / survival),
               at.length + 1,
               choice.pdf,
               rays_formed_++,
               kind == RayKind::refract ? at.behind : at.medium};
  differential_.leave(at.bsdf, at.refraction, choice);
  if constexpr (media) {
    next.scattered_at = next.ray.origin;
    if (at.seamless && kind == RayKind::refract) next.scattered_at = at.scattered_at, next.pdf = at.pdf;
  }
  if constexpr (dipoles) next.exit = choice.exit;
  ++statistics_.formed(kind);
  note(Line::form_next_ray, at.length, [&] {
    RayFormed event{next.number,          at.number, kind, Vec3d(next.ray.origin), Vec3d(choice.direction),
                    Rgbd(next.throughput)};
    bool bends = kind == RayKind::refract;
    if constexpr (dipoles) bends = bends && !choice.exit;
    if (bends) event.snell = snell_numbers(at, choice.direction);
    return event;
  });
  return next;
}

template <class Policy>
template <class Put>
void PathTracer<Policy>::put_in_pixel(const Pixel& pixel, const Rgb<T>& final, Put& put) {
  if (!is_representable(final)) ++statistics_.not_finite;
  put(pixel, final);
  note(Line::path_put_final_shade, 0, [&] { return PixelPut{pixel.column, pixel.row, pixel.sample, Rgbd(final)}; });
}

}  // namespace raywalk
