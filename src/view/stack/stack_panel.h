#pragma once
// The call stack, as data.

#include "view/state.h"

#include <string>
#include <vector>

namespace raywalk {

struct StackRow {
  std::string title;    ///< "SHADE (DEPTH 2)" or "MAIN ALGORITHM"
  std::string ray;      ///< "reflect ray from Polygon"
  std::string object;   ///< whose surface is shaded; empty for MAIN ALGORITHM
  std::string waiting;  ///< what it waits for, or what it does
  int ray_index = -1;   ///< for hovering; -1 for MAIN ALGORITHM
  /// Colours already returned by calls from this one: "REFLSHADE" and its colour.
  struct Returned {
    std::string name;
    Rgbd linear;
    Colour colour;
  };
  std::vector<Returned> returned;
};

struct StackPanel {
  std::vector<StackRow> rows;  ///< innermost call first, MAIN ALGORITHM last
  std::string empty;           ///< why there are none, where there are none
};

[[nodiscard]] StackPanel stack_panel(const State& state);

}  // namespace raywalk
