#pragma once
// The Cost panel without a window: the knobs, the attempts, and the plot of error against cost. Their results are
// computed outside the state (study/workbench.h) and passed in.

#include "math/words.h"
#include "study/effect_costs.h"
#include "study/workbench.h"
#include "text/language.h"
#include "view/cost/room.h"
#include "view/drawing/display_list.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

struct State;

/// What TryCost will try.
[[nodiscard]] study::Setup cost_knobs(const State& state);
/// The size of the attempts' pictures: small, with the image's aspect ratio.
[[nodiscard]] ImageSize cost_size(ImageSize image);

/// What the workbench has found so far.
struct CostFindings {
  const std::vector<study::Attempt>& attempts;
  double floor = 0;  ///< of the reference
  int reference_samples = 0;
  std::optional<study::SceneCost> survey{};  ///< of the effects; empty during the first round
  double surveyed = 0;                       ///< a fraction
};
[[nodiscard]] inline CostFindings findings_of(const study::Workbench& bench) {
  return {bench.attempts(), bench.floor(), bench.reference_samples()};
}

/// Error against cost, both logarithmic: one mark per attempt, the Pareto front, and the floor below which differences
/// mean nothing. Coordinates are pixels within width x height; `unit`: a pixel at scale 1.
struct CostPlot {
  DisplayList list;
  struct Mark {
    int attempt;
    Vec2d at;
  };
  std::vector<Mark> marks;
};
[[nodiscard]] CostPlot cost_plot(const State& state, const CostFindings& findings, double width, double height,
                                 double unit);

/// Each effect's share of the rays and of the time as two bars, the interval of the time as a whisker, and below them
/// the total cost and the cost of computing every effect regardless. Coordinates as in cost_plot. `survey`: empty
/// during the first round.
[[nodiscard]] DisplayList effect_bars(const State& state, const std::optional<study::SceneCost>& survey, double width,
                                      double height, double unit);
/// The same as sentences, after a title.
[[nodiscard]] std::vector<std::string> effect_texts(const study::SceneCost& survey, Language language);
/// "12.3 k rays in 0.05 s; every effect regardless: 9.1 times the rays, 7.5 times the time".
[[nodiscard]] std::string survey_text(const std::optional<study::SceneCost>& survey, double done, Language language);

/// "64 samples, sobol, depth 3": how a setup differs from `usual`.
[[nodiscard]] std::string setup_text(const study::Setup& setup, const study::Setup& usual, Language language);
/// One line on an attempt's cost and error.
[[nodiscard]] std::string attempt_text(const State& state, const CostFindings& findings, int index);
/// How good the reference is so far.
[[nodiscard]] std::string reference_text(const CostFindings& findings, Language language);

/// The pictures for display, width * height pixels of four bytes. `right` is left out if its size differs (not yet
/// available). `largest`: for a difference, the value of the last colour; a quarter of it has the middle one, so that
/// small differences are visible too.
[[nodiscard]] std::vector<std::uint8_t> cost_picture(const CostRoom& cost, const Image& left, const Image& right,
                                                     Encoding encoding, double& largest);

}  // namespace raywalk
