#pragma once

namespace raywalk {

/// 1 / (constant + linear r + quadratic r^2), r the distance to the light in scene units. Terms are >= 0, not all 0.
struct Attenuation {
  double constant = 1, linear = 0, quadratic = 0;
  friend bool operator==(const Attenuation&, const Attenuation&) = default;
};

}  // namespace raywalk
