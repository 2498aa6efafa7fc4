#pragma once
// The band as a drawing.

#include "view/drawing/display_list.h"
#include "view/state.h"

namespace raywalk {

/// Height of the band in pixels at scale 1.
inline constexpr double band_height = 58;

/// The cells in a row, as EYE sees them, from cell 0 on: each with its number where there is room, its shade once
/// known, and the one under way marked. Below them the numbers of one cell's colour: the cell pointed at (-1: none),
/// else the one under way. Coordinates are pixels within width x height; `unit`: a pixel at scale 1.
[[nodiscard]] DisplayList band_view(const State& state, double width, double height, double unit, int pointed_at);
/// The cell at a point of the drawing; -1: none.
[[nodiscard]] int band_cell_at(const State& state, double width, double height, double unit, const Vec2d& at);

}  // namespace raywalk
