#pragma once
// The bugs that a person finds: what is broken now, and the hunts of this sitting. Part of the state.

#include "timeline/timeline.h"
#include "trace/fault.h"

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

namespace raywalk {

struct State;

/// A tracer that is broken on purpose: for a hunt, or for a step of a lesson.
struct Bug {
  Fault fault{};
  bool mended = false;  ///< the walk and the picture are traced without it
  bool known = false;   ///< the person has named it, or given up: the cure may be seen
  /// The same walk with the fault where it is mended, else without.
  std::shared_ptr<const Timeline> other{};
};

enum class BugEnd { open, found, given_up };

/// One bug on its way to being found. Its scene takes the place of the person's own, which waits.
struct BugHunt {
  int number = 1;         ///< in all_faults, from 1
  bool surprise = false;  ///< the number is not told
  int pixel = 0;          ///< the first of SCREEN in which the bug is seen
  int first_pixel = 0;    ///< the same as index in the walk's pixels: rays of those before would only be in the way
  std::optional<Line> marked{};     ///< thought to be at fault, and not judged yet
  std::optional<Line> acquitted{};  ///< judged last, and not at fault
  BugEnd end = BugEnd::open;
  std::shared_ptr<const State> before{};  ///< all as it was, for the way back
};

struct BugSitting {
  bool shown = false;
  std::optional<BugHunt> hunt{};
  std::array<BugEnd, all_faults.size()> ends{};  ///< of each bug: the best that has been reached
};

/// A scene that comes with Raywalk and in whose strip and picture the fault shows.
[[nodiscard]] std::string_view bug_scene(Fault fault);

/// The fault that is at work in the walk and in the picture.
[[nodiscard]] std::optional<Fault> fault_at_work(const State& state);

/// Whether a line of code is asked for now, so that a click on one marks it.
[[nodiscard]] bool asks_for_line(const State& state);
/// The line that is marked as the one at fault, of a hunt or in a lesson.
[[nodiscard]] std::optional<Line> marked_line(const State& state);

}  // namespace raywalk
