#pragma once
// Images that say what a surface is like from point to point: maps of a material's parameters, of its normal and of its
// height, and masks between two materials. They lie on the surface as its texture does (scene/material.h), bilinear
// between pixel centres.

#include "image/image.h"
#include "math/vec.h"
#include "math/words.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// A parameter of a material that an image can vary.
enum class MappedParameter {
  ambient,
  diffuse,
  diffuse_roughness,
  specular,
  shininess,
  reflection,
  transmission,
  roughness,
  gloss,
  translucency,
  emission,
};
template <>
inline constexpr Word<MappedParameter> words_of<MappedParameter>[] = {
    {MappedParameter::ambient, "ambient"},
    {MappedParameter::diffuse, "diffuse"},
    {MappedParameter::diffuse_roughness, "diffuse_roughness"},
    {MappedParameter::specular, "specular"},
    {MappedParameter::shininess, "shininess"},
    {MappedParameter::reflection, "reflection"},
    {MappedParameter::transmission, "transmission"},
    {MappedParameter::roughness, "roughness"},
    {MappedParameter::gloss, "gloss"},
    {MappedParameter::translucency, "translucency"},
    {MappedParameter::emission, "emission"}};

/// Whether it is a colour, whose map is one too: bytes of its file are decoded from sRGB. All other maps hold numbers:
/// the bytes over 255, as glTF has it.
[[nodiscard]] constexpr bool is_colour(MappedParameter parameter) {
  switch (parameter) {
    case MappedParameter::ambient:
    case MappedParameter::diffuse:
    case MappedParameter::specular:
    case MappedParameter::reflection:
    case MappedParameter::transmission:
    case MappedParameter::emission:
      return true;
    case MappedParameter::diffuse_roughness:
    case MappedParameter::shininess:
    case MappedParameter::roughness:
    case MappedParameter::gloss:
    case MappedParameter::translucency:
      break;
  }
  return false;
}

/// Where an image holds the number of a point. Grey images have it in all three; a channel is exact, which a luminance
/// of equal parts is not, and glTF keeps two maps in one image.
enum class MapChannel { red, green, blue };
template <>
inline constexpr Word<MapChannel> words_of<MapChannel>[] = {
    {MapChannel::red, "red"}, {MapChannel::green, "green"}, {MapChannel::blue, "blue"}};

/// How an image goes on beyond the edges of its first copy, which has its lower left corner at (u, v) = (0, 0).
enum class ImageWrap : std::uint8_t {
  repeat,  ///< by copies of it
  clamp,   ///< by the pixels of its edge
  mirror,  ///< by copies each of which is the mirror image of its neighbours
};
template <>
inline constexpr Word<ImageWrap> words_of<ImageWrap>[] = {
    {ImageWrap::repeat, "repeat"}, {ImageWrap::clamp, "clamp"}, {ImageWrap::mirror, "mirror"}};

/// Each way by itself.
struct ImageWraps {
  ImageWrap u = ImageWrap::repeat, v = ImageWrap::repeat;
  friend bool operator==(const ImageWraps&, const ImageWraps&) = default;
};

/// An image on a surface.
struct MapImage {
  std::string file;              ///< as the scene states it; empty: none, or part of a mesh file
  double width = 1, height = 1;  ///< of one copy, in units of the shape's (u, v), not 0; < 0: as wide, and mirrored
  /// The file's content. Null until a reader has loaded it; until then the map changes nothing.
  std::shared_ptr<const Image> pixels{};
  ImageWrap wrap = ImageWrap::repeat;
  std::optional<ImageWrap> wrap_v{};  ///< along v, if it is another one there: of a mesh file
  [[nodiscard]] ImageWraps wraps() const { return {wrap, wrap_v.value_or(wrap)}; }
  /// The pixels are determined by the file.
  friend bool operator==(const MapImage& a, const MapImage& b) {
    return a.file == b.file && a.width == b.width && a.height == b.height && a.wrap == b.wrap && a.wrap_v == b.wrap_v;
  }
};

/// Multiplies one of the parameters, a colour by the image's colour, a number by one of its channels.
struct ParameterMap : MapImage {
  MappedParameter of = MappedParameter::diffuse;
  MapChannel channel = MapChannel::red;
  friend bool operator==(const ParameterMap&, const ParameterMap&) = default;
};

/// A normal map as glTF 2.0 has it: 2 c - 1 is the normal in the frame of the surface, +x along u, +y along v, +z
/// outward. In copies that are mirror images, too, as viewers of glTF take it.
struct NormalMap : MapImage {
  double strength = 1;  ///< factor of its x and y, >= 0
  friend bool operator==(const NormalMap&, const NormalMap&) = default;
};

/// The height of the surface, of which only the normals are seen (J. Blinn, "Simulation of Wrinkled Surfaces", SIGGRAPH
/// 1978).
struct BumpMap : MapImage {
  double relief = 0.1;  ///< how far 1 lies above 0 along the outward normal, in scene units
  MapChannel channel = MapChannel::red;
  friend bool operator==(const BumpMap&, const BumpMap&) = default;
};

/// What a mask puts in the place of a material's own parameters. All else is as the first material has it: what the
/// body is filled with, metal, shadows.
struct SecondMaterial {
  Rgbd ambient{0.0};
  Rgbd diffuse{0.8};
  double diffuse_roughness = 0;
  Rgbd specular{0.0};
  double shininess = 30;
  Rgbd reflection{0.0};
  double roughness = 0;
  Rgbd emission{0.0};
  std::vector<ParameterMap> maps{};  ///< of these
  friend bool operator==(const SecondMaterial&, const SecondMaterial&) = default;
};

/// How much there is of a second material, in 0..1: by an image, or in every second square of a checker. Between them
/// all parameters are interpolated linearly.
struct Mask : MapImage {
  std::optional<double> squares{};  ///< edge of a square, > 0, in units of (u, v); those of odd place have the second
  MapChannel channel = MapChannel::red;
  SecondMaterial second{};
  friend bool operator==(const Mask&, const Mask&) = default;
};

}  // namespace raywalk
