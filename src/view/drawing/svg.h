#pragma once
// A drawing as SVG 1.1, for pages and print.

#include "view/drawing/display_list.h"

#include <string>
#include <string_view>

namespace raywalk {

/// One shape as one element or a few.
[[nodiscard]] std::string svg_element(const Shape2d& shape);
/// A whole file, `width` x `height` pixels, on a background of this colour. `title`: read by screen readers.
[[nodiscard]] std::string svg_file(const DisplayList& list, double width, double height, Colour ground,
                                   std::string_view title);

/// "#1f2e3d"
[[nodiscard]] std::string css_colour(Colour colour);

}  // namespace raywalk
