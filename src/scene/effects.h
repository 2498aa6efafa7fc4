#pragma once

#include "scene/scene.h"

#include <array>
#include <string>
#include <string_view>

namespace raywalk {

/// Everything that a scene may or may not call for. The tracer simulates only what is used.
enum class Effect {
  shadows,
  reflection,
  refraction,
  gloss,
  translucency,
  penumbra,
  depth_of_field,
  motion_blur,
  antialiasing,
  indirect_light,
  textures,
};
inline constexpr int effect_count = 11;

[[nodiscard]] std::string_view effect_name(Effect effect);

struct EffectUse {
  bool used = false;
  std::string why;  ///< one clause, for people: "the material of Mirror Sphere reflects"
};

/// Which effects a scene calls for and why. Enabled but inert counts as not used.
class Effects {
 public:
  [[nodiscard]] const EffectUse& operator[](Effect effect) const { return uses_[static_cast<std::size_t>(effect)]; }
  EffectUse& operator[](Effect effect) { return uses_[static_cast<std::size_t>(effect)]; }
  [[nodiscard]] bool used(Effect effect) const { return (*this)[effect].used; }

 private:
  std::array<EffectUse, effect_count> uses_;
};

[[nodiscard]] Effects effects_of(const Scene& scene, int samples_per_pixel = 1);

}  // namespace raywalk
