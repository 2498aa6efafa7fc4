// Focus: its command, and the edges to which panes are folded.

#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"

namespace raywalk {

void folded_pane(const Ui& ui, const char* name, const Rect& where) {
  const Pane pane(ui, name, where, ui.colours.panel, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  ImGui::SetCursorScreenPos(corner(where));
  command_button(ui, command("focus"), size(where),
                 {.look = Look::flat, .icon = Icon::focus, .font = nullptr, .label = false});
}

void focus_button(const Ui& ui, const Rect& where) {
  // On the ground of the strip that it ends.
  const Colour ground = ui.state.walk.mode == Mode::move ? ui.colours.window : ui.colours.plan;
  const Pane pane(ui, "corner", where, ground, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  const float gap = ui.px(ui.finger > 0 ? 1 : 4), edge = std::max(std::min(where.width, where.height) - 2 * gap, 1.0f);
  ImGui::SetCursorScreenPos({where.x + (where.width - edge) / 2, where.y + (where.height - edge) / 2});
  command_button(ui, command("focus"), {edge, edge},
                 {.look = Look::choice, .icon = Icon::focus, .font = nullptr, .label = false});
}

Commands FocusRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "focus", .keys = {"Shift+F"}, .section = Section::window,
       .chosen = [](const State& state) { return state.focus.on; }, .turn = turn<action::SetFocus>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
