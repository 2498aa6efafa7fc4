#pragma once
// What light travels in, and what that leaves of it.
//
// Where bodies can nest, each ray carries the stack of those that it is inside of: the top one is where it travels.
// Which body is where two overlap is settled by priority, as C. Schmidt and B. Budge have it ("Simple Nested
// Dielectrics in Ray Traced Images", JGT 7(2), 2002); of equal ones the body entered last is there. Every crossing
// stays a hit, also where it changes nothing.

#include "trace/world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace raywalk {

/// What is left of light after a way inside an object that absorbs it (A. Beer 1852).
template <class T>
[[nodiscard]] Rgb<T> left_after(const Rgb<T>& absorption, T way) {
  return {std::exp(-absorption.x * way), std::exp(-absorption.y * way), std::exp(-absorption.z * way)};
}

/// The medium of a ray that leaves what it met last, `before` that; null: air, or not known. One that is not refracted
/// goes on at the side it came from.
template <class Surface>
[[nodiscard]] const typename Surface::Medium* medium_after(const Surface& met, bool entering, bool refracted,
                                                           const typename Surface::Medium* before) {
  if (refracted) return entering ? &met : nullptr;
  if (entering) return before;
  return met.transmits ? &met : nullptr;
}

/// What is left of light after its way to a surface, if any is lost. Where the medium is not known, a way that ends by
/// leaving an object lay inside that.
template <class T, class Surface>
[[nodiscard]] std::optional<Rgb<T>> left_on_way(const typename Surface::Medium* medium, const Surface& met,
                                                bool entering, T way) {
  const typename Surface::Medium* through = medium == nullptr && !entering ? &met : medium;
  if (through == nullptr || !through->absorbs) return std::nullopt;
  return left_after(through->absorption, way);
}

/// The bodies that a ray is inside of, by their places in World::bodies: the top one last.
using BodyStack = std::vector<std::int32_t>;

[[nodiscard]] inline bool holds(const BodyStack& stack, std::int32_t body) {
  return std::find(stack.begin(), stack.end(), body) != stack.end();
}
/// One that it is inside of already is not entered again.
inline void enter(BodyStack& stack, std::int32_t body, const Bodies& bodies) {
  if (holds(stack, body)) return;
  const auto above = std::find_if(stack.begin(), stack.end(),
                                  [&](std::int32_t each) { return bodies[each].priority > bodies[body].priority; });
  stack.insert(above, body);
}
inline void leave(BodyStack& stack, std::int32_t body) {
  stack.erase(std::remove(stack.begin(), stack.end(), body), stack.end());
}

/// The media of rays where bodies can nest: one for each stack that has come up.
template <class T>
class NestedMedia {
 public:
  using Medium = typename World<T>::Medium;
  /// Both sides of a crossing.
  struct Sides {
    const Medium *before, *beyond;
  };

  explicit NestedMedia(const World<T>& world)
      : world_(world), all_(world.bodies.list.size(), 1), some_(world.bodies.list.size(), 0) {}

  /// Whether a ray may start inside of a body.
  [[nodiscard]] bool any_around_eye() const { return !world_.bodies.around_eye.empty(); }
  /// What a ray from the eye starts in. The bodies are asked, each by where the ray first crosses it: from inside or
  /// from outside.
  template <class AnyRay>
  [[nodiscard, gnu::noinline]] const Medium* at_eye(const AnyRay& ray, TestCounts& tests);

  /// The media on both sides of a transmitting surface that the ray, which travels in `medium`, has met at `point`:
  /// with every other body whose surface lies in the same place, which is crossed too.
  template <class AnyRay>
  [[nodiscard, gnu::noinline]] Sides across(const AnyRay& ray, const Hit<T>& hit, const Vec3<T>& point, bool entering,
                                            const Medium* medium, TestCounts& tests);

  [[nodiscard]] static T index(const Medium* medium) { return medium == nullptr ? T(1) : medium->ior; }
  /// The bodies behind a medium that was handed out here.
  [[nodiscard]] static const BodyStack& bodies_in(const Medium* medium) {
    static const BodyStack none;
    return medium == nullptr ? none : static_cast<const Stacked*>(medium)->bodies;
  }

 private:
  /// A copy of the top body's medium, and all of the stack.
  struct Stacked : Medium {
    BodyStack bodies;
  };

