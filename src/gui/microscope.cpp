// The numerical microscope: a hit at any magnification, and what robust and naive numerics make of it.

#include "view/microscope/microscope.h"
#include "gui/broken_lines.h"
#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text/text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raywalk {

namespace {

// Controls: zoom; numerics and precision of the walk. `low`: there is little room; the slider's ends do as much as the
// buttons that go there at once.
void draw_controls(const Ui& ui, ButtonRow& row, float height, bool low) {
  const float edge = height, bar = ui.px(low ? 90 : 120), gap = ui.px(4);
  const ButtonLook minus{.look = Look::plain, .icon = Icon::minus, .font = nullptr, .label = false};
  ButtonLook plus = minus;
  plus.icon = Icon::plus;
  row.place(2 * edge + bar + 2 * gap);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  command_button(ui, command("diminish"), {edge, height}, minus);
  ImGui::SetCursorScreenPos({at.x + edge + gap, at.y});
  const auto to = slider(ui, "magnification", {bar, height}, static_cast<float>(ui.state.microscope.magnified), {});
  if (to && static_cast<double>(*to) != ui.state.microscope.magnified)
    ui.act(action::Magnify{static_cast<double>(*to)});
  tooltip(ui, "magnification", ui.say("microscope.magnification_hint"));
  ImGui::SetCursorScreenPos({at.x + edge + bar + 2 * gap, at.y});
  command_button(ui, command("magnify"), {edge, height}, plus);
  if (!low) row.add(command("to-numbers"));
  if (!low) row.add(command("to-scene"));
  for (const Section section : {Section::numerics, Section::precision}) {
    float width = 0;
    for (const Command* each : commands_in(section))
      width += button_width(ui, *each, {.look = Look::choice, .icon = Icon::none, .font = ui.fonts.small});
    row.place(width);
    choice(ui, commands_in(section), height, ui.fonts.small);
  }
}

void draw_slide(const Ui& ui, const Rect& where, const Specimen& specimen) {
  const Viewport pane{static_cast<double>(where.width / ui.dpi), static_cast<double>(where.height / ui.dpi)};
  paint(*ImGui::GetWindowDrawList(), microscope_view(ui.state, specimen, pane), where, ui.dpi, ui.fonts);
  ImGui::SetCursorScreenPos(corner(where));
  ImGui::InvisibleButton("microscope", size(where));
  ui.publish("microscope", where);
  constexpr double notch = 0.025;
  const float wheel = ImGui::GetIO().MouseWheel;
  if (ImGui::IsItemHovered() && wheel != 0)
    ui.act(action::Magnify{ui.state.microscope.magnified + notch * static_cast<double>(wheel)});
}

// Elides more digits of a number ("7.857\u202611") to fit the column: the last ones matter.
std::string with_fewer_digits(std::string words, float width) {
  const std::string ellipsis = "\u2026";
  while (ImGui::CalcTextSize(words.c_str()).x > width) {
    const std::size_t at = words.find(ellipsis);
    if (at == std::string::npos || at < 2) break;
    words.erase(at - 1, 1);
  }
  return words;
}

// Wraps words within a column; returns where the column's next cell may begin.
float cell(Colour colour, const std::string& words, float x, float y, float width) {
  ImGui::SetCursorScreenPos({x, y});
  label(colour, broken_lines(with_fewer_digits(words, width), width));
  return ImGui::GetItemRectMax().y;
}

// The signs of the two in the drawing, `r` wide to either side.
void draw_disc(const Ui& ui, float x, float middle, float r) {
  ImGui::GetWindowDrawList()->AddCircleFilled({x, middle}, r, to_imgui(ui.colours.hovered));
}
void draw_triangle(const Ui& ui, float x, float middle, float r) {
  ImGui::GetWindowDrawList()->AddTriangle({x, middle - 1.2f * r}, {x - 1.2f * r, middle + r},
                                          {x + 1.2f * r, middle + r}, to_imgui(ui.colours.error), ui.px(2));
}

// The words of the table, and where its columns are. Where it is narrow, each row is three lines, and a legend above
// them has the words for the signs.
struct Columns {
  float what, robust, naive;  ///< x
  float first, second;        ///< widths, of the row's name and of a value
  float sign;                 ///< radius
  bool stacked;
};

Columns columns_of(const Ui& ui, const Rect& where) {
  const float sign = ui.px(5), indent = 3.4f * sign, first = where.width * 0.24f, second = (where.width - first) / 2;
  if (where.width < ui.px(250))
    return {where.x, where.x + indent, where.x + indent, where.width, where.width - indent, sign, true};
  return {where.x, where.x + first, where.x + first + second, first - ui.px(6), second - ui.px(6), sign, false};
}

// Returns where the rows may begin.
float draw_heads(const Ui& ui, const Columns& columns, float y) {
  const float r = columns.sign, indent = 3 * r;
  push_font(ui.fonts.strong);
  const auto width = [&](const char* id) { return indent + ImGui::CalcTextSize(ui.say(id).c_str()).x; };
  const bool narrow = std::max(width("microscope.robust"), width("microscope.naive")) > columns.second;
  pop_font();
  push_font(narrow ? ui.fonts.small : ui.fonts.strong);
  const float line = ImGui::GetFontSize(), below = columns.stacked ? line + ui.px(3) : 0;
  const float robust = columns.stacked ? columns.what : columns.robust;
  const float naive = columns.stacked ? columns.what : columns.naive;
  draw_disc(ui, robust + 1.2f * r, y + line / 2, r);
  draw_triangle(ui, naive + 1.2f * r, y + below + line / 2, r);
  const float room = columns.stacked ? columns.first - indent : columns.second - indent;
  cell(ui.colours.text, shortened(ui.say("microscope.robust"), room), robust + indent, y, ui.px(200));
  cell(ui.colours.text, shortened(ui.say("microscope.naive"), room), naive + indent, y + below, ui.px(200));
  pop_font();
  return y + below + line;
}

// Returns where it ends.
float draw_table(const Ui& ui, const Rect& where, const MicroscopeTable& table) {
  const Columns columns = columns_of(ui, where);
  const float gap = ui.px(6), r = columns.sign;
  const ImU32 line = to_imgui(Shades(ui.state.appearance.theme).line);
  ImFont* font = where.width >= ui.px(420) ? ui.fonts.text : ui.fonts.small;
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  push_font(ui.fonts.strong);
  float y = cell(ui.colours.text, table.title, where.x, where.y, where.width) + gap;
  ui.publish("microscope/title");
  pop_font();
  push_font(font);
  y = cell(ui.colours.text, table.sentence, where.x, y, where.width) + 1.5f * gap;
  ui.publish("microscope/sentence");
  pop_font();
  if (table.rows.empty()) return y;
  y = draw_heads(ui, columns, y) + gap;
  push_font(font);
  int number = 0;
  for (const MicroscopeTable::Row& row : table.rows) {
    draw.AddLine({where.x, y}, {where.right(), y}, line);
    y += gap / 2;
    float bottom = cell(ui.colours.dim_text, row.what, columns.what, y, columns.first);
    const auto value = [&](const std::string& words, Colour colour, float x, auto draw_sign) {
      if (columns.stacked) {
        y = bottom;
        draw_sign(ui, columns.what + 1.2f * r, y + ImGui::GetFontSize() / 2, r);
      }
      bottom = std::max(bottom, cell(colour, words, x, y, columns.second));
    };
    value(row.robust, ui.colours.text, columns.robust, draw_disc);
    push_font(row.wrong ? ui.fonts.strong : font);
    value(row.naive, row.wrong ? ui.colours.error : ui.colours.text, columns.naive, draw_triangle);
    pop_font();
    ui.publish("microscope/row-" + std::to_string(number++));
    y = bottom + gap / 2;
  }
  draw.AddLine({where.x, y}, {where.right(), y}, line);
  pop_font();
  return y;
}

// What the tab keeps between frames.
struct Kept {
  Microscope microscope;
  FormMemory epsilon;
};

void microscope_tab(const Ui& ui, const Rect& where, Kept& kept) {
  push_font(ui.fonts.small);
  const auto specimen = specimen_of(kept.microscope, ui.state);
  const float height = ui.high(28), gap = ui.px(8);
  const bool wide = where.width > 1.15f * where.height;
  ButtonRow row(ui, where, height);
  draw_controls(ui, row, height, where.height < ui.px(260));
  const float top = row.bottom() + gap;
  Rect slide{where.x, top, where.width, where.bottom() - top}, table = slide;
  if (wide) {
    // A narrow table needs its share more than the drawing does, unless that is too low for its labels.
    const bool is_low = slide.height < ui.px(150) && where.width > ui.px(260);
    slide.width = std::floor(where.width * (is_low ? 0.58f : where.width < ui.px(480) ? 0.5f : 0.54f));
    table.x = slide.right() + ui.px(14);
    table.width = where.right() - table.x;
  } else {
    // A low drawing needs its share more than the table does, which scrolls.
    slide.height = std::floor(slide.height * (slide.height < ui.px(260) ? 0.62f : 0.5f));
    table.y = slide.bottom() + gap;
    table.height = where.bottom() - table.y;
  }
  if (!specimen) {
    ImGui::SetCursorScreenPos({where.x, top});
    paragraph(ui.colours.dim_text, ui.say("microscope.empty"));
    return pop_font();
  }
  if (slide.width > 8 && slide.height > 8) draw_slide(ui, slide, *specimen);
  ImGui::SetCursorScreenPos(corner(table));
  if (ImGui::BeginChild("microscope-table", size(table))) {
    const Rect inside{table.x, ImGui::GetCursorScreenPos().y, ImGui::GetContentRegionAvail().x - ui.px(4),
                      table.height};
    const float bottom = draw_table(ui, inside, microscope_table(ui.state, *specimen));
    ImGui::SetCursorScreenPos({inside.x, bottom + 1.5f * gap});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ui.px(6), ui.px(6)});
    Form form(ui, kept.epsilon, inside.width);
    epsilon_row(ui, form);
    ImGui::PopStyleVar();
    close_edges(ui, ui.colours.panel);
  }
  ImGui::EndChild();
  pop_font();
}

}  // namespace

