// What one chooses from, in English: as files and options name it.

#include "view/choice_text.h"

namespace raywalk {

std::string_view english(AcceleratorKind kind) { return accelerator_name(kind); }

std::string_view english(Integrator integrator) { return integrator_name(integrator); }

std::string_view english(Sampler sampler) { return sampler_name(sampler); }

std::string_view english(Numerics numerics) { return numerics_name(numerics); }

std::string_view english(Effect effect) {
  switch (effect) {
    case Effect::shadows:
      return "shadows";
    case Effect::reflection:
      return "reflection";
    case Effect::refraction:
      return "refraction";
    case Effect::gloss:
      return "gloss";
    case Effect::translucency:
      return "translucency";
    case Effect::penumbra:
      return "penumbra";
    case Effect::depth_of_field:
      return "depth of field";
    case Effect::motion_blur:
      return "motion blur";
    case Effect::antialiasing:
      return "antialiasing";
    case Effect::indirect_light:
      return "indirect light";
    case Effect::textures:
      return "textures";
  }
  return {};
}

}  // namespace raywalk
