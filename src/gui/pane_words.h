#pragma once
// What the panes of words are written with: the lessons, and spot the bug.

#include "gui/ui.h"

#include <string>

namespace raywalk {

/// Paragraphs, with lists; Markdown's stars and backquotes are for emphasis that the pane does not have.
void prose(const Ui& ui, Colour colour, const std::string& text);
void heading(const Ui& ui, Colour colour, const std::string& text);
[[nodiscard]] float button_height(const Ui& ui);
/// A button over the width of the pane, as high as its words need. Whether it was pressed.
bool wide_button(const Ui& ui, const std::string& name, const std::string& text, Colour ground, Colour ink,
                 bool enabled);

}  // namespace raywalk
