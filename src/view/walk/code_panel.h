#pragma once
// The pseudocode beside the plan, as data.

#include "view/state.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// The suspicion on a line while a faulty one is searched.
enum class Blame { none, marked, at_fault };

struct CodeRow {
  Line line;
  int indent;  ///< levels
  std::string text;
  bool just_run = false;    ///< highlighted: this line has just run
  bool next = false;        ///< outlined: this line runs next
  bool breakpoint = false;  ///< the walk pauses before it
  bool hovered = false;     ///< hovered here, or formed or found the ray hovered elsewhere
  Blame blame = Blame::none;
};

struct CodeBox {
  Procedure procedure;
  std::string title;  ///< in English "MAIN ALGORITHM" or "SHADE (DEPTH, RTNSHADE)", or path tracing's
  /// DEPTH of the executing call, or the number of rays of the path so far, for its box; 0 in the first procedure.
  /// Absent in the other box.
  std::optional<int> depth;
  std::string badge;  ///< the same as text; empty if absent or 0
  std::vector<CodeRow> rows;
};

struct CodePanel {
  std::array<CodeBox, 2> boxes;
};

[[nodiscard]] CodePanel code_panel(const State& state);

}  // namespace raywalk
