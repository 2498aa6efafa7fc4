#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/code_panel.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

namespace {

// Lengths at scale 1: margins of the pane, of a box, of its heading and lines.
constexpr float margin = 10, box_padding = 6, between_boxes = 8, row_gap = 1, pointer_column = 22, indent = 18;

struct CodeSizes {
  /// Lines are tighter by this factor if there is little room.
  explicit CodeSizes(const Ui& ui, float squeeze = 1)
      : row(squeeze * (line_height(ui.fonts, *ui.fonts.code) + ui.px(row_gap))),
        heading(squeeze * (line_height(ui.fonts, *ui.fonts.code_strong) + ui.px(4))) {}
  float row, heading;
};

float box_height(const Ui& ui, const CodeSizes& sizes, const CodeBox& box) {
  return sizes.heading + static_cast<float>(box.rows.size()) * sizes.row + ui.px(2 * box_padding);
}

float text_width(ImFont* font, const std::string& text) {
  push_font(font);
  const float width = ImGui::CalcTextSize(text.c_str()).x;
  pop_font();
  return width;
}

// A disc for a breakpoint, and for one that a click would set.
void draw_breakpoint(const Ui& ui, const Rect& gutter, bool is_set, bool pointed_at) {
  if (!is_set && !pointed_at) return;
  const ImVec2 centre{gutter.x + gutter.width * 0.42f, gutter.y + gutter.height / 2};
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  if (is_set) draw.AddCircleFilled(centre, ui.px(8), to_imgui(ui.colours.error));
  if (pointed_at) draw.AddCircle(centre, ui.px(8), to_imgui(ui.colours.text), 0, std::max(ui.px(1.4f), 1.0f));
}

// A frame, and a sign at the right end: suspected, or known to be faulty.
void draw_blame(const Ui& ui, Blame blame, const Rect& where) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 ink = to_imgui(ui.colours.error);
  draw.AddRect(corner(where), opposite(where), ink, ui.px(4), 0, std::max(ui.px(2), 1.0f));
  const char* sign = blame == Blame::marked ? "?" : "\u2717";
  push_font(ui.fonts.code_strong);
  const ImVec2 extent = ImGui::CalcTextSize(sign);
  draw.AddText({where.right() - extent.x - ui.px(7), where.y + (where.height - extent.y) / 2}, ink, sign);
  pop_font();
}

// The line just run has a pointer at its left and a background, the next one an outline.
void draw_row(const Ui& ui, const CodeRow& row, const Rect& where) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Shades shades(ui.state.appearance.theme);
  const float rounding = ui.px(4), y = where.y + where.height / 2;
  const ImVec2 least{where.x + ui.px(pointer_column), where.y}, most{where.right(), where.bottom()};
  if (row.just_run) {
    draw.AddRectFilled(least, most, to_imgui(ui.colours.just_run), rounding);
    const float x = where.x + ui.px(3), r = ui.px(7);
    draw.AddTriangleFilled({x, y - r}, {x + 1.7f * r, y}, {x, y + r}, to_imgui(shades.accent_hovered));
  } else if (row.hovered) {
    draw.AddRectFilled(least, most, to_imgui(shades.raised), rounding);
  }
  if (row.hovered && row.just_run)
    draw.AddRect(least, most, to_imgui(ui.colours.hovered), rounding, 0, std::max(ui.px(1), 1.0f));
  if (row.next) draw.AddRect(least, most, to_imgui(ui.colours.next), rounding, 0, std::max(ui.px(1.5f), 1.0f));
  if (row.blame != Blame::none) draw_blame(ui, row.blame, {least.x, where.y, most.x - least.x, where.height});
  ImFont* font = row.just_run ? ui.fonts.code_strong : ui.fonts.code;
  const float height = line_height(ui.fonts, *font);
  push_font(font);
  draw.AddText({std::round(least.x + ui.px(7 + indent * static_cast<float>(row.indent))), std::round(y - height / 2)},
               to_imgui(ui.colours.text), row.text.c_str());
  pop_font();
}

void draw_heading(const Ui& ui, const CodeBox& box, const Rect& where) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const Shades shades(ui.state.appearance.theme);
  push_font(ui.fonts.code_strong);
  draw.AddText({std::round(where.x), std::round(where.y)}, to_imgui(box.depth ? ui.colours.text : ui.colours.dim_text),
               box.title.c_str());
  pop_font();
  if (box.badge.empty()) return;
  push_font(ui.fonts.small);
  const ImVec2 extent = ImGui::CalcTextSize(box.badge.c_str());
  const float height = line_height(ui.fonts, *ui.fonts.code_strong);
  const ImVec2 at{where.right() - extent.x - ui.px(8), where.y + (height - extent.y) / 2};
  draw.AddRectFilled({at.x - ui.px(8), at.y - ui.px(2)}, {where.right(), at.y + extent.y + ui.px(2)},
                     to_imgui(shades.accent), ui.px(9));
  draw.AddText(at, to_imgui(shades.on_accent), box.badge.c_str());
  pop_font();
}

