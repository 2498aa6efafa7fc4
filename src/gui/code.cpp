#include "gui/panes.h"
#include "gui/widgets.h"
#include "view/text/text.h"
#include "view/walk/asked.h"
#include "view/walk/code_panel.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

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

// A frame, and a sign at the right end: suspected, or known to be faulty (no cross: that is a wrong answer's).
void draw_blame(const Ui& ui, Blame blame, const Rect& where) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const ImU32 ink = to_imgui(ui.colours.error);
  draw.AddRect(corner(where), opposite(where), ink, ui.px(4), 0, std::max(ui.px(2), 1.0f));
  const char* sign = blame == Blame::marked ? "?" : "!";
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
    fill_triangle(draw, {x, y - r}, {x + 1.7f * r, y}, {x, y + r}, to_imgui(shades.accent_hovered));
  } else if (row.hovered) {
    draw.AddRectFilled(least, most, to_imgui(shades.raised), rounding);
  }
  if (row.hovered && row.just_run)
    draw.AddRect(least, most, to_imgui(ui.colours.hovered), rounding, 0, std::max(ui.px(1), 1.0f));
  if (row.next) draw.AddRect(least, most, to_imgui(ui.colours.next), rounding, 0, std::max(ui.px(1.5f), 1.0f));
  if (row.blame != Blame::none) draw_blame(ui, row.blame, {least.x, where.y, most.x - least.x, where.height});
  ImFont* font = row.just_run ? ui.fonts.code_strong : ui.fonts.code;
  // From the tops of capitals to the feet of p and y, letters are a sixteenth below the middle of a font's line.
  const float top = y - line_height(ui.fonts, *font) * (0.5f + 0.0625f);
  push_font(font);
  draw.AddText({std::round(least.x + ui.px(7 + indent * static_cast<float>(row.indent))), std::round(top)},
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

// A heading or a row of a box, and where it is in the contents.
struct CodeLine {
  const CodeBox* box;
  const CodeRow* row;  // null: the heading
  float top, height;
  [[nodiscard]] float bottom() const { return top + height; }
};
struct CodeLines {
  CodeLines(const Ui& ui, std::span<const CodeBox> boxes, const CodeSizes& sizes) : height(ui.px(margin)) {
    for (const CodeBox& box : boxes) {
      height += ui.px(box_padding);
      lines.push_back({&box, nullptr, height, sizes.heading});
      height += sizes.heading;
      for (const CodeRow& row : box.rows) {
        lines.push_back({&box, &row, height, sizes.row});
        height += sizes.row;
      }
      height += ui.px(box_padding + between_boxes);
    }
    height += ui.px(margin - between_boxes);
  }
  std::vector<CodeLine> lines;
  float height;
};

// Of headings and rows: what may be squeezed.
float height_of_lines(const CodeLines& code) {
  float sum = 0;
  for (const CodeLine& line : code.lines) sum += line.height;
  return sum;
}

// By how much the contents are shifted so that the uppermost line is whole: by about as much as was scrolled, at the
// end so far that the last line is whole too. `edge`: the room above it for the mark.
float whole_lines(const CodeLines& code, float room, float edge) {
  const float scroll = ImGui::GetScrollY(), most = ImGui::GetScrollMaxY(), last = code.height - room;
  const bool at_end = most > 0 && scroll >= most - 1;
  float shift = 0;
  for (const CodeLine& line : code.lines) {
    if (at_end ? shift >= last : line.top - edge > scroll) break;
    shift = line.top - edge;
  }
  return std::max(shift, 0.0f);
}

// The wheel turns some lines up or down, never past one that was not seen.
void scroll_by_wheel(float row, float room) {
  const float wheel = ImGui::GetIO().MouseWheel;
  if (wheel == 0 || !ImGui::IsWindowHovered()) return;
  constexpr float most = 3;  // lines
  const float lines = std::clamp(std::floor(room / row) - 2, 1.0f, most);
  ImGui::SetScrollY(std::clamp(ImGui::GetScrollY() - wheel * lines * row, 0.0f, ImGui::GetScrollMaxY()));
}

// Scrolls `top`..`bottom` (of the contents) into view, once per new position.
void keep_in_sight(const Ui& ui, float top, float bottom) {
  int& shown = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("position"), -1);
  if (shown == ui.state.walk.position) return;
  shown = ui.state.walk.position;
  const float height = ImGui::GetWindowHeight(), scroll = ImGui::GetScrollY();
  if (top < scroll || bottom > scroll + height) ImGui::SetScrollY(std::max((top + bottom - height) / 2, 0.0f));
}

