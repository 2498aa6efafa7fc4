#include "view/legend/legend.h"
#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/widgets.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

// A sample of a ray of this kind, with its arrowhead, from (x, y) to the right.
void sample(const Ui& ui, const LegendRow& row, float x, float y, float length) {
  LineItem line;
  line.from = {x, y};
  line.to = {x + length, y};
  line.stroke = {row.style.colour, static_cast<double>(ui.px(2.2f)), row.style.dash, 0};
  for (double& part : line.stroke.dash.lengths) part *= static_cast<double>(ui.unit);
  // With little room, dashes are more informative than the arrowhead.
  line.arrow = length < ui.px(30) ? 0.0 : static_cast<double>(ui.px(10));
  paint_line(*ImGui::GetWindowDrawList(), line);
}

}  // namespace

void LegendRoom::draw_tab(const Ui& ui, const Rect& where, TabContext&) {
  const Legend content = legend(ui.state);
  const float column = ui.px(78);
  for (const LegendRow& row : content.rays) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    sample(ui, row, at.x, at.y + ImGui::GetFontSize() / 2, ui.px(56));
    ImGui::SetCursorScreenPos({at.x + column, at.y});
    ImGui::PushTextWrapPos(where.width - ui.px(12));
    push_font(ui.fonts.strong);
    label(ui.colours.text, row.name);
    pop_font();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + column);
    push_font(ui.fonts.small);
    label(ui.colours.dim_text, row.meaning);
    pop_font();
    ImGui::PopTextWrapPos();
  }
  ImGui::Spacing();
  for (const LegendSign& sign : content.signs) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    push_font(ui.fonts.strong);
    label(ui.colours.text, sign.symbol);
    pop_font();
    ImGui::SetCursorScreenPos({at.x + column, at.y});
    ImGui::PushTextWrapPos(where.width - ui.px(12));
    push_font(ui.fonts.small);
    label(ui.colours.dim_text, sign.meaning);
    pop_font();
    ImGui::PopTextWrapPos();
  }
}

void legend_pane(const Ui& ui, const Rect& where) {
  const Pane pane(ui, "legend", where, ui.colours.plan, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  push_font(ui.fonts.small);
  const Legend content = legend(ui.state);
  const float height = line_height(ui.fonts, *ui.fonts.small), gap = ui.px(7);
  const float length = ui.px(where.width < ui.px(640) ? 26 : 34);
  const auto width_of = [&](std::string LegendRow::* name) {
    float sum = 0;
    for (const LegendRow& row : content.rays) sum += length + gap + ImGui::CalcTextSize((row.*name).c_str()).x;
    return sum;
  };
  const float least_between = ui.px(8) * static_cast<float>(content.rays.size());
  const bool in_short = width_of(&LegendRow::name) + least_between > where.width - ui.px(28);
  const auto name = in_short ? &LegendRow::short_name : &LegendRow::name;
  // Spread, but not too far; in a narrow window tight, or in two lines.
  const float most = where.width - ui.px(28);
  const auto count = content.rays.size();
  const std::size_t lines = width_of(name) + least_between > most ? 2 : 1, in_line = (count + lines - 1) / lines;
  const float room = (most - width_of(name) / static_cast<float>(lines)) / static_cast<float>(in_line);
  const float between = std::clamp(room, ui.px(4), ui.px(22));
  const float line = std::min(height + ui.px(2), where.height / static_cast<float>(lines));
  float y = std::round(where.y + (where.height - line * static_cast<float>(lines)) / 2 + (line - height) / 2);
  // In two lines the names are aligned.
  float widest = 0;
  for (const LegendRow& row : content.rays) widest = std::max(widest, ImGui::CalcTextSize((row.*name).c_str()).x);
  float x = where.x + ui.px(14);
  for (std::size_t i = 0; i < count; ++i) {
    const LegendRow& row = content.rays[i];
    if (i > 0 && i % in_line == 0) {
      x = where.x + ui.px(14);
      y = std::round(y + line);
    }
    sample(ui, row, x, y + height / 2, length);
    x += length + gap;
    ImGui::GetWindowDrawList()->AddText({std::round(x), y}, to_imgui(ui.colours.dim_text), (row.*name).c_str());
    x += (lines > 1 ? widest : ImGui::CalcTextSize((row.*name).c_str()).x) + between;
  }
  pop_font();
}

Commands LegendRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-legend", .keys = {"L"}, .section = Section::tabs, .line = "keys.tabs",
       .chosen = shows_tab<LegendRoom>, .run = open_tab<LegendRoom>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
