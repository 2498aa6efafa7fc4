#pragma once
// The media that light travels in, and their transmittance.
//
// Where bodies can nest, each ray carries the stack of bodies it is inside of; it travels in the top one. Where two
// overlap, priority decides, as in C. Schmidt and B. Budge ("Simple Nested Dielectrics in Ray Traced Images", JGT 7(2),
// 2002); of equal ones the body entered last wins. Every crossing remains a hit, even where it changes nothing.

#include "math/elementary.h"
#include "trace/spawn_ray.h"
#include "trace/world.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace raywalk {

/// The transmittance over a distance in a medium (Beer-Lambert law; A. Beer 1852).
template <class T>
[[nodiscard]] Rgb<T> beer_lambert(const Rgb<T>& extinction, T distance) {
  return {portable::exp(-extinction.x * distance), portable::exp(-extinction.y * distance),
          portable::exp(-extinction.z * distance)};
}

/// The medium of a ray spawned at the hit `met`; `before`: the medium up to there. Null: air, or unknown. A ray that is
/// not refracted continues on the side it came from.
template <class Surface>
[[nodiscard]] const typename Surface::Medium* medium_after(const Surface& met, bool entering, bool refracted,
                                                           const typename Surface::Medium* before) {
  if (refracted) return entering ? &met : nullptr;
  if (entering) return before;
  return met.transmits ? &met : nullptr;
}

/// The transmittance up to a hit, if anything is absorbed. Where the medium is unknown, a ray that exits an object was
/// inside it. Inlined, because most hits need no more than the test.
template <class T, class Surface>
[[nodiscard, gnu::always_inline]] inline std::optional<Rgb<T>> transmittance_to_hit(
    const typename Surface::Medium* medium, const Surface& met, bool entering, T distance) {
  const typename Surface::Medium* through = medium == nullptr && !entering ? &met : medium;
  if (through == nullptr || !through->absorbs) return std::nullopt;
  return beer_lambert(through->extinction, distance);
}

/// The transmittance of a ray that meets nothing any more: what it never leaves lets nothing through. In a body that
/// has an end, it has come out through an opening.
template <class T, class Medium>
[[nodiscard]] Rgb<T> transmittance_to_nothing(const Medium* medium) {
  if (medium == nullptr || !medium->endless) return Rgb<T>(1);
  return beer_lambert(medium->extinction, std::numeric_limits<T>::max());
}

/// The bodies that a ray is inside of, as indices into World::bodies: the top one last.
using BodyStack = std::vector<std::int32_t>;

[[nodiscard]] inline bool holds(const BodyStack& stack, std::int32_t body) {
  return std::find(stack.begin(), stack.end(), body) != stack.end();
}
/// A body that the ray is already inside of is not entered again.
inline void enter(BodyStack& stack, std::int32_t body, const Bodies& bodies) {
  if (holds(stack, body)) return;
  const auto above = std::find_if(stack.begin(), stack.end(),
                                  [&](std::int32_t each) { return bodies[each].priority > bodies[body].priority; });
  stack.insert(above, body);
}
inline void leave(BodyStack& stack, std::int32_t body) {
  stack.erase(std::remove(stack.begin(), stack.end(), body), stack.end());
}

/// The media of rays where bodies can nest: one for each stack encountered.
template <class T>
class NestedMedia {
 public:
  using Medium = typename World<T>::Medium;
  /// The media on both sides of a surface.
  struct Sides {
    const Medium *before, *beyond;
  };

  explicit NestedMedia(const World<T>& world)
      : world_(world), all_(world.bodies.list.size(), 1), some_(world.bodies.list.size(), 0) {}

  /// Whether a ray may start inside a body.
  [[nodiscard]] bool any_around_eye() const { return !world_.bodies.around_eye.empty(); }
  /// The medium that a ray from the eye starts in: for each body, whether the ray first crosses it from inside or from
  /// outside.
  template <class AnyRay>
  [[nodiscard, gnu::noinline]] const Medium* at_eye(const AnyRay& ray, TestCounts& tests);

