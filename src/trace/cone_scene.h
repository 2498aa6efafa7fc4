#pragma once
// A scene as cones meet it. A disc that a cone meets aslant is taken as a polygon of 64 corners, of the same area.

#include "scene/scene.h"
#include "trace/cone_bodies.h"

namespace raywalk {

/// All of a scene that has no reason against cones (scene/cone_limits.h); of a flat world, those that meet the plan.
[[nodiscard]] ConeBodies cone_bodies_of(const Scene& scene, bool flat);

}  // namespace raywalk
