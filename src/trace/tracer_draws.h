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

/// Where on the light the shadow ray with this number goes.
template <class Policy>
auto Tracer<Policy>::light_point(const Traced& ray, const Lamp& lamp, int sample) -> Vec3<T> {
  if constexpr (Policy::effects.penumbra) {
    if (lamp.extent != World<T>::Extent::none) {
      const T edge = static_cast<T>(lamp.grid);
      const Vec2<T> cell(static_cast<T>(sample % lamp.grid), static_cast<T>(sample / lamp.grid));
      if (!world_.draws) return lamp.point_at((cell + T(0.5)) / edge);
      RandomKey key = key_;
      key.effect = static_cast<std::uint32_t>(Effect::penumbra);
      key.path = ray.branch.path;
      const auto count = static_cast<std::uint32_t>(lamp.samples());
      statistics_.drew(Effect::penumbra, 2);
      if (camera_.sampler() == Sampler::sobol) {
        // One sequence for all samples of the pixel: each takes a run of it.
        key.dimension = lamp.first_dimension;
        key.sample = key.sample * count + static_cast<std::uint32_t>(sample);
        const Vec2<T> unit = draw_pair<T>(Sampler::sobol, key, camera_.count() * count);
        return lamp.point_at(unit);
      }
      key.dimension = lamp.first_dimension + 2 * static_cast<std::uint32_t>(sample);
      const Vec2<T> unit = draw_pair<T>(lamp.grid == 1 ? camera_.sampler() : Sampler::random, key, camera_.count());
      const bool jitters = camera_.sampler() == Sampler::jittered;
      return lamp.point_at(jitters && lamp.grid > 1 ? (cell + unit) / edge : unit);
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
      const Vec2<T> unit = draw_pair<T>(camera_.sampler(), key, camera_.count());
      statistics_.drew(effect, 2);
      const Vec3<T> aside = renormalize(Basis<T>(direction).to_world(uniform_cone(unit, one_minus_cos)));
      const T above = dot(aside, side);
      return above > 0 ? aside : aside - 2 * above * side;
    }
  }
  return direction;
}

}  // namespace raywalk
