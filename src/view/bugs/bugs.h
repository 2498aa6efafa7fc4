#pragma once
// Spot the bug: the current fault, and the hunts of this session. Part of the state.

#include "timeline/timeline.h"
#include "trace/fault.h"

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

struct State;

enum class BugEnd { open, found, given_up };

/// The hunt for one bug. Its scene replaces the user's own for the time being.
struct BugHunt {
  int number = 1;                   ///< in all_faults, from 1
  bool surprise = false;            ///< the number is not shown
  int pixel = 0;                    ///< the first of SCREEN in which the bug is visible
  int first_pixel = 0;              ///< the same as index in the walk's pixels: rays of earlier pixels are hidden
  std::optional<Line> marked{};     ///< suspected, and not judged yet
  std::optional<Line> acquitted{};  ///< the last one judged innocent
  BugEnd end = BugEnd::open;
  std::shared_ptr<const State> before{};  ///< the previous state, to return to
};

struct BugSitting {
  bool shown = false;
  std::optional<BugHunt> hunt{};
  std::array<BugEnd, all_faults.size()> ends{};  ///< of each bug: the best result
};

/// A shipped scene in whose strip and picture the fault is visible.
[[nodiscard]] std::string_view bug_scene(Fault fault);

/// Whether a click on a line of code marks it now.
[[nodiscard]] bool asks_for_line(const State& state);
/// The line marked as faulty, in a hunt or in a lesson.
[[nodiscard]] std::optional<Line> marked_line(const State& state);

/// Restores the state before the hunt.
void leave_hunt(State& state);

}  // namespace raywalk
