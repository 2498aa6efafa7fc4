#include "view/walk/equation.h"
#include "gui/broken_lines.h"
#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "text/language.h"

#include <algorithm>

namespace raywalk {

namespace {

// A swatch of a term's colour, as in the picture.
void swatch(const Ui& ui, const Rgbd& light, float height) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = 1.6f * height;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled(at, {at.x + width, at.y + height}, to_imgui(display_colour(light, ui.state.scene().encoding)),
                     ui.px(3));
  draw.AddRect(at, {at.x + width, at.y + height}, to_imgui(ui.colours.dim_text), ui.px(3));
  ImGui::SetCursorScreenPos({at.x + width + ui.px(8), at.y});
}

}  // namespace

void EquationRoom::draw_tab(const Ui& ui, const Rect& where, TabContext&) {
  const EquationPanel panel = equation_panel(ui.state);
  if (panel.rows.empty())
    return paragraph(ui.colours.dim_text, ui.say(ui.state.walk.position == 0 ? "equation.empty" : "equation.nothing"));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(8), ui.px(5)});
  push_font(ui.fonts.strong);
  label(ui.colours.text, panel.title);
  pop_font();
  int number = 0;
  for (const EquationRow& row : panel.rows) {
    using Kind = EquationRow::Kind;
    const bool total = row.kind == Kind::total;
    if (total && row.light) {
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::GetWindowDrawList()->AddLine(at, {at.x + where.width - ui.px(14), at.y},
                                          to_imgui(Shades(ui.state.appearance.theme).line));
      ImGui::Dummy({1, ui.px(1)});
    }
    push_font(row.kind == Kind::note ? ui.fonts.small : total ? ui.fonts.code_strong : ui.fonts.code);
    if (row.light) swatch(ui, *row.light, ImGui::GetFontSize());
    const bool dim = row.kind == Kind::formula || row.kind == Kind::note;
    const float room = where.right() - ui.px(14) - ImGui::GetCursorScreenPos().x;
    label(dim ? ui.colours.dim_text : ui.colours.text, broken_lines(row.text, room));
    ui.publish("equation/" + std::to_string(number++));
    pop_font();
  }
  ImGui::PopStyleVar();
}

Commands EquationRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-equation", .keys = {"E"}, .section = Section::tabs, .chosen = shows_tab<EquationRoom>,
       .run = open_tab<EquationRoom>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
