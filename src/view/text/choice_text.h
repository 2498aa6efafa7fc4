#pragma once
// The names of choices. Files and options use English, whatever the language of the interface.

#include "accel/accelerator.h"
#include "math/sampler.h"
#include "render/heat.h"
#include "scene/effects.h"
#include "scene/render_choices.h"
#include "text/language.h"

#include <array>
#include <string_view>

namespace raywalk {

[[nodiscard]] std::string_view text(AcceleratorKind kind, Language language);
[[nodiscard]] std::string_view text(Integrator integrator, Language language);
[[nodiscard]] std::string_view text(Sampler sampler, Language language);
[[nodiscard]] std::string_view text(Numerics numerics, Language language);
[[nodiscard]] std::string_view text(Subsurface subsurface, Language language);
[[nodiscard]] std::string_view text(Heat heat, Language language);
[[nodiscard]] std::string_view text(Effect effect, Language language);  ///< "depth of field"

/// The accelerators offered to the user.
inline constexpr std::array pickable_accelerators{AcceleratorKind::automatic, AcceleratorKind::none,
                                                  AcceleratorKind::bvh,       AcceleratorKind::grid,
                                                  AcceleratorKind::octree,    AcceleratorKind::kdtree};

/// Whether single precision is used.
inline constexpr std::array precisions{false, true};
[[nodiscard]] constexpr std::string_view precision_word(bool single) {
  return single ? "precision.float" : "precision.double";
}

}  // namespace raywalk
