#pragma once
// The line view: the scene in space as outlines of its shapes, the camera as its view frustum, and the rays of the walk
// as in the plan. It replaces the plan for pixels off the strip and for scenes that are not planar.

#include "view/drawing/display_list.h"
#include "view/state.h"

namespace raywalk {

/// The camera of the line view in a pane of this size.
[[nodiscard]] Camera lines_camera(const State& state, const Viewport& viewport);

/// `buttons`: width and height of what covers the upper right corner, in pixels; no name stands there.
[[nodiscard]] DisplayList lines_view(const State& state, const Viewport& viewport, const Vec2d& buttons = Vec2d(0.0));

/// What is under a point of the pane; rays take precedence.
[[nodiscard]] Target pick_in_lines(const State& state, const Viewport& viewport, const Vec2d& at);

}  // namespace raywalk
