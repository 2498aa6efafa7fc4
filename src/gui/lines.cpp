#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "text/language.h"
#include "view/plan/plan_view.h"
#include "view/space/lines_view.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

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
  const Viewport viewport = plan_viewport(ui, where);
  const Pane pane(ui, "plan", where, ui.colours.plan, {0, 0},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (!pane) return;
  const float edge = ui.high(28), above = ui.px(8) - ui.unseen(edge), gap = ui.px(6);
  const ButtonLook look{.look = Look::plain, .icon = Icon::none, .font = ui.fonts.small, .label = true};
  std::vector<std::pair<const Command*, Rect>> buttons;  // from the right
  float x = where.right() - ui.px(10);
  for (const Command* each : {&command("lines"), &command("reset-view"), &command("walk-strip")}) {
    if (!enabled(*each, ui.state)) continue;
    const float width = button_width(ui, *each, look);
    if (x - width < where.x) break;
    buttons.emplace_back(each, Rect{x - width, where.y + above, width, edge});
    x -= width + gap;
  }
  const Vec2d covered = buttons.empty() ? Vec2d(0.0)
                                        : Vec2d(static_cast<double>((where.right() - x) / ui.dpi),
                                                static_cast<double>((above + edge + gap) / ui.dpi));
  paint(*ImGui::GetWindowDrawList(), lines_view(ui.state, viewport, covered), where, ui.dpi, ui.fonts);
  // The buttons come before the pane's own item: the first one gets the mouse.
  for (const auto& [each, place] : buttons) {
    ImGui::SetCursorScreenPos(corner(place));
    command_button(ui, *each, size(place), look);
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
  if ((inside || pointing) && ray != ui.state.plan.hovered_ray) ui.act(action::HoverRay{ray});
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

namespace {

constexpr double turn_step = 3.14159265358979323846 / 24;  // radians
constexpr double shift_step = 0.05;                        // of the view's width

// The view that keys turn: the lines, if they are shown and were turned last, else the picture.
SpaceView view_in_hand(const State& state) { return shows_lines(state) ? state.space.turned_last : SpaceView::image; }

std::string lines_label(const State& state, bool) {
  return fill(shows_lines(state) ? "plan.name" : "command.lines.label", state.appearance.language);
}

bool is_turned(const State& state) {
  return (view_in_hand(state) == SpaceView::image ? state.picture.camera : state.space.lines_camera).has_value();
}

}  // namespace

Commands SpaceRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "lines", .keys = {"V"}, .section = Section::show, .line = "keys.lines", .label = lines_label,
       .run = [](const Ui& ui) { ui.act(action::ShowLines{!shows_lines(ui.state)}); }},
      {.name = "walk-strip", .keys = {{"S", When::trace}}, .section = Section::show, .line = "keys.lines",
       .enabled = [](const State& state) { return state.walk.pixel.has_value(); }, .run = act<action::WalkStrip>},
      {.name = "turn-left", .keys = {"Alt+Shift+Left"}, .line = "keys.turn",
       .run = [](const Ui& ui) { ui.act(action::Orbit{view_in_hand(ui.state), {-turn_step, 0}}); }},
      {.name = "turn-right", .keys = {"Alt+Shift+Right"}, .line = "keys.turn",
       .run = [](const Ui& ui) { ui.act(action::Orbit{view_in_hand(ui.state), {turn_step, 0}}); }},
      {.name = "turn-up", .keys = {"Alt+Shift+Up"}, .line = "keys.turn",
       .run = [](const Ui& ui) { ui.act(action::Orbit{view_in_hand(ui.state), {0, -turn_step}}); }},
      {.name = "turn-down", .keys = {"Alt+Shift+Down"}, .line = "keys.turn",
       .run = [](const Ui& ui) { ui.act(action::Orbit{view_in_hand(ui.state), {0, turn_step}}); }},
      {.name = "shift-left", .keys = {"Ctrl+Shift+Left"}, .line = "keys.shift",
       .run = [](const Ui& ui) { ui.act(action::Shift{view_in_hand(ui.state), {-shift_step, 0}}); }},
      {.name = "shift-right", .keys = {"Ctrl+Shift+Right"}, .line = "keys.shift",
       .run = [](const Ui& ui) { ui.act(action::Shift{view_in_hand(ui.state), {shift_step, 0}}); }},
      {.name = "shift-up", .keys = {"Ctrl+Shift+Up"}, .line = "keys.shift",
       .run = [](const Ui& ui) { ui.act(action::Shift{view_in_hand(ui.state), {0, -shift_step}}); }},
      {.name = "shift-down", .keys = {"Ctrl+Shift+Down"}, .line = "keys.shift",
       .run = [](const Ui& ui) { ui.act(action::Shift{view_in_hand(ui.state), {0, shift_step}}); }},
      {.name = "approach", .keys = {"Alt+Page Up"}, .line = "keys.approach",
       .run = [](const Ui& ui) { ui.act(action::Approach{view_in_hand(ui.state), 1.15}); }},
      {.name = "recede", .keys = {"Alt+Page Down"}, .line = "keys.approach",
       .run = [](const Ui& ui) { ui.act(action::Approach{view_in_hand(ui.state), 1 / 1.15}); }},
      {.name = "reset-view", .keys = {"O"}, .section = Section::show, .line = "keys.approach", .enabled = is_turned,
       .run = [](const Ui& ui) { ui.act(action::ResetView{view_in_hand(ui.state)}); }},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
