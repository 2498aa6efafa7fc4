#pragma once
// What of a lamp's light passes between a surface and the lamp.

#include "trace/leaving.h"
#include "trace/media.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>
#include <vector>

namespace raywalk {

/// How far a shadow ray runs inside an object: from all its crossings with the object's surface, in any order. Lengths
/// are counted from the first one told, which lies near the others, so that none of their digits are lost.
template <class T>
class WayInside {
 public:
  WayInside(const Vec3<T>& origin, const Vec3<T>& direction, T t_max)
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
  int entered_ = 0;  ///< more often than left
};

/// What primitive `id` leaves of the light of a shadow ray: each crossing multiplies by the transmission. `tell` hears
/// where each lies, and whether the ray leaves there.
template <class T, class AnyRay, class Tell>
[[nodiscard]] Rgb<T> light_by_crossings(const World<T>& world, const AnyRay& shadow, T t_max, TestCounts& tests, int id,
                                        Tell tell) {
  const Primitives<T>& primitives = world.accelerator.primitives();
  const Rgb<T>& filter = world.surface(id).filter;
  Rgb<T> passed{1};
  AnyRay rest = shadow;
  T reach = t_max;
  constexpr int crossings_limit = 10000;  // more than a line crosses any shape: whatever rounding does, it ends
  for (int crossings = 0; crossings < crossings_limit; ++crossings) {
    ++tests.primitives;
    const auto crossing = primitives.intersect(id, rest, reach, tests);
    if (!crossing) break;
    const SurfacePoint<T> point = primitives.surface_at(id, rest, *crossing);
    passed *= filter;
    tell(point.position, dot(point.normal, rest.direction) > 0);
    rest = leaving<AnyRay>(world, point.position, point.normal, {id, crossing->part}, rest.direction, rest.time);
    reach -= crossing->t;
  }
  return passed;
}

/// The same where only the number of crossings counts.
template <class T, class AnyRay>
[[nodiscard]] Rgb<T> light_through_primitive(const World<T>& world, const AnyRay& shadow, T t_max, TestCounts& tests,
                                             int id) {
  if constexpr (std::is_same_v<AnyRay, Ray<T>>) {
    // No way from one to the next is sought where they are counted at once.
    if (const auto number = world.accelerator.primitives().crossings(id, shadow, t_max, tests)) {
      ++tests.primitives;
      Rgb<T> passed{1};
      for (int crossing = 0; crossing < *number; ++crossing) passed *= world.surface(id).filter;
      return passed;
    }
  }
  return light_by_crossings(world, shadow, t_max, tests, id, [](const Vec3<T>&, bool) {});
}

/// What the objects `filters`, all that a shadow ray crosses, leave of its light. One primitive after the other, each
/// by itself: where surfaces of two touch, rounding could else hand the ray to and fro for ever.
template <class T, class AnyRay>
[[nodiscard]] Rgb<T> light_filtered(const World<T>& world, const AnyRay& shadow, T t_max, TestCounts& tests,
                                    const std::vector<int>& filters) {
  Rgb<T> passed{1};
  for (const int id : filters) passed *= light_through_primitive(world, shadow, t_max, tests, id);
  return passed;
}

/// The same where bodies that absorb can nest: only the top one does. None where the ray is never inside of two.
/// `stack`: the bodies that it starts in.
template <class T, class AnyRay>
[[nodiscard]] std::optional<Rgb<T>> light_absorbed_by_top(const World<T>& world, const AnyRay& shadow, T t_max,
                                                          TestCounts& tests, const std::vector<int>& filters,
                                                          BodyStack stack) {
  struct Crossed {
    T at;
    std::int32_t body;
    bool leaving;
  };
  std::vector<Crossed> met;
  const T size = length(shadow.direction);
  Rgb<T> passed{1};
  const auto cross = [&](int id) {
    return light_by_crossings(world, shadow, t_max, tests, id, [&](const Vec3<T>& point, bool leaving) {
      met.push_back({dot(point - shadow.origin, shadow.direction) / size, world.bodies.of_primitive(id), leaving});
    });
  };
  for (const int id : filters) {
    passed *= cross(id);
    if (const auto doubles = world.bodies.doubles.find(id); doubles != world.bodies.doubles.end())
      for (const int each : doubles->second) static_cast<void>(cross(each));  // one surface weakens light once
  }
  std::stable_sort(met.begin(), met.end(), [](const Crossed& a, const Crossed& b) { return a.at < b.at; });
  // What is left before it is entered was there from the start.
  BodyStack known = stack;
  for (const Crossed& each : met) {
    if (holds(known, each.body)) continue;
    known.push_back(each.body);
    if (each.leaving) enter(stack, each.body, world.bodies);
  }
  std::size_t most = stack.size();
  Rgb<T> depth{0};  // optical
  T from = 0;
  const auto go = [&](T to) {
    if (!stack.empty())
      depth += std::min(to - from, std::numeric_limits<T>::max()) *
               world.surfaces[static_cast<std::size_t>(world.bodies[stack.back()].surface)].absorption;
    from = to;
  };
  for (const Crossed& each : met) {
    go(each.at);
    each.leaving ? leave(stack, each.body) : enter(stack, each.body, world.bodies);
    most = std::max(most, stack.size());
  }
  go(t_max * size);
  if (most < 2) return std::nullopt;
  return passed * left_after(depth, T(1));
}

/// The same where something in the scene absorbs. `medium` is what the ray starts in, where that is known.
template <class T, class AnyRay>
[[nodiscard, gnu::noinline]] Rgb<T> light_absorbed(const World<T>& world, const AnyRay& shadow, T t_max,
                                                   TestCounts& tests, const std::vector<int>& filters,
                                                   const typename World<T>::Medium* medium) {
  if (!world.bodies.empty()) {
    const BodyStack& stack = NestedMedia<T>::bodies_in(medium);
    if (const auto passed = light_absorbed_by_top(world, shadow, t_max, tests, filters, stack)) return *passed;
    medium = stack.empty() ? nullptr : &world.surfaces[static_cast<std::size_t>(world.bodies[stack.back()].surface)];
  }
  Rgb<T> passed{1};
  for (auto id = filters.begin(); id != filters.end();) {
    const typename World<T>::Surface& surface = world.surface(*id);
    if (!surface.absorbs) {
      passed *= light_through_primitive(world, shadow, t_max, tests, *id++);
      continue;
    }
    WayInside<T> way(shadow.origin, shadow.direction, t_max);
    // The triangles of a mesh follow each other.
    for (; id != filters.end() && &world.surface(*id) == &surface; ++id)
      passed *= light_by_crossings(world, shadow, t_max, tests, *id,
                                   [&](const Vec3<T>& point, bool leaving) { way.cross(point, leaving); });
    passed *= left_after(surface.absorption, way.length_inside());
    if (&surface == medium) medium = nullptr;  // it was left, and that counted
  }
  if (medium != nullptr && medium->absorbs)
    passed *= left_after(medium->absorption, std::min(t_max * length(shadow.direction), std::numeric_limits<T>::max()));
  return passed;
}

/// The share of light that arrives over a shadow ray's (0, t_max); none when something stops it. `filters` is room for
/// the search, handed in so that no shadow ray allocates; `hints` are the search's; `medium` is what the ray starts in,
/// where that is known.
template <class T, class AnyRay>
[[nodiscard]] inline std::optional<Rgb<T>> light_through(const World<T>& world, const AnyRay& shadow, T t_max,
                                                         TestCounts& tests, std::vector<int>& filters,
                                                         const ShadowHints& hints = {},
                                                         const typename World<T>::Medium* medium = nullptr) {
  if (hints.among != nullptr && hints.among->empty() && !world.absorbs) return Rgb<T>(1);
  const Accelerator<T>& accelerator = world.accelerator;
  const bool stopped = world.shadow_roles.empty()
                           ? accelerator.any(shadow, t_max, tests, hints)
                           : accelerator.any_stop(shadow, t_max, tests, world.shadow_roles, filters, hints);
  if (stopped) return std::nullopt;
  if (world.absorbs) return light_absorbed(world, shadow, t_max, tests, filters, medium);
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
