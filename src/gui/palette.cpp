// The buttons that add and remove objects.

#include "gui/command.h"
#include "gui/panes.h"
#include "gui/widgets.h"

#include <algorithm>

namespace raywalk {

void palette_pane(const Ui& ui, const Rect& where) {
  const Pane pane(ui, "palette", where, ui.colours.window, {0, 0}, ImGuiWindowFlags_NoScrollbar);
  if (!pane) return;
  const float height = where.height - 2 * ui.px(6);
  ImGui::SetCursorScreenPos({where.x + ui.px(10), where.y + ui.px(6)});
  const std::vector<const Command*>& adds = commands_in(Section::add);
  const Command& removes = command("remove");
  ButtonLook add{.look = Look::plain, .icon = Icon::plus, .font = nullptr, .label = true};
  ButtonLook remove{.look = Look::flat, .icon = Icon::minus, .font = nullptr, .label = true};
  bool in_short = false;
  const auto word = [&](const Command& each) { return command_label(each, ui.state, in_short); };
  const auto width = [&] {
    float sum = button_width(ui, word(removes), remove) + ui.px(20);
    for (const Command* each : adds) sum += button_width(ui, word(*each), add) + ImGui::GetStyle().ItemSpacing.x;
    return sum;
  };
  // In a narrow window first the letters shrink, then the words, then the icons go, then the space beside the words.
  if (width() > where.width) add.font = remove.font = ui.fonts.small;
  if (width() > where.width) in_short = true;
  if (width() > where.width) add.icon = remove.icon = Icon::none;
  const float less = std::max(width() - where.width, 0.0f) / static_cast<float>(adds.size() + 1);
  const auto narrowed = [&](const Command& each, const ButtonLook& look) {
    return ImVec2{std::max(button_width(ui, word(each), look) - less, 1.0f), height};
  };
  for (const Command* each : adds) {
    command_button(ui, *each, narrowed(*each, add), add, word(*each));
    ImGui::SameLine();
  }
  command_button(ui, removes, narrowed(removes, remove), remove, word(removes));
}

}  // namespace raywalk
