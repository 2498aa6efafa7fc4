#pragma once

#include "math/numerics.h"
#include "math/sampler.h"
#include "math/words.h"

#include <array>
#include <cstddef>
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
  photons,      ///< the same by photon mapping (Jensen 1996)
  radiosity,    ///< light between matt surfaces, from patch to patch (Goral et al. 1984)
  beams,        ///< all rays of a pixel at once (Heckbert and Hanrahan 1984)
  cones,        ///< a pixel as one cone, and how much of it each object covers (Amanatides 1984)
  pencils,      ///< whitted's rays, each with the matrix of those beside it (Shinya, Takahashi, Naito 1987)
};
/// What is to be known of an integrator before it runs. Its procedure is in trace.
struct IntegratorTraits {
  Integrator integrator;
  std::string_view name;
  std::string_view follows;   ///< what light it follows, for the reference of the keys
  bool draws_random = false;  ///< cast and whitted take their samples at fixed positions
  bool is_global = false;     ///< surfaces light each other
  bool is_recursive = true;   ///< follows rays beyond the first hit
  bool has_width = false;     ///< what is followed is as wide as a pixel or a light; it has no lens
  bool has_lobes = false;     ///< and as a lobe
};
/// All integrators, in the order of the enumeration: files, options and menus offer them from here.
inline constexpr std::array integrators{
    IntegratorTraits{.integrator = Integrator::automatic,
                     .name = "automatic",
                     .follows = "distributed if the scene has any of these, else whitted"},
    IntegratorTraits{.integrator = Integrator::cast, .name = "cast", .follows = "shadows only", .is_recursive = false},
    IntegratorTraits{.integrator = Integrator::whitted, .name = "whitted", .follows = "mirrors and glass, all sharp"},
    IntegratorTraits{.integrator = Integrator::distributed,
                     .name = "distributed",
                     .follows = "soft shadows, lens, motion, gloss and translucency too",
                     .draws_random = true},
    IntegratorTraits{.integrator = Integrator::path,
                     .name = "path",
                     .follows = "light from everywhere",
                     .draws_random = true,
                     .is_global = true},
    IntegratorTraits{.integrator = Integrator::photons,
                     .name = "photons",
                     .follows = "light from everywhere, sent from the lights: caustics too",
                     .draws_random = true,
                     .is_global = true},
    IntegratorTraits{.integrator = Integrator::radiosity,
                     .name = "radiosity",
                     .follows = "light between matt surfaces, cut into patches",
                     .is_global = true,
                     .is_recursive = false},
    IntegratorTraits{.integrator = Integrator::beams,
                     .name = "beams",
                     .follows = "all rays of a pixel at once: exact edges and shadows without samples",
                     .has_width = true},
    IntegratorTraits{.integrator = Integrator::cones,
                     .name = "cones",
                     .follows = "a pixel as one cone: soft shadows, gloss and translucency without samples",
                     .has_width = true,
                     .has_lobes = true},
    IntegratorTraits{.integrator = Integrator::pencils,
                     .name = "pencils",
                     .follows = "what whitted does, and the rays beside each, by a matrix"}};
[[nodiscard]] constexpr const IntegratorTraits& traits_of(Integrator integrator) {
  return integrators[static_cast<std::size_t>(integrator)];
}
template <>
inline constexpr auto words_of<Integrator> = [] {
  std::array<Word<Integrator>, integrators.size()> words;
  for (std::size_t i = 0; i < words.size(); ++i) words[i] = {integrators[i].integrator, integrators[i].name};
  return words;
}();

/// Effects that can be left out of a scene to see what they do and cost; not in a scene's file.
struct EffectSwitches {
  bool shadows = true;     ///< off: no shadow ray is formed, and every light in front of a surface reaches it
  bool reflection = true;  ///< off: nothing reflects, but for what is totally reflected inside
  bool refraction = true;  ///< off: nothing transmits
  friend bool operator==(const EffectSwitches&, const EffectSwitches&) = default;
};

/// Of photon mapping.
struct PhotonChoices {
  int count = 100000;              ///< photons that are sent, >= 1
  int nearest = 60;                ///< the circle of an estimate reaches to this one, >= 2
  std::optional<double> radius{};  ///< largest of a circle, in scene units, > 0; absent: a twentieth of the scene
  bool gather = false;             ///< indirect light by one more ray from what is seen, and photons where that ends
  bool progressive = false;        ///< each sample has a map of its own, with smaller circles than the one before
  friend bool operator==(const PhotonChoices&, const PhotonChoices&) = default;
};

/// Of radiosity, also where other integrators use it.
struct RadiosityChoices {
  std::optional<double> patch{};  ///< no side of a patch is longer; left out, a twelfth of the scene
  double tolerance = 0.005;       ///< as much of the light may stay unshot, >= 0
  int shots = 100000;             ///< after as many it ends in any case, >= 1
  bool as_ambient = false;        ///< whitted and distributed: what patches send each other, in place of ambient light
  friend bool operator==(const RadiosityChoices&, const RadiosityChoices&) = default;
};

/// How paths get through bodies that scatter light inside.
enum class Subsurface {
  walk,    ///< from each place where it is scattered to the next
  dipole,  ///< at once, to where the dipole lets it out (Jensen et al. 2001)
};
template <>
inline constexpr Word<Subsurface> words_of<Subsurface>[] = {{Subsurface::walk, "walk"}, {Subsurface::dipole, "dipole"}};

/// How a scene is rendered, unless the command line says otherwise. None of it changes what the scene is.
struct RenderChoices {
  Integrator integrator = Integrator::automatic;
  int samples = 1;                      ///< of each pixel, >= 1
  Sampler sampler = Sampler::jittered;  ///< how samples of pixel, lens, light and lobe are distributed
  std::optional<int> light_grid{};      ///< overrides `samples` of every area light
  double tolerance = 0;                 ///< of adaptive sampling (render/adaptive.h); 0: every pixel takes all samples
  std::optional<int> path_length{};     ///< maximum number of rays of a path from the eye to a light, first and last
                                        ///< included; absent: no limit
  Subsurface subsurface = Subsurface::walk;
  PhotonChoices photons{};
  RadiosityChoices radiosity{};
  Numerics numerics = Numerics::robust;
  EffectSwitches switches{};
  double epsilon = default_epsilon;  ///< of naive numerics: the offset of ray origins from a surface, in scene units
  friend bool operator==(const RenderChoices&, const RenderChoices&) = default;
};

}  // namespace raywalk
