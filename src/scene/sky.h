#pragma once
// The sky: what a ray brings back that leaves the scene, by its direction. It is infinitely far away.

#include "image/image.h"
#include "math/vec.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace raywalk {

/// From the colour of the horizon to that of the zenith, in proportion to the sine of the elevation.
struct GradientSky {
  Rgbd horizon{0.75, 0.85, 0.95}, zenith{0.2, 0.4, 0.8};  ///< radiance
  friend bool operator==(const GradientSky&, const GradientSky&) = default;

  static constexpr std::string_view name = "gradient";
};

/// A sky wholly covered with clouds, three times as bright overhead as at the horizon: zenith (1 + 2 sin elevation) / 3
/// (P. Moon and D. Spencer, "Illumination from a non-uniform sky", Illuminating Engineering 37, 1942; the CIE's
/// standard overcast sky of 1955).
struct OvercastSky {
  Rgbd zenith{0.8};  ///< radiance
  friend bool operator==(const OvercastSky&, const OvercastSky&) = default;

  static constexpr std::string_view name = "overcast";
};

/// A clear sky without its sun, which is a light of its own (L. Hosek and A. Wilkie, "An Analytic Model for Full
/// Spectral Sky-Dome Radiance", SIGGRAPH 2012).
struct ClearSky {
  double elevation = 40;  ///< of the sun, in degrees, 0..90; it stands in the sky's middle
  double turbidity = 3;   ///< 1..10: 2 is very clear, 6 a moist day, 10 hazy
  double albedo = 0.2;    ///< 0..1: of the ground, which lights the air
  Rgbd strength{0.05};    ///< 1: radiance as measured, in units of 683 cd / m^2 of luminance
  friend bool operator==(const ClearSky&, const ClearSky&) = default;

  static constexpr std::string_view name = "clear";
};

/// A measured sky: a picture of all directions. Its columns are longitudes and its rows latitudes, the zenith at the
/// top; its middle is the sky's. Bilinear between the centres of the pixels.
struct ImageSky {
  std::string file;  ///< as the scene states it: relative to the scene's folder
  Rgbd strength{1.0};
  /// The file's content, linear radiance: twice as wide as high, not negative, finite, not wholly black. Null until a
  /// reader has loaded it; until then the sky is `strength` everywhere.
  std::shared_ptr<const Image> pixels{};
  /// The pixels are determined by the file.
  friend bool operator==(const ImageSky& a, const ImageSky& b) { return a.file == b.file && a.strength == b.strength; }

  static constexpr std::string_view name = "image";
};

using AnySky = std::variant<GradientSky, OvercastSky, ClearSky, ImageSky>;

/// Below the horizon a ray brings back the scene's background; only an image has a lower half of its own.
struct Sky {
  AnySky kind;
  Vec3d up{0.0, 0.0, 1.0};  ///< towards the zenith; any length but 0
  double rotation = 0;      ///< degrees: the azimuth of the sky's middle, counter-clockwise seen from the zenith
  friend bool operator==(const Sky&, const Sky&) = default;
};

/// Why a picture cannot be a sky, and a hint; none if it can.
[[nodiscard]] std::optional<std::pair<std::string, std::string>> why_no_sky(const Image& picture);

}  // namespace raywalk
