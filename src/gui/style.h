#pragma once

#include "view/theme.h"

struct ImGuiStyle;

namespace raywalk {

/// Shades that ImGui's parts need besides those of the palette, mixed from it.
struct Shades {
  explicit Shades(Theme theme);
  Colour raised, raised_hovered, raised_held;  ///< buttons and fields
  Colour line;                                 ///< between panes and round fields
  Colour accent, accent_hovered, accent_held;  ///< what is chosen, and the first thing to press
  Colour on_accent;                            ///< text on it
};

/// Spacing, rounding and colours of everything that ImGui draws itself. `unit`: see Ui.
void set_style(ImGuiStyle& style, Theme theme, float unit);

}  // namespace raywalk
