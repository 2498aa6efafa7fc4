#pragma once
// The sampled targets of distributed rays: on a light, in a lobe. Each draw is a pure function of the pixel's sample,
// the effect and the ray's position in the ray tree. Included by trace/tracer.h alone.

#include "trace/tracer.h"

#include <limits>

namespace raywalk {

template <class Policy>
int Tracer<Policy>::samples_of(const Light& light) {
  if constexpr (Policy::effects.penumbra)
    return light.samples();
  else
    return 1;
}

/// What is known about all shadow rays from a hit to one light.
template <class Policy>
inline void Tracer<Policy>::set_shadow_hints(const ShadingPoint& at, const Light& light) {
  if constexpr (Policy::effects.penumbra) {
    if (static_cast<std::size_t>(light.index) % few_lights == few_lights - 1) stop_.check();
  }
  if (world_.shadow_cache) hints_.last = &last_blockers_[static_cast<std::size_t>(&light - world_.lights.data())];
  if constexpr (culls) {
    const auto found = [&] {
      return world_.accelerator.within(Shaft(at.position, light.place, light.reach), at.departure, possible_blockers_);
    };
    hints_.candidates = light.samples() > 1 && found() ? &possible_blockers_ : nullptr;
  }
}

/// The key of all draws for lights at this ray's hit.
template <class Policy>
RandomKey Tracer<Policy>::light_key(const TreeRay& ray) const {
  return key_.at(static_cast<std::uint32_t>(Effect::penumbra), ray.branch.path, 0);
}

/// A point of a light with an extent: apart, and all of it in one piece, as `sample_rough`.
template <class Policy>
[[gnu::noinline, gnu::flatten]] auto Tracer<Policy>::sample_light(const Light& light, const Vec2<T>& unit) -> Vec3<T> {
  return light.sample(unit);
}
template <class Policy>
[[gnu::noinline, gnu::flatten]] auto Tracer<Policy>::regular_on_light(const Light& light, int sample) -> Vec3<T> {
  return light.regular(sample, light.grid);
}

/// The point on the light that shadow ray number `sample` goes to.
template <class Policy>
inline auto Tracer<Policy>::light_point(const ShadingPoint& at, const TreeRay& ray, const Light& light, int sample)
    -> Vec3<T> {
  if constexpr (Policy::effects.penumbra) {
    if (!light.is_delta) {
      if (!world_.draws) return regular_on_light(light, sample);
      const T edge = static_cast<T>(light.grid);
      const Vec2<T> cell(static_cast<T>(sample % light.grid), static_cast<T>(sample / light.grid));
      const auto number = static_cast<std::uint32_t>(sample);
      constexpr int unasked = 16;  // rows of samples
      if (light.grid > unasked && number % (unasked * unasked) == 0) [[unlikely]]
        check_stop();
      statistics_.drew(Effect::penumbra, 2);
      if (light.grid > 1 && camera_.sampler() != Sampler::sobol) {
        const Vec2<T> unit = at.light_pairs.template draw<T>(light.first_dimension + 2 * number);
        return sample_light(light, camera_.sampler() == Sampler::jittered ? (cell + unit) / edge : unit);
      }
      RandomKey key = light_key(ray);
      key.dimension = light.first_dimension;
      // With Sobol's points, all samples of the pixel share one sequence: each takes a range of it.
      key.sample = key.sample * static_cast<std::uint32_t>(light.samples()) + number;
      const Vec2<T> unit = draw_pair<T>(camera_.sampler(), key, camera_.strata());
      return sample_light(light, unit);
    }
  }
  return light.place;
}

/// A direction uniform in the cone about `direction`. Directions through the surface, which has `facing_normal`, are
/// mirrored back: the lobe loses no light.
template <class Policy>
auto Tracer<Policy>::sample_cone(const TreeRay& ray, const Vec3<T>& direction, T one_minus_cos,
                                 const Vec3<T>& facing_normal, Effect effect) -> Vec3<T> {
  if constexpr (Policy::effects.lobes)
    if (one_minus_cos > 0) return sample_rough(ray, direction, one_minus_cos, facing_normal, effect);
  return direction;
}

/// The same where the lobe has a width: apart, and all of it in one piece, so that neither sharp rays nor what else a
/// kernel has change how it is compiled.
template <class Policy>
[[gnu::noinline, gnu::flatten]] auto Tracer<Policy>::sample_rough(const TreeRay& ray, const Vec3<T>& direction,
                                                                  T one_minus_cos, const Vec3<T>& facing_normal,
                                                                  Effect effect) -> Vec3<T> {
  const RandomKey key = key_.at(static_cast<std::uint32_t>(effect), ray.branch.path, 0);
  const Vec2<T> unit = draw_pair<T>(camera_.sampler(), key, camera_.strata());
  statistics_.drew(effect, 2);
  const Vec3<T> aside = renormalize(Basis<T>(direction).to_world(sample_uniform_cone(unit, one_minus_cos)));
  const T above = dot(aside, facing_normal);
  return above > 0 ? aside : aside - 2 * above * facing_normal;
}

template <class Policy>
bool Tracer<Policy>::draws_facet(const ShadingPoint& at, RayKind kind) const {
  if (!world_.draws) return false;
  return at.facets.glass || (kind == RayKind::reflect && at.facets.mirror && at.facets.mirror->facets);
}

template <class Policy>
auto Tracer<Policy>::evaluate_facets(const ShadingPoint& at, const TreeRay& ray, const Vec3<T>& to_light)
    -> FacetValue {
  if constexpr (Policy::effects.maps) {
    if (at.rougher.share > 0) {
      ShadingPoint of_one = at;
      of_one.rougher = {};
      const FacetValue smoother = evaluate_facets(of_one, ray, to_light);
      of_one.facets.mirror = at.rougher.mirror, of_one.facets.glass = at.rougher.glass;
      const FacetValue rougher = evaluate_facets(of_one, ray, to_light);
      return {smoother.weight, smoother.value + at.rougher.share * (rougher.value - smoother.value),
              smoother.pdf + at.rougher.share * (rougher.pdf - smoother.pdf)};
    }
  }
  const bool before = dot(at.geometric_normal(), to_light) > 0;
  if (const RoughDielectric<T>* glass = at.facets.glass) {
    if (before != (dot(at.shading_normal, to_light) > 0)) return {};
    const auto value =
        glass->evaluate(glass->side_of(at.refraction.n1), at.shading_normal, -ray.ray.direction, to_light);
    return {Rgb<T>(1), glass->value(at.values().reflection + at.values().transmission, value), value.pdf};
  }
  if (!before || !at.facets.mirror || !at.facets.mirror->facets) return {};
  const Microsurface<T>& own = *at.facets.mirror;
  const auto value = own.facets->evaluate(at.shading_normal, -ray.ray.direction, to_light);
  return {at.values().reflection, own.value(value), value.pdf};
}

/// A direction to which one of the small facets sends light, or light that several have. Sets the weight of the ray,
/// which is 0 where it would go to the wrong side of the surface.
template <class Policy>
auto Tracer<Policy>::sample_facet(ShadedPoint& at, const TreeRay& ray, RayKind kind) -> Vec3<T> {
  const bool through = kind == RayKind::refract;
  const RandomKey key = key_.at(static_cast<std::uint32_t>(Effect::microfacets), ray.branch.path, through ? 2 : 0);
  Vec2<T> unit = draw_pair<T>(camera_.sampler(), key, camera_.strata());
  statistics_.drew(Effect::microfacets, 2);
  const Vec3<T>&normal = at.shading_normal, to_eye = -ray.ray.direction;
  const RoughDielectric<T>* glass = at.facets.glass;
  const Microsurface<T>* mirror = at.facets.mirror;
  if constexpr (Policy::effects.maps) {
    const T share = at.rougher.share;
    const bool rougher = unit.x < share;
    if (rougher) glass = at.rougher.glass, mirror = at.rougher.mirror;
    if (share > 0)
      unit.x = std::clamp(rougher ? unit.x / share : (unit.x - share) / (1 - share), T(0),
                          1 - std::numeric_limits<T>::epsilon() / 2);
  }
  const Vec3<T> direction = glass ? glass->sample(glass->side_of(at.refraction.n1), through, normal, to_eye, unit)
                                  : mirror->facets->sample(normal, to_eye, unit);
  const FacetValue value = evaluate_facets(at, ray, direction);
  const bool goes_through = !(dot(at.geometric_normal(), direction) > 0);
  (through ? at.weights->transmission : at.weights->reflection) =
      value.pdf > 0 && goes_through == through ? value.weight * value.value * (1 / value.pdf) : Rgb<T>(0);
  return direction;
}

}  // namespace raywalk
