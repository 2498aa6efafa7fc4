// The commands of the document: what is in the scene, what is selected, files, and taking changes back.

#include "gui/command.h"
#include "gui/platform.h"

#include <iterator>

#include <algorithm>

namespace raywalk {

namespace {

bool moves(const State& state) { return state.walk.mode == Mode::move; }

bool selects(const State& state) { return static_cast<bool>(state.plan.selected); }

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

bool can_remove(const State& state) {
  const TargetKind kind = state.plan.selected.kind;
  return state.walk.mode == Mode::move &&
         (kind == TargetKind::object || kind == TargetKind::light || kind == TargetKind::corner);
}

}  // namespace

Commands DocumentRoom::commands() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "add-solid-sphere", .keys = {{"Shift+1", When::move}}, .section = Section::add, .line = "keys.add",
       .enabled = moves, .run = act<action::AddObject, action::ObjectKind::solid_sphere>},
      {.name = "add-transparent-sphere", .keys = {{"Shift+2", When::move}}, .section = Section::add, .line = "keys.add",
       .enabled = moves, .run = act<action::AddObject, action::ObjectKind::transparent_sphere>},
      {.name = "add-polygon", .keys = {{"Shift+3", When::move}}, .section = Section::add, .line = "keys.add",
       .enabled = moves, .run = act<action::AddObject, action::ObjectKind::polygon>},
      {.name = "add-light", .keys = {{"Shift+4", When::move}}, .section = Section::add, .line = "keys.add", .enabled = moves,
       .run = act<action::AddObject, action::ObjectKind::light>},
      {.name = "select-next", .keys = {{"Tab", When::move}, {"Page Down", When::move}}, .section = Section::select, .line = "keys.select",
       .enabled = moves, .run = [](const Ui& ui) { select_along(ui, 1); }},
      {.name = "select-previous", .keys = {{"Shift+Tab", When::move}, {"Page Up", When::move}}, .section = Section::select,
       .line = "keys.select", .enabled = moves, .run = [](const Ui& ui) { select_along(ui, -1); }},
      {.name = "edit-properties", .keys = {{"Enter", When::move}}, .section = Section::select, .line = "keys.edit",
       .enabled = [](const State& state) { return moves(state) && selects(state); },
       .run = wish<WindowWish::properties>},
      {.name = "remove", .keys = {{"Delete", When::move}, {"Backspace", When::move}}, .section = Section::select,
       .line = "keys.edit", .enabled = can_remove, .run = act<action::RemoveSelected>},
      {.name = "deselect", .section = Section::select, .enabled = selects, .run = act<action::Select>},
      {.name = "undo", .keys = {"Ctrl+Z"}, .section = Section::undo, .line = "keys.undo",
       .enabled = [](const State& state) {
         return state.ink.begun || !state.document.undo.empty() || (state.bugs.hunt && state.bugs.hunt->is_new());
       },
       .run = act<action::Undo>},
      {.name = "redo", .keys = {"Ctrl+Y", "Ctrl+Shift+Z"}, .section = Section::undo, .line = "keys.undo",
       .enabled = [](const State& state) { return !state.document.redo.empty(); }, .run = act<action::Redo>},
      {.name = "new", .keys = {"Ctrl+N"}, .section = Section::open, .line = "keys.files", .run = act<action::AskNew>},
      {.name = "open", .keys = {"Ctrl+O"}, .section = Section::open, .line = "keys.files", .run = act<action::AskOpen>},
      {.name = "save", .keys = {"Ctrl+S"}, .section = Section::save, .line = "keys.files", .run = act<action::Save>},
      {.name = "save-as", .keys = {"Ctrl+Shift+S"}, .section = Section::save, .line = "keys.files",
       .run = act<action::AskSaveAs>},
      {.name = "export", .keys = {"Ctrl+E"}, .section = Section::save, .line = "keys.files",
       .run = act<action::AskExport>},
      {.name = "quit", .keys = {"Ctrl+Q"}, .section = Section::quit, .line = "keys.files", .run = act<action::Quit>},
  };
  // clang-format on
  return Commands(all).first(std::size(all) - (platform::can_quit() ? 0 : 1));
}

}  // namespace raywalk
