#pragma once

#include <imgui.h>

namespace raywalk {

/// Moves what is seen at this place of the window, in ImGui's units, by so many down, as a finger does that drags
/// paper. False if what lies in front there does not scroll.
bool scroll_at(ImVec2 at, float by);

}  // namespace raywalk
