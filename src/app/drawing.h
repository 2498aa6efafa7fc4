#pragma once
// A picture as a drawing of polygons (.svg), which beams make.

#include "app/render_command.h"

#include <string>

namespace raywalk {

/// Whether the name of an image ends in .svg.
[[nodiscard]] bool is_drawing(const std::string& image);

/// `scene` has all that the options choose; `size` is that of the drawing.
[[nodiscard]] ExitCode render_drawing(const RenderOptions& options, const Scene& scene, ImageSize size);

}  // namespace raywalk
