#pragma once
// Text widgets of the panes of lessons and spot the bug.

#include "gui/ui.h"

#include <string>

namespace raywalk {

/// Paragraphs, with lists; Markdown's stars and backquotes are removed.
void prose(const Ui& ui, Colour colour, const std::string& text);
void heading(const Ui& ui, Colour colour, const std::string& text);
[[nodiscard]] float button_height(const Ui& ui);
/// A button of this width, else as wide as the pane, and as high as its words need. Returns whether it was pressed.
bool wide_button(const Ui& ui, const std::string& name, const std::string& text, Colour ground, Colour ink,
                 bool enabled, float width = 0);

}  // namespace raywalk
