#include "scene/effects.h"
#include "view/cost/cost.h"
#include "view/document/properties.h"
#include "view/outline_items.h"
#include "view/text/choice_text.h"
#include "view/text/shown.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <fmt/format.h>

#include <algorithm>

namespace raywalk {

namespace {

using Role = OutlineItem::Role;

/// A button for each of these values, which says what it is of; `named` is its text.
template <class Choices, class Value, class Named, class Doing>
void choose(OutlineItem& region, std::string_view key, const std::string& label, const Choices& choices,
            const Value& now, const Named& named, const Doing& does) {
  int number = 0;
  for (const auto& choice : choices)
    button(region, fmt::format("{}-{}", key, ++number), label + ": " + std::string(named(choice)), does(choice))
        .chosen = choice == now;
}

/// The line of an action with `{}` for its argument of this number, from 0.
std::string with_gap(const Action& action, int argument) {
  std::string line = write_action(action);
  std::size_t begin = line.find(' ');
  for (int i = 0; i < argument; ++i) begin = line.find(' ', begin + 1);
  const std::size_t end = std::min(line.find(' ', begin + 1), line.size());
  return line.replace(begin + 1, end - begin - 1, "{}");
}

}  // namespace

void outline_breakpoints(const State& state, OutlineItem& region) {
  const Language language = state.appearance.language;
  const auto say = [&](std::string_view id) { return std::string(text(id, language)); };
  if (breakpoints_in_force(state) != breakpoints_here(state)) add(region, Role::warning, "off", say("breakpoints.off"));
  const action::StopAt now = stops_chosen(state);
  field(region, Role::number, "depth", say("breakpoints.at_depth"), with_gap(now, 0), std::to_string(now.depth));
  field(region, Role::number, "pixel", say("breakpoints.at_pixel"), with_gap(now, 1), std::to_string(now.pixel));
  action::StopAt next = now;
  next.total_internal_reflection = !now.total_internal_reflection;
  button(region, "total", say("breakpoints.at_total"), next).chosen = now.total_internal_reflection;
  next = now;
  const int objects = static_cast<int>(std::min(state.scene().objects.size(), most_outlined));
  for (next.object = -1; next.object < objects; ++next.object) {
    const std::string name = next.object < 0 ? say("breakpoints.nowhere") : object_name(state, next.object);
    button(region, fmt::format("object-{}", next.object), say("breakpoints.at_object") + ": " + name, next).chosen =
        next.object == now.object;
  }
  button(region, "remove", say("breakpoints.remove"), action::RemoveBreakpoints{}, breakpoints_here(state).any());
}

void outline_properties(const State& state, OutlineItem& region) {
  const Language language = state.appearance.language;
  const Target& of = state.plan.selected;
  const auto to = [&](const PropertyText& key, std::string_view value) {
    return action::SetKey{of, fmt::format("{} {}", key.key, value)};
  };
  for (const PropertyText& key : property_texts(state, of)) {
    if (key.words.empty()) {
      field(region, Role::words, key.key, key.label, write_action(to(key, "{}")), key.value);
    } else if (key.words.front() == on_or_off.yes) {
      const bool is_on = key.value == on_or_off.yes;
      button(region, key.key, key.label, to(key, is_on ? on_or_off.no : on_or_off.yes)).chosen = is_on;
    } else {
      choose(
          region, key.key, key.label, key.words, std::string_view(key.value),
          [&](std::string_view word) { return family_text("choice", word, language); },
          [&](std::string_view word) { return to(key, word); });
    }
  }
}

void outline_cost_knobs(const State& state, OutlineItem& region) {
  const Language language = state.appearance.language;
  const study::Setup now = cost_knobs(state);
  const auto named = [&](const auto& choice) { return text(choice, language); };
  const auto with = [&](auto study::Setup::* part) {
    return [&now, part](const auto& choice) {
      study::Setup next = now;
      next.*part = choice;
      return action::SetCostKnobs{next};
    };
  };
  const auto number = [&](std::string_view key, std::string_view label, int argument, double value) {
    field(region, Role::number, std::string(key), std::string(text(label, language)),
          with_gap(action::SetCostKnobs{now}, argument), number_text(value, language));
  };
  number("samples", "property.samples", 0, now.samples);
  choose(region, "sampler", std::string(text("property.sampler", language)), values_of<Sampler>, now.sampler, named,
         with(&study::Setup::sampler));
  number("light-grid", "property.light_grid", 2, now.light_grid);
  number("depth", "property.limits_depth", 3, now.depth);
  number("threshold", "property.threshold", 4, now.threshold);
  number("tolerance", "property.tolerance", 7, now.tolerance);
  choose(
      region, "precision", std::string(text("property.precision", language)), precisions, now.single_precision,
      [&](bool single) { return text(precision_word(single), language); }, with(&study::Setup::single_precision));
  choose(region, "numerics", std::string(text("property.numerics", language)), values_of<Numerics>, now.numerics, named,
         with(&study::Setup::numerics));
  if (now.numerics == Numerics::naive) number("epsilon", "property.epsilon", 9, now.epsilon);
  choose(region, "accelerator", std::string(text("property.accelerator", language)), pickable_accelerators,
         now.accelerator, named, with(&study::Setup::accelerator));
}

void outline_image_settings(const State& state, OutlineItem& region) {
  const Language language = state.appearance.language;
  const auto say = [&](std::string_view id) { return std::string(text(id, language)); };
  const auto named = [&](const auto& choice) { return text(choice, language); };
  const ImageSettings& now = state.picture.settings;
  const Scene& scene = state.scene();
  const auto with = [&](auto ImageSettings::* part) {
    return [&now, part](const auto& choice) {
      ImageSettings next = now;
      next.*part = choice;
      return action::SetImageSettings{next};
    };
  };
  choose(region, "integrator", say("property.integrator"), values_of<Integrator>,
         now.integrator.value_or(scene.render.integrator), named, with(&ImageSettings::integrator));
  choose(region, "accelerator", say("property.accelerator"), pickable_accelerators, now.accelerator, named,
         with(&ImageSettings::accelerator));
  field(region, Role::number, "samples", say("property.samples"), with_gap(action::SetImageSettings{now}, 2),
        std::to_string(now.samples));
  field(region, Role::number, "walk-samples", say("property.walk_samples"), with_gap(action::SetImageSettings{now}, 3),
        std::to_string(now.walk_samples));
  choose(
      region, "precision", say("property.precision"), precisions, now.single_precision,
      [&](bool single) { return text(precision_word(single), language); }, with(&ImageSettings::single_precision));
  choose(region, "heat", say("property.heat"), values_of<Heat>, now.heat, named, with(&ImageSettings::heat));

  // Of the scene: they change its walk and its file, too.
  const TraceLimits& limits = scene.limits;
  field(region, Role::number, "depth", say("property.limits_depth"), with_gap(action::SetLimits{limits}, 0),
        std::to_string(limits.depth));
  field(region, Role::number, "threshold", say("property.threshold"), with_gap(action::SetLimits{limits}, 1),
        number_text(limits.threshold, language));
  const RenderChoices& render = scene.render;
  choose(region, "numerics", say("property.numerics"), values_of<Numerics>, render.numerics, named,
         [&](Numerics numerics) { return action::SetNumerics{numerics, render.epsilon}; });
  field(region, Role::number, "epsilon", say("property.epsilon"),
        with_gap(action::SetNumerics{render.numerics, render.epsilon}, 1), number_text(render.epsilon, language));
  const bool as_ambient = render.radiosity.as_ambient;
  if (effects_of(scene).used(Effect::scattering))
    choose(region, "subsurface", say("property.subsurface"), values_of<Subsurface>, render.subsurface, named,
           [&](Subsurface subsurface) { return action::SetLightWays{subsurface, as_ambient}; });
  if (may_take_ambient_from_patches(now.integrator.value_or(render.integrator)))
    button(region, "as-ambient", say("property.as_ambient"), action::SetLightWays{render.subsurface, !as_ambient})
        .chosen = as_ambient;
}

}  // namespace raywalk
