#include "view/text/choice_text.h"

namespace raywalk {

std::string_view text(AcceleratorKind kind, Language language) {
  return family_text("accelerator", accelerator_name(kind), language);
}

std::string_view text(Integrator integrator, Language language) {
  return family_text("integrator", integrator_name(integrator), language);
}

std::string_view text(Sampler sampler, Language language) {
  return family_text("sampler", sampler_name(sampler), language);
}

std::string_view text(Numerics numerics, Language language) {
  return family_text("numerics", numerics_name(numerics), language);
}

std::string_view text(Effect effect, Language language) { return family_text("effect", effect_name(effect), language); }

}  // namespace raywalk