  /// The medium that a ray starts in anywhere else, as photons do; null also where all that it is inside of bends light
  /// but absorbs nothing, and touches nothing else.
  template <class AnyRay>
  [[nodiscard, gnu::noinline]] const Medium* at_start(const AnyRay& ray, TestCounts& tests);

  /// The media on both sides of a transmitting surface that a ray in `medium` has hit at `point`. Other bodies whose
  /// surfaces coincide there are crossed too.
  template <class AnyRay>
  [[nodiscard, gnu::noinline]] Sides across(const AnyRay& ray, const Hit<T>& hit, const Vec3<T>& point, bool entering,
                                            const Medium* medium, TestCounts& tests);

  [[nodiscard]] static T index(const Medium* medium) { return medium == nullptr ? T(1) : medium->ior; }
  /// The bodies of a medium returned by this class.
  [[nodiscard]] static const BodyStack& bodies_in(const Medium* medium) {
    static const BodyStack none;
    return medium == nullptr ? none : static_cast<const StackedMedium*>(medium)->bodies;
  }

 private:
  /// A copy of the top body's medium, and the whole stack.
  struct StackedMedium : Medium {
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
  using BodyMask = std::vector<std::uint8_t>;  ///< by body: whether it is selected
  static void ask(BodyMask& asked, std::int32_t body, bool yes) { asked[static_cast<std::size_t>(body)] = yes; }
  /// The first hit of one of the selected bodies.
  struct BodyHit {
    std::int32_t body;
    bool entering;
  };
  template <class AnyRay>
  [[nodiscard]] std::optional<BodyHit> first_met(const BodyMask& asked, const AnyRay& ray, T t_max,
                                                 TestCounts& tests) const {
    const auto hit = world_.accelerator.closest(ray, t_max, tests, OfBodies{world_.bodies.of, asked});
    if (!hit) return std::nullopt;
    const Vec3<T> normal =
        world_.accelerator.primitives().surface_at(hit->primitive, ray, Intersection<T>{hit->t, hit->part}).normal;
    return BodyHit{world_.bodies.of_primitive(hit->primitive), dot(normal, ray.direction) <= 0};
  }
  /// Of the bodies `undecided`, those that the ray leaves before it enters them, in this order. Those that it does not
  /// cross stay undecided.
  template <class AnyRay>
  [[nodiscard]] BodyStack left_by(const AnyRay& ray, BodyStack& undecided, TestCounts& tests);
  /// `at_start` where bodies neither touch nor hold the eye: a ray is inside of at most one.
  template <class AnyRay>
  [[nodiscard]] const Medium* alone_at_start(const AnyRay& ray, TestCounts& tests) const;
  /// Whether an unbounded body contains a point. If so, some line along an axis leads out of it.
  template <class AnyRay>
  [[nodiscard]] bool endless_holds(std::int32_t body, const AnyRay& from, TestCounts& tests);

