#pragma once

#include "scene/sky.h"

#include <array>

namespace raywalk {

/// The radiance of a clear sky, without the sun itself: L. Hosek and A. Wilkie, "An Analytic Model for Full Spectral
/// Sky-Dome Radiance", SIGGRAPH 2012, with the authors' fit for CIE X, Y and Z. The sun stands over the x axis, the
/// zenith on z.
class ClearSkyRadiance {
 public:
  explicit ClearSkyRadiance(const ClearSky& sky);

  /// CIE X, Y and Z, Y in units of 683 lm / (m^2 sr), before `strength`. `direction`: of unit length, z >= 0.
  [[nodiscard]] Vec3d xyz(const Vec3d& direction) const;
  /// The same in linear sRGB, times `strength`. What lies outside of sRGB's gamut is cut off at 0.
  [[nodiscard]] Rgbd operator()(const Vec3d& direction) const;

 private:
  /// A to F, G, I and H of the paper's equation 8, and the mean radiance.
  struct Channel {
    std::array<double, 9> shape;
    double radiance;
  };
  std::array<Channel, 3> channels_;
  Vec3d sun_;
  Rgbd strength_;
};

}  // namespace raywalk
