// The commands for files and for taking changes back.

#include "gui/command.h"
#include "gui/platform.h"

#include <iterator>

namespace raywalk {

rows::Rows rows::document() {
  // clang-format off
  static constexpr Command all[] = {
      {.name = "undo", .keys = {"Ctrl+Z"}, .section = Section::undo, .line = "keys.undo",
       .enabled = [](const State& state) { return !state.document.undo.empty() || state.bugs.hunt; },
       .run = [](const Ui& ui) { ui.act(action::Undo{}); }},
      {.name = "redo", .keys = {"Ctrl+Y", "Ctrl+Shift+Z"}, .section = Section::undo, .line = "keys.undo",
       .enabled = [](const State& state) { return !state.document.redo.empty(); },
       .run = [](const Ui& ui) { ui.act(action::Redo{}); }},
      {.name = "new", .keys = {"Ctrl+N"}, .section = Section::open, .line = "keys.files",
       .run = [](const Ui& ui) { ui.act(action::New{}); }},
      {.name = "open", .keys = {"Ctrl+O"}, .section = Section::open, .line = "keys.files",
       .run = [](const Ui& ui) { ui.act(action::AskOpen{}); }},
      {.name = "save", .keys = {"Ctrl+S"}, .section = Section::save, .line = "keys.files",
       .run = [](const Ui& ui) { ui.act(action::Save{}); }},
      {.name = "save-as", .keys = {"Ctrl+Shift+S"}, .section = Section::save, .line = "keys.files",
       .run = [](const Ui& ui) { ui.act(action::AskSaveAs{}); }},
      {.name = "export", .keys = {"Ctrl+E"}, .section = Section::save, .line = "keys.files",
       .run = [](const Ui& ui) { ui.act(action::AskExport{}); }},
      {.name = "quit", .keys = {"Ctrl+Q"}, .section = Section::quit, .line = "keys.files",
       .run = [](const Ui& ui) { ui.act(action::Quit{}); }},
  };
  // clang-format on
  return rows::Rows(all).first(std::size(all) - (platform::can_quit() ? 0 : 1));
}

}  // namespace raywalk
