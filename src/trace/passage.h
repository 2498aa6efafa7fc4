#pragma once
// What of a lamp's light passes between a surface and the lamp.

#include "trace/leaving.h"

#include <cmath>
#include <optional>
#include <type_traits>
#include <vector>

namespace raywalk {

/// What is left of light after a way inside an object that absorbs it (A. Beer 1852).
template <class T>
[[nodiscard]] Rgb<T> left_after(const Rgb<T>& absorption, T way) {
  return {std::exp(-absorption.x * way), std::exp(-absorption.y * way), std::exp(-absorption.z * way)};
}

/// What object `id` leaves of the light of a shadow ray: each crossing multiplies by the transmission.
template <class T, class AnyRay>
[[nodiscard]] Rgb<T> light_through_object(const World<T>& world, const AnyRay& shadow, T t_max, TestCounts& tests,
                                          int id) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  const typename World<T>::Surface& surface = world.surface(id);
  Rgb<T> passed{1};
  if constexpr (std::is_same_v<AnyRay, Ray<T>>) {
    // Where only their number counts, no way from one to the next is sought.
    if (const auto number = surface.absorbs ? std::nullopt : primitives.crossings(id, shadow, t_max, tests)) {
      ++tests.primitives;
      for (int crossing = 0; crossing < *number; ++crossing) passed *= surface.filter;
      return passed;
    }
  }
  AnyRay rest = shadow;
  T reach = t_max;
  constexpr int crossings_limit = 10000;  // more than a line crosses any shape: whatever rounding does, it ends
  for (int crossings = 0; crossings < crossings_limit; ++crossings) {
    ++tests.primitives;
    const auto crossing = primitives.intersect(id, rest, reach, tests);
    if (!crossing) break;
    const SurfacePoint<T> point = primitives.surface_at(id, rest, *crossing);
    passed *= surface.filter;
    // Where it leaves, it was inside since the crossing before.
    if (surface.absorbs && dot(point.normal, rest.direction) > 0)
      passed *= left_after(surface.absorption, length(point.position - rest.origin));
    rest = leaving<AnyRay>(world, point.position, point.normal, {id, crossing->part}, rest.direction, rest.time);
    reach -= crossing->t;
  }
  return passed;
}

/// What the objects `filters`, all that a shadow ray crosses, leave of its light. One object after the other, each by
/// itself: where surfaces of two touch, rounding could else hand the ray to and fro for ever.
template <class T, class AnyRay>
[[nodiscard]] Rgb<T> light_filtered(const World<T>& world, const AnyRay& shadow, T t_max, TestCounts& tests,
                                    const std::vector<int>& filters) {
  Rgb<T> passed{1};
  for (const int id : filters) passed *= light_through_object(world, shadow, t_max, tests, id);
  return passed;
}

/// The share of light that arrives over a shadow ray's (0, t_max); none when something stops it. `filters` is room for
/// the search, handed in so that no shadow ray allocates; `hints` are the search's.
template <class T, class AnyRay>
[[nodiscard]] inline std::optional<Rgb<T>> light_through(const World<T>& world, const AnyRay& shadow, T t_max,
                                                         TestCounts& tests, std::vector<int>& filters,
                                                         const ShadowHints& hints = {}) {
  if (hints.among != nullptr && hints.among->empty()) return Rgb<T>(1);
  const Accelerator<T>& accelerator = world.accelerator;
  const bool stopped = world.shadow_roles.empty()
                           ? accelerator.any(shadow, t_max, tests, hints)
                           : accelerator.any_stop(shadow, t_max, tests, world.shadow_roles, filters, hints);
  if (stopped) return std::nullopt;
  return filters.empty() ? Rgb<T>(1) : light_filtered(world, shadow, t_max, tests, filters);
}

/// What a shadow ray that does not arrive meets first.
template <class T, class AnyRay>
[[nodiscard]] std::optional<Hit<T>> first_blocker(const World<T>& world, const AnyRay& shadow, T t_max) {
  TestCounts uncounted;
  if (world.shadow_roles.empty()) return world.accelerator.closest(shadow, t_max, uncounted);
  return world.accelerator.closest(shadow, t_max, uncounted, StopsShadows{world.shadow_roles});
}

}  // namespace raywalk
