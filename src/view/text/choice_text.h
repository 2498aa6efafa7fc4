#pragma once
// The names of choices. Files and options use English, whatever the language of the interface.

#include "accel/accelerator.h"
#include "math/sampler.h"
#include "scene/effects.h"
#include "scene/render_choices.h"
#include "text/language.h"

#include <string_view>

namespace raywalk {

[[nodiscard]] std::string_view text(AcceleratorKind kind, Language language);
[[nodiscard]] std::string_view text(Integrator integrator, Language language);
[[nodiscard]] std::string_view text(Sampler sampler, Language language);
[[nodiscard]] std::string_view text(Numerics numerics, Language language);
[[nodiscard]] std::string_view text(Subsurface subsurface, Language language);
[[nodiscard]] std::string_view text(Effect effect, Language language);  ///< "depth of field"

}  // namespace raywalk
