#pragma once

#include "math/vec.h"

#include <string>
#include <variant>

namespace raywalk {

/// 1 / (constant + linear r + quadratic r^2), r the distance to the light in scene units. Terms are >= 0, not all 0.
struct Attenuation {
  double constant = 1, linear = 0, quadratic = 0;
  friend bool operator==(const Attenuation&, const Attenuation&) = default;
};

struct PointLight {
  Vec3d position{0.0};
  Attenuation attenuation;
  friend bool operator==(const PointLight&, const PointLight&) = default;
};

/// Light from infinitely far away; not attenuated.
struct DirectionalLight {
  Vec3d direction{0.0, 0.0, 1.0};  ///< from the surface to the light; any length but 0
  friend bool operator==(const DirectionalLight&, const DirectionalLight&) = default;
};

struct Light {
  std::string name;
  Rgbd strength{1.0};
  std::variant<PointLight, DirectionalLight> kind;
  friend bool operator==(const Light&, const Light&) = default;
};

}  // namespace raywalk
