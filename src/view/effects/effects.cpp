#include "study/effect_costs.h"
#include "view/action.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace raywalk {

namespace {

constexpr double most_entries = 20'000;     // of a scene whose rays are counted: it needs a world for each effect
constexpr std::size_t most_rays = 100'000;  // of all walks that are recorded to count them

/// Effects that the tracer can leave out alone.
constexpr struct {
  Effect effect;
  bool EffectSwitches::* on;
} of_tracer[]{{Effect::shadows, &EffectSwitches::shadows},
              {Effect::reflection, &EffectSwitches::reflection},
              {Effect::refraction, &EffectSwitches::refraction}};

bool is_of_tracer(Effect effect) {
  return std::any_of(std::begin(of_tracer), std::end(of_tracer), [&](const auto& of) { return of.effect == effect; });
}

int most_samples(const State& state) {
  return std::max(state.picture.settings.walk_samples, state.picture.settings.samples);
}

/// What is so of `tried` with other switches. That is one copy of the state for all that is asked: its scene may be
/// large.
template <class Ask>
auto with(State& tried, EffectSet left_out, const Ask& ask) {
  const EffectSet own = std::exchange(tried.effects.left_out, left_out);
  auto answer = ask(std::as_const(tried));
  tried.effects.left_out = own;
  return answer;
}

/// What the scene calls for as it is walked, with nothing left out.
Effects used_effects(State& tried) {
  return with(tried, {}, [](const State& all) { return effects_of(*walked_scene(all), most_samples(all)); });
}

void limit(State& state, int depth) {
  state.effects.depth.reset();
  if (depth != state.scene().limits.depth) state.effects.depth = std::clamp(depth, 1, EffectsRoom::deepest);
}

/// Plan and picture as the switches now say.
void see_again(State& state) {
  state.document.worlds = std::make_shared<WorldCache>();  // of one scene
  ++state.picture.revision;
  record_again(state);
}

int formed(const Timeline& timeline) {
  return static_cast<int>(
      std::count_if(timeline.rays().begin(), timeline.rays().end(), [](const RayRecord& ray) { return ray.formed; }));
}

void count(State& tried, EffectRays& rays) {
  const auto difference = [&](const State& other) { return std::abs(rays.all - formed(record_alone(other))); };
  for (const Effect effect : values_of<Effect>)
    if (rays.can[number_of(effect)])
      rays.brought[number_of(effect)] =
          with(tried, EffectSet(tried.effects.left_out).flip(number_of(effect)), difference);
  const int depth = tried.effects.depth.value_or(tried.scene().limits.depth);
  if (depth > 1) {
    const auto own = std::exchange(tried.effects.depth, depth - 1);
    rays.by_depth = difference(tried);
    tried.effects.depth = own;
  }
}

/// Whether an effect that the scene uses can be left out (can_switch).
bool can_leave_out(State& tried, Effect effect) {
  if (tried.walk.bug) return false;
  return with(tried, EffectSet(tried.effects.left_out).set(number_of(effect)), [&](const State& without) {
    const SceneSeen scene = walked_scene(without);
    const RenderChoices& now = scene->render;
    if (effect == Effect::shadows) return now.numerics == Numerics::robust && !traits_of(now.integrator).is_global;
    return is_of_tracer(effect) || !effects_of(*scene, samples_seen(without, most_samples(without))).used(effect);
  });
}

EffectRays looked_at(const State& state) {
  EffectRays rays;
  rays.of = state.walk.timeline;
  rays.samples = most_samples(state);
  State tried = state;
  const Effects used = used_effects(tried);
  for (const Effect effect : values_of<Effect>) {
    const bool is_out = state.effects.leaves_out(effect);
    rays.offered.set(number_of(effect), is_out || used.used(effect));
    rays.can.set(number_of(effect), is_out || (used.used(effect) && can_leave_out(tried, effect)));
  }
  rays.all = formed(*state.walk.timeline);
  rays.counted = entries_of(state.scene().objects) <= most_entries &&
                 static_cast<std::size_t>(rays.all) * (rays.can.count() + 1) <= most_rays;
  if (rays.counted) count(tried, rays);
  return rays;
}

}  // namespace

EffectSwitches EffectsRoom::switches() const {
  EffectSwitches switches;
  for (const auto& [effect, on] : of_tracer) switches.*on = !leaves_out(effect);
  return switches;
}

std::optional<Scene> without_effects(const State& state, const Scene& scene) {
  std::optional<Scene> changed;
  for (const Effect effect : values_of<Effect>)
    if (state.effects.leaves_out(effect) && !is_of_tracer(effect))
      if (auto without = study::without(changed ? *changed : scene, effect)) changed = std::move(without);
  return changed;
}

int samples_seen(const State& state, int asked) { return state.effects.leaves_out(Effect::antialiasing) ? 1 : asked; }

bool can_switch(const State& state, Effect effect) {
  State tried = state;
  return used_effects(tried).used(effect) && can_leave_out(tried, effect);
}

void action::ShowEffects::apply(State& state) const {
  state.effects.shown = shown;
  if (shown || !state.effects.leaves_out()) return;
  EffectsRoom::close(state);
  see_again(state);
}

void action::SwitchEffect::apply(State& state) const {
  state.effects.shown = true;
  if (on != state.effects.leaves_out(effect) || (!on && !can_switch(state, effect))) return;
  state.effects.left_out.set(number_of(effect), !on);
  see_again(state);
}

void action::LimitDepth::apply(State& state) const {
  state.effects.shown = true;
  const std::optional<int> before = state.effects.depth;
  limit(state, depth);
  if (state.effects.depth != before) see_again(state);
}

void EffectsRoom::leave_out(State& state, EffectSet effects, std::optional<int> depth) {
  state.effects.shown = true;
  if (!state.walk.bug) state.effects.left_out = effects;
  limit(state, depth.value_or(state.scene().limits.depth));
  see_again(state);
}

void EffectsRoom::follow(State& state, const Before&) {
  EffectsRoom& effects = state.effects;
  // A drag comes first: the numbers follow at its end.
  if (!effects.shown || state.plan.drag) return;
  if (effects.rays && effects.rays->of == state.walk.timeline && effects.rays->samples == most_samples(state)) return;
  effects.rays = std::make_shared<const EffectRays>(looked_at(state));
}

void EffectsRoom::close(State& state) {
  if (state.effects.left_out.any()) state.document.worlds = std::make_shared<WorldCache>();
  state.effects.left_out.reset();
  state.effects.depth.reset();
  state.effects.rays.reset();
}

}  // namespace raywalk
