#pragma once
// One command as the table of commands (gui/command_table.h) tells of it.

#include "gui/commands.h"

#include <array>

namespace raywalk {

/// In which mode a key asks for its command. Digits and arrows mean different things in Move and in Trace.
enum class When { always, move, not_move, trace };

struct Key {
  int key = 0;  ///< GLFW_KEY_*; 0: none
  bool ctrl = false, shift = false, alt = false;
  When when = When::always;
};

struct CommandRow {
  Command command;
  const char* name;
  std::array<Key, 3> keys{};  ///< the first one stands in menus and tooltips
};

}  // namespace raywalk
