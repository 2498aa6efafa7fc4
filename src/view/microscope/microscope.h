#pragma once
// The Microscope panel without a window: the drawing of a hit at any magnification, a table comparing robust and naive
// numerics, and a sentence on what is visible.

#include "inspect/microscope.h"
#include "text/language.h"
#include "view/drawing/display_list.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

struct State;
struct Viewport;

/// What is under the microscope; none before the first hit.
[[nodiscard]] std::shared_ptr<const Specimen> specimen_of(Microscope& microscope, const State& state);

/// The magnification relative to the whole scene in this pane.
[[nodiscard]] double magnification(const State& state, const Specimen& specimen, const Viewport& pane);

/// The surfaces, the ray, the points and the numbers around them.
[[nodiscard]] DisplayList microscope_view(const State& state, const Specimen& specimen, const Viewport& pane);

struct MicroscopeTable {
  struct Row {
    std::string what, robust, naive;
    bool wrong = false;  ///< naive numerics err
  };
  std::string title;  ///< which ray meets what
  std::vector<Row> rows;
  std::string sentence;
};
[[nodiscard]] MicroscopeTable microscope_table(const State& state, const Specimen& specimen);

/// "419": a number of ulps, abbreviated.
[[nodiscard]] std::string ulps_text(double ulps, Language language);
/// "× 1.6e+06"
[[nodiscard]] std::string magnification_text(double factor, Language language);

}  // namespace raywalk
