#pragma once
// What the statements of trace/photons.h about photons do; those about what the eye sees stand in trace/gather_steps.h.
// Included by it alone.

#include "trace/photons.h"
#include "trace/representable.h"
#include "trace/spawn_ray.h"
#include "trace/tracer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raywalk {

namespace detail {

/// The random dimensions where a ray of photon mapping ends. Pairs use two.
struct PhotonDimension {
  static constexpr std::uint32_t direction = 0, lobe = 2, roulette = 3, pick = 4, light = 5, environment = 7;
};
/// Where no pixel is: the keys of photons.
inline constexpr std::int32_t pixel_of_photons = std::numeric_limits<std::int32_t>::min();

}  // namespace detail

template <class Policy>
void PhotonTracer<Policy>::begin(int photon, int pass) {
  stop_.check();
  key_ = {settings_.seed, detail::pixel_of_photons, pass, static_cast<std::uint32_t>(photon)};
  note(Line::for_each_photon, 0, [&] { return PhotonBegun{photon, settings_.count}; });
}

template <class Policy>
auto PhotonTracer<Policy>::emit_photon() -> PhotonRay {
  T u[PhotonLights<T>::draws];
  for (std::uint32_t i = 0; i < PhotonLights<T>::draws; ++i) u[i] = random_unit<T>(key_at(0, i));
  statistics_.drew(Effect::indirect_light, PhotonLights<T>::draws);
  const EmittedPhoton<T> emitted = lights_.emit(u);
  T time = camera_.shutter_open();
  if (camera_.moves()) {
    time = camera_.time_after(random_unit<T>(key_at(0, 0, Effect::motion_blur)));
    statistics_.drew(Effect::motion_blur, 1);
  }
  const raywalk::Ray<T> ray{emitted.origin, emitted.direction, emitted.departure, time};
  PhotonRay photon{
      Ray{ray},    emitted.power * (1 / static_cast<T>(settings_.count)), 1, rays_formed_++, PhotonHistory::direct,
      emitted.lamp};
  if constexpr (Policy::effects.nesting) photon.medium = nested_.at_start(photon.ray, statistics_.tests);
  inject<Policy>(world_, Fault::power_of_another_pass, [&] { photon.throughput *= T(2); });
  if constexpr (std::is_same_v<Ray, NaiveRay<T>>) {
    // Off the emitter, along the ray itself: at a flat angle it stays nearer than what spawn_ray forms.
    if (emitted.departure.primitive >= 0) photon.ray.origin += world_.epsilon * emitted.direction;
  }
  ++statistics_.formed(RayKind::photon);
  note(Line::emit_photon, 0, [&] {
    RayFormed formed{photon.number,          -1, RayKind::photon, Vec3d(photon.ray.origin), Vec3d(photon.ray.direction),
                     Rgbd(photon.throughput)};
    formed.light = emitted.light;
    return formed;
  });
  return photon;
}

template <class Policy>
auto PhotonTracer<Policy>::call(const PhotonRay& emitted) -> std::optional<PhotonRay> {
  note(Line::follow_photon, 0, [&] { return Decided{true, Rgbd(emitted.throughput)}; });
  if (is_black(emitted.throughput)) return std::nullopt;
  return emitted;
}

template <class Policy>
bool PhotonTracer<Policy>::there_is(const std::optional<PhotonRay>& photon) {
  note(Line::while_photon, photon ? photon->length : 0,
       [&] { return Decided{photon.has_value(), photon ? Rgbd(photon->throughput) : Rgbd(0.0)}; });
  return photon.has_value();
}

template <class Policy>
auto PhotonTracer<Policy>::find_closest(const PhotonRay& photon) -> Nearest {
  const Nearest nearest = world_.accelerator.closest(photon.ray, infinity<T>, statistics_.tests);
  ++statistics_.ends(nearest ? Ending::hit : Ending::missed);
  note(Line::photon_find_closest_intersection, photon.length, [&] {
    return nearest ? detail::describe(photon.number, Ending::hit, world_, photon.ray, *nearest)
                   : detail::describe_missed(photon.number, Ending::missed, world_, photon.ray);
  });
  return nearest;
}

