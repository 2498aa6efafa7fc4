#pragma once
// What the window says while a large scene is read: until then there is nothing else to show.

#include "gui/attention.h"
#include "gui/gui.h"
#include "gui/window.h"
#include "view/state.h"

namespace raywalk {

/// Whether the scene that `options` name takes so long to read that one would wonder.
[[nodiscard]] bool takes_long_to_read(const GuiOptions& options);
/// Shows the window with a word that the scene is being read, while it is. Throws Stopped when it is closed meanwhile.
[[nodiscard]] Result<State> start_in_sight(const GuiOptions& options, Window& window, Attention& attention);

}  // namespace raywalk
