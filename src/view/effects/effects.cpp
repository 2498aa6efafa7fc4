#include "view/action.h"
#include "view/walk/walk.h"

#include <algorithm>

namespace raywalk {

namespace {

constexpr int deepest = 50;              // as in the settings of the picture
constexpr double most_entries = 20'000;  // of a scene whose rays are counted: it needs a world for each effect

/// Plan and picture as the switches now say.
void see_again(State& state) {
  ++state.picture.revision;
  record_again(state);
}

int formed(const Timeline& timeline) {
  return static_cast<int>(
      std::count_if(timeline.rays().begin(), timeline.rays().end(), [](const RayRecord& ray) { return ray.formed; }));
}

EffectRays counted(const State& state) {
  EffectRays rays{state.walk.timeline, formed(*state.walk.timeline), {}, 0};
  const auto difference = [&](const State& other) { return std::abs(rays.all - formed(record_alone(other))); };
  for (std::size_t i = 0; i < switched_effects.size(); ++i) {
    State other = state;
    bool& on = switch_of(other.effects.switches, switched_effects[i]);
    on = !on;
    rays.brought[i] = difference(other);
  }
  State shallower = state;
  const int depth = state.effects.depth.value_or(state.scene().limits.depth);
  if (depth > 1) {
    shallower.effects.depth = depth - 1;
    rays.by_depth = difference(shallower);
  }
  return rays;
}

}  // namespace

bool can_switch(const State& state, Effect effect) {
  if (state.walk.bug) return false;
  const RenderChoices now = walked_scene(state)->render;
  return effect != Effect::shadows || (now.numerics == Numerics::robust && !traits_of(now.integrator).is_global);
}

bool& switch_of(EffectSwitches& switches, Effect effect) {
  return effect == Effect::shadows      ? switches.shadows
         : effect == Effect::reflection ? switches.reflection
                                        : switches.refraction;
}

void action::ShowEffects::apply(State& state) const {
  state.effects.shown = shown;
  if (shown || !state.effects.leaves_out()) return;
  EffectsRoom::close(state);
  see_again(state);
}

void action::SwitchEffect::apply(State& state) const {
  if (std::find(switched_effects.begin(), switched_effects.end(), effect) == switched_effects.end()) return;
  bool& now = switch_of(state.effects.switches, effect);
  state.effects.shown = true;
  if (now == on || (!on && !can_switch(state, effect))) return;
  now = on;
  see_again(state);
}

void action::LimitDepth::apply(State& state) const {
  const int next = std::clamp(depth, 1, deepest), own = state.scene().limits.depth;
  state.effects.shown = true;
  if (next == state.effects.depth.value_or(own)) return;
  state.effects.depth = next == own ? std::nullopt : std::optional(next);
  see_again(state);
}

void EffectsRoom::follow(State& state, const Before&) {
  EffectsRoom& effects = state.effects;
  // A drag comes first: the numbers follow at its end.
  if (!effects.shown || state.plan.drag || (effects.rays && effects.rays->of == state.walk.timeline)) return;
  effects.rays =
      entries_of(state.scene().objects) > most_entries ? nullptr : std::make_shared<const EffectRays>(counted(state));
}

void EffectsRoom::close(State& state) {
  state.effects.switches = {};
  state.effects.depth.reset();
  state.effects.rays.reset();
}

}  // namespace raywalk