/// The hit, ready to scatter the photon; its throughput is the power that arrives, by the law of the lamp over the
/// whole way from it.
template <class Policy>
auto PhotonTracer<Policy>::arrive(const PhotonRay& photon, const Hit<T>& hit) -> Vertex {
  NoDifferential<T> none;
  Vertex at = prepare_vertex<Policy>(world_, nested_, photon, hit, statistics_, none);
  take_flat(at);
  if (photon.lamp) {
    at.throughput *= lights_.weight_at(*photon.lamp, photon.travelled + hit.t);
    if (photon.travelled > 0) at.throughput *= 1 / lights_.weight_at(*photon.lamp, photon.travelled);
  }
  return at;
}

template <class Policy>
bool PhotonTracer<Policy>::decide_diffuse(const PhotonRay& photon, const Vertex& at) {
  const bool diffuse = !is_black(at.bsdf.diffuse);
  note(Line::if_diffuse, photon.length, [&] { return Decided{diffuse, Rgbd(at.bsdf.diffuse)}; });
  return diffuse;
}

/// On the side that it came from. Straight from a source it is kept only where final gathering asks for all light.
template <class Policy>
void PhotonTracer<Policy>::store_photon(const PhotonRay& photon, const Vertex& at) {
  const Photon stored{Vec3<float>(at.position), Vec3<float>(at.bsdf.geometric_normal), Rgb<float>(at.throughput)};
  const bool of_caustic = photon.history == PhotonHistory::caustic;
  const bool of_other = photon.history == PhotonHistory::indirect || settings_.gather;
  if (of_caustic) caustic_photons_.photons.push_back(stored);
  if (of_other) other_photons_.photons.push_back(stored);
  if constexpr (Policy::effects.microfacets) {
    if (world_.has_rough_diffuse && !settings_.flat) {
      const Vec3<float> incident(at.bsdf.incident);
      if (of_caustic) caustic_photons_.incidents.push_back(incident);
      if (of_other) other_photons_.incidents.push_back(incident);
    }
  }
  note(Line::store_photon, photon.length, [&] {
    return PhotonStored{photon.number,       Vec3d(at.position), Vec3d(at.bsdf.geometric_normal),
                        Rgbd(at.throughput), photon.history,     of_caustic || of_other};
  });
}

/// What light loses or wins as power when it goes from the photon's way on along `direction`, where the lobe is sampled
/// as if it were followed from the eye (E. Veach, thesis, 1997, chapter 5).
template <class Policy>
auto PhotonTracer<Policy>::adjoint(const Vertex& at, Lobe lobe, const Vec3<T>& direction) const -> T {
  const Vec3<T>&geometric = at.bsdf.geometric_normal, &shading = at.bsdf.shading_normal;
  const auto cos_in = [&](const Vec3<T>& normal) { return std::abs(dot(at.bsdf.incident, normal)); };
  const auto cos_out = [&](const Vec3<T>& normal) { return std::abs(dot(direction, normal)); };
  // Of a scattering function that is the same both ways, about the shading normal.
  const auto both_ways = [&] {
    if (shading == geometric) return T(1);
    return cos_in(shading) * cos_out(geometric) / (cos_in(geometric) * cos_out(shading));
  };
  switch (lobe) {
    case Lobe::diffuse:
      return both_ways();
    case Lobe::highlight:
      return cos_out(geometric) / cos_in(geometric);
    case Lobe::mirror:
      if (at.bsdf.by_facets()) return both_ways();
      return at.bsdf.mirror_width > 0 ? cos_out(geometric) / cos_in(geometric) : T(1);
    case Lobe::transparent: {
      const T ratio = at.refraction.n1 / at.refraction.n2, bent = settings_.flat ? ratio : ratio * ratio;
      if (at.bsdf.by_facets()) return bent * both_ways();
      if (at.bsdf.transparent_width == 0) return bent;
      return bent * cos_out(geometric) / std::abs(dot(at.bsdf.transparent_axis, geometric));
    }
    case Lobe::phase:
      break;
  }
  return 1;
}

