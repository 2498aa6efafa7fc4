// The buttons that add and remove objects, and the commands for these and for what is selected.

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

namespace {

bool moves(const State& state) { return state.walk.mode == Mode::move; }

template <action::ObjectKind kind>
void add_object(const Ui& ui) {
  ui.act(action::AddObject{kind});
}

// The targets of Tab, in order.
std::vector<Target> selectable(const Scene& scene) {
  std::vector<Target> targets;
  for (int i = 0; i < static_cast<int>(scene.objects.size()); ++i) targets.push_back({TargetKind::object, i});
  for (int i = 0; i < static_cast<int>(scene.lights.size()); ++i) targets.push_back({TargetKind::light, i});
  targets.push_back({TargetKind::eye});
  return targets;
}

void select_along(const Ui& ui, int direction) {
  const std::vector<Target> targets = selectable(ui.state.scene());
  const auto same = [&](const Target& t) {
    return t.kind == ui.state.plan.selected.kind &&
           (t.kind == TargetKind::eye || t.index == ui.state.plan.selected.index);
  };
  const auto at = std::find_if(targets.begin(), targets.end(), same);
  const int count = static_cast<int>(targets.size());
  int next = direction > 0 ? 0 : count - 1;
  if (at != targets.end()) next = (static_cast<int>(at - targets.begin()) + direction + count) % count;
  ui.act(action::Select{targets[static_cast<std::size_t>(next)]});
}

}  // namespace

rows::Rows rows::palette() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "add-solid-sphere", .keys = {{"1", When::move}}, .section = Section::add, .line = "keys.add",
       .enabled = moves, .run = add_object<action::ObjectKind::solid_sphere>},
      {.name = "add-transparent-sphere", .keys = {{"2", When::move}}, .section = Section::add, .line = "keys.add",
       .enabled = moves, .run = add_object<action::ObjectKind::transparent_sphere>},
      {.name = "add-polygon", .keys = {{"3", When::move}}, .section = Section::add, .line = "keys.add",
       .enabled = moves, .run = add_object<action::ObjectKind::polygon>},
      {.name = "add-light", .keys = {{"4", When::move}}, .section = Section::add, .line = "keys.add", .enabled = moves,
       .run = add_object<action::ObjectKind::light>},
      {.name = "select-next", .keys = {{"Tab", When::move}}, .section = Section::select, .line = "keys.select",
       .enabled = moves, .run = [](const Ui& ui) { select_along(ui, 1); }},
      {.name = "select-previous", .keys = {{"Shift+Tab", When::move}}, .section = Section::select,
       .line = "keys.select", .enabled = moves, .run = [](const Ui& ui) { select_along(ui, -1); }},
  };
  // clang-format on
  return all;
}

}  // namespace raywalk
