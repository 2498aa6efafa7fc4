#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "text/language.h"
#include "view/lines_view.h"
#include "view/plan_view.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

void turn_by_mouse(const Ui& ui, SpaceView view, const Rect& where) {
  const ImGuiIO& io = ImGui::GetIO();
  const float edge = std::max(std::min(where.width, where.height), 1.0f);
  const auto part = [&](float moved, float whole) { return static_cast<double>(moved / std::max(whole, 1.0f)); };
  const bool moved = io.MouseDelta.x != 0 || io.MouseDelta.y != 0;
  if (ImGui::IsItemActive() && moved) {
    const bool shifts = io.KeyShift || ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2);
    // Half a turn for the length of an edge.
    constexpr double pi = 3.14159265358979323846;
    if (shifts) {
      ui.act(action::Shift{view, {part(io.MouseDelta.x, where.width), part(io.MouseDelta.y, where.width)}});
    } else if (ImGui::IsMouseDragging(0)) {
      ui.act(action::Orbit{view, {pi * part(io.MouseDelta.x, edge), pi * part(io.MouseDelta.y, edge)}});
    }
  }
  if (ImGui::IsItemHovered() && io.MouseWheel != 0)
    ui.act(action::Approach{view, std::pow(1.15, static_cast<double>(io.MouseWheel))});
}

bool clicked_in_place() {
  if (!ImGui::IsItemDeactivated() || !ImGui::IsMouseReleased(0)) return false;
  const ImVec2 way = ImGui::GetMouseDragDelta(0, 0);
  const float tremble = ImGui::GetIO().MouseDragThreshold;
  return std::abs(way.x) < tremble && std::abs(way.y) < tremble && ImGui::IsItemHovered();
}

void lines_pane(const Ui& ui, const Rect& where) {
  const Viewport viewport{std::max(static_cast<double>(where.width / ui.dpi), 1.0),
                          std::max(static_cast<double>(where.height / ui.dpi), 1.0)};
  if (!where.empty() && viewport != ui.state.viewport) ui.act(action::ResizePlan{viewport});
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  const bool visible =
      begin_pane(ui, "plan", where, ui.colours.plan, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (visible) {
    paint(*ImGui::GetWindowDrawList(), lines_view(ui.state, viewport), where, ui.dpi, ui.fonts);
    // The buttons come before the pane's own item: the first one gets the mouse.
    const float edge = ui.px(28);
    ButtonLook look{.look = Look::plain, .icon = Icon::none, .font = ui.fonts.small, .label = true};
    float x = where.right() - ui.px(10);
    for (const Command command : {Command::lines, Command::reset_view, Command::walk_strip}) {
      if (!enabled(command, ui.state)) continue;
      const float width = button_width(ui, command, look);
      x -= width;
      if (x < where.x) break;
      ImGui::SetCursorScreenPos({x, where.y + ui.px(8)});
      command_button(ui, command, {width, edge}, look);
      x -= ui.px(6);
    }
    ImGui::SetCursorScreenPos(corner(where));
    ImGui::InvisibleButton(
        "lines", size(where),
        ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
    ui.publish("lines", where);
    turn_by_mouse(ui, SpaceView::lines, where);
    const bool inside = ImGui::IsItemHovered(), clicked = clicked_in_place();
    Target target;
    if (inside && !ImGui::IsItemActive() && ImGui::IsMousePosValid()) {
      const ImVec2 mouse = ImGui::GetIO().MousePos;
      target = pick_in_lines(
          ui.state, viewport,
          {static_cast<double>((mouse.x - where.x) / ui.dpi), static_cast<double>((mouse.y - where.y) / ui.dpi)});
    }
    const int ray = target.kind == TargetKind::ray ? target.index : -1;
    // Set only by the hovered pane.
    bool& pointing = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("pointing"), false);
    if ((inside || pointing) && ray != ui.state.hovered_ray) ui.act(action::HoverRay{ray});
    pointing = inside;
    if (clicked && ray >= 0) ui.act(action::JumpToRay{ray});
    if (ray >= 0) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    if (const std::string what = target_text(ui.state, target); !what.empty() && inside) {
      ImGui::BeginTooltip();
      push_font(ui.fonts.small);
      ImGui::TextUnformatted(what.c_str());
      pop_font();
      ImGui::EndTooltip();
    }
  }
  end_pane();
}

}  // namespace raywalk
