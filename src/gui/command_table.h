#pragma once
// The commands, one row each, in the order of the enumeration: name, label, what it does, and the keys that ask for it.

#include "gui/command_rows_edit.h"
#include "gui/command_rows_panel.h"
#include "gui/command_rows_view.h"
#include "gui/command_rows_walk.h"

#include <array>

namespace raywalk {

inline constexpr std::array<CommandRow, command_count> command_table = [] {
  std::array<CommandRow, command_count> table{};
  std::size_t next = 0;
  const auto append = [&](const auto& rows) {
    for (const CommandRow& row : rows) table[next++] = row;
  };
  append(edit_rows);
  append(walk_rows);
  append(panel_rows);
  append(view_rows);
  return table;
}();

// The table is indexed by the enumeration.
static_assert([] {
  for (int i = 0; i < command_count; ++i) {
    if (static_cast<int>(command_table[static_cast<std::size_t>(i)].command) != i) return false;
  }
  return true;
}());

}  // namespace raywalk
