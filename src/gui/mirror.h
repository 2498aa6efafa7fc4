#pragma once
// The window in words with all its commands, as a page mirrors it for assistive technology.

#include "view/outline.h"

#include <string>
#include <string_view>

namespace raywalk {

/// What the button of the system's chooser of files `does`.
inline constexpr std::string_view choosing_files = "choose-files";

/// outline() and, unless an answer is waited for, every command: those of the walk and of the plan in their regions,
/// the others in those of their menus.
[[nodiscard]] Outline outline_with_commands(const State& state, const CostFindings* costs = nullptr);

/// It as JSON: its items, each with the members of OutlineItem that are not as by default.
[[nodiscard]] std::string outline_json(const State& state, const CostFindings* costs = nullptr);

}  // namespace raywalk