/// An eye sees through translucent glass what lies in a cone about its refracted ray. To be seen by it, a photon turns
/// on its own side, into any direction of such a cone about where it came from, and that is refracted.
template <class Policy>
auto PhotonTracer<Policy>::bent_translucently(const Vertex& at, const Vec2<T>& unit) const -> BsdfSample {
  const Vec3<T>&geometric = at.bsdf.geometric_normal, &shading = at.bsdf.shading_normal;
  const auto folded = [&](const Vec3<T>& along) { return along - 2 * dot(along, geometric) * geometric; };
  const auto into_plane = [&](Vec3<T> along) {
    if (settings_.flat) along.z = 0;
    return normalize(along);
  };
  BsdfSample choice{Lobe::transparent, at.bsdf.transparent_axis, Rgb<T>(0),
                    uniform_cone_pdf(at.bsdf.transparent_width)};
  Vec3<T> turned =
      into_plane(Basis<T>(at.bsdf.incident).to_world(sample_uniform_cone(unit, at.bsdf.transparent_width)));
  if (!(dot(turned, geometric) < 0)) turned = folded(turned);
  const Refraction<T> bends = refraction_at(turned, shading, at.refraction.n1, at.refraction.n2);
  const std::optional<Vec3<T>> direction = refract(turned, shading, bends);
  if (!direction) return choice;  // no eye refracts into it
  choice.direction = into_plane(*direction);
  if (!(dot(choice.direction, geometric) < 0)) choice.direction = folded(choice.direction);
  const T ratio = at.refraction.n1 / at.refraction.n2, bent = settings_.flat ? ratio : ratio * ratio;
  choice.weight = at.bsdf.transparent * (bent * std::abs(dot(turned, geometric) / dot(at.bsdf.incident, geometric)));
  if (at.surface->dielectric) choice.weight *= (1 - bends.fresnel()) / (1 - at.refraction.fresnel());
  return choice;
}

template <class Policy>
auto PhotonTracer<Policy>::choose_photon_direction(const PhotonRay& photon, const Vertex& at)
    -> std::optional<BsdfSample> {
  std::optional<BsdfSample> choice;
  if (!at.bsdf.absorbs()) {
    T u = 0;
    if (at.bsdf.several()) {
      u = random_unit<T>(key_at(at.length, detail::PhotonDimension::lobe));
      statistics_.drew(Effect::indirect_light, 1);
    }
    const Lobe lobe = at.bsdf.sample_lobe(u);
    Vec2<T> unit(0);
    if (at.bsdf.needs_direction(lobe)) {
      unit.x = random_unit<T>(key_at(at.length, detail::PhotonDimension::direction));
      unit.y = random_unit<T>(key_at(at.length, detail::PhotonDimension::direction + 1));
      statistics_.drew(detail::effect_of(lobe, at.bsdf.by_facets()), 2);
    }
    const T chance = at.bsdf.probability_of_choice(lobe);
    if (lobe == Lobe::transparent && bends_translucently(at)) {
      choice = bent_translucently(at, unit);
      choice->weight *= 1 / chance;
    } else {
      choice = sample_alone(at.bsdf, lobe, unit, u);
      choice->weight *= adjoint(at, choice->lobe, choice->direction) / chance;
    }
    // Along a surface, the power of what is sent on would be infinite.
    if (const T most = max_component(choice->weight); !(most > 0) || std::isinf(most)) choice.reset();
  }
  note(Line::photon_choose_direction, photon.length, [&] {
    if (!choice) return DirectionChosen{true};
    return DirectionChosen{false, choice->lobe, Vec3d(choice->direction), static_cast<double>(choice->pdf),
                           Rgbd(at.throughput * choice->weight)};
  });
  return choice;
}

