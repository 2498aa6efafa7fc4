#pragma once
// Spot the bug: the current fault, and the hunts of this session. Part of the state.

#include "timeline/timeline.h"
#include "trace/fault.h"
#include "view/bugs/room.h"

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

struct State;

/// A shipped scene in whose strip and picture the fault is visible.
[[nodiscard]] std::string_view bug_scene(Fault fault);

/// Whether a click on a line of code marks it now.
[[nodiscard]] bool asks_for_line(const State& state);
/// The line marked as faulty, in a hunt or in a lesson.
[[nodiscard]] std::optional<Line> marked_line(const State& state);

/// Restores the state before the hunt.
void leave_hunt(State& state);

}  // namespace raywalk
