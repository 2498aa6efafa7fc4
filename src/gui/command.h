#pragma once
// Commands: what buttons, menu entries and keys do. Each is one row, which stands in the gui/NAME.cpp of its room;
// menus, the choices of buttons and the list of keys are made from the rows. Their words are texts in src/text:
// command.step_back.label, .hint, and .short for little room.

#include "gui/key.h"
#include "gui/ui.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A section of a menu or a choice of buttons: its commands, in the order of their rows.
enum class Section {
  none,
  open,
  save,
  quit,
  undo,
  select,
  zoom,
  show,
  rays,
  earlier,
  ink,
  style,
  window,
  step,
  back,
  over,
  run,
  grain,
  play,
  ends,
  learn,
  tabs,
  cost,
  microscope,
  numerics,
  precision,
  structure,
  modes,
  add,
};

struct Command {
  std::string_view name;            ///< unique: "step-back"
  Shortcut keys[3] = {};            ///< the first one is shown in menus and tooltips
  Section section = Section::none;  ///< none: of buttons and keys alone
  /// The id of a line of the list of keys that several commands share, in their order; empty: a line of its own.
  std::string_view line{};
  bool (*enabled)(const State&) = nullptr;                      ///< null: always
  bool (*chosen)(const State&) = nullptr;                       ///< for choices: whether it is the current one
  std::string (*label)(const State&, bool in_short) = nullptr;  ///< in place of its text, if it depends on the state
  void (*run)(const Ui&) = nullptr;                             ///< when enabled
  void (*turn)(const Ui&, bool on) = nullptr;                   ///< of a switch, in place of `run`: on if not `chosen`
  void (*held)(const Ui&) = nullptr;  ///< while its key or its button is held down; null: nothing more
};

/// What rows do: `.run = act<action::Step, true>`.
template <class Action, auto... fields>
void act(const Ui& ui) {
  ui.act(Action{fields...});
}
/// What a switch does: `.turn = turn<action::ShowBand>`.
template <class Action>
void turn(const Ui& ui, bool on) {
  ui.act(Action{on});
}
template <WindowWish what>
void wish(const Ui& ui) {
  ui.wish(what);
}
template <class Room>
bool shows_tab(const State& state) {
  return state.appearance.tab == Room::tab;
}
template <class Room>
void open_tab(const Ui& ui) {
  ui.act(action::SetTab{Room::tab});
}

/// All commands, in the order of the rooms and of their rows: that of menus and of the list of keys.
[[nodiscard]] const std::vector<const Command*>& commands();
[[nodiscard]] const std::vector<const Command*>& commands_in(Section section);
/// The one of this name, which must exist: a test looks up those that the sources name.
[[nodiscard]] const Command& command(std::string_view name);

/// The label of its button: "STEP".
[[nodiscard]] std::string command_label(const Command& command, const State& state, bool in_short = false);
/// What it does, in one clause, without the key.
[[nodiscard]] std::string command_hint(const Command& command, Language language);
/// The key shown in menus and tooltips: "Ctrl+Shift+S"; empty if none.
[[nodiscard]] std::string command_key(const Command& command, Language language);
/// All of them: "Space, \u2192, Page Down".
[[nodiscard]] std::string all_command_keys(const Command& command, Language language);

[[nodiscard]] bool enabled(const Command& command, const State& state);
[[nodiscard]] bool chosen(const Command& command, const State& state);
/// Runs it, if enabled.
void perform(const Command& command, const Ui& ui);

/// The command of a key press in this mode; null if none.
[[nodiscard]] const Command* command_of(const KeyPress& press, Mode mode);
/// The number of commands bound to a key press: at most one, if the rows are consistent.
[[nodiscard]] int commands_on(const KeyPress& press, Mode mode);
/// Turns a key press into actions: a command's, or nudging by arrows in Move mode, or Escape. Returns whether it had a
/// meaning.
bool press_key(const KeyPress& press, const Ui& ui);

/// All keys and what they do: shown in Help and, checked by a test, in lessons/README.md.
struct KeyListRow {
  std::string keys;  ///< "Space, \u2192 \u00b7 \u2190"
  std::string does;  ///< "one step on \u00b7 back"
};
[[nodiscard]] std::vector<KeyListRow> key_list(Language language);

}  // namespace raywalk
