#pragma once
// One row of the table of commands (gui/command_table.h).

#include "gui/commands.h"

#include <array>

namespace raywalk {

/// The mode in which a key is bound to its command. Digits and arrows differ between Move and Trace.
enum class When { always, move, not_move, trace };

struct Key {
  int key = 0;  ///< GLFW_KEY_*; 0: none
  bool ctrl = false, shift = false, alt = false;
  When when = When::always;
};

struct CommandRow {
  Command command;
  const char* name;
  std::array<Key, 3> keys{};  ///< the first one is shown in menus and tooltips
};

}  // namespace raywalk
