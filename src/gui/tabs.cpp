#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/document/properties.h"

#include <algorithm>
#include <string_view>

namespace raywalk {

void fronts_pane(const Ui& ui, const Rect& where, Front front, bool with_lesson) {
  if (where.empty()) return;
  const Pane pane(ui, "fronts", where, ui.colours.window, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  const float margin = ui.px(10), gap = ui.px(6), count = with_lesson ? 3 : 2;
  const float inset = ui.px(ui.finger > 0 ? 1 : 3);
  const ImVec2 extent{(where.width - 2 * margin - (count - 1) * gap) / count, where.height - 2 * inset};
  float x = where.x + margin;
  const auto choice = [&](Front each, const char* name, std::string_view label) {
    ImGui::SetCursorScreenPos({x, where.y + inset});
    if (button(ui, name, ui.say(label), "", extent, {.look = Look::choice}, front == each))
      ui.act(action::ShowFront{each});
    x += extent.x + gap;
  };
  choice(Front::code, "front-code", shows_properties(ui.state) ? "command.edit_properties.label" : "front.code");
  choice(Front::tabs, "front-tabs", "menu.panels");
  if (with_lesson) choice(Front::lesson, "front-lesson", "command.lessons.label");
}

void divider_pane(const Ui& ui, const Layout& layout) {
  if (layout.divider.empty()) return;
  const Pane pane(ui, "divider", layout.divider, ui.colours.panel.with_alpha(0), {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  ImGui::SetCursorScreenPos(corner(layout.divider));
  ImGui::InvisibleButton("divider", size(layout.divider));
  ui.publish("divider");
  const bool held = ImGui::IsItemActive(), pointed_at = ImGui::IsItemHovered();
  if (held || pointed_at) {
    ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeNS);
    const float y = layout.divider.y + layout.divider.height / 2;
    ImGui::GetWindowDrawList()->AddLine({layout.divider.x, y}, {layout.divider.right(), y},
                                        to_imgui(ui.colours.hovered), std::max(ui.px(2), 1.0f));
  }
  if (!held) tooltip(ui, "divider", ui.say("code.divider_hint"));
  const float whole = ImGui::GetIO().DisplaySize.y - layout.side.y;
  if (pointed_at && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left))
    ui.act(action::DividePanes{0});
  else if (held && ImGui::IsMouseDragging(ImGuiMouseButton_Left) && whole > 0)
    ui.act(action::DividePanes{static_cast<double>((ImGui::GetIO().MousePos.y - layout.side.y) / whole)});
}

namespace {

constexpr float tab_height = 32, tab_margin = 10, tab_inset = 7;  // at scale 1

// Of the tabs, beside the button that exchanges them and the plan.
float tabs_width(const Ui& ui, float width) { return width - ui.px(2 * tab_margin + tab_height + 4); }

}  // namespace

float tab_choice_height(const Ui& ui, float width) {
  return choice_height(ui, commands_in(Section::tabs), ui.high(tab_height), ui.fonts.small, tabs_width(ui, width)) +
         ui.px(2 * tab_inset);
}

void tab_choice(const Ui& ui, const Rect& where) {
  if (where.empty()) return;
  const Pane pane(ui, "choice-of-tabs", where, ui.colours.panel, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  ImGui::GetWindowDrawList()->AddLine({where.x, where.y}, {where.right(), where.y},
                                      to_imgui(Shades(ui.state.appearance.theme).line));
  const float height = ui.high(tab_height), edge = ui.px(tab_height), y = where.y + ui.px(tab_inset);
  ImGui::SetCursorScreenPos({where.x + ui.px(tab_margin), y});
  choice_in_lines(ui, commands_in(Section::tabs), height, ui.fonts.small, tabs_width(ui, where.width));
  ImGui::SetCursorScreenPos({where.right() - ui.px(tab_margin) - edge, y});
  command_button(ui, command("exchange"), {edge, height},
                 {.look = Look::choice, .icon = Icon::exchange, .font = nullptr, .label = false}, {},
                 panes_exchanged(ui.state));
}

void TabsPane::draw(const Ui& ui, const Rect& where, const Rect& choice, const PictureView& picture, bool open_settings,
                    bool open_knobs) {
  const Pane pane(ui, "tabs", where, ui.colours.panel, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  const float margin = ui.px(tab_margin), top = where.y + (choice.bottom() == where.y ? 0 : margin);
  const Rect inside{where.x + margin, top, where.width - 2 * margin, where.bottom() - top - ui.px(4)};
  int pointed_at = -1;
  if (inside.width > 1 && inside.height > 1) {
    ImGui::SetCursorScreenPos(corner(inside));
    ImGui::PushStyleColor(ImGuiCol_ChildBg, ImVec4{0, 0, 0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    const bool own = ui.state.appearance.tab.scrolls;
    const bool open = ImGui::BeginChild("tab", size(inside), false,
                                        own ? ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse : 0);
    ImGui::PopStyleVar();
    ImGui::PopStyleColor();
    if (open) {
      TabContext context{picture, memory_};
      for_each_room(Rooms(), [&]<class Room>() {
        if constexpr (rooms::WithTab<Room>)
          if (Room::tab == ui.state.appearance.tab) Room::draw_tab(ui, inside, context);
      });
      pointed_at = context.pointed_at;
      if (!own) close_edges(ui, ui.colours.panel);
    }
    ImGui::EndChild();
  }
  const ImVec2 whole = ImGui::GetIO().DisplaySize;
  const float bar = ui.px(44), gap = ui.px(8), width = ui.px(390 + 2 * 14);  // of the widest popup
  // Beside the picture, and never over the menus.
  const auto beside = [&] {
    const bool to_the_left = where.x > whole.x / 3;
    const float x = to_the_left ? std::max(where.x - gap, std::min(width + gap, whole.x - gap))
                                : std::max(std::min(where.right() + gap, whole.x - gap - width), 0.0f);
    ImGui::SetNextWindowPos({x, whole.y - gap}, ImGuiCond_Appearing, {to_the_left ? 1.0f : 0.0f, 1.0f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {whole.x, std::max(whole.y - bar - ui.px(12), 1.0f)});
  };
  // Below its button, or above it if there is more room.
  const auto next_to = [&](std::string_view button) {
    const auto found = ui.items.find(button);
    if (found == ui.items.end()) return beside();
    const Rect& at = found->second;
    const float above = at.y - bar - gap, below = whole.y - at.bottom() - gap;
    const bool down = below >= above;
    ImGui::SetNextWindowPos({std::clamp(at.x, 0.0f, std::max(whole.x - width, 0.0f)), down ? at.bottom() : at.y},
                            ImGuiCond_Appearing, {0, down ? 0.0f : 1.0f});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {whole.x, std::max(down ? below : above, 1.0f)});
  };
  if (open_settings) ImGui::OpenPopup("image-settings");
  beside();
  image_settings(ui, settings_);
  if (open_knobs) ImGui::OpenPopup("cost-knobs");
  next_to("cost-knobs");
  cost_knobs_popup(ui, knobs_);
  if (pointed_at != hovering_ && pointed_at != ui.state.plan.hovered_ray) ui.act(action::HoverRay{pointed_at});
  hovering_ = pointed_at;
}

}  // namespace raywalk
