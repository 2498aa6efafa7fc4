#pragma once

#include "image/image.h"
#include "math/vec.h"
#include "math/words.h"
#include "scene/maps.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// How a checker is seen through a pixel that is larger than a square.
enum class CheckerFilter {
  none,    ///< by the one point that a ray meets
  closed,  ///< by its mean over the footprint of the pixel, in closed form
};
template <>
inline constexpr Word<CheckerFilter> words_of<CheckerFilter>[] = {{CheckerFilter::none, "none"},
                                                                  {CheckerFilter::closed, "closed"}};

/// The same of an image.
enum class TextureFilter {
  none,       ///< by the one point that a ray meets
  trilinear,  ///< between two levels of a pyramid, as wide as the footprint is long (L. Williams 1983)
  ewa,        ///< weighted over the ellipse of the footprint (P. Heckbert 1989)
};
template <>
inline constexpr Word<TextureFilter> words_of<TextureFilter>[] = {
    {TextureFilter::none, "none"}, {TextureFilter::trilinear, "trilinear"}, {TextureFilter::ewa, "ewa"}};

/// A checkerboard of two colours in the shape's own (u, v), which are lengths along the surface in scene units. The
/// colour of a square multiplies the material's ambient and diffuse.
struct Checker {
  Rgbd even{1.0};
  Rgbd odd{0.0};
  double size = 1.0;  ///< edge of a square, > 0
  CheckerFilter filter = CheckerFilter::none;
  friend bool operator==(const Checker&, const Checker&) = default;
};

/// An image mapped onto the surface. Its lower left corner lies at (u, v) = (0, 0) of the shape,
/// its right edge at u = width and its upper edge at v = height. Colours are interpolated bilinearly between pixel
/// centres. The colour multiplies the material's ambient and diffuse.
struct ImageTexture {
  std::string file;              ///< as the scene states it: relative to the scene's folder
  double width = 1, height = 1;  ///< of one copy on the surface, in units of the shape's (u, v), > 0
  /// The file's content, in linear light. Null until a reader has loaded it; until then the texture is white.
  std::shared_ptr<const Image> pixels{};
  TextureFilter filter = TextureFilter::none;
  ImageWrap wrap = ImageWrap::repeat;
  /// The pixels are determined by the file.
  friend bool operator==(const ImageTexture& a, const ImageTexture& b) {
    return a.file == b.file && a.width == b.width && a.height == b.height && a.filter == b.filter && a.wrap == b.wrap;
  }
};

/// What a surface does to shadow rays: block them, or let them pass weighted by `transmission` at each crossing.
enum class ShadowKind { opaque, filtered };
template <>
inline constexpr Word<ShadowKind> words_of<ShadowKind>[] = {{ShadowKind::opaque, "opaque"},
                                                            {ShadowKind::filtered, "filtered"}};

/// Which way the shading normal points.
enum class ShadingNormal {
  facing,  ///< the side the ray came from: the normal turns to face the ray
  fixed,   ///< the front, whichever side the ray came from; highlights of lights behind show too (course scenes)
};
template <>
inline constexpr Word<ShadingNormal> words_of<ShadingNormal>[] = {{ShadingNormal::facing, "facing"},
                                                                  {ShadingNormal::fixed, "fixed"}};

/// What kr is multiplied by: nothing, or the reflectance of a metal, which follows from its index of refraction
/// (scene/metals.h).
enum class MirrorKind { ideal, gold, copper, silver, aluminium };
template <>
inline constexpr Word<MirrorKind> words_of<MirrorKind>[] = {{MirrorKind::ideal, "ideal"},
                                                            {MirrorKind::gold, "gold"},
                                                            {MirrorKind::copper, "copper"},
                                                            {MirrorKind::silver, "silver"},
                                                            {MirrorKind::aluminium, "aluminium"}};

