#pragma once
// Switches for effects: left out at once in the plan and in the picture, with what each costs in rays.

#include "scene/effects.h"
#include "scene/render_choices.h"
#include "timeline/timeline.h"
#include "view/fields.h"
#include "view/room.h"

#include <array>
#include <memory>
#include <optional>

namespace raywalk {

/// Those that can be switched.
inline constexpr std::array switched_effects{Effect::shadows, Effect::reflection, Effect::refraction};

/// Rays formed in the walk, and how many of them each effect brings.
struct EffectRays {
  std::shared_ptr<const Timeline> of;  ///< the walk
  int all = 0;
  std::array<int, switched_effects.size()> brought{};  ///< by each; of one that is left out: what it would bring
  int by_depth = 0;                                    ///< by the deepest SHADE
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
  Effect effect;  ///< one of switched_effects
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

  bool shown = false;
  EffectSwitches switches;
  std::optional<int> depth;                ///< absent: the scene's
  std::shared_ptr<const EffectRays> rays;  ///< null before they are counted, and for very large scenes

  [[nodiscard]] bool leaves_out() const { return switches != EffectSwitches{} || depth; }
};

/// Whether an effect can be left out of the walk as it is: a faulty tracer has all of them, and only Whitted's
/// algorithm, with robust numerics, does without shadow rays.
[[nodiscard]] bool can_switch(const State& state, Effect effect);
/// The switch of one of switched_effects.
[[nodiscard]] bool& switch_of(EffectSwitches& switches, Effect effect);

}  // namespace raywalk
