#pragma once
// What the pane of spot the bug shows, as data.

#include "view/state.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

struct BugRow {
  int number = 1;
  BugEnd end = BugEnd::open;
  std::string of{};     ///< whose procedure it breaks; empty: the tracer's
  bool chosen = false;  ///< by keys
};
struct BugPassage {
  std::string heading, text;
};

struct BugPanel {
  bool hunting = false;  ///< else the list
  std::string heading;
  std::string tally;             ///< empty before the first is found
  std::vector<BugRow> rows;      ///< the list
  std::vector<BugPassage> said;  ///< what is seen, what to do, hints
  std::string marked;            ///< which line, or that none is; empty when no longer asked
  std::string verdict;
  bool is_right = false;
  std::vector<BugPassage> learnt;  ///< at the end: what was wrong, and the fix
  bool can_judge = false, can_give_up = false;
};
[[nodiscard]] BugPanel bug_panel(const State& state);

/// The id of the clause that states the purpose of a line of MAIN ALGORITHM or SHADE: "it aims from the hit at the
/// light". Empty for other procedures.
[[nodiscard]] std::string_view duty_of(Line line);

/// The number of a surprise bug: one that is not found yet, else any. `draw`: any number.
[[nodiscard]] int surprising_bug(const BugRoom& bugs, unsigned draw);

/// Once the bug is known: the rays of the current pixel without it (or with it, once fixed) that differ from those
/// walked.
[[nodiscard]] std::vector<RayRecord> other_rays(const State& state);

/// The banner over the plan while the tracer has a bug, or has just been fixed; else empty.
[[nodiscard]] std::string bug_banner(const State& state);

}  // namespace raywalk
