#pragma once

#include "gui/fonts.h"
#include "gui/layout.h"
#include "view/drawing/display_list.h"

#include <imgui.h>

#include <array>
#include <vector>

namespace raywalk {

/// Draws a list of `view` into `pane` and clips it there. `scale`: units per pixel of the list.
void paint(ImDrawList& draw, const DisplayList& list, const Rect& pane, float scale, const Fonts& fonts);

/// The same for a single line, in ImGui's coordinates: legend samples and tree links.
void paint_line(ImDrawList& draw, const LineItem& line);

/// A font and its size for a text of this height, both in units: the rasterised size if that is close enough, because
/// scaled letters are blurred.
struct FontChoice {
  ImFont* font;
  float size;
};
[[nodiscard]] FontChoice lettering(const Fonts& fonts, float size);

/// Indices of the corners of triangles that cover a simple polygon, convex or not, of either orientation: ear clipping
/// (G. Meisters 1975). A polygon that is not simple gets some triangles within it.
[[nodiscard]] std::vector<std::array<int, 3>> triangulate(const std::vector<ImVec2>& corners);

}  // namespace raywalk
