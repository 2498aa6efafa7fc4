#include "gui/ui.h"

#include "gui/style.h"

#include <algorithm>

namespace raywalk {

void Ui::act(Action action) const { actions.push_back(std::move(action)); }

void Ui::publish(std::string_view name) const {
  const ImVec2 least = ImGui::GetItemRectMin(), most = ImGui::GetItemRectMax();
  publish(name, {least.x, least.y, most.x - least.x, most.y - least.y});
}

void Ui::publish(std::string_view name, const Rect& where) const { items.insert_or_assign(std::string(name), where); }

Pane::Pane(const Ui& ui, const char* name, const Rect& where, Colour ground, ImVec2 padding, ImGuiWindowFlags flags) {
  ImGui::SetCursorScreenPos(corner(where));
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_imgui4(ground));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, padding);
  // ImGui takes a size of 0 as "the rest", so an empty pane is one unit large, and outside the window.
  const ImVec2 extent{std::max(where.width, 1.0f), std::max(where.height, 1.0f)};
  flags |= ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysUseWindowPadding;
  visible_ = ImGui::BeginChild(name, extent, false, flags) && !where.empty();
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  ui.publish(name, where);
}

ScrolledList::ScrolledList(const Ui& ui, const char* name, float height, float padding) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_imgui4(ui.colours.window));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, padding});
  visible_ = ImGui::BeginChild(name, {0, height}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
}

FormPopup::FormPopup(const Ui& ui, const char* name) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {ui.px(14), ui.px(12)});
  open_ = ImGui::BeginPopup(name);
  ImGui::PopStyleVar();
  if (!open_) return;
  ui.publish(std::string(name) + "-popup",
             {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y, ImGui::GetWindowWidth(), ImGui::GetWindowHeight()});
  ImGui::PushFont(ui.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(6)});
}

FormPopup::~FormPopup() {
  if (!open_) return;
  ImGui::PopStyleVar();
  ImGui::PopFont();
  ImGui::EndPopup();
}

void mark_more(const Ui& ui, const Rect& where, bool above, bool below) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 ink = to_imgui(Shades(ui.state.appearance.theme).accent);
  const float x = where.x + where.width / 2, half = ui.px(7), high = ui.px(5), edge = ui.px(2);
  const auto head = [&](float tip, float base) {
    draw.AddTriangleFilled({x, tip}, {x - half, base}, {x + half, base}, ink);
  };
  if (above) head(where.y + edge, where.y + edge + high);
  if (below) head(where.bottom() - edge, where.bottom() - edge - high);
}

void fade_edges(const Ui& ui, Colour ground) {
  const ImVec2 at = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
  const float bar = ImGui::GetScrollMaxY() > 0 ? ImGui::GetStyle().ScrollbarSize : 0;
  const float right = at.x + extent.x - bar, bottom = at.y + extent.y, most = std::min(ui.px(22), extent.y / 4);
  const float above = std::min(ImGui::GetScrollY(), most),
              below = std::min(ImGui::GetScrollMaxY() - ImGui::GetScrollY(), most);
  const ImU32 solid = to_imgui(ground), clear = to_imgui(ground.with_alpha(0));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.PushClipRect(at, {right, bottom});
  if (above > 0) draw.AddRectFilledMultiColor(at, {right, at.y + above}, solid, solid, clear, clear);
  if (below > 0) draw.AddRectFilledMultiColor({at.x, bottom - below}, {right, bottom}, clear, clear, solid, solid);
  mark_more(ui, {at.x, at.y, right - at.x, bottom - at.y}, above > 0, below > 0);
  draw.PopClipRect();
}

}  // namespace raywalk
