#pragma once
// The window while a large scene is read, with nothing else to show.

#include "gui/attention.h"
#include "gui/fonts.h"
#include "gui/gui.h"
#include "gui/window.h"
#include "view/state.h"

#include <string>

namespace raywalk {

/// A frame with `words` and, below them, a line that moves with the seconds and a smaller `hint`, which may be empty.
void show_loading(Window& window, const Fonts& fonts, Theme theme, const std::string& words, const std::string& hint,
                  double seconds);

/// Whether the scene of `options` takes noticeably long to read.
[[nodiscard]] bool takes_long_to_read(const GuiOptions& options);
/// Shows the window with a message while the scene is read. Throws Stopped if it is closed meanwhile.
[[nodiscard]] Result<State> start_in_sight(const GuiOptions& options, Window& window, Attention& attention);

}  // namespace raywalk
