#pragma once
// The one program of a page.

#include "gui/loop.h"

namespace raywalk {

/// Once main has opened it.
[[nodiscard]] Loop& page_loop();

}  // namespace raywalk
