#pragma once

#include "math/numerics.h"
#include "math/ray.h"
#include "scene/effects.h"
#include "trace/event.h"
#include "trace/fault.h"

#include <cstddef>
#include <type_traits>

namespace raywalk {

/// Observes nothing and compiles away.
struct NoObserver {
  static constexpr bool watches = false;
};

/// Receives every event, in order.
class Observer {
 public:
  static constexpr bool watches = true;
  virtual ~Observer() = default;
  virtual void record(Event&& event) = 0;
};

/// The effects whose code is inside the hit loop. A kernel without an effect contains none of its code.
struct HitEffects {
  bool reflection = true, refraction = true, textures = true;
  bool penumbra = true;     ///< area lights, or many lights
  bool lobes = true;        ///< gloss and translucency
  bool shadows = true;      ///< lights at all, occluded or not
  bool nesting = true;      ///< transmitting bodies may overlap, or contain the eye
  bool occlusion = true;    ///< shadow rays are traced; else every light in front of a surface reaches it
  bool scattering = true;   ///< paths scatter inside of bodies
  bool sky = true;          ///< what rays bring back that leave the scene depends on their direction
  bool filtering = true;    ///< rays carry differentials, by which patterns are filtered
  bool microfacets = true;  ///< mirrors of metal, and of small mirrors
  bool maps = true;         ///< surfaces are different from point to point, other than by a pattern of ka and kd
  bool dipole = true;       ///< paths that go into a body that scatters may leave it without a walk
  bool bounced = true;      ///< light that surfaces send each other is in the place of ambient light
  friend bool operator==(const HitEffects&, const HitEffects&) = default;
};
inline constexpr HitEffects all_hit_effects{};
inline constexpr HitEffects no_occlusion{.occlusion = false};
/// Each of these is without the last three, which few scenes call for.
inline constexpr HitEffects no_maps{.maps = false, .dipole = false, .bounced = false};
inline constexpr HitEffects no_filtering = [] {
  HitEffects set = no_maps;
  set.filtering = false;
  return set;
}();
inline constexpr HitEffects no_filtering_nor_facets = [] {
  HitEffects set = no_filtering;
  set.microfacets = false;
  return set;
}();
/// With sharp rays and sharp shadows alone.
inline constexpr HitEffects sharp_rays = [] {
  HitEffects set = no_filtering_nor_facets;
  set.penumbra = set.lobes = set.scattering = set.sky = false;
  return set;
}();
/// With filters, what most scenes have that filter, where no bodies nest; and without mirrors and glass.
inline constexpr HitEffects plain_filtering = [] {
  HitEffects set = sharp_rays;
  set.filtering = true;
  set.nesting = false;
  return set;
}();
inline constexpr HitEffects matt_filtering = [] {
  HitEffects set = plain_filtering;
  set.reflection = set.refraction = false;
  return set;
}();

/// Where the program is to be small, as in a page, or sanitizers make it large, many scenes take kernels that have more
/// than they call for: the same bits, a little later.
#ifdef RAYWALK_FEW_KERNELS
inline constexpr bool few_kernels = true;
#else
inline constexpr bool few_kernels = false;
#endif

/// Where there are to be few kernels, those that are rarely used and not watched are watched by this one, to the same
/// bits.
struct ForgetfulObserver final : Observer {
  void record(Event&& /*event*/) override {}
};

/// Lights that a hit may have before the tracer asks between them whether it is cancelled: so few are soon done.
inline constexpr std::size_t few_lights = 64;

/// `lights`: how many the world has. `nesting`: whether it has bodies that can nest.
[[nodiscard]] inline HitEffects hit_effects(const Effects& effects, std::size_t lights, bool nesting) {
  return {.reflection = effects.used(Effect::reflection),
          .refraction = effects.used(Effect::refraction),
          .textures = effects.used(Effect::textures),
          .penumbra = effects.used(Effect::penumbra) || lights > few_lights,
          .lobes = effects.used(Effect::gloss) || effects.used(Effect::translucency),
          .shadows = effects.used(Effect::shadows),
          .nesting = nesting,
          .occlusion = true,
          .scattering = effects.used(Effect::scattering),
          .sky = effects.used(Effect::sky),
          .filtering = effects.used(Effect::filtering),
          .microfacets = effects.used(Effect::microfacets),
          .maps = effects.used(Effect::maps),
          .dipole = false,
          .bounced = effects.used(Effect::indirect_light)};
}

/// Everything about the tracer that is fixed when it is compiled.
template <class ScalarType, class ObserverType = NoObserver, HitEffects Set = all_hit_effects,
          Numerics Arithmetic = Numerics::robust, bool Faulty = false>
struct Policy {
  using Scalar = ScalarType;
  using Observer = ObserverType;
  static constexpr HitEffects effects = Set;
  static_assert(Set.refraction || !Set.nesting, "only bodies that transmit nest");
  /// The ray type, which selects robust or naive intersections.
  using Ray = std::conditional_t<Arithmetic == Numerics::naive, NaiveRay<Scalar>, raywalk::Ray<Scalar>>;
  /// Whether there are hooks for fault injection: the fault that a world names breaks the tracer on purpose
  /// (trace/fault.h). A kernel without them contains none of their code.
  static constexpr bool faulty = Faulty;

  /// Whether shadow rays are traced. Of kernels that need to be fast and are many, those for looking alone do not; the
  /// others ask the world.
  [[nodiscard]] static constexpr bool occludes(const auto& world) {
    constexpr bool asks = Observer::watches || few_kernels || Arithmetic == Numerics::naive;
    return asks ? world.occludes : effects.occlusion;
  }
};

/// The policy's hook for fault injection: lets the fault that the world names change what a statement has computed.
/// Without faults, `damage` is not compiled into the kernel.
template <class Policy, class World, class Damage>
void inject(const World& world, Fault fault, Damage&& damage) {
  if constexpr (Policy::faulty) {
    if (world.fault == fault) damage();
  }
}

}  // namespace raywalk
