#include "gui/pane_words.h"

#include "gui/widgets.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace raywalk {

namespace {

// A sign of a formula stays in the line of what follows it.
std::string with_formulas_together(std::string line) {
  constexpr std::array<std::string_view, 11> signs{"=",      "+", "\u2212", "-",      "/",     "\u00b7",
                                                   "\u00d7", "<", ">",      "\u2264", "\u2265"};
  constexpr std::string_view no_break = "\u00a0";
  for (std::size_t at = line.find(' '); at != std::string::npos; at = line.find(' ', at + 1)) {
    const std::size_t before = at == 0 ? std::string::npos : line.rfind(' ', at - 1);
    const std::size_t begin = before == std::string::npos ? 0 : before + 1;
    const std::string_view word = std::string_view(line).substr(begin, at - begin);
    if (std::find(signs.begin(), signs.end(), word) != signs.end()) line.replace(at, 1, no_break);
  }
  return line;
}

}  // namespace

void prose(const Ui& ui, Colour colour, const std::string& text) {
  std::string plain;
  for (const char c : text)
    if (c != '*' && c != '`') plain += c;
  for (std::size_t at = 0; at < plain.size();) {
    const std::size_t end = std::min(plain.find('\n', at), plain.size());
    std::string line = plain.substr(at, end - at);
    at = end + 1;
    if (line.empty()) {
      ImGui::Dummy({1, ui.px(2)});
      continue;
    }
    const bool item = line.starts_with("- ");
    if (item) {
      line = line.substr(2);
      const ImVec2 dot = ImGui::GetCursorScreenPos();
      ImGui::GetWindowDrawList()->AddCircleFilled({dot.x + ui.px(5), dot.y + ImGui::GetFontSize() * 0.55f}, ui.px(2),
                                                  to_imgui(colour));
      ImGui::Indent(ui.px(16));
    }
    paragraph(colour, with_formulas_together(std::move(line)));
    if (item) ImGui::Unindent(ui.px(16));
  }
}

void heading(const Ui& ui, Colour colour, const std::string& text) {
  ImGui::Dummy({1, ui.px(4)});
  push_font(ui.fonts.strong);
  paragraph(colour, text);
  pop_font();
}

float button_height(const Ui& ui) { return std::max(ImGui::GetFontSize() + ui.px(14), ui.finger); }

bool wide_button(const Ui& ui, const std::string& name, const std::string& text, Colour ground, Colour ink,
                 bool enabled, float width) {
  if (width <= 0) width = ImGui::GetContentRegionAvail().x;
  const float pad = ui.px(10);
  const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, width - 2 * pad);
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float height = std::max(size.y + ui.px(12), ui.finger);
  const float inset = ui.unseen(height), y = at.y + inset, bottom = at.y + height - inset;
  const bool pressed = ImGui::InvisibleButton(name.c_str(), {width, height}) && enabled;
  ui.publish(name);
  const Shades shades(ui.state.appearance.theme);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({at.x, y}, {at.x + width, bottom}, to_imgui(ground), ui.px(6));
  if (enabled && ImGui::IsItemHovered())
    draw.AddRect({at.x, y}, {at.x + width, bottom}, to_imgui(shades.accent), ui.px(6), 0, ui.px(1.4f));
  draw.AddText(ImGui::GetFont(), ImGui::GetFontSize(), {at.x + pad, at.y + (height - size.y) / 2}, to_imgui(ink),
               text.c_str(), nullptr, width - 2 * pad);
  if (inset > 0) ImGui::SetCursorPosY(ImGui::GetCursorPosY() - ImGui::GetStyle().ItemSpacing.y);
  return pressed;
}

}  // namespace raywalk
