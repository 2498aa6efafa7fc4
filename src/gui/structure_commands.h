#pragma once
// The commands of the Structure tab.

#include "gui/commands.h"

namespace raywalk {

/// `command`: one of structure_*.
void perform_structure(Command command, const Ui& ui);
[[nodiscard]] bool structure_enabled(Command command, const State& state);

}  // namespace raywalk
