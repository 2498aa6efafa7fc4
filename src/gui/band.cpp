// The band of SCREEN's cells below the plan.

#include "view/band/band.h"
#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"

namespace raywalk {

void band_pane(const Ui& ui, const Rect& where) {
  const Pane pane(ui, "band", where, ui.colours.plan, {0, 0},
                  ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  if (!pane) return;
  ImGui::SetCursorScreenPos(corner(where));
  const bool clicked = ImGui::InvisibleButton("cells", size(where));
  const auto width = static_cast<double>(where.width), height = static_cast<double>(where.height),
             unit = static_cast<double>(ui.unit);
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const int cell = ImGui::IsItemHovered()
                       ? band_cell_at(ui.state, width, height, unit,
                                      {static_cast<double>(mouse.x - where.x), static_cast<double>(mouse.y - where.y)})
                       : -1;
  paint(*ImGui::GetWindowDrawList(), band_view(ui.state, width, height, unit, cell), where, 1, ui.fonts);
  if (cell < 0) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  if (!clicked) return;
  if (ui.state.walk.mode == Mode::move)
    ui.act(action::ChooseLiveCell{cell});
  else
    ui.act(action::JumpToCell{cell});
}

Commands BandRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "band", .keys = {"Shift+S"}, .section = Section::show,
       .chosen = [](const State& state) { return state.band.shown; }, .turn = turn<action::ShowBand>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
