#pragma once
// What the window calls the things of its scene.

#include "scene/names.h"
#include "view/state.h"
#include "view/text/text.h"

#include <string>

namespace raywalk {

/// In the language of the window.
[[nodiscard]] inline std::string shown_name(const State& state, std::string_view name) {
  return shown_name(state.scene(), name, state.appearance.language);
}
[[nodiscard]] inline std::string object_name(const State& state, int object) {
  return shown_name(state, state.scene().objects[static_cast<std::size_t>(object)].name);
}
[[nodiscard]] inline std::string light_name(const State& state, int light) {
  return shown_name(state, state.scene().lights[static_cast<std::size_t>(light)].name);
}

/// What follows rays: "shadow ray", and of a walk of cones "cone".
[[nodiscard]] inline std::string kind_name(const State& state, RayKind kind) {
  const bool cone = kind == RayKind::beam && state.walk.timeline->of_cones();
  return std::string(cone ? text("plan.cone", state.appearance.language) : text(kind, state.appearance.language));
}

/// Why nothing is shown of a pixel where none is walked: `at_start`, or that photons or patches have light first.
[[nodiscard]] inline std::string text_without_pixel(const State& state, std::string_view at_start) {
  const bool light_first = state.walk.timeline->of_photons() || state.walk.timeline->of_radiosity();
  return std::string(
      text(light_first && state.walk.position > 0 ? "stack.no_pixel" : at_start, state.appearance.language));
}

/// How much of its pixel a part of a beam is, or of its cone a part of a cone: "0.2 of the pixel".
[[nodiscard]] inline std::string coverage_text(const State& state, const BeamRecord& part) {
  const Language language = state.appearance.language;
  return fill(state.walk.timeline->of_cones() ? "plan.of_cone" : "plan.of_pixel", language,
              {{"coverage", number_text(part.coverage, language)}});
}

}  // namespace raywalk
