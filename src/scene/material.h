#pragma once

#include "math/vec.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// Two colours in squares on the surface, in the shape's own (u, v), which are lengths along the surface in scene
/// units. The colour of the square multiplies the material's ambient and diffuse.
struct Checker {
  Rgbd even{1.0};
  Rgbd odd{0.0};
  double size = 1.0;  ///< edge of a square, > 0
  friend bool operator==(const Checker&, const Checker&) = default;
};

/// Pixels of a texture in linear RGB, top row first.
struct TexturePixels {
  int width = 0, height = 0;
  std::vector<Vec3<float>> pixels;
};

/// An image laid over the surface and repeated without end. Its lower left corner lies at (u, v) = (0, 0) of the shape,
/// its right edge at u = width and its upper edge at v = height. Between the centres of pixels colours are interpolated
/// bilinearly. The colour multiplies the material's ambient and diffuse.
struct ImageTexture {
  std::string file;              ///< as the scene states it: relative to the scene's folder
  double width = 1, height = 1;  ///< of one copy on the surface, in units of the shape's (u, v), > 0
  /// What the file holds. Null until a reader has loaded it; then the texture is white.
  std::shared_ptr<const TexturePixels> pixels{};
  /// The pixels follow from the file.
  friend bool operator==(const ImageTexture& a, const ImageTexture& b) {
    return a.file == b.file && a.width == b.width && a.height == b.height;
  }
};

/// What a surface does to shadow rays: stop them, or let them through weighted by `transmission` at each crossing.
enum class ShadowKind { opaque, filtered };

/// Which side of a surface lights shine on.
enum class ShadingNormal {
  facing,  ///< the side the ray came from: the normal turns to face the ray
  fixed,   ///< the front, whichever side the ray came from; highlights of lights behind show too (course scenes)
};

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
  double gloss = 0;         ///< half angle in degrees, 0..90, of the cone about the mirror direction that kr gathers
  double translucency = 0;  ///< the same about the refracted direction, for kt; in both, all directions count the same
  Rgbd absorption{0.0};     ///< a: of the light inside, exp(-a d) is left after the way d (Beer); where kt > 0
  double priority = 0;      ///< where bodies that transmit overlap, the one with the highest is there
  ShadowKind shadow = ShadowKind::opaque;
  ShadingNormal normal = ShadingNormal::facing;  ///< fixed only where nothing transmits
  Rgbd emission{0.0};                            ///< radiance the surface gives off by itself
  std::optional<Checker> checker;
  std::optional<ImageTexture> texture{};
  friend bool operator==(const Material&, const Material&) = default;

  [[nodiscard]] bool reflects() const { return !is_black(reflection); }
  [[nodiscard]] bool transmits() const { return !is_black(transmission); }
};

}  // namespace raywalk
