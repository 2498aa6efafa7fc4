#include "view/text/choice_text.h"

namespace raywalk {

std::string_view text(AcceleratorKind kind, Language language) {
  return family_text("accelerator", name_of(kind), language);
}

std::string_view text(Integrator integrator, Language language) {
  return family_text("integrator", name_of(integrator), language);
}

std::string_view text(Sampler sampler, Language language) { return family_text("sampler", name_of(sampler), language); }

std::string_view text(Numerics numerics, Language language) {
  return family_text("numerics", name_of(numerics), language);
}

std::string_view text(Subsurface subsurface, Language language) {
  return family_text("subsurface", name_of(subsurface), language);
}

std::string_view text(Heat heat, Language language) {
  const auto id = [&]() -> std::string_view {
    switch (heat) {
      case Heat::none:
        return "heat.none";
      case Heat::rays:
        return "heat.rays";
      case Heat::tests:
        return "heat.tests";
      case Heat::time:
        return "heat.time";
      case Heat::noise:
        return "heat.noise";
    }
    return "heat.none";
  }();
  return text(id, language);
}

std::string_view text(Effect effect, Language language) { return family_text("effect", name_of(effect), language); }

}  // namespace raywalk
