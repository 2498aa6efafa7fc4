#pragma once

#include "view/drawing/theme.h"

struct ImGuiStyle;

namespace raywalk {

/// Further shades for ImGui's widgets, mixed from the palette.
struct Shades {
  explicit Shades(Theme theme);
  Colour raised, raised_hovered, raised_held;  ///< buttons and fields
  Colour line;                                 ///< between panes and around fields
  Colour accent, accent_hovered, accent_held;  ///< of choices, and of the primary button
  Colour on_accent;                            ///< text on it
};

/// Spacing, rounding and colours of everything that ImGui draws itself. `unit`: see Ui.
void set_style(ImGuiStyle& style, Theme theme, float unit);

}  // namespace raywalk