// Scrolls `top`..`bottom` (of the contents) into view, once per new position.
void keep_in_sight(const Ui& ui, float top, float bottom) {
  int& shown = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("position"), -1);
  if (shown == ui.state.walk.position) return;
  shown = ui.state.walk.position;
  const float height = ImGui::GetWindowHeight(), scroll = ImGui::GetScrollY();
  if (top < scroll || bottom > scroll + height) ImGui::SetScrollY(std::max((top + bottom - height) / 2, 0.0f));
}

}  // namespace

float code_height(const Ui& ui) {
  const CodeSizes sizes(ui);
  float height = ui.px(2 * margin + between_boxes);
  for (const CodeBox& box : code_panel(ui.state).boxes) height += box_height(ui, sizes, box);
  return height + 1;
}

float code_width(const Ui& ui) {
  float width = 0;
  for (const CodeBox& box : code_panel(ui.state).boxes) {
    const std::string badge = ui.say("code.depth_badge", {{"number", "10"}});
    width =
        std::max(width, text_width(ui.fonts.code_strong, box.title) + text_width(ui.fonts.small, badge) + ui.px(24));
    for (const CodeRow& row : box.rows) {
      width = std::max(width, text_width(ui.fonts.code_strong, row.text) +
                                  ui.px(pointer_column + 14 + indent * static_cast<float>(row.indent)));
    }
  }
  return width + ui.px(2 * (margin + box_padding)) + ImGui::GetStyle().ScrollbarSize;
}

void code_pane(const Ui& ui, const Rect& where) {
  const Pane pane(ui, "code", where, ui.colours.panel);
  if (!pane) return;
  constexpr float closest = 0.8f;
  const CodeSizes sizes(ui, std::clamp(where.height / code_height(ui), closest, 1.0f));
  const Shades shades(ui.state.appearance.theme);
  const float scroll = ImGui::GetScrollY(), left = where.x + ui.px(margin);
  const bool scrolls = ImGui::GetScrollMaxY() > 0;
  const float width = where.width - ui.px(2 * margin) - (scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
  float y = where.y + ui.px(margin) - scroll;
  const bool asks = asks_for_line(ui.state);
  std::optional<Line> pointed_at;
  float ran = -1, next = -1;  // of the contents
  for (const CodeBox& box : code_panel(ui.state).boxes) {
    const Rect frame{left, y, width, box_height(ui, sizes, box)};
    const float edge = box.depth ? 1.6f : 1.0f;
    ImGui::GetWindowDrawList()->AddRect(corner(frame), opposite(frame),
                                        to_imgui(box.depth ? shades.raised_held : shades.line), ui.px(6), 0,
                                        std::max(ui.px(edge), 1.0f));
    y += ui.px(box_padding);
    draw_heading(ui, box, {left + ui.px(box_padding), y, width - ui.px(2 * box_padding), sizes.heading});
    y += sizes.heading;
    for (const CodeRow& row : box.rows) {
      const Rect place{left + ui.px(box_padding) - ui.px(2), y, width - ui.px(2 * box_padding) + ui.px(2), sizes.row};
      const std::string number = std::to_string(static_cast<int>(row.line)), name = "line-" + number;
      const Rect gutter{place.x, place.y, ui.px(pointer_column), place.height};
      ImGui::SetCursorScreenPos(corner(gutter));
      if (ImGui::InvisibleButton(("break-" + number).c_str(), size(gutter))) ui.act(action::ToggleBreakpoint{row.line});
      ui.publish("break-" + number);
      draw_breakpoint(ui, gutter, row.breakpoint, ImGui::IsItemHovered());
      if (!row.breakpoint) tooltip(ui, "break-" + number, ui.say("code.breakpoint_hint"));
      ImGui::SetCursorScreenPos({gutter.right(), place.y});
      if (ImGui::InvisibleButton(name.c_str(), {std::max(place.width - gutter.width, 1.0f), place.height}))
        ui.act(asks ? Action(action::MarkLine{row.line}) : Action(action::RunToLine{row.line}));
      if (ImGui::IsItemHovered()) pointed_at = row.line;
      ui.publish(name);
      if (asks) tooltip(ui, name, ui.say("code.mark_hint"));
      draw_row(ui, row, place);
      if (row.just_run) ran = y - where.y + scroll;
      if (row.next) next = y - where.y + scroll;
      y += sizes.row;
    }
    y = frame.bottom() + ui.px(between_boxes);
  }
  ImGui::SetCursorScreenPos({left, y + ui.px(margin - between_boxes)});
  ImGui::Dummy({1, 1});
  // The line that has just run with some around it, and the next one if both fit.
  const float at = ran >= 0 ? ran : next;
  float sight_top = at - 2 * sizes.row, sight_bottom = at + 3 * sizes.row;
  if (next >= 0 && std::abs(next - at) + 3 * sizes.row < where.height) {
    sight_top = std::max(std::min(at, next) - sizes.row, std::max(at, next) + 2 * sizes.row - where.height);
    sight_bottom = std::max(at, next) + 2 * sizes.row;
  }
  if (at >= 0) keep_in_sight(ui, sight_top, sight_bottom);
  // Set only by the hovered pane, so that panes do not override each other.
  bool& pointing = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("pointing"), false);
  if ((pointed_at || pointing) && pointed_at != ui.state.plan.hovered_line) ui.act(action::HoverLine{pointed_at});
  pointing = pointed_at.has_value();
  fade_edges(ui, ui.colours.panel);
}

}  // namespace raywalk