void MicroscopeRoom::draw_tab(const Ui& ui, const Rect& where, TabContext& context) {
  microscope_tab(ui, where, context.memory.of<Kept>());
}

namespace {

constexpr double magnify_step = 0.05;

bool can_magnify(const State& state) {
  return state.appearance.tab == MicroscopeRoom::tab && state.microscope.magnified < 1;
}
bool can_diminish(const State& state) {
  return state.appearance.tab == MicroscopeRoom::tab && state.microscope.magnified > 0;
}

void set_numerics(const Ui& ui, Numerics numerics) {
  ui.act(action::SetNumerics{numerics, ui.state.scene().render.epsilon});
}

void set_precision(const Ui& ui, bool single) {
  ImageSettings settings = ui.state.picture.settings;
  settings.single_precision = single;
  ui.act(action::SetImageSettings{settings});
}

}  // namespace

Commands MicroscopeRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-microscope", .keys = {"Y"}, .section = Section::tabs, .line = "keys.microscope",
       .chosen = shows_tab<MicroscopeRoom>, .run = open_tab<MicroscopeRoom>},
      {.name = "magnify", .keys = {"Z"}, .section = Section::microscope, .line = "keys.microscope",
       .enabled = can_magnify,
       .run = [](const Ui& ui) { ui.act(action::Magnify{ui.state.microscope.magnified + magnify_step}); }},
      {.name = "diminish", .keys = {"Shift+Z"}, .section = Section::microscope, .line = "keys.microscope",
       .enabled = can_diminish,
       .run = [](const Ui& ui) { ui.act(action::Magnify{ui.state.microscope.magnified - magnify_step}); }},
      {.name = "to-numbers", .keys = {"Alt+Z"}, .section = Section::microscope, .line = "keys.microscope",
       .enabled = can_magnify, .run = act<action::Magnify, 1>},
      {.name = "to-scene", .keys = {"Alt+Shift+Z"}, .section = Section::microscope, .line = "keys.microscope",
       .enabled = can_diminish, .run = act<action::Magnify, 0>},
      {.name = "numerics-robust", .keys = {"Shift+Q"}, .section = Section::numerics, .line = "keys.numerics",
       .chosen = [](const State& state) { return state.scene().render.numerics == Numerics::robust; },
       .run = [](const Ui& ui) { set_numerics(ui, Numerics::robust); }},
      {.name = "numerics-naive", .keys = {"Shift+N"}, .section = Section::numerics, .line = "keys.numerics",
       .chosen = [](const State& state) { return state.scene().render.numerics == Numerics::naive; },
       .run = [](const Ui& ui) { set_numerics(ui, Numerics::naive); }},
      {.name = "precision-double", .keys = {"Alt+Shift+Q"}, .section = Section::precision, .line = "keys.numerics",
       .chosen = [](const State& state) { return !state.picture.settings.single_precision; },
       .run = [](const Ui& ui) { set_precision(ui, false); }},
      {.name = "precision-float", .keys = {"Alt+Q"}, .section = Section::precision, .line = "keys.numerics",
       .chosen = [](const State& state) { return state.picture.settings.single_precision; },
       .run = [](const Ui& ui) { set_precision(ui, true); }},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
