// The buttons that add and remove objects.

#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"

#include <algorithm>
#include <string_view>
#include <vector>

namespace raywalk {

namespace {

struct PaletteButton {
  const Command* command;
  ButtonLook look;
};

std::vector<PaletteButton> palette_buttons() {
  std::vector<PaletteButton> buttons;
  for (const Command* adds : commands_in(Section::add)) {
    const auto kind = named<action::ObjectKind>(adds->name.substr(std::string_view("add-").size()));
    buttons.push_back({adds, {.look = Look::plain, .pictogram = kind}});
  }
  buttons.push_back({&command("remove"), {.look = Look::flat, .icon = Icon::bin}});
  return buttons;
}

}  // namespace

void palette_pane(const Ui& ui, const Rect& where) {
  const Pane pane(ui, "palette", where, ui.colours.window, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  const float margin = ui.px(10), inset = ui.finger > 0 ? 0 : ui.px(6), height = where.height - 2 * inset;
  std::vector<PaletteButton> buttons = palette_buttons();
  const float gap = ImGui::GetStyle().ItemSpacing.x;
  bool in_short = false;
  const auto word = [&](const PaletteButton& each) { return command_label(*each.command, ui.state, in_short); };
  const auto width = [&] {
    float sum = 2 * margin - gap;
    for (const PaletteButton& each : buttons) sum += button_width(ui, word(each), each.look) + gap;
    return sum;
  };
  const auto change = [&](auto what) {
    if (width() > where.width)
      for (PaletteButton& each : buttons) what(each.look);
  };
  // In a narrow window first the letters shrink, then the words; then pictures stand alone, whose tooltips say more.
  change([&](ButtonLook& look) { look.font = ui.fonts.small; });
  in_short = width() > where.width;
  change([](ButtonLook& look) { look.label = false; });
  const float less = std::max(width() - where.width, 0.0f) / static_cast<float>(buttons.size());
  ImGui::SetCursorScreenPos({where.x + margin, where.y + inset});
  for (const PaletteButton& each : buttons) {
    const float own = std::max(button_width(ui, word(each), each.look) - less, 1.0f);
    command_button(ui, *each.command, {own, height}, each.look, word(each));
    ImGui::SameLine(0, gap);
  }
}

}  // namespace raywalk
