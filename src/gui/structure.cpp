// The accelerators, step by step: which one, the step of its search or build, what the step did, what each saves.

#include "view/structure/structure.h"
#include "gui/choices.h"
#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"
#include "inspect/search_walk.h"
#include "view/text/text.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

std::string said(const Ui& ui, std::string_view id) { return std::string(text(id, ui.state.appearance.language)); }

// A button for one of several choices, as wide as its words; the chosen one is filled.
bool choice_button(const Ui& ui, ButtonRow& row, std::string_view name, const std::string& words, std::string_view hint,
                   float height, bool is_chosen) {
  const ButtonLook look{.look = Look::choice, .icon = Icon::none, .font = ui.fonts.small};
  const float width = button_width(ui, words, look);
  row.place(width);
  return button(ui, name, words, said(ui, hint), {width, height}, look, is_chosen);
}

float draw_steps(const Ui& ui, const Rect& where, float height) {
  const float edge = 1.6f * height, gap = ui.px(4);
  const ButtonLook back{.look = Look::plain, .icon = Icon::back, .font = nullptr, .label = false};
  ButtonLook next{.look = Look::primary, .icon = Icon::step, .font = nullptr, .label = false};
  ImGui::SetCursorScreenPos(corner(where));
  command_button(ui, command("structure-back"), {edge, height}, back);
  ImGui::SetCursorScreenPos({where.x + edge + gap, where.y});
  const int steps = structure_steps(ui.state);
  const float at = steps > 0 ? static_cast<float>(structure_step(ui.state)) / static_cast<float>(steps) : 0.0f;
  const ImVec2 extent{where.width - 2 * (edge + gap), height};
  if (const auto to = slider(ui, "structure/slider", extent, at, structure_panel(ui.state).counter)) {
    const int step = static_cast<int>(std::lround(*to * static_cast<float>(steps)));
    if (step != structure_step(ui.state)) ui.act(action::GoInStructure{step});
  }
  tooltip(ui, "structure/slider", said(ui, "structure.slider_hint"));
  ImGui::SetCursorScreenPos({where.right() - edge, where.y});
  command_button(ui, command("structure-next"), {edge, height}, next);
  return where.y + height;
}

// The pages, and the steps beside or below them.
float draw_pages(const Ui& ui, const Rect& where, float height) {
  ButtonRow row(ui, where, height);
  for (const StructurePage page : {StructurePage::search, StructurePage::build}) {
    const bool search = page == StructurePage::search;
    if (choice_button(ui, row, search ? "structure/search" : "structure/build",
                      said(ui, search ? "structure.search" : "structure.build"),
                      search ? "structure.search_hint" : "structure.build_hint", height,
                      ui.state.structure.page == page))
      ui.act(action::ShowStructurePage{page});
  }
  if (structure_steps(ui.state) == 0) return row.bottom();
  const float right = ImGui::GetItemRectMax().x + ui.px(8), gap = ui.px(8);
  if (where.right() - right >= ui.px(210))
    return draw_steps(ui, {right, where.y, where.right() - right, height}, height);
  return draw_steps(ui, {where.x, row.bottom() + gap, where.width, height}, height);
}

// Each line is a button that chooses its accelerator.
float draw_table(const Ui& ui, const Rect& where, const StructurePanel& panel) {
  const Shades shades(ui.state.appearance.theme);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float line = std::max(ImGui::GetFontSize() + ui.px(12), ui.finger), first = where.width * 0.34f;
  const float inset = (line - ImGui::GetFontSize()) / 2;
  const float column = (where.width - first) / static_cast<float>(std::max<std::size_t>(panel.columns.size(), 1));
  const auto right_aligned = [&](const std::string& words, std::size_t i, float y, Colour colour) {
    const float width = ImGui::CalcTextSize(words.c_str()).x;
    draw.AddText({where.x + first + column * static_cast<float>(i + 1) - width - ui.px(8), std::round(y + inset)},
                 to_imgui(colour), words.c_str());
  };
  float y = where.y;
  for (std::size_t i = 0; i < panel.columns.size(); ++i)
    right_aligned(panel.columns[i], i, y + ui.px(6) - inset, ui.colours.dim_text);
  y += ImGui::GetFontSize() + ui.px(12);
  for (const StructureRow& row : panel.rows) {
    const bool is_chosen = row.kind == ui.state.structure.kind;
    const std::string name = "structure/" + std::string(name_of(row.kind));
    ImGui::SetCursorScreenPos({where.x, y});
    const bool pressed = ImGui::InvisibleButton(name.c_str(), {where.width, line});
    const bool pointed_at = ImGui::IsItemHovered();
    ui.publish(name);
    tooltip(ui, name, said(ui, "structure.kind_hint"));
    if (is_chosen || pointed_at)
      draw.AddRectFilled({where.x, y}, {where.right(), y + line},
                         to_imgui(is_chosen ? shades.accent : shades.raised_hovered), ui.px(4));
    const Colour ink = is_chosen ? shades.on_accent : ui.colours.text;
    draw.AddLine({where.x, y}, {where.right(), y}, to_imgui(shades.line));
    push_font(is_chosen ? ui.fonts.strong : ImGui::GetFont());
    draw.AddText({where.x + ui.px(8), std::round(y + inset)}, to_imgui(ink), row.name.c_str());
    for (std::size_t i = 0; i < row.numbers.size(); ++i) right_aligned(row.numbers[i], i, y, ink);
    pop_font();
    if (pressed) ui.act(action::ChooseStructure{row.kind});
    y += line;
  }
  return y;
}

}  // namespace

