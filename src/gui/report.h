#pragma once

#include "gui/interface.h"
#include "gui/live_costs.h"
#include "gui/session.h"

#include <string>

namespace raywalk {

/// What tests and scripts need to know of the window besides the state.
struct WindowReport {
  int frames = 0;               ///< drawn since the start
  double first_frame = 0;       ///< seconds from run_gui to the end of the first frame
  float width = 0, height = 0;  ///< units
  bool idle = false;            ///< nothing to do until an event
  bool typing = false;          ///< a field has the focus
};

/// The state as JSON: mode, playback, selection, files, questions, every object's and light's place in the window, and
/// the rectangle [x, y, width, height] of everything that can be clicked, in units of the window.
[[nodiscard]] std::string report(const State& state, const Interface& interface, const Preview& preview,
                                 const LiveCosts& costs, float dpi, const WindowReport& window);

}  // namespace raywalk
