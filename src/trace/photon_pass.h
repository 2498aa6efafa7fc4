#pragma once
// What is to be known of the photons of a picture without the procedure that sends them (trace/photons.h).

#include "math/ray.h"
#include "trace/photon_map.h"

#include <cstdint>

namespace raywalk {

struct PhotonSettings {
  int count = 100000;                ///< photons of a pass, >= 1
  int nearest = 60;                  ///< k, >= 2
  double radius = infinity<double>;  ///< largest of a circle; of the first pass, where they shrink
  bool gather = false;
  bool progressive = false;  ///< circles have the radius of their pass, whatever is in them
  bool flat = false;
  std::uint64_t seed = 0;
  friend bool operator==(const PhotonSettings&, const PhotonSettings&) = default;

  static constexpr double alpha = 2.0 / 3;  ///< how much of what a pass adds stays in the shrunken circle
  /// The square of a circle's radius in a pass, from 0.
  [[nodiscard]] double squared_radius(int pass) const;
};

/// The photons of one pass.
struct PhotonMaps {
  PhotonMap caustic, other;
};

/// A range of photons of a pass.
struct PhotonRange {
  int begin = 0, end = 0;
  int pass = 0;
};

}  // namespace raywalk