/// How a surface reflects and transmits light (J. Blinn 1977 for the highlight, T. Whitted 1980 for the secondary
/// rays). All reflectances are linear RGB, normally in 0..1.
struct Material {
  Rgbd ambient{0.0};        ///< ka: weight of the scene's ambient light
  Rgbd diffuse{0.8};        ///< kd
  Rgbd specular{0.0};       ///< ks: strength of the highlight
  double shininess = 30;    ///< s: exponent of n.h, >= 0
  Rgbd reflection{0.0};     ///< kr: weight of the mirror ray
  Rgbd transmission{0.0};   ///< kt: weight of the refracted ray
  double ior = 1.5;         ///< index of refraction inside, > 0; only used if kt > 0
  bool dielectric = false;  ///< split kr + kt between the two by the exact Fresnel equations
  double gloss = 0;         ///< half angle in degrees, 0..90, of the cone about the mirror direction that kr gathers
  double translucency = 0;  ///< the same about the refracted direction, for kt; both uniform over the cone
  MirrorKind mirror =
      MirrorKind::ideal;  ///< kr is multiplied by what it reflects (Fresnel); only where nothing transmits
  double roughness = 0;   ///< alpha, 0..1, of the small facets that reflect kr (GGX), and of a dielectric transmit too;
                          ///< only without gloss and translucency
  double diffuse_roughness = 0;  ///< r, 0..1, of the surface that sends kd back: 0 is Lambert's, 1 the roughest (Oren
                                 ///< and Nayar 1994; Portsmouth, Kutz and Hill 2025)
  Rgbd absorption{0.0};          ///< a: inside, the transmittance over a distance d is exp(-a d) (Beer); where kt > 0
  Rgbd scattering{0.0};   ///< s: inside, paths go straight for a distance d with probability exp(-s d), then scatter
  double anisotropy = 0;  ///< g: mean cosine of the angle by which they scatter, in -1..1 (Henyey-Greenstein)
  double priority = 0;    ///< where transmitting bodies overlap, the one with the highest priority wins
  ShadowKind shadow = ShadowKind::opaque;
  ShadingNormal normal = ShadingNormal::facing;  ///< fixed only where nothing transmits
  Rgbd emission{0.0};                            ///< radiance that the surface emits
  std::optional<Checker> checker;
  std::optional<ImageTexture> texture{};
  std::vector<ParameterMap> maps{};  ///< of different parameters
  std::optional<NormalMap> normal_map{};
  std::optional<BumpMap> bump_map{};
  std::optional<Mask> mask{};
  friend bool operator==(const Material&, const Material&) = default;

  // What there is somewhere on the surface: with a mask, also by the second material.
  [[nodiscard]] bool reflects() const { return !is_black(reflection) || (mask && !is_black(mask->second.reflection)); }
  [[nodiscard]] bool transmits() const { return !is_black(transmission); }
  [[nodiscard]] bool is_glossy() const { return gloss > 0 && (reflects() || transmits()); }
  /// Small facets that reflect, or transmit too.
  [[nodiscard]] bool is_rough() const { return is_rough_mirror() || is_rough_glass(); }
  [[nodiscard]] bool is_rough_mirror() const { return has_roughness() && reflects() && !is_rough_glass(); }
  [[nodiscard]] bool is_rough_glass() const { return has_roughness() && transmits() && dielectric; }
  [[nodiscard]] bool is_rough_diffuse() const {
    return (diffuse_roughness > 0 && !is_black(diffuse)) ||
           (mask && mask->second.diffuse_roughness > 0 && !is_black(mask->second.diffuse));
  }
  [[nodiscard]] bool is_metal() const { return mirror != MirrorKind::ideal && reflects(); }
  [[nodiscard]] bool is_translucent() const { return translucency > 0 && transmits(); }
  [[nodiscard]] bool scatters_inside() const { return transmits() && !is_black(scattering); }
  [[nodiscard]] bool emits() const { return !is_black(emission) || (mask && !is_black(mask->second.emission)); }
  [[nodiscard]] bool filters_checker() const { return checker && checker->filter != CheckerFilter::none; }
  [[nodiscard]] bool filters_texture() const { return texture && texture->filter != TextureFilter::none; }
  /// Whether its normals are not those of the shape.
  [[nodiscard]] bool has_bent_normals() const { return normal_map || bump_map; }
  /// Whether its parameters change from point to point, but for checker and texture.
  [[nodiscard]] bool has_mapped_parameters() const { return !maps.empty() || mask; }
  [[nodiscard]] bool is_mapped() const { return has_mapped_parameters() || has_bent_normals(); }

 private:
  [[nodiscard]] bool has_roughness() const { return roughness > 0 || (mask && mask->second.roughness > 0); }
};

/// All of its maps, each with whether its bytes are colours, else numbers. `AnyMaterial`: Material, const or not.
template <class AnyMaterial, class Visit>
void each_map(AnyMaterial& material, const Visit& visit) {
  for (auto& map : material.maps) visit(map, is_colour(map.of));
  if (material.normal_map) visit(*material.normal_map, false);
  if (material.bump_map) visit(*material.bump_map, false);
  if (!material.mask) return;
  if (!material.mask->squares) visit(*material.mask, false);
  for (auto& map : material.mask->second.maps) visit(map, is_colour(map.of));
}

/// The second material of its mask, with the rest as the material has it.
[[nodiscard]] Material second_of(const Material& material);

/// Why its maps and its mask do not go together with the rest; empty when they do.
[[nodiscard]] std::string why_not_mapped(const Material& material);

}  // namespace raywalk
