#pragma once
// What is highlighted where something is pointed at elsewhere.

#include "view/state.h"

namespace raywalk {

/// Whether the line forms, follows or shades rays of this kind.
[[nodiscard]] bool concerns(Line line, RayKind kind);
/// Whether a ray is highlighted in plan and tree: it is hovered, or it is of the current pixel and the hovered line
/// concerns it.
[[nodiscard]] bool is_lit(const State& state, int ray);

}  // namespace raywalk