  const World<T>& world_;
  std::map<BodyStack, StackedMedium> known_;
  BodyMask all_, some_;  ///< kept so that no ray allocates; between calls all and none are set
};

/// Replaces NestedMedia in kernels without nesting.
template <class T>
struct NoNestedMedia {
  explicit NoNestedMedia(const World<T>& /*world*/) {}
};

template <class T>
template <class AnyRay>
bool NestedMedia<T>::endless_holds(std::int32_t body, const AnyRay& from, TestCounts& tests) {
  std::optional<BodyHit> met;
  ask(some_, body, true);
  for (int sense = 0; sense < 6 && !met; ++sense) {
    AnyRay ray = from;
    ray.direction = Vec3<T>(0);
    ray.direction[sense / 2] = static_cast<T>(sense % 2 == 0 ? 1 : -1);
    met = first_met(some_, ray, infinity<T>, tests);
  }
  ask(some_, body, false);
  return met && !met->entering;
}

template <class T>
template <class AnyRay>
BodyStack NestedMedia<T>::left_by(const AnyRay& ray, BodyStack& undecided, TestCounts& tests) {
  BodyStack left;
  for (const std::int32_t body : undecided) ask(some_, body, true);
  while (const auto met = first_met(some_, ray, infinity<T>, tests)) {
    if (!met->entering) left.push_back(met->body);
    leave(undecided, met->body);
    ask(some_, met->body, false);
  }
  for (const std::int32_t body : undecided) ask(some_, body, false);
  return left;
}

template <class T>
template <class AnyRay>
auto NestedMedia<T>::at_start(const AnyRay& ray, TestCounts& tests) -> const Medium* {
  const Bodies& bodies = world_.bodies;
  if (bodies.empty()) return world_.absorbs ? alone_at_start(ray, tests) : nullptr;
  BodyStack undecided, stack;
  for (std::size_t body = 0; body < bodies.list.size(); ++body) undecided.push_back(static_cast<std::int32_t>(body));
  const BodyStack left = left_by(ray, undecided, tests);
  for (const std::int32_t body : undecided)
    if (bodies[body].endless && endless_holds(body, ray, tests)) enter(stack, body, bodies);
  // Of two that hold the start, the outer one is left later.
  for (auto body = left.rbegin(); body != left.rend(); ++body) enter(stack, *body, bodies);
  return medium_of(stack);
}

template <class T>
template <class AnyRay>
auto NestedMedia<T>::alone_at_start(const AnyRay& ray, TestCounts& tests) const -> const Medium* {
  constexpr int most = 100;  // surfaces, whatever rounding does where they touch
  // Along a ray that meets no body, one without an end may lie all the way; along some axis it ends.
  for (int sense = -1; sense < 6; ++sense) {
    AnyRay rest = ray;
    if (sense >= 0) {
      rest.direction = Vec3<T>(0);
      rest.direction[sense / 2] = static_cast<T>(sense % 2 == 0 ? 1 : -1);
    }
    for (int surfaces = 0; surfaces < most; ++surfaces) {
      const auto hit = world_.accelerator.closest(rest, infinity<T>, tests);
      if (!hit) break;
      const auto& met = world_.surface(hit->primitive);
      const SurfacePoint<T> point =
          world_.accelerator.primitives().surface_at(hit->primitive, rest, Intersection<T>{hit->t, hit->part});
      if (met.transmits) return dot(point.normal, rest.direction) > 0 ? &met : nullptr;
      rest = spawn_ray<AnyRay>(world_, point.position, point.normal, {hit->primitive, hit->part}, rest.direction,
                               rest.time);
    }
  }
  return nullptr;
}

template <class T>
template <class AnyRay>
auto NestedMedia<T>::at_eye(const AnyRay& ray, TestCounts& tests) -> const Medium* {
  const Bodies& bodies = world_.bodies;
  BodyStack undecided = bodies.around_eye;
  const BodyStack left = left_by(ray, undecided, tests);
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
  // The distance that rounding may put between coinciding surfaces.
  const T size = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z), hit.t});
  const T rounding = 64 * std::numeric_limits<T>::epsilon() * size;
  const Bodies& bodies = world_.bodies;
  const std::int32_t body = bodies.of_primitive(hit.primitive);
  BodyStack stack = bodies_in(medium);
  const Medium* before = medium;
  if (!entering && !holds(stack, body)) {
    // The ray exits a body that it never entered. Close to its origin that is rounding, where surfaces of two bodies
    // coincide. Otherwise the body has an opening through which the ray came in.
    if (hit.t > rounding) {
      enter(stack, body, bodies);
      before = medium_of(stack);
    }
  }
  BodyStack crossed;
  const auto cross = [&](const BodyHit& met) {
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
