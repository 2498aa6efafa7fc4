#pragma once
// The transmittance between a surface and a light.

#include "trace/media.h"
#include "trace/policy.h"
#include "trace/spawn_ray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace raywalk {

/// The length of a shadow ray inside an object, from all its crossings with the object's surface in any order. Lengths
/// are relative to the first crossing given, which is near the others, so that no digits are lost.
template <class T>
class ChordLength {
 public:
  ChordLength(const Vec3<T>& origin, const Vec3<T>& direction, T t_max)
      : origin_(origin), length_(length(direction)), along_(direction / length_), end_(t_max * length_) {}

  void cross(const Vec3<T>& point, bool leaving) {
    if (!any_) first_ = point, any_ = true;
    const T at = dot(point - first_, along_);
    if (at < nearest_) nearest_ = at, starts_inside_ = leaving;
    inside_ += leaving ? at : -at;
    entered_ += leaving ? -1 : 1;
  }
  [[nodiscard]] T length_inside() const {
    if (!any_) return 0;
    const T to_first = dot(first_ - origin_, along_);
    T sum = inside_;
    if (starts_inside_) sum += to_first;
    if (starts_inside_ + entered_ > 0) sum += end_ - to_first;  // it ends inside
    return std::clamp(sum, T(0), std::numeric_limits<T>::max());
  }

 private:
  Vec3<T> origin_;
  T length_;
  Vec3<T> along_;  ///< unit
  T end_;
  Vec3<T> first_{0};
  T nearest_ = infinity<T>, inside_ = 0;
  bool any_ = false, starts_inside_ = false;
  int entered_ = 0;  ///< entries minus exits
};

/// Surfaces on the way of one ray, more than any shape has: guarantees termination, whatever rounding does.
inline constexpr int crossings_limit = 10000;

/// The transmittance of primitive `id` for a shadow ray: each crossing multiplies by its filter. `tell` is given the
/// position of each crossing, and whether the ray exits there.
template <class T, class AnyRay, class Tell>
[[nodiscard]] Rgb<T> transmittance_by_crossings(const World<T>& world, const AnyRay& shadow, T t_max, TestCounts& tests,
                                                int id, Tell tell) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  const Rgb<T>& filter = world.surface(id).filter;
  Rgb<T> transmittance{1};
  AnyRay rest = shadow;
  T t_far = t_max;
  for (int crossings = 0; crossings < crossings_limit; ++crossings) {
    ++tests.primitives;
    const auto intersection = primitives.intersect(id, rest, t_far, tests);
    if (!intersection) break;
    const SurfacePoint<T> point = primitives.surface_at(id, rest, *intersection);
    transmittance *= filter;
    tell(point.position, dot(point.normal, rest.direction) > 0);
    rest = spawn_ray<AnyRay>(world, point.position, point.normal, {id, intersection->part}, rest.direction, rest.time);
    t_far -= intersection->t;
  }
  return transmittance;
}

/// The same where only the number of crossings matters.
template <class T, class AnyRay>
[[nodiscard]] Rgb<T> primitive_transmittance(const World<T>& world, const AnyRay& shadow, T t_max, TestCounts& tests,
                                             int id) {
  if constexpr (std::is_same_v<AnyRay, Ray<T>>) {
    // No search from one crossing to the next where they can be counted directly.
    if (const auto number = world.accelerator.primitives().intersection_count(id, shadow, t_max, tests)) {
      ++tests.primitives;
      Rgb<T> transmittance{1};
      for (int i = 0; i < *number; ++i) transmittance *= world.surface(id).filter;
      return transmittance;
    }
  }
  return transmittance_by_crossings(world, shadow, t_max, tests, id, [](const Vec3<T>&, bool) {});
}

/// The transmittance of the primitives `filters`, all that a shadow ray crosses. Each primitive is traversed
/// separately: where surfaces of two touch, rounding could otherwise bounce the ray between them endlessly.
template <class T, class AnyRay>
[[nodiscard]] Rgb<T> filtered_transmittance(const World<T>& world, const AnyRay& shadow, T t_max, TestCounts& tests,
                                            const std::vector<int>& filters) {
  Rgb<T> transmittance{1};
  for (const int id : filters) transmittance *= primitive_transmittance(world, shadow, t_max, tests, id);
  return transmittance;
}

