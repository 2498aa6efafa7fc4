#pragma once

#include "math/numerics.h"
#include "math/sampler.h"

#include <optional>
#include <string_view>

namespace raywalk {

/// How light transport is computed.
enum class Integrator {
  automatic,    ///< `distributed` when the scene calls for one of its effects, else `whitted`, with the same bits
  cast,         ///< the nearest object, its shadows and local shading (Appel 1968)
  whitted,      ///< also mirrors and glass, all sharp; draws no random numbers (Whitted 1980)
  distributed,  ///< also gloss, translucency, penumbras, depth of field and motion blur (Cook, Porter, Carpenter 1984)
  path,         ///< global illumination: path tracing (Kajiya 1986)
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
  Sampler sampler = Sampler::jittered;  ///< how samples of pixel, lens, light and lobe are distributed
  std::optional<int> light_grid{};      ///< overrides `samples` of every area light
  double tolerance = 0;                 ///< of adaptive sampling (render/adaptive.h); 0: every pixel takes all samples
  std::optional<int> path_length{};     ///< maximum number of rays of a path from the eye to a light, first and last
                                        ///< included; absent: no limit
  Numerics numerics = Numerics::robust;
  double epsilon = default_epsilon;  ///< of naive numerics: the offset of ray origins from a surface, in scene units
  friend bool operator==(const RenderChoices&, const RenderChoices&) = default;
};

}  // namespace raywalk
