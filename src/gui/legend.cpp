#include "view/legend/legend.h"
#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/widgets.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

constexpr int hidden_alpha = 70;  // alpha of what is hidden

std::string command_name(RayKind kind) { return "rays-" + std::string(name_of(kind)); }

// A sample of a ray of this kind, with its arrowhead, from (x, y) to the right.
void sample(const Ui& ui, const LegendRow& row, float x, float y, float length) {
  LineItem line;
  line.from = {x, y};
  line.to = {x + length, y};
  const Colour colour = ui.state.legend.shows(row.kind) ? row.style.colour : row.style.colour.with_alpha(hidden_alpha);
  line.stroke = {colour, static_cast<double>(ui.px(2.2f)), row.style.dash, 0};
  for (double& part : line.stroke.dash.lengths) part *= static_cast<double>(ui.unit);
  // With little room, dashes are more informative than the arrowhead.
  line.arrow = length < ui.px(30) ? 0.0 : static_cast<double>(ui.px(10));
  paint_line(*ImGui::GetWindowDrawList(), line);
}

// A row hides and shows its rays: a click anywhere in `where`.
void row_button(const Ui& ui, const LegendRow& row, const Rect& where) {
  const Command& shows = command(command_name(row.kind));
  const std::string name = "legend/" + std::string(name_of(row.kind));
  ImGui::SetCursorScreenPos(corner(where));
  if (ImGui::InvisibleButton(name.c_str(), size(where))) perform(shows, ui);
  ui.publish(name);
  if (!ImGui::IsItemHovered()) return;
  ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
  tooltip(ui, name, ui.say(ui.state.legend.shows(row.kind) ? "legend.hide" : "legend.show"));
}

}  // namespace

void LegendRoom::draw_tab(const Ui& ui, const Rect& where, TabContext&) {
  const Legend content = legend(ui.state);
  const float column = ui.px(78);
  // Before its choice if both fit into a line.
  push_font(ui.fonts.small);
  const std::string earlier = ui.say("legend.earlier");
  const float words = ImGui::CalcTextSize(earlier.c_str()).x + ui.px(12), room = where.width - ui.px(24);
  float buttons = 0;
  for (const Command* each : commands_in(Section::earlier))
    buttons += button_width(ui, *each, {.look = Look::choice, .icon = Icon::none, .font = ui.fonts.small});
  const bool in_line = words + buttons <= room;
  if (in_line) ImGui::SetCursorPosY(ImGui::GetCursorPosY() + (ui.px(30) - ImGui::GetFontSize()) / 2);
  const ImVec2 begun = ImGui::GetCursorScreenPos();
  label(ui.colours.text, earlier);
  if (in_line) ImGui::SetCursorScreenPos({begun.x + words, begun.y - (ui.px(30) - ImGui::GetFontSize()) / 2});
  pop_font();
  choice(ui, commands_in(Section::earlier), ui.px(30), ui.fonts.small, in_line ? room - words : room);
  ImGui::Spacing();
  for (const LegendRow& row : content.rays) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    sample(ui, row, at.x, at.y + ImGui::GetFontSize() / 2, ui.px(56));
    ImGui::SetCursorScreenPos({at.x + column, at.y});
    ImGui::PushTextWrapPos(where.width - ui.px(12));
    push_font(ui.fonts.strong);
    const bool shown = ui.state.legend.shows(row.kind);
    label(shown ? ui.colours.text : ui.colours.dim_text, row.name);
    pop_font();
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + column);
    push_font(ui.fonts.small);
    label(ui.colours.dim_text, shown ? row.meaning : ui.say("legend.hidden"));
    pop_font();
    ImGui::PopTextWrapPos();
    const ImVec2 below = ImGui::GetCursorScreenPos();
    row_button(ui, row, {at.x, at.y, where.width - ui.px(12), std::max(below.y - at.y, 1.0f)});
    ImGui::SetCursorScreenPos(below);
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
  float length = ui.px(where.width < ui.px(640) ? 26 : 34);
  const auto width_of = [&](std::string LegendRow::* name) {
    float sum = 0;
    for (const LegendRow& row : content.rays) sum += length + gap + ImGui::CalcTextSize((row.*name).c_str()).x;
    return sum;
  };
  const float least_between = ui.px(8) * static_cast<float>(content.rays.size());
  // "Only this pixel" at the right: in short if that lets the kinds of rays stand in one line.
  const Command& only = command("only-pixel");
  const ButtonLook look{
      .look = chosen(only, ui.state) ? Look::choice : Look::plain, .icon = Icon::none, .font = ui.fonts.small};
  const auto button_of = [&](bool in_short) { return button_width(ui, command_label(only, ui.state, in_short), look); };
  const auto left_by = [&](float button) { return where.width - button - ui.px(28 + 8); };
  const bool button_in_short = width_of(&LegendRow::name) + least_between > left_by(button_of(false));
  const float button = button_of(button_in_short), most = left_by(button);
  const bool in_short = width_of(&LegendRow::name) + least_between > most;
  const auto name = in_short ? &LegendRow::short_name : &LegendRow::name;
  // Spread, but not too far; in a narrow window tight, or in two lines.
  const auto count = content.rays.size();
  const std::size_t lines = width_of(name) + least_between > most ? 2 : 1, in_line = (count + lines - 1) / lines;
  // In two lines the names are aligned if there is room, with shorter samples where the widest would not fit otherwise.
  float widest = 0;
  for (const LegendRow& row : content.rays) widest = std::max(widest, ImGui::CalcTextSize((row.*name).c_str()).x);
  const auto each = static_cast<float>(in_line);
  if (lines > 1) length = std::clamp(most / each - ui.px(4) - gap - widest, ui.px(8), length);
  const bool aligned = lines > 1 && each * (length + gap + widest + ui.px(4)) <= most;
  const float needed = lines > 1 ? each * (length + gap + widest) : width_of(name);
  const float between = std::clamp((most - needed) / each, ui.px(4), ui.px(22));
  const float line = std::min(height + ui.px(2), where.height / static_cast<float>(lines));
  float y = std::round(where.y + (where.height - line * static_cast<float>(lines)) / 2 + (line - height) / 2);
  float x = where.x + ui.px(14);
  for (std::size_t i = 0; i < count; ++i) {
    const LegendRow& row = content.rays[i];
    if (i > 0 && i % in_line == 0) {
      x = where.x + ui.px(14);
      y = std::round(y + line);
    }
    const float left = x, words = ImGui::CalcTextSize((row.*name).c_str()).x;
    sample(ui, row, x, y + height / 2, length);
    x += length + gap;
    const bool shown = ui.state.legend.shows(row.kind);
    const ImU32 ink = to_imgui(shown ? ui.colours.dim_text : ui.colours.dim_text.with_alpha(2 * hidden_alpha));
    ImDrawList& draw = *ImGui::GetWindowDrawList();
    draw.AddText({std::round(x), y}, ink, (row.*name).c_str());
    // Struck through, so that a kind that is hidden is not only fainter.
    if (!shown) draw.AddLine({left, y + height / 2}, {x + words, y + height / 2}, ink, ui.px(1.5f));
    row_button(ui, row, {left, y, x + words - left, line});
    x += (aligned ? widest : words) + between;
  }
  const float button_height = std::min(ui.px(30), where.height);
  ImGui::SetCursorScreenPos({where.right() - button - ui.px(4), where.y + (where.height - button_height) / 2});
  command_button(ui, only, {button, button_height}, look, command_label(only, ui.state, button_in_short));
  pop_font();
}

