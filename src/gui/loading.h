#pragma once
// The window while a large scene is read, with nothing else to show yet.

#include "gui/attention.h"
#include "gui/gui.h"
#include "gui/window.h"
#include "view/state.h"

namespace raywalk {

/// Whether the scene of `options` takes noticeably long to read.
[[nodiscard]] bool takes_long_to_read(const GuiOptions& options);
/// Shows the window with a message while the scene is read. Throws Stopped if it is closed meanwhile.
[[nodiscard]] Result<State> start_in_sight(const GuiOptions& options, Window& window, Attention& attention);

}  // namespace raywalk
