#pragma once

#include "math/numerics.h"
#include "math/sampler.h"

#include <optional>
#include <string_view>

namespace raywalk {

/// How light is followed.
enum class Integrator {
  automatic,    ///< `distributed` when the scene calls for one of its effects, else `whitted`, with the same bits
  cast,         ///< the nearest object, its shadows and local shading (Appel 1968)
  whitted,      ///< mirrors and glass besides, all sharp; draws no random number (Whitted 1980)
  distributed,  ///< gloss, translucency, penumbras, depth of field and motion blur besides (Cook, Porter, Carpenter
                ///< 1984)
  path,         ///< light from everywhere: path tracing (Kajiya 1986)
};
inline constexpr int integrator_count = 5;
[[nodiscard]] constexpr std::string_view integrator_name(Integrator integrator) {
  switch (integrator) {
    case Integrator::automatic:
      return "automatic";
    case Integrator::cast:
      return "cast";
    case Integrator::whitted:
      return "whitted";
    case Integrator::distributed:
      return "distributed";
    case Integrator::path:
      return "path";
  }
  return "";
}

inline constexpr int sampler_count = 3;

/// How a scene is rendered, unless the command line says otherwise. None of it changes what the scene is.
struct RenderChoices {
  Integrator integrator = Integrator::automatic;
  int samples = 1;                      ///< of each pixel, >= 1
  Sampler sampler = Sampler::jittered;  ///< where samples of pixel, lens, light and lobe fall
  std::optional<int> light_grid{};      ///< for the `samples` of every area light
  double tolerance = 0;                 ///< of adaptive sampling (render/adaptive.h); 0: every pixel takes all samples
  std::optional<int> path_length{};  ///< rays of a path from the eye to a light, both ends' included; absent: no limit
  Numerics numerics = Numerics::robust;
  double epsilon = usual_epsilon;  ///< of naive numerics: how far from a surface rays leave it, in scene units
  friend bool operator==(const RenderChoices&, const RenderChoices&) = default;
};

}  // namespace raywalk
