#pragma once
// What lines and signs of the plan stand for.

#include "view/state.h"

#include <string>
#include <vector>

namespace raywalk {

struct LegendRow {
  RayKind kind;
  RayStyle style;  ///< dash lengths in pixels at scale 1
  std::string name;
  std::string short_name;  ///< if there is little room
  std::string meaning;     ///< one clause
};
/// Signs in the plan besides the rays.
struct LegendSign {
  std::string symbol;
  std::string meaning;
};
struct Legend {
  std::vector<LegendRow> rays;
  std::vector<LegendSign> signs;
};
[[nodiscard]] Legend legend(const State& state);

}  // namespace raywalk
