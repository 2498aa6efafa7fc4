#pragma once

#include "math/vec.h"

#include <optional>

namespace raywalk {

/// Two colours in squares on the surface, in the shape's own (u, v), which are lengths along the surface in scene
/// units. The colour of the square multiplies the material's ambient and diffuse.
struct Checker {
  Rgbd even{1.0};
  Rgbd odd{0.0};
  double size = 1.0;  ///< edge of a square, > 0
  friend bool operator==(const Checker&, const Checker&) = default;
};

/// What a surface does to shadow rays: stop them, or let them through weighted by `transmission` at each crossing.
enum class ShadowKind { opaque, filtered };

/// How a surface answers light (J. Blinn 1977 for the highlight, T. Whitted 1980 for the secondary rays). All
/// reflectances are linear RGB, normally in 0..1.
struct Material {
  Rgbd ambient{0.0};        ///< ka: share of the scene's ambient light
  Rgbd diffuse{0.8};        ///< kd
  Rgbd specular{0.0};       ///< ks: strength of the highlight
  double shininess = 30;    ///< s: exponent of n.h, >= 0
  Rgbd reflection{0.0};     ///< kr: share of the mirror ray
  Rgbd transmission{0.0};   ///< kt: share of the refracted ray
  double ior = 1.5;         ///< index of refraction inside, > 0; only used when something transmits
  bool dielectric = false;  ///< share kr + kt between the two by the exact Fresnel equations
  ShadowKind shadow = ShadowKind::opaque;
  Rgbd emission{0.0};  ///< radiance the surface gives off by itself
  std::optional<Checker> checker;
  friend bool operator==(const Material&, const Material&) = default;

  [[nodiscard]] bool reflects() const { return !is_black(reflection); }
  [[nodiscard]] bool transmits() const { return !is_black(transmission); }
};

}  // namespace raywalk
