#pragma once
// What one chooses from, in words: families of view/text.h. Files and options name the same things in English, however
// the interface speaks.

#include "accel/accelerator.h"
#include "math/sampler.h"
#include "scene/effects.h"
#include "scene/render_choices.h"

#include <string_view>

namespace raywalk {

[[nodiscard]] std::string_view english(AcceleratorKind kind);
[[nodiscard]] std::string_view english(Integrator integrator);
[[nodiscard]] std::string_view english(Sampler sampler);
[[nodiscard]] std::string_view english(Numerics numerics);
[[nodiscard]] std::string_view english(Effect effect);  ///< "depth of field"
[[nodiscard]] std::string_view portuguese(AcceleratorKind kind);
[[nodiscard]] std::string_view portuguese(Integrator integrator);
[[nodiscard]] std::string_view portuguese(Sampler sampler);
[[nodiscard]] std::string_view portuguese(Numerics numerics);
[[nodiscard]] std::string_view portuguese(Effect effect);

}  // namespace raywalk
