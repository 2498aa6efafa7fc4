#pragma once
// Shapes as lines in space, for the 3-D line view.

#include "scene/scene.h"

#include <vector>

namespace raywalk {

using Polyline = std::vector<Vec3d>;  ///< points joined by straight lines, in scene units

/// The edges of an object, or some circles on a round one. Infinite ones are clipped to `room`.
[[nodiscard]] std::vector<Polyline> outline_of(const Object& object, const Bounds<double>& room);

}  // namespace raywalk
