#include "app/idle_options.h"

#include "app/drawing.h"
#include "render/adaptive.h"
#include "scene/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace raywalk {

namespace {

/// Whether a random number may be drawn. Assumed for paths, which nearly always draw.
bool may_draw(const Scene& scene, Integrator integrator) {
  if (integrator != Integrator::distributed) return draws_random(integrator);
  const Effects effects = effects_of(scene, scene.render.samples);
  constexpr std::array drawn{Effect::antialiasing, Effect::gloss,          Effect::translucency,
                             Effect::penumbra,     Effect::depth_of_field, Effect::motion_blur};
  const auto uses = material_uses(scene);
  return std::any_of(drawn.begin(), drawn.end(), [&](Effect effect) { return effects.used(effect); }) ||
         std::any_of(uses.begin(), uses.end(), [](const MaterialUse& use) { return use.material->is_rough(); });
}

}  // namespace

std::vector<std::string> idle_options(std::string_view command, const RenderOptions& given, const Scene& scene) {
  const RenderChoices& choices = scene.render;
  const Integrator integrator = integrator_of(scene, choices.samples);
  const std::string_view name = name_of(integrator);
  std::vector<std::string> lines;
  const auto idle = [&](std::string_view option, const std::string& why) {
    lines.push_back(fmt::format("raywalk {}: note: {} has no effect: {}", command, option, why));
  };

  constexpr int first_look = Adaptive<double>::first_look;
  const bool is_drawn = is_drawing(given.image);
  if (is_drawn) {
    const std::string why = "a drawing is cut along edges, and takes no samples";
    if (given.samples) idle("--spp", why);
    if (given.corner_samples) idle("--corner-samples", why);
    if (given.tolerance) idle("--tolerance", why);
    if (given.threads > 0) idle("--threads", "a drawing is made by one thread");
    if (given.precision != Precision::double_) idle("--precision", "a drawing is computed in double");
  } else if (given.tolerance.value_or(0) > 0 && choices.samples <= first_look) {
    idle("--tolerance",
         fmt::format("a pixel always takes its first {} samples, and has only {} here", first_look, choices.samples));
  }
  if (!may_draw(scene, integrator)) {
    const std::string why = fmt::format("the integrator {} draws no random number here", name);
    if (given.sampler) idle("--sampler", why);
    if (given.seed) idle("--seed", why);
  }
  const bool is_global = traits_of(integrator).is_global;
  if (given.light_grid && std::none_of(scene.lights.begin(), scene.lights.end(), is_area))
    idle("--light-grid", "no light has an extent");
  else if (given.light_grid && integrator == Integrator::cones)
    idle("--light-grid", "cones see lights whole");
  else if (given.light_grid && is_global)
    idle("--light-grid", fmt::format("the integrator {} chooses points of lights by itself", name));
  if (is_global || !traits_of(integrator).is_recursive) {
    const std::string why = integrator == Integrator::path ? "paths end by chance, or as --path-length says"
                            : integrator == Integrator::photons
                                ? "photons and rays end by chance"
                                : fmt::format("the integrator {} follows no ray beyond a hit", name);
    if (given.depth) idle("--depth", why);
    if (given.threshold) idle("--threshold", why);
  }
  if (given.path_length && integrator != Integrator::path)
    idle("--path-length", fmt::format("the integrator is {} (expected --integrator path)", name));
  if (traits_of(integrator).has_width) {
    const std::string why = fmt::format("{} have numerics of their own", name);
    if (given.numerics) idle("--numerics", why);
    if (given.epsilon) idle("--epsilon", why);
  } else if (given.epsilon && choices.numerics != Numerics::naive) {
    idle("--epsilon", fmt::format("numerics are {} (expected --numerics naive)", name_of(choices.numerics)));
  }
  return lines;
}

}  // namespace raywalk