// The line that has just run with some around it, and the next one if both fit.
void keep_walk_in_sight(const Ui& ui, const CodeLines& code, float row, float room) {
  float ran = -1, next = -1;
  for (const CodeLine& line : code.lines) {
    if (line.row != nullptr && line.row->just_run) ran = line.top;
    if (line.row != nullptr && line.row->next) next = line.top;
  }
  const float at = ran >= 0 ? ran : next;
  if (at < 0) return;
  float top = at - 2 * row, bottom = at + 3 * row;
  if (next >= 0 && std::abs(next - at) + 3 * row < room) {
    top = std::max(std::min(at, next) - row, std::max(at, next) + 2 * row - room);
    bottom = std::max(at, next) + 2 * row;
  }
  keep_in_sight(ui, top, bottom);
}

// The gutter for breakpoints and the line itself, both to be clicked. Returns whether the line is pointed at.
bool code_row(const Ui& ui, const CodeRow& row, const Rect& place, bool asks) {
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
  const bool pointed_at = ImGui::IsItemHovered();
  ui.publish(name);
  if (asks) tooltip(ui, name, ui.say("code.mark_hint"));
  draw_row(ui, row, place);
  return pointed_at;
}

void draw_frame(const Ui& ui, const CodeBox& box, const Rect& frame) {
  const Shades shades(ui.state.appearance.theme);
  ImGui::GetWindowDrawList()->AddRect(corner(frame), opposite(frame),
                                      to_imgui(box.depth ? shades.raised_held : shades.line), ui.px(6), 0,
                                      std::max(ui.px(box.depth ? 1.6f : 1.0f), 1.0f));
}

}  // namespace

float code_height(const Ui& ui) {
  const CodePanel panel = code_panel(ui.state);
  return std::ceil(CodeLines(ui, panel.boxes, CodeSizes(ui)).height);
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
  const Pane pane(ui, "code", where, ui.colours.panel, {0, 0}, ImGuiWindowFlags_NoScrollWithMouse);
  if (!pane) return;
  // Tighter lines before any is out of sight; then whole ones, and a mark that there are more.
  constexpr float closest = 0.8f;
  const CodePanel panel = code_panel(ui.state);
  const CodeLines loose(ui, panel.boxes, CodeSizes(ui));
  const float lines = height_of_lines(loose), room = where.height - (loose.height - lines);
  const CodeSizes sizes(ui, lines > 0 ? std::clamp(room / lines, closest, 1.0f) : 1.0f);
  const CodeLines code(ui, panel.boxes, sizes);
  const bool scrolls = code.height > where.height + 0.5f;
  const float edge = ui.px(margin);
  const float shift = scrolls ? whole_lines(code, where.height, edge) : 0.0f;
  const float left = where.x + ui.px(margin);
  const float width = where.width - ui.px(2 * margin) - (scrolls ? ImGui::GetStyle().ScrollbarSize : 0);
  const bool more_above = shift > 0, more_below = code.height - shift > where.height + 0.5f;
  const float from = shift + (more_above ? edge - 0.5f : 0.0f);
  const float until = shift + where.height - (more_below ? edge : -0.5f);
  const auto on_screen = [&](float y) { return where.y + y - shift; };
  const bool asks = asks_for_line(ui.state);
  std::optional<Line> pointed_at;
  for (std::size_t i = 0; i < code.lines.size(); ++i) {
    const CodeLine& line = code.lines[i];
    if (line.row == nullptr) {
      const float top = line.top - ui.px(box_padding);
      const float bottom = code.lines[i + line.box->rows.size()].bottom() + ui.px(box_padding);
      draw_frame(ui, *line.box, {left, on_screen(top), width, bottom - top});
    }
    if (line.top < from || line.bottom() > until) continue;
    const float inside = width - ui.px(2 * box_padding);
    if (line.row == nullptr) {
      draw_heading(ui, *line.box, {left + ui.px(box_padding), on_screen(line.top), inside, line.height});
    } else if (code_row(ui, *line.row,
                        {left + ui.px(box_padding - 2), on_screen(line.top), inside + ui.px(2), line.height}, asks)) {
      pointed_at = line.row->line;
    }
  }
  ImGui::SetCursorScreenPos({left, where.y - ImGui::GetScrollY() + code.height - 1});
  ImGui::Dummy({1, 1});
  if (scrolls) scroll_by_wheel(sizes.row, where.height - 2 * edge);
  if (scrolls) keep_walk_in_sight(ui, code, sizes.row, where.height);
  // Set only by the hovered pane, so that panes do not override each other.
  bool& pointing = *ImGui::GetStateStorage()->GetBoolRef(ImGui::GetID("pointing"), false);
  if ((pointed_at || pointing) && pointed_at != ui.state.plan.hovered_line) ui.act(action::HoverLine{pointed_at});
  pointing = pointed_at.has_value();
  mark_more(ui, {where.x, where.y, width, where.height}, more_above, more_below);
}

}  // namespace raywalk
