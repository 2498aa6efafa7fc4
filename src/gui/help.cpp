#include "gui/command.h"
#include "gui/painter.h"
#include "gui/panes.h"
#include "gui/platform.h"
#include "gui/widgets.h"
#include "view/plan/pictogram.h"
#include "view/text/text.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace raywalk {

namespace {

/// What others' licences ask to be shown, each behind its name.
void licences_section(const Ui& ui, float width) {
  std::string_view rest = platform::licences();
  constexpr std::string_view before = "== ", behind = " ==\n";
  if (!rest.starts_with(before)) return;
  push_font(ui.fonts.title);
  label(ui.colours.text, ui.say("help.licences.title"));
  pop_font();
  ImGui::Spacing();
  const float left = ImGui::GetCursorPosX();
  ImGui::PushTextWrapPos(left + width);
  label(ui.colours.text, ui.say("help.licences.text"));
  while (rest.starts_with(before)) {
    rest.remove_prefix(before.size());
    const std::size_t name_end = std::min(rest.find(behind), rest.size());
    const std::string name(rest.substr(0, name_end));
    rest.remove_prefix(std::min(name_end + behind.size(), rest.size()));
    const std::size_t end = std::min(rest.find("\n== "), rest.size());
    const bool open = ImGui::TreeNode(name.c_str());
    ui.publish("licence/" + name);
    if (open) {
      label(ui.colours.dim_text, rest.substr(0, end));
      ImGui::TreePop();
    }
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  ImGui::PopTextWrapPos();
}

}  // namespace

void help_pane(const Ui& ui, const Rect& where, float scroll_by) {
  const Pane pane(ui, "help", where, ui.colours.panel, {ui.px(28), ui.px(20)});
  if (!pane) return;
  if (scroll_by != 0) ImGui::SetScrollY(ImGui::GetScrollY() + scroll_by);
  // Lines longer than this are hard to read.
  const float width = std::min(ImGui::GetContentRegionAvail().x, ui.px(760));
  const float term_width = std::min(ui.px(210), width * 0.4f), left = ImGui::GetCursorPosX();
  std::vector<HelpSection> sections = help(ui.state.appearance.language);
  sections.push_back({ui.say("keys.title"), {}});
  for (const KeyListRow& row : key_list(ui.state.appearance.language))
    sections.back().entries.push_back({row.keys, row.does});
  for (const HelpSection& section : sections) {
    push_font(ui.fonts.title);
    label(ui.colours.text, section.title);
    pop_font();
    ImGui::Spacing();
    for (const HelpEntry& entry : section.entries) {
      const float y = ImGui::GetCursorPosY();
      float text_left = left, bottom = y;
      if (!entry.term.empty()) {
        push_font(ui.fonts.strong);
        ImGui::PushTextWrapPos(left + term_width - ui.px(14));
        label(ui.colours.text, entry.term);
        ImGui::PopTextWrapPos();
        pop_font();
        if (entry.picture) {
          const float edge = ui.px(52);
          const ImVec2 at = ImGui::GetCursorScreenPos();
          paint(*ImGui::GetWindowDrawList(), pictogram(*entry.picture, ui.state.appearance.theme, edge),
                {at.x, at.y, edge, edge}, 1, ui.fonts);
          ImGui::Dummy({edge, edge});
        }
        bottom = ImGui::GetCursorPosY();
        text_left = left + term_width;
      }
      ImGui::SetCursorPos({text_left, y});
      ImGui::PushTextWrapPos(left + width);
      label(ui.colours.text, entry.text);
      ImGui::PopTextWrapPos();
      ImGui::SetCursorPos({left, std::max(bottom, ImGui::GetCursorPosY())});
    }
    ImGui::Dummy({1, ui.px(14)});
  }
  licences_section(ui, width);
  close_edges(ui, ui.colours.panel);
}

}  // namespace raywalk
