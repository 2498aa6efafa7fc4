#pragma once
// Names in the line view. Included only by the files of this folder that draw it.

#include "view/plan/painter.h"
#include "view/space/orbit.h"

#include <array>
#include <string>
#include <vector>

namespace raywalk {

/// Draws the name of a point in view: `away` from it or, where that leaves the pane, on another side of it, off
/// `lines` if one is. None if it would cover another one everywhere.
void draw_name(Painter& painter, const std::string& what, const Vec2d& of, const Vec2d& away,
               const std::vector<std::array<Vec2d, 2>>& lines = {});

/// Draws the objects' names, each on its own body unless a smaller one is there, else beside it; rather off `lines`.
void draw_object_names(Painter& painter, const Projection& seen, const std::vector<std::array<Vec2d, 2>>& lines);

}  // namespace raywalk