/// The same where absorbing bodies can nest: only the top one absorbs. None where the ray is never inside two at once.
/// `stack`: the bodies that it starts in.
template <class T, class AnyRay>
[[nodiscard]] std::optional<Rgb<T>> nested_transmittance(const World<T>& world, const AnyRay& shadow, T t_max,
                                                         TestCounts& tests, const std::vector<int>& filters,
                                                         BodyStack stack) {
  struct Crossed {
    T at;
    std::int32_t body;
    bool leaving;
  };
  std::vector<Crossed> met;
  const T size = length(shadow.direction);
  Rgb<T> transmittance{1};
  const auto cross = [&](int id) {
    return transmittance_by_crossings(world, shadow, t_max, tests, id, [&](const Vec3<T>& point, bool leaving) {
      met.push_back({dot(point - shadow.origin, shadow.direction) / size, world.bodies.of_primitive(id), leaving});
    });
  };
  for (const int id : filters) {
    transmittance *= cross(id);
    if (const auto doubles = world.bodies.doubles.find(id); doubles != world.bodies.doubles.end())
      for (const int each : doubles->second) static_cast<void>(cross(each));  // a surface attenuates light only once
  }
  std::stable_sort(met.begin(), met.end(), [](const Crossed& a, const Crossed& b) { return a.at < b.at; });
  // A body that is exited before it is entered contained the origin.
  BodyStack known = stack;
  for (const Crossed& each : met) {
    if (holds(known, each.body)) continue;
    known.push_back(each.body);
    if (each.leaving) enter(stack, each.body, world.bodies);
  }
  std::size_t most = stack.size();
  Rgb<T> depth{0};  // optical depth
  T from = 0;
  const auto go = [&](T to) {
    if (!stack.empty())
      depth += std::min(to - from, std::numeric_limits<T>::max()) *
               world.surfaces[static_cast<std::size_t>(world.bodies[stack.back()].surface)].extinction;
    from = to;
  };
  for (const Crossed& each : met) {
    go(each.at);
    each.leaving ? leave(stack, each.body) : enter(stack, each.body, world.bodies);
    most = std::max(most, stack.size());
  }
  go(t_max * size);
  if (most < 2) return std::nullopt;
  return transmittance * beer_lambert(depth, T(1));
}

/// The same where something in the scene absorbs. `medium`: the medium that the ray starts in, if known.
template <class T, class AnyRay>
[[nodiscard, gnu::noinline]] Rgb<T> absorbing_transmittance(const World<T>& world, const AnyRay& shadow, T t_max,
                                                            TestCounts& tests, const std::vector<int>& filters,
                                                            const typename World<T>::Medium* medium) {
  if (!world.bodies.empty()) {
    const BodyStack& stack = NestedMedia<T>::bodies_in(medium);
    if (const auto transmittance = nested_transmittance(world, shadow, t_max, tests, filters, stack))
      return *transmittance;
    medium = stack.empty() ? nullptr : &world.surfaces[static_cast<std::size_t>(world.bodies[stack.back()].surface)];
  }
  Rgb<T> transmittance{1};
  for (auto id = filters.begin(); id != filters.end();) {
    const typename World<T>::Surface& surface = world.surface(*id);
    if (!surface.absorbs) {
      transmittance *= primitive_transmittance(world, shadow, t_max, tests, *id++);
      continue;
    }
    ChordLength<T> chord(shadow.origin, shadow.direction, t_max);
    // The triangles of a mesh are consecutive.
    for (; id != filters.end() && &world.surface(*id) == &surface; ++id)
      transmittance *= transmittance_by_crossings(
          world, shadow, t_max, tests, *id, [&](const Vec3<T>& point, bool leaving) { chord.cross(point, leaving); });
    transmittance *= beer_lambert(surface.extinction, chord.length_inside());
    if (&surface == medium) medium = nullptr;  // the ray has exited it, and that was counted
  }
  if (medium != nullptr && medium->absorbs)
    transmittance *=
        beer_lambert(medium->extinction, std::min(t_max * length(shadow.direction), std::numeric_limits<T>::max()));
  return transmittance;
}

/// The transmittance over a shadow ray's (0, t_max); none when it is blocked. `filters`: a buffer for the search, so
/// that no shadow ray allocates; `hints`: for the search; `medium`: the medium that the ray starts in, if known.
template <class T, class AnyRay>
[[nodiscard]] inline std::optional<Rgb<T>> shadow_transmittance(const World<T>& world, const AnyRay& shadow, T t_max,
                                                                TestCounts& tests, std::vector<int>& filters,
                                                                const ShadowHints& hints = {},
                                                                const typename World<T>::Medium* medium = nullptr) {
  if (hints.candidates != nullptr && hints.candidates->empty() && !world.absorbs) return Rgb<T>(1);
  const Accelerator<T>& accelerator = world.accelerator;
  const bool stopped = world.shadow_roles.empty()
                           ? accelerator.occluded(shadow, t_max, tests, hints)
                           : accelerator.occluded_or_filtered(shadow, t_max, tests, world.shadow_roles, filters, hints);
  if (stopped) return std::nullopt;
  if (world.absorbs) return absorbing_transmittance(world, shadow, t_max, tests, filters, medium);
  return filters.empty() ? Rgb<T>(1) : filtered_transmittance(world, shadow, t_max, tests, filters);
}

/// The first blocker of a shadow ray that is blocked.
template <class T, class AnyRay>
[[nodiscard]] std::optional<Hit<T>> first_blocker(const World<T>& world, const AnyRay& shadow, T t_max) {
  TestCounts uncounted;
  if (world.shadow_roles.empty()) return world.accelerator.closest(shadow, t_max, uncounted);
  return world.accelerator.closest(shadow, t_max, uncounted, StopsShadows{world.shadow_roles});
}

/// The closest hit of a ray to primitive `target`, which it mostly reaches; -1 for none. (A naive ray may hit what its
/// search misses, and a small program has one search for all.)
template <class T, class AnyRay>
[[nodiscard]] std::optional<Hit<T>> closest_on_the_way(const World<T>& world, const AnyRay& ray, int target,
                                                       TestCounts& counts) {
  if constexpr (std::is_same_v<AnyRay, Ray<T>> && !few_kernels)
    if (target >= 0) return world.accelerator.closest_likely(ray, target, counts);
  return world.accelerator.closest(ray, infinity<T>, counts);
}

}  // namespace raywalk
