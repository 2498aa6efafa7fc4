#pragma once
// The line view: the scene in space as the outlines of its shapes, the camera as the pyramid that it sees, and the rays
// of the walk as the plan draws them. It takes the plan's place for pixels off the strip and for scenes that are not
// planar.

#include "view/display_list.h"
#include "view/state.h"

namespace raywalk {

/// The camera that the lines are seen by in a pane of this size.
[[nodiscard]] Camera lines_camera(const State& state, const Viewport& viewport);

[[nodiscard]] DisplayList lines_view(const State& state, const Viewport& viewport);

/// What is under a point of the pane: a ray before anything else.
[[nodiscard]] Target pick_in_lines(const State& state, const Viewport& viewport, const Vec2d& at);

}  // namespace raywalk
