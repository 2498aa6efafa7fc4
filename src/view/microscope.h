#pragma once
// The Microscope panel without a window: the drawing of a hit at any magnification, what robust and naive numerics make
// of it in a table, and a sentence on what is to be seen.

#include "lesson/language.h"
#include "timeline/microscope.h"
#include "view/display_list.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

struct State;
struct Viewport;

namespace action {
struct Magnify {
  double part;
};  ///< of the way from the whole scene, 0, to single numbers of the precision, 1; powers of ten in equal steps.
    ///< Clamped
}  // namespace action

/// What is under the microscope; none before a ray has met anything.
[[nodiscard]] std::shared_ptr<const Specimen> specimen_of(Microscope& microscope, const State& state);

/// By how much the drawing is larger than the whole scene in this pane.
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

/// "419": a number of ulps, short.
[[nodiscard]] std::string ulps_text(double ulps, Language language);
/// "× 1.6e+06"
[[nodiscard]] std::string magnification_text(double factor, Language language);

/// Words of the panel.
enum class ScopeText {
  empty,  ///< nothing was met yet
  title,  ///< {0} ray, {1} object
  robust,
  naive,
  naive_start,
  error_box,
  crossing,
  row_hit,
  row_t,
  row_t_error,
  row_point,
  row_start,
  nothing,
  none,
  ulp,      ///< {0} how many
  outside,  ///< {0} ulps
  inside,
  on_surface,
  at_point,
  leaves,
  hits_own,
  goes_astray,
  some_hit_own,  ///< {0} how many, {1} of how many
  some_astray,
  off_sight,  ///< {0} what, {1} how far in ulps
  one_cell,   ///< {0} an ulp
  two_cells,  ///< {0} axis, {1} its ulp, {2} axis, {3} its ulp
  bar,        ///< {0} length, {1} in ulps
  says_missed,
  says_invented,
  says_acne,        ///< {0} ulps, {1} ray
  says_wrong_side,  ///< {0} ulps
  says_astray,      ///< {0} ulps
  says_apart,       ///< {0} ulps between the points, {1} ulps
  says_alike,       ///< {0} ulps of the start
  says_alike_at_surface,
};
[[nodiscard]] std::string_view english(ScopeText id);
[[nodiscard]] std::string_view portuguese(ScopeText id);

}  // namespace raywalk