/// Russian roulette: the photon survives as often as the surface reflects, so that its power stays as it is.
template <class Policy>
auto PhotonTracer<Policy>::decide_photon_survival(const PhotonRay& photon, const Vertex& at,
                                                  const std::optional<BsdfSample>& choice) -> T {
  T survival = 0;
  std::optional<Ending> why;
  if (choice) {
    // What refraction takes it gives back on the way out: no reason to end.
    const T bent = choice->lobe == Lobe::transparent ? adjoint(at, choice->lobe, choice->direction) : T(1);
    survival = std::min(max_component(at.throughput * choice->weight) / (bent * max_component(at.throughput)),
                        static_cast<T>(detail::surest));
    const T u = random_unit<T>(key_at(at.length, detail::PhotonDimension::roulette));
    statistics_.drew(Effect::indirect_light, 1);
    if (!(u < survival)) survival = 0, why = Ending::threshold;
  }
  if (why) ++statistics_.ends(*why);
  note(Line::if_photon_survives, photon.length,
       [&] { return SurvivalDecided{survival > 0, static_cast<double>(survival), why}; });
  return survival;
}

template <class Policy>
auto PhotonTracer<Policy>::form_next_photon(const PhotonRay& photon, const Vertex& at, const BsdfSample& choice,
                                            T survival) -> PhotonRay {
  stop_.check();
  const bool through = choice.lobe == Lobe::transparent;
  PhotonHistory history = PhotonHistory::indirect;
  if (choice.lobe != Lobe::diffuse && photon.history != PhotonHistory::indirect) history = PhotonHistory::caustic;
  PhotonRay next{spawn_ray<Ray>(world_, at.position, at.outward_normal, at.departure, choice.direction, at.time),
                 at.throughput * choice.weight * (1 / survival),
                 at.length + 1,
                 rays_formed_++,
                 history,
                 nullptr,
                 0,
                 through ? at.behind : at.medium};
  // Behind a mirror and through clear glass the lamp is still seen, from so far away.
  if (const bool sharp = choice.pdf == 0; sharp && photon.lamp != nullptr) {
    const T travelled = photon.travelled + length(at.position - Vec3<T>(photon.ray.origin));
    if (lights_.weight_at(*photon.lamp, travelled) > 0) next.lamp = photon.lamp, next.travelled = travelled;
  }
  ++statistics_.formed(RayKind::photon);
  note(Line::photon_form_next_ray, at.length, [&] {
    RayFormed event{next.number,          at.number, RayKind::photon, Vec3d(next.ray.origin), Vec3d(choice.direction),
                    Rgbd(next.throughput)};
    if (through) event.snell = snell_numbers(at, choice.direction);
    return event;
  });
  return next;
}

template <class Policy>
auto PhotonTracer<Policy>::sample_alone(const SurfaceBsdf& bsdf, Lobe lobe, const Vec2<T>& unit,
                                        [[maybe_unused]] T chosen_by) const -> BsdfSample {
  const SurfaceBsdf alone = bsdf.only(lobe);
  T u = 0;
  if constexpr (Policy::effects.microfacets) u = bsdf.among_choices(lobe, chosen_by);
  if (!settings_.flat || !alone.needs_direction(lobe)) return alone.sample(lobe, unit, u);
  if (lobe == Lobe::diffuse) {
    // Lambert's cosine in the plane: the sine is uniform.
    const Vec3<T>& normal = bsdf.shading_normal;
    const T sin = 2 * unit.x - 1, cos = std::sqrt(std::max(1 - sin * sin, T(0)));
    BsdfSample choice{lobe, cos * normal + sin * Vec3<T>(-normal.y, normal.x, 0), bsdf.diffuse, cos / 2};
    if (!(dot(choice.direction, bsdf.geometric_normal) > 0)) choice.weight = Rgb<T>(0);
    return choice;
  }
  BsdfSample choice = alone.sample(lobe, unit, u);
  choice.direction.z = 0;
  const T size = length(choice.direction);
  if (!(size > 0)) choice.weight = Rgb<T>(0);
  if (size > 0) choice.direction /= size;
  return choice;
}

}  // namespace raywalk
