#pragma once
// Actions as lines of text, for demo files: a word and its arguments, such as `step forward line`,
// `press 120 80 left`, `speed 8`. Empty lines and those that begin with # are ignored.

#include "text/error.h"
#include "view/action.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// The line that parse_action reads back as the same action; empty for the few without text form (SetShape etc. carry
/// whole values; a demo drags instead).
[[nodiscard]] std::string write_action(const Action& action);

/// Parses one line; an error lists the expected words.
[[nodiscard]] Result<Action> parse_action(std::string_view line);

/// Every action with its arguments, one a line, in the order of the words, below what the arguments stand for.
[[nodiscard]] std::string demo_help();

/// A whole demo; errors carry `file_name` and the line.
[[nodiscard]] Result<std::vector<Action>> parse_demo(std::string_view text, const std::string& file_name);

}  // namespace raywalk
