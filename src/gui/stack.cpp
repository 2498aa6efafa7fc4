#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/stack/stack_panel.h"
#include "view/text/text.h"

#include <algorithm>

namespace raywalk {

namespace {

void draw_returned(const Ui& ui, const StackRow& row) {
  for (const StackRow::Returned& returned : row.returned) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float edge = ImGui::GetFontSize();
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddRectFilled(at, {at.x + edge * 1.6f, at.y + edge}, to_imgui(returned.colour), ui.px(3));
    draw.AddRect(at, {at.x + edge * 1.6f, at.y + edge}, to_imgui(ui.colours.dim_text), ui.px(3));
    ImGui::SetCursorScreenPos({at.x + edge * 1.6f + ui.px(8), at.y});
    label(ui.colours.text, returned.name + " = " + colour_text(returned.linear, ui.state.appearance.language));
  }
}

int stack_tab(const Ui& ui, const Rect& where) {
  const StackPanel stack = stack_panel(ui.state);
  if (stack.rows.empty()) {
    paragraph(ui.colours.dim_text, stack.empty);
    return -1;
  }
  int pointed_at = -1;
  const Shades shades(ui.state.appearance.theme);
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(4)});
  bool innermost = true;
  int number = 0;
  for (const StackRow& row : stack.rows) {
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float width = std::max(ImGui::GetContentRegionAvail().x, 1.0f), pad = ui.px(10);
    // The background's height depends on the text, so it is drawn last, on a layer below.
    draw.ChannelsSplit(2);
    draw.ChannelsSetCurrent(1);
    ImGui::SetCursorScreenPos({at.x + pad, at.y + ui.px(7)});
    ImGui::BeginGroup();
    ImGui::PushTextWrapPos(where.width - ui.px(26));
    push_font(ui.fonts.strong);
    label(ui.colours.text, row.title);
    pop_font();
    push_font(ui.fonts.small);
    std::string whose = row.ray;
    if (!row.object.empty()) whose += (whose.empty() ? "" : "  \u2192  ") + row.object;
    if (!whose.empty()) label(ui.colours.text, whose);
    if (!row.waiting.empty()) label(ui.colours.dim_text, row.waiting);
    draw_returned(ui, row);
    pop_font();
    ImGui::PopTextWrapPos();
    ImGui::EndGroup();
    const float bottom = ImGui::GetItemRectMax().y + ui.px(7);
    draw.ChannelsSetCurrent(0);
    ImGui::SetCursorScreenPos(at);
    const std::string name = "call-" + std::to_string(number++);
    ImGui::InvisibleButton(name.c_str(), {width, bottom - at.y});
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && row.ray_index >= 0) pointed_at = row.ray_index;
    ui.publish(name);
    draw.AddRectFilled(at, {at.x + width, bottom}, to_imgui(hovered ? shades.raised_hovered : shades.raised), ui.px(6));
    if (innermost) draw.AddRect(at, {at.x + width, bottom}, to_imgui(shades.accent), ui.px(6), 0, ui.px(1.6f));
    draw.ChannelsMerge();
    innermost = false;
  }
  ImGui::PopStyleVar();
  return pointed_at;
}

}  // namespace

void StackRoom::draw_tab(const Ui& ui, const Rect& where, TabContext& context) {
  context.pointed_at = stack_tab(ui, where);
}

Commands StackRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-stack", .keys = {"K"}, .section = Section::tabs, .line = "keys.tabs",
       .chosen = shows_tab<StackRoom>, .run = open_tab<StackRoom>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
