#pragma once
// The places that distributed rays go to: on a light, in a lobe. Each draw is a pure function of the pixel's sample,
// the effect and the ray's place in the ray tree. Included by trace/tracer.h alone.

#include "trace/tracer.h"

namespace raywalk {

template <class Policy>
int Tracer<Policy>::samples_of(const Lamp& lamp) {
  if constexpr (Policy::effects.penumbra)
    return lamp.samples();
  else
    return 1;
}

/// What is known of the rays from a hit to one light before any of them is formed.
template <class Policy>
inline void Tracer<Policy>::look_between(const Shading& at, const Lamp& lamp) {
  constexpr unsigned unasked = 64;  // lamps
  if (static_cast<unsigned>(lamp.index) % unasked == unasked - 1) stop_.check();
  if (world_.shadow_cache) hints_.last = &last_blockers_[static_cast<std::size_t>(&lamp - world_.lamps.data())];
  if constexpr (culls) {
    const auto found = [&] {
      return world_.accelerator.within(Shaft(at.position, lamp.place, lamp.reach), at.departure, between_);
    };
    hints_.among = lamp.samples() > 1 && found() ? &between_ : nullptr;
  }
}

/// What every draw for a light begins with at the end of this ray.
template <class Policy>
RandomKey Tracer<Policy>::light_key(const Traced& ray) const {
  RandomKey key = key_;
  key.effect = static_cast<std::uint32_t>(Effect::penumbra);
  key.path = ray.branch.path;
  return key;
}

/// Where on the light the shadow ray with this number goes.
template <class Policy>
inline auto Tracer<Policy>::light_point(const Shading& at, const Traced& ray, const Lamp& lamp, int sample) -> Vec3<T> {
  if constexpr (Policy::effects.penumbra) {
    if (lamp.extent != World<T>::Extent::none) {
      const T edge = static_cast<T>(lamp.grid);
      const Vec2<T> cell(static_cast<T>(sample % lamp.grid), static_cast<T>(sample / lamp.grid));
      if (!world_.draws) return lamp.point_at((cell + T(0.5)) / edge);
      const auto number = static_cast<std::uint32_t>(sample);
      constexpr std::uint32_t unasked = 256;  // samples
      if (number % unasked == unasked - 1) stop_.check();
      statistics_.drew(Effect::penumbra, 2);
      if (lamp.grid > 1 && camera_.sampler() != Sampler::sobol) {
        const Vec2<T> unit = at.light_pairs.template draw<T>(lamp.first_dimension + 2 * number);
        return lamp.point_at(camera_.sampler() == Sampler::jittered ? (cell + unit) / edge : unit);
      }
      RandomKey key = light_key(ray);
      key.dimension = lamp.first_dimension;
      // Of Sobol's points all samples of the pixel share one sequence: each takes a run of it.
      key.sample = key.sample * static_cast<std::uint32_t>(lamp.samples()) + number;
      const Vec2<T> unit = draw_pair<T>(camera_.sampler(), key, camera_.strata());
      return lamp.point_at(unit);
    }
  }
  return lamp.place;
}

/// A direction of the cone about `direction`, all of them alike. What would go through the surface that `side` is the
/// normal of is mirrored back: the lobe keeps its light.
template <class Policy>
auto Tracer<Policy>::spread(const Traced& ray, const Vec3<T>& direction, T one_minus_cos, const Vec3<T>& side,
                            Effect effect) -> Vec3<T> {
  if constexpr (Policy::effects.lobes) {
    if (compiled(effect) && one_minus_cos > 0) {
      RandomKey key = key_;
      key.effect = static_cast<std::uint32_t>(effect);
      key.path = ray.branch.path;
      const Vec2<T> unit = draw_pair<T>(camera_.sampler(), key, camera_.strata());
      statistics_.drew(effect, 2);
      const Vec3<T> aside = renormalize(Basis<T>(direction).to_world(uniform_cone(unit, one_minus_cos)));
      const T above = dot(aside, side);
      return above > 0 ? aside : aside - 2 * above * side;
    }
  }
  return direction;
}

}  // namespace raywalk