namespace {

template <RayKind kind>
bool shows_rays(const State& state) {
  return state.legend.shows(kind);
}
template <RayKind kind>
void toggle_rays(const Ui& ui) {
  ui.act(action::ShowRays{kind, !ui.state.legend.shows(kind)});
}
template <Earlier how>
bool shows_earlier(const State& state) {
  return state.legend.earlier == how;
}

}  // namespace

Commands LegendRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-legend", .keys = {"L"}, .section = Section::tabs, .line = "keys.tabs",
       .chosen = shows_tab<LegendRoom>, .run = open_tab<LegendRoom>},
      {.name = "rays-primary", .keys = {"Alt+1"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::primary>, .run = toggle_rays<RayKind::primary>},
      {.name = "rays-shadow", .keys = {"Alt+2"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::shadow>, .run = toggle_rays<RayKind::shadow>},
      {.name = "rays-reflect", .keys = {"Alt+3"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::reflect>, .run = toggle_rays<RayKind::reflect>},
      {.name = "rays-refract", .keys = {"Alt+4"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::refract>, .run = toggle_rays<RayKind::refract>},
      {.name = "rays-photon", .keys = {"Alt+8"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::photon>, .run = toggle_rays<RayKind::photon>},
      {.name = "rays-beam", .keys = {"Alt+9"}, .section = Section::rays, .line = "keys.rays_shown",
       .chosen = shows_rays<RayKind::beam>, .run = toggle_rays<RayKind::beam>},
      {.name = "only-pixel", .keys = {"Shift+L"}, .section = Section::rays, .chosen = shows_earlier<Earlier::hidden>,
       .run = [](const Ui& ui) {
         ui.act(action::ShowEarlier{shows_earlier<Earlier::hidden>(ui.state) ? Earlier::faded : Earlier::hidden});
       }},
      {.name = "earlier-shown", .keys = {"Alt+5"}, .section = Section::earlier, .line = "keys.earlier",
       .chosen = shows_earlier<Earlier::shown>, .run = act<action::ShowEarlier, Earlier::shown>},
      {.name = "earlier-faded", .keys = {"Alt+6"}, .section = Section::earlier, .line = "keys.earlier",
       .chosen = shows_earlier<Earlier::faded>, .run = act<action::ShowEarlier, Earlier::faded>},
      {.name = "earlier-hidden", .keys = {"Alt+7"}, .section = Section::earlier, .line = "keys.earlier",
       .chosen = shows_earlier<Earlier::hidden>, .run = act<action::ShowEarlier, Earlier::hidden>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
