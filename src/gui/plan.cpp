#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/plan/plan_view.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

// Whether the pointer should be a hand.
bool can_be_held(const State& state, TargetKind kind) {
  switch (kind) {
    case TargetKind::nothing:
      return false;
    case TargetKind::eye:
    case TargetKind::view_direction:
    case TargetKind::screen_height:
    case TargetKind::screen_distance:
    case TargetKind::object:
    case TargetKind::radius:
    case TargetKind::corner:
    case TargetKind::edge:
    case TargetKind::rotation:
    case TargetKind::light:
    case TargetKind::light_radius:
      return state.walk.mode == Mode::move;
    case TargetKind::cell:
    case TargetKind::ray:
      return state.walk.mode == Mode::trace;
  }
  return false;
}

// Mouse actions on the last item, in pixels of the plan.
void pointer_actions(const Ui& ui, const Rect& where) {
  const ImGuiIO& io = ImGui::GetIO();
  const State& state = ui.state;
  const bool inside = ImGui::IsItemHovered();
  if (!ImGui::IsMousePosValid()) return;
  const Vec2d at{static_cast<double>((io.MousePos.x - where.x) / ui.dpi),
                 static_cast<double>((io.MousePos.y - where.y) / ui.dpi)};
  const action::Modifiers modifiers{io.KeyShift, io.KeyCtrl, io.KeyAlt};
  const bool held = ImGui::IsMouseDown(0) || ImGui::IsMouseDown(1) || ImGui::IsMouseDown(2);

  if ((inside || state.plan.drag) && (!state.plan.pointer || *state.plan.pointer != at))
    ui.act(action::PointerMoved{at, modifiers});
  if (state.plan.drag) {
    if (!held) ui.act(action::PointerReleased{at, modifiers});
  } else if (inside) {
    constexpr std::array buttons{action::Button::left, action::Button::right, action::Button::middle};
    for (int i = 0; i < 3; ++i) {
      if (ImGui::IsMouseClicked(i))
        ui.act(action::PointerPressed{at, buttons[static_cast<std::size_t>(i)], modifiers,
                                      ImGui::IsMouseDoubleClicked(i)});
    }
  } else if (state.plan.pointer && !held) {
    ui.act(action::PointerLeft{});
  }
  if (inside && io.MouseWheel != 0) ui.act(action::Zoom{at, std::pow(1.2, static_cast<double>(io.MouseWheel))});
}

// The tooltip of what is under the pointer, without delay.
void name_target(const Ui& ui, const Rect& where) {
  const std::string what = target_text(ui.state, ui.state.plan.hovered);
  if (!what.empty()) tooltip_now(ui, what, where);
}

}  // namespace

Viewport plan_viewport(const Ui& ui, const Rect& where) {
  const Viewport viewport{std::max(static_cast<double>(where.width / ui.dpi), 1.0),
                          std::max(static_cast<double>(where.height / ui.dpi), 1.0)};
  if (!where.empty() && viewport != ui.state.plan.viewport) ui.act(action::ResizePlan{viewport});
  return viewport;
}

void plan_pane(const Ui& ui, const Rect& where) {
  const Viewport viewport = plan_viewport(ui, where);
  const Pane pane(ui, "plan", where, ui.colours.plan, {0, 0},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (!pane) return;
  ImGui::SetCursorScreenPos(corner(where));
  ImGui::InvisibleButton(
      "plan", size(where),
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  pointer_actions(ui, where);
  const bool inside = ImGui::IsItemHovered();
  // Drawn for the current size of the pane, even in the one frame before the state knows it.
  paint(*ImGui::GetWindowDrawList(), plan_view(ui.state, viewport), where, ui.dpi, ui.fonts);
  if (inside && !ui.state.plan.drag) name_target(ui, where);
  if ((inside || ui.state.plan.drag) && can_be_held(ui.state, ui.state.plan.hovered.kind))
    ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

namespace {

void zoom(const Ui& ui, double factor) {
  const Viewport& pane = ui.state.plan.viewport;
  ui.act(action::Zoom{{pane.width / 2, pane.height / 2}, factor});
}

}  // namespace

Commands PlanRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "fit", .keys = {"F"}, .section = Section::zoom, .line = "keys.zoom", .run = act<action::FitView>},
      {.name = "zoom-in", .keys = {"Alt+Up"}, .section = Section::zoom, .line = "keys.zoom",
       .run = [](const Ui& ui) { zoom(ui, 1.25); }},
      {.name = "zoom-out", .keys = {"Alt+Down"}, .section = Section::zoom, .line = "keys.zoom",
       .run = [](const Ui& ui) { zoom(ui, 1 / 1.25); }},
      {.name = "ghosts", .keys = {"N"}, .section = Section::show,
       .chosen = [](const State& state) { return state.walk.shows_ghosts; }, .turn = turn<action::ShowGhosts>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
