#pragma once
// Shapes as lines in space, for the 3-D line view.

#include "scene/scene.h"

#include <vector>

namespace raywalk {

using Curve = std::vector<Vec3d>;  ///< points joined by straight lines, in scene units

/// The edges of an object, or for round ones some circles on it. What has no end is shown as far as `room` reaches.
[[nodiscard]] std::vector<Curve> outline_of(const Object& object, const Bounds<double>& room);

}  // namespace raywalk
