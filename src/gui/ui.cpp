#include "gui/ui.h"

#include "gui/style.h"
#include "gui/widgets.h"

#include <algorithm>
#include <cfloat>
#include <cmath>

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

FingerFields::FingerFields(const Ui& ui) : reach_(ImGui::GetStyle().TouchExtraPadding) {
  if (ui.finger <= 0) return;
  ImGuiStyle& style = ImGui::GetStyle();
  const float apart = ui.px(8);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      {style.FramePadding.x, (ui.finger - apart - ImGui::GetFontSize()) / 2});
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {style.ItemSpacing.x, apart});
  pushed_ = 2;
  style.TouchExtraPadding = {ui.px(2), apart / 2};
}

FingerFields::~FingerFields() {
  ImGui::PopStyleVar(pushed_);
  ImGui::GetStyle().TouchExtraPadding = reach_;
}

ScrolledList::ScrolledList(const Ui& ui, const char* name, float height, float padding) {
  ImGui::PushStyleColor(ImGuiCol_ChildBg, to_imgui4(ui.colours.window));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {padding, padding});
  visible_ = ImGui::BeginChild(name, {0, height}, true, ImGuiWindowFlags_AlwaysUseWindowPadding);
  ImGui::PopStyleVar();
  ImGui::PopStyleColor();
  const ImVec2 apart = ImGui::GetStyle().ItemSpacing;
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {apart.x, std::max(apart.y, ui.finger - ImGui::GetFontSize())});
}

ScrolledList::~ScrolledList() {
  ImGui::PopStyleVar();
  ImGui::EndChild();
}

FormPopup::FormPopup(const Ui& ui, const char* name) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ui.padding(14, 12));
  open_ = ImGui::BeginPopup(name);
  ImGui::PopStyleVar();
  if (!open_) return;
  ui.publish(std::string(name) + "-popup",
             {ImGui::GetWindowPos().x, ImGui::GetWindowPos().y, ImGui::GetWindowWidth(), ImGui::GetWindowHeight()});
  ImGui::PushFont(ui.fonts.small);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(6)});
}

float FormPopup::width(const Ui& ui, float units) {
  const float beside = 2 * ui.px(14) + ImGui::GetStyle().ScrollbarSize + 2 * ImGui::GetStyle().DisplaySafeAreaPadding.x;
  return std::min(ui.px(units), ImGui::GetIO().DisplaySize.x - beside);
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
    fill_triangle(draw, {x, tip}, {x - half, base}, {x + half, base}, ink);
  };
  if (above) head(where.y + edge, where.y + edge + high);
  if (below) head(where.bottom() - edge, where.bottom() - edge - high);
}

std::optional<float> uncut_edge(const ImDrawList& drawn, const Rect& where, float edge, float way, float most) {
  constexpr float rounding = 0.5f;
  const float begun = edge;
  // A letter may be cut only because another of its line made the edge move, so until none is.
  for (bool moved = true; moved;) {
    moved = false;
    for (const ImDrawCmd& command : drawn.CmdBuffer) {
      const auto first_of = [&](unsigned i) { return drawn.IdxBuffer[static_cast<int>(command.IdxOffset + i)]; };
      for (unsigned i = 0, next = 0; i + 2 < command.ElemCount; i = next) {
        float left = FLT_MAX, top = FLT_MAX, bottom = -FLT_MAX;
        // A fan, such as a box with round corners, is cut as a whole.
        for (next = i; next + 2 < command.ElemCount && first_of(next) == first_of(i); next += 3)
          for (const unsigned n : {0U, 1U, 2U}) {
            const ImVec2 corner = drawn.VtxBuffer[static_cast<int>(command.VtxOffset) + first_of(next + n)].pos;
            left = std::min(left, corner.x);
            top = std::min(top, corner.y);
            bottom = std::max(bottom, corner.y);
          }
        if (top >= edge - rounding || bottom <= edge + rounding) continue;
        const bool is_ground = top <= where.y && bottom >= where.bottom();
        if (is_ground || left >= where.right()) continue;
        edge = way < 0 ? top : bottom;
        if (std::abs(edge - begun) > most) return std::nullopt;
        moved = true;
      }
    }
  }
  return edge;
}

Rect close_edges(const Ui& ui, Colour ground) {
  const ImVec2 at = ImGui::GetWindowPos(), extent = ImGui::GetWindowSize();
  const float bar = ImGui::GetScrollMaxY() > 0 ? ImGui::GetStyle().ScrollbarSize : 0;
  const Rect where{at.x, at.y, extent.x - bar, extent.y};
  const float above = ImGui::GetScrollY(), below = ImGui::GetScrollMaxY() - above;
  const float mark = ui.px(10), most = std::min(ui.px(70), extent.y / 3), fade = std::min(ui.px(22), extent.y / 4);
  const ImU32 solid = to_imgui(ground), clear = to_imgui(ground.with_alpha(0));
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const auto uncut = [&](float edge, float inwards) {
    return uncut_edge(draw, where, edge + inwards * mark, inwards, most).value_or(edge);
  };
  const float upper = above > 0 ? uncut(at.y, 1) : at.y, lower = below > 0 ? uncut(where.bottom(), -1) : where.bottom();
  draw.PushClipRect(at, opposite(where));
  if (upper > at.y) {
    draw.AddRectFilled(at, {where.right(), upper}, solid);
  } else if (above > 0) {
    draw.AddRectFilledMultiColor(at, {where.right(), at.y + std::min(above, fade)}, solid, solid, clear, clear);
  }
  if (lower < where.bottom()) {
    draw.AddRectFilled({at.x, lower}, opposite(where), solid);
  } else if (below > 0) {
    draw.AddRectFilledMultiColor({at.x, lower - std::min(below, fade)}, opposite(where), clear, clear, solid, solid);
  }
  mark_more(ui, where, above > 0, below > 0);
  draw.PopClipRect();
  return {where.x, upper, where.width, lower - upper};
}

}  // namespace raywalk
