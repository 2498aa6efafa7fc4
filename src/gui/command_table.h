#pragma once
// The commands, one row each: name and keys. Their labels and hints are in src/text/*.toml.

#include "gui/command_rows_scene.h"
#include "gui/command_rows_view.h"
#include "gui/command_rows_walk.h"

#include <algorithm>
#include <array>

namespace raywalk {

inline constexpr std::array<CommandRow, command_count> command_table = [] {
  static_assert(scene_rows.size() + walk_rows.size() + view_rows.size() == static_cast<std::size_t>(command_count));
  std::array<CommandRow, command_count> all{};
  auto end = std::copy(scene_rows.begin(), scene_rows.end(), all.begin());
  end = std::copy(walk_rows.begin(), walk_rows.end(), end);
  std::copy(view_rows.begin(), view_rows.end(), end);
  return all;
}();

// The table is indexed by the enumeration.
static_assert([] {
  for (int i = 0; i < command_count; ++i) {
    if (static_cast<int>(command_table[static_cast<std::size_t>(i)].command) != i) return false;
  }
  return true;
}());

}  // namespace raywalk
