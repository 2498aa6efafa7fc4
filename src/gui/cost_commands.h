#pragma once
// The commands of the Cost panel. Called by gui/commands.h.

#include "gui/commands.h"
#include "text/language.h"

#include <optional>

namespace raywalk {

/// `command`: one of the Cost panel's, enabled.
void perform_cost(Command command, const Ui& ui);
/// The current value shown by a button that cycles through several. None for other commands.
[[nodiscard]] std::optional<std::string_view> cost_label(Command command, const State& state);

}  // namespace raywalk
