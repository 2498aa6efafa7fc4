#pragma once
// Switches for effects: left out at once in the plan and in the picture, with what each costs in rays.

#include "scene/effects.h"
#include "scene/render_choices.h"
#include "timeline/timeline.h"
#include "view/fields.h"
#include "view/room.h"

#include <array>
#include <bitset>
#include <memory>
#include <optional>

namespace raywalk {

/// By the numbers of the effects.
using EffectSet = std::bitset<effect_count>;
[[nodiscard]] constexpr std::size_t number_of(Effect effect) { return static_cast<std::size_t>(effect); }

/// What the switches say.
struct EffectRays {
  std::shared_ptr<const Timeline> of;  ///< the walk
  int samples = 1;                     ///< of walk and picture, with all effects
  EffectSet offered;                   ///< that the scene uses, or that are left out of it
  EffectSet can;                       ///< of those: that can be left out, or taken in again
  // Rays formed in the walk; 0 where they are too many to be counted again for each effect.
  bool counted = false;
  int all = 0;
  std::array<int, effect_count> brought{};  ///< by each that can be switched; left out: what it would bring
  int by_depth = 0;                         ///< by the deepest SHADE
};

}  // namespace raywalk

namespace raywalk::action {

/// The bar with the switches. Hidden, nothing is left out.
struct ShowEffects {
  static constexpr std::string_view word = "effects";
  bool shown;
  static void fields(auto& f, auto& a) { f(a.shown, on_or_off); }
  void apply(State& state) const;
};
struct SwitchEffect {
  static constexpr std::string_view word = "effect";
  Effect effect;
  bool on;
  static void fields(auto& f, auto& a) { f(a.effect), f(a.on, on_or_off); }
  void apply(State& state) const;
};
/// Of plan and picture, in place of the scene's own; clamped.
struct LimitDepth {
  static constexpr std::string_view word = "depth";
  int depth;
  static void fields(auto& f, auto& a) { f(a.depth); }
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// Effects that are left out, though the scene calls for them.
struct EffectsRoom {
  using Actions = Types<action::ShowEffects, action::SwitchEffect, action::LimitDepth>;
  static Commands commands();
  static void follow(State& state, const Before& before);
  static void close(State& state);
  static constexpr int deepest = 50;  ///< that it limits to; as in the settings of the picture
  /// As a link says. A faulty tracer has all effects; `depth` is clamped, and absent the scene's own.
  static void leave_out(State& state, EffectSet effects, std::optional<int> depth);

  bool shown = false;
  EffectSet left_out;
  std::optional<int> depth;                ///< absent: the scene's
  std::shared_ptr<const EffectRays> rays;  ///< null before the bar is shown

  [[nodiscard]] bool leaves_out() const { return left_out.any() || depth; }
  [[nodiscard]] bool leaves_out(Effect effect) const { return left_out[number_of(effect)]; }
  /// Effects that the tracer leaves out; the scene is seen without the others.
  [[nodiscard]] EffectSwitches switches() const;
};

/// The scene without the effects that are left out, but for those that the tracer leaves out; empty where there are
/// none.
[[nodiscard]] std::optional<Scene> without_effects(const State& state, const Scene& scene);
/// Samples of a pixel, of `asked`: one without antialiasing.
[[nodiscard]] int samples_seen(const State& state, int asked);

/// Whether an effect of the scene can be left out of the walk as it is: a faulty tracer has all of them, only Whitted's
/// algorithm, with robust numerics, does without shadow rays, and a beam is as wide as its pixel.
[[nodiscard]] bool can_switch(const State& state, Effect effect);

}  // namespace raywalk