  const Medium* medium_of(const BodyStack& stack) {
    if (stack.empty()) return nullptr;
    const auto [entry, is_new] = known_.try_emplace(stack);
    if (is_new) {
      const Medium& top = world_.surfaces[static_cast<std::size_t>(world_.bodies[stack.back()].surface)];
      entry->second = {top, stack};
    }
    return &entry->second;
  }
  using Asked = std::vector<std::uint8_t>;  ///< by body: whether it is asked for
  static void ask(Asked& asked, std::int32_t body, bool yes) { asked[static_cast<std::size_t>(body)] = yes; }
  /// The first crossing with one of the bodies asked for.
  struct Met {
    std::int32_t body;
    bool entering;
  };
  template <class AnyRay>
  [[nodiscard]] std::optional<Met> first_met(const Asked& asked, const AnyRay& ray, T t_max, TestCounts& tests) const {
    const auto hit = world_.accelerator.closest(ray, t_max, tests, OfBodies{world_.bodies.of, asked});
    if (!hit) return std::nullopt;
    const Vec3<T> normal =
        world_.accelerator.primitives().surface_at(hit->primitive, ray, Crossing<T>{hit->t, hit->part}).normal;
    return Met{world_.bodies.of_primitive(hit->primitive), dot(normal, ray.direction) <= 0};
  }
  /// Whether a body that has no end holds a place. Some line along an axis leads out of it, if it does.
  template <class AnyRay>
  [[nodiscard]] bool endless_holds(std::int32_t body, const AnyRay& from, TestCounts& tests);

  const World<T>& world_;
  std::map<BodyStack, Stacked> known_;
  Asked all_, some_;  ///< kept so that no ray allocates: between calls all of them, and none
};

/// In the place of the above in kernels without nesting.
template <class T>
struct NothingNests {
  explicit NothingNests(const World<T>& /*world*/) {}
};

template <class T>
template <class AnyRay>
bool NestedMedia<T>::endless_holds(std::int32_t body, const AnyRay& from, TestCounts& tests) {
  std::optional<Met> met;
  ask(some_, body, true);
  for (int way = 0; way < 6 && !met; ++way) {
    AnyRay ray = from;
    ray.direction = Vec3<T>(0);
    ray.direction[way / 2] = static_cast<T>(way % 2 == 0 ? 1 : -1);
    met = first_met(some_, ray, infinity<T>, tests);
  }
  ask(some_, body, false);
  return met && !met->entering;
}

template <class T>
template <class AnyRay>
auto NestedMedia<T>::at_eye(const AnyRay& ray, TestCounts& tests) -> const Medium* {
  const Bodies& bodies = world_.bodies;
  BodyStack undecided = bodies.around_eye, left;
  for (const std::int32_t body : undecided) ask(some_, body, true);
  while (const auto met = first_met(some_, ray, infinity<T>, tests)) {
    if (!met->entering) left.push_back(met->body);
    leave(undecided, met->body);
    ask(some_, met->body, false);
  }
  for (const std::int32_t body : undecided) ask(some_, body, false);
  BodyStack stack;
  for (const std::int32_t body : bodies.around_eye) {
    const bool never_met = bodies[body].endless && holds(undecided, body);
    if (holds(left, body) || (never_met && endless_holds(body, ray, tests))) enter(stack, body, bodies);
  }
  return medium_of(stack);
}

template <class T>
template <class AnyRay>
auto NestedMedia<T>::across(const AnyRay& ray, const Hit<T>& hit, const Vec3<T>& point, bool entering,
                            const Medium* medium, TestCounts& tests) -> Sides {
  // What rounding may leave between surfaces in one place.
  const T size = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z), hit.t});
  const T rounding = 64 * std::numeric_limits<T>::epsilon() * size;
  const Bodies& bodies = world_.bodies;
  const std::int32_t body = bodies.of_primitive(hit.primitive);
  BodyStack stack = bodies_in(medium);
  const Medium* before = medium;
  if (!entering && !holds(stack, body)) {
    // A body that was never entered is left. Close to where the ray started, rounding did that, where surfaces of two
    // bodies coincide. Else the body is open somewhere, and the ray came in there.
    if (hit.t > rounding) {
      enter(stack, body, bodies);
      before = medium_of(stack);
    }
  }
  BodyStack crossed;
  const auto cross = [&](const Met& met) {
    met.entering ? enter(stack, met.body, bodies) : leave(stack, met.body);
    ask(all_, met.body, false);
    crossed.push_back(met.body);
  };
  cross({body, entering});
  while (crossed.size() < bodies.list.size()) {
    const auto met = first_met(all_, ray, hit.t + rounding, tests);
    if (!met) break;
    cross(*met);
  }
  for (const std::int32_t each : crossed) ask(all_, each, true);
  return {before, medium_of(stack)};
}

}  // namespace raywalk
