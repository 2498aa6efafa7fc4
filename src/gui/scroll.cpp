#include "gui/scroll.h"

#include <imgui_internal.h>

#include <algorithm>

namespace raywalk {

bool scroll_at(ImVec2 at, float by) {
  const auto& windows = ImGui::GetCurrentContext()->Windows;  // the last in front
  for (int i = windows.Size - 1; i >= 0; --i) {
    ImGuiWindow* const window = windows[i];
    if (!window->WasActive || window->Hidden || !window->OuterRectClipped.Contains(at)) continue;
    if ((window->Flags & ImGuiWindowFlags_NoInputs) == ImGuiWindowFlags_NoInputs) continue;  // a tooltip
    if (window->ScrollMax.y <= 0) return false;
    ImGui::SetScrollY(window, std::clamp(window->Scroll.y - by, 0.0f, window->ScrollMax.y));
    return true;
  }
  return false;
}

}  // namespace raywalk
