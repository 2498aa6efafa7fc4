#pragma once

#include "gui/attention.h"
#include "gui/gui.h"
#include "gui/session.h"
#include "gui/window.h"

#include <chrono>

namespace raywalk {

/// Shows `state` in the window and follows its events until it is closed or, for a screenshot, idle. `begun`: when the
/// program began, for its report. Fails where run_gui says.
[[nodiscard]] Result<void> run_loop(const GuiOptions& options, State state, Window& window, Attention& attention,
                                    Demo demo, std::chrono::steady_clock::time_point begun);

}  // namespace raywalk
