#include "gui/ui.h"

namespace raywalk {

void Ui::act(Action action) const { actions.push_back(std::move(action)); }

void Ui::publish(std::string_view name) const {
  const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
  publish(name, {least.x, least.y, most.x - least.x, most.y - least.y});
}

void Ui::publish(std::string_view name, const Rect& where) const { items.insert_or_assign(std::string(name), where); }

bool begin_pane(const Ui& ui, const char* name, const Rect& where, Colour ground, ImGuiWindowFlags flags) {
  ImGui::SetCursorScreenPos(corner(where));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_imgui4(ground));
  // ImGui takes a size of 0 for "what is left", so an empty pane is one unit large, and outside of what is seen.
  const ImVec2 extent{std::max(where.width, 1.0f), std::max(where.height, 1.0f)};
  const bool visible = ImGui::BeginChild(name, extent, false, flags | ImGuiWindowFlags_NoSavedSettings);
  ImGui::PopStyleColor();
  ui.publish(name, where);
  return visible && !where.empty();
}

void end_pane() { ImGui::EndChild(); }

}  // namespace raywalk