void StructureRoom::draw_tab(const Ui& ui, const Rect& pane, TabContext&) {
  // If scrolled, the bar takes some of the width, and the contents begin above the pane.
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const Rect where{at.x, at.y, ImGui::GetContentRegionAvail().x, pane.height};
  const StructurePanel panel = structure_panel(ui.state);
  const float height = ui.high(32), gap = ui.px(8);
  Rect rest = where;
  const auto take = [&](float bottom) { rest = {where.x, bottom + gap, where.width, where.bottom() - bottom - gap}; };
  take(draw_pages(ui, rest, height));
  const auto words = [&](ImFont* font, Colour colour, const std::string& said_here, const char* name) {
    if (said_here.empty()) return;
    ImGui::SetCursorScreenPos({where.x, rest.y});
    push_font(font);
    paragraph(colour, said_here);
    pop_font();
    ui.publish(name);
    take(ImGui::GetItemRectMax().y);
  };
  words(ui.fonts.strong, ui.colours.text, panel.title, "structure/title");
  // Room for three lines, so that nothing below jumps between steps.
  const float top = rest.y;
  words(ui.fonts.text, ui.colours.text, panel.sentence, "structure/sentence");
  words(ui.fonts.small, ui.colours.dim_text, panel.so_far, "structure/so-far");
  if (!panel.rows.empty()) take(std::max(rest.y - gap, top + 4.2f * line_height(ui.fonts, *ui.fonts.text)));
  if (!panel.rows.empty()) {
    push_font(ui.fonts.small);
    take(draw_table(ui, rest, panel));
    pop_font();
  }
  words(ui.fonts.strong, ui.colours.text, panel.summary, "structure/summary");
  for (const std::string& note : panel.notes) words(ui.fonts.small, ui.colours.dim_text, note, "structure/note");
}

namespace {

bool has_next_box(const State& state) {
  return shows_structure(state) && structure_step(state) < structure_steps(state);
}
bool has_last_box(const State& state) { return shows_structure(state) && structure_step(state) > 0; }

void watch_next_kind(const Ui& ui) {
  ui.act(action::ChooseStructure{next_among(watched_accelerators, ui.state.structure.kind)});
}

void turn_structure_page(const Ui& ui) {
  const bool search = ui.state.structure.page == StructurePage::search;
  ui.act(action::ShowStructurePage{search ? StructurePage::build : StructurePage::search});
}

}  // namespace

Commands StructureRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "tab-structure", .keys = {"Ctrl+T"}, .section = Section::tabs, .line = "keys.structure",
       .chosen = shows_tab<StructureRoom>, .run = open_tab<StructureRoom>},
      {.name = "structure-kind", .keys = {"Ctrl+U"}, .section = Section::structure, .line = "keys.structure",
       .enabled = shows_structure, .run = watch_next_kind},
      {.name = "structure-page", .keys = {"Ctrl+I"}, .section = Section::structure, .line = "keys.structure",
       .enabled = shows_structure, .run = turn_structure_page},
      {.name = "structure-next", .keys = {"Ctrl+J"}, .section = Section::structure, .line = "keys.structure_steps",
       .enabled = has_next_box,
       .run = [](const Ui& ui) { ui.act(action::GoInStructure{structure_step(ui.state) + 1}); }},
      {.name = "structure-back", .keys = {"Ctrl+K"}, .section = Section::structure, .line = "keys.structure_steps",
       .enabled = has_last_box,
       .run = [](const Ui& ui) { ui.act(action::GoInStructure{structure_step(ui.state) - 1}); }},
      {.name = "structure-last", .keys = {"Ctrl+Shift+J"}, .line = "keys.structure_steps", .enabled = has_next_box,
       .run = [](const Ui& ui) { ui.act(action::GoInStructure{structure_steps(ui.state)}); }},
      {.name = "structure-first", .keys = {"Ctrl+Shift+K"}, .line = "keys.structure_steps", .enabled = has_last_box,
       .run = act<action::GoInStructure, 0>},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
