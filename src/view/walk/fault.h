#pragma once
// A fault injected into the tracer, for a hunt or a step of a lesson.

#include "timeline/timeline.h"
#include "trace/fault.h"

#include <memory>
#include <optional>

namespace raywalk {

struct State;

/// A fault injected into the tracer: for a hunt, or for a step of a lesson.
struct Bug {
  Fault fault{};
  bool mended = false;  ///< fixed: the walk and the picture are traced without it
  bool known = false;   ///< the user has found it, or given up: the fix may be shown
  /// The same walk with the fault if it is fixed, else without.
  std::shared_ptr<const Timeline> other{};
};

/// The current fault of the walk and the picture.
[[nodiscard]] std::optional<Fault> fault_at_work(const State& state);

/// Injects a fault, or removes it; records again.
void set_bug(State& state, std::optional<Fault> fault);

}  // namespace raywalk
