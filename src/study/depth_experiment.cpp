// E4: what the recursion depth cuts off, in a room where it is known.
#include "study/curve.h"
#include "study/reference.h"
#include "study/shot.h"
#include "study/subjects.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace raywalk::study {

namespace {

constexpr std::array albedos{0.3, 0.5, 0.7, 0.9};
constexpr double rounding_floor = 1e-7;  ///< relative error below which rounding begins to show

Scene room(double albedo, bool mirror, int depth, int round) {
  Scene scene = glowing_room(albedo, mirror, round);
  scene.limits.depth = depth;
  return scene;
}

std::string method_of(double albedo, bool mirror) { return fmt::format("{} {}", mirror ? "mirror" : "paths", albedo); }

Report conclude_depth(const std::vector<Trial>& trials) {
  Report report;
  Plot plot;
  plot.title = "What is missing after N rays, by how much walls send back";
  plot.x_label = "depth N: rays one after the other";
  plot.y_label = "missing light, share of all";
  plot.log_x = false;
  plot.floor = rounding_floor, plot.floor_name = "fitted above this";
  for (const bool mirror : {true, false})
    for (const double albedo : albedos) {
      const ErrorCurve curve(trials, method_of(albedo, mirror));
      std::vector<double> n, logs;
      for (std::size_t i = 0; i < curve.knobs().size(); ++i) {
        const double missing = curve.at(i);
        if (missing < rounding_floor) continue;
        n.push_back(curve.knobs()[i]);
        logs.push_back(std::log(missing));
      }
      const double ratio = std::exp(fit_line(n, logs).slope);
      report.laws.push_back({method_of(albedo, mirror),
                             fmt::format("each ray more leaves {} of what was missing", albedo),
                             LawKind::exact,
                             albedo,
                             {ratio, 0, 0},
                             1e-6,
                             "Rounding alone cannot do this: the recursion or the reference is wrong."});
      if (!mirror) continue;
      PlotSeries series = curve.series(fmt::format("albedo {}", albedo));
      series.law = std::log(albedo);
      series.law_name = fmt::format("{}^N", albedo);
      plot.series.push_back(series);
    }
  report.figures.push_back(
      {plot,
       "A closed room whose wall glows and sends back a share of the light that falls on it: after N rays the picture "
       "shows E (1 - rho^N) / (1 - rho) of the E / (1 - rho) that is there. On this paper, with N along and powers of "
       "ten upwards, that is a straight line; every ray more removes the same share of what is still missing. A dark "
       "room (0.3) is right to 1% after four rays, a bright one (0.9) needs 44. Mirrors and evenly scattering walls, "
       "traced by paths of limited length, give the same numbers."});
  return report;
}

}  // namespace

Experiment depth_experiment(Effort effort, const Faults& faults) {
  const int most = effort == Effort::glance ? 8 : 48, edge = effort == Effort::full ? 16 : 6;
  Experiment e;
  e.number = "E4", e.name = "depth", e.title = "Depth of recursion";
  e.question = "How deep must a tracer go before nobody sees what is missing?";
  e.weight = 0.4;
  e.columns = {"depth", "missing_share", "albedo"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    for (int depth = 1; depth <= most; depth += depth < 8 ? 1 : 4)
      for (const bool mirror : {true, false})
        for (const double albedo : albedos) {
          if (stop.asked()) return trials;
          const Scene scene = room(albedo, mirror, depth, round);
          constexpr int never = 1 << 30;
          const PathSettings paths{depth, never, PathStrategy::directions};
          const Shot shot =
              shoot(scene, {edge, edge}, {1, seed_of(round)}, false, mirror ? std::nullopt : std::optional(paths));
          const double truth = faults.reference * endless_furnace(1, albedo);
          trials.push_back({round, method_of(albedo, mirror), static_cast<double>(depth),
                            compared(shot.film, [&](int, int) { return truth; }).rms / truth, albedo, shot.cost});
        }
    return trials;
  };
  e.conclude = conclude_depth;
  return e;
}

}  // namespace raywalk::study
