#include "gui/scroll.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cfloat>

namespace raywalk {

bool scroll_at(ImVec2 at, float by) {
  const auto& windows = ImGui::GetCurrentContext()->Windows;  // the last in front
  for (int i = windows.Size - 1; i >= 0; --i) {
    ImGuiWindow* const window = windows[i];
    if (!window->WasActive || window->Hidden || !window->OuterRectClipped.Contains(at)) continue;
    if ((window->Flags & ImGuiWindowFlags_NoInputs) == ImGuiWindowFlags_NoInputs) continue;  // a tooltip
    if (window->ScrollMax.y <= 0) return false;
    // A finger may have moved before in this frame, which is not drawn yet.
    const float from = window->ScrollTarget.y < FLT_MAX && window->ScrollTargetCenterRatio.y == 0
                           ? window->ScrollTarget.y
                           : window->Scroll.y;
    ImGui::SetScrollY(window, std::clamp(from - by, 0.0f, window->ScrollMax.y));
    return true;
  }
  return false;
}

}  // namespace raywalk
