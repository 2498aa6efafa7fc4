// E5: three ways to end a ray tree: by depth, by a threshold, by Russian roulette.
#include "study/curve.h"
#include "study/reference.h"
#include "study/shot.h"
#include "study/subjects.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace raywalk::study {

namespace {

constexpr double albedo = 0.8;
constexpr std::array cuts{4, 16};
const std::string threshold_room = "threshold room", by_depth = "depth", by_threshold = "threshold",
                  roulette = "roulette";

Scene room(bool mirror, int round) {
  Scene scene = glowing_room(albedo, mirror, round);
  scene.limits.depth = 1 << 20;
  scene.render.sampler = Sampler::random;
  return scene;
}

/// Glass and mirror balls over a floor: trees with two branches.
Scene balls(int round) {
  Scene scene;
  Material glass, mirror, floor;
  glass.diffuse = Rgbd(0.0), glass.transmission = Rgbd(0.9), glass.reflection = Rgbd(0.1), glass.dielectric = true;
  mirror.diffuse = Rgbd(0.2, 0.25, 0.3), mirror.reflection = Rgbd(0.7);
  floor.checker = Checker{Rgbd(0.9), Rgbd(0.3), 0.5};
  const double turn = drawn_for(round, 3);
  scene.objects = {{"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, floor},
                   {"Glass", Sphere<double>{{0, -1.1, 0}, 1}, glass},
                   {"Mirror", Sphere<double>{{0.4 + 0.2 * turn, 1.1, 0}, 1}, mirror},
                   {"Second glass", Sphere<double>{{-2, 0.3, -0.4}, 0.6}, glass},
                   {"Second mirror", Sphere<double>{{2.2, 0.1, 0.3}, 1.2}, mirror}};
  scene.lights = {{"Lamp", Rgbd(0.9), PointLight{{-4, 3, 6}, {}}}};
  scene.background = Rgbd(0.2, 0.3, 0.5);
  scene.camera.eye = {-6, 0.4 * turn, 1.2};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.screen = {1, 0.8, 1};
  scene.render.integrator = Integrator::whitted;
  return scene;
}

double rays_of(const Trial& trial) { return static_cast<double>(trial.cost.rays) / trial.other; }

Report conclude_endings(const std::vector<Trial>& trials, double max_samples) {
  Report report;
  // In the mirror room, every number is known.
  int off = 0, miscounted = 0;
  for (const Trial& t : trials) {
    if (t.method != threshold_room) continue;
    const double rounding = 1e-9;
    if (t.error >= t.knob * (1 + rounding) || t.error < albedo * t.knob * (1 - rounding)) ++off;
    if (rays_of(t) != 1 + std::floor(std::log(t.knob) / std::log(albedo))) ++miscounted;
  }
  report.laws.push_back({"threshold, error",
                         "in a room of albedo rho the missing share lies in [rho X, X)",
                         LawKind::exact,
                         0,
                         {static_cast<double>(off), 0, 0},
                         0,
                         "Paths would be ended elsewhere, or count for another share.",
                         "how many trials are outside of it"});
  report.laws.push_back({"threshold, rays",
                         "a path has 1 + floor(ln X / ln rho) rays: halving X adds 3 or 4 rays",
                         LawKind::exact,
                         0,
                         {static_cast<double>(miscounted), 0, 0},
                         0,
                         "Paths would be ended elsewhere.",
                         "in how many trials it has another number"});
  Plot known;
  known.title = "A threshold in a room of albedo 0.8";
  known.x_label = "threshold X";
  known.y_label = "missing light, share of all";
  PlotSeries series = ErrorCurve(trials, threshold_room).series("missing");
  series.law = 1, series.law_name = "X";
  known.series = {series};
  report.figures.push_back(
      {known,
       "A ray is not formed when it could bring less than X of its pixel. What is missing in the end is always less "
       "than X and never less than 0.8 X, however small X is: the threshold is a promise about the error, which a "
       "depth "
       "is not. Time grows only with the logarithm of 1/X."});

  Plot bargain;
  bargain.title = "Glass and mirror balls: error against rays";
  bargain.x_label = "rays a pixel, shadow rays too";
  bargain.y_label = "root mean square error against depth 30";
  for (const std::string& method : {by_depth, by_threshold})
    bargain.series.push_back(
        ErrorCurve(trials, method).series(method == by_depth ? "depth 1 to 12" : "threshold 1/2 to 1/4096", rays_of));
  report.figures.push_back(
      {bargain,
       "The same two knobs where trees have two branches. Both errors are a bias: always the same, always too dark. "
       "A depth cuts strong branches and lets weak ones grow; a threshold spends rays where light is left, so for the "
       "same number of rays its curve lies lower wherever branches differ in strength."});

  Plot chance;
  chance.title = "Roulette or a cut: error against rays";
  chance.x_label = "rays a pixel";
  chance.y_label = "root mean square error, share of all light";
  const ErrorCurve played(trials, roulette, [](const Trial& t) { return t.error; });
  PlotSeries of_roulette =
      played.series(roulette, [](const Trial& t) { return static_cast<double>(t.cost.rays) / (36); });
  of_roulette.law = -0.5, of_roulette.law_name = "N^-1/2";
  chance.series.push_back(of_roulette);
  report.laws.push_back({"roulette, noise", "error falls as N^-1/2 and never stops", LawKind::equals, -0.5,
                         played.exponent(4, max_samples), 0, "Roulette would be biased, or its variance not finite."});
  const ErrorCurve mean(trials, roulette, [](const Trial& t) { return t.other; }, Pool::mean);
  report.laws.push_back({"roulette, bias", "on the average nothing is missing", LawKind::equals, 0,
                         mean.estimate(mean.knobs().size() - 1), 0, "A survivor must count for those that died."});
  for (const int cut : cuts) {
    const ErrorCurve curve(trials, fmt::format("cut {}", cut));
    chance.series.push_back(curve.series(fmt::format("cut after {} rays", cut),
                                         [](const Trial& t) { return static_cast<double>(t.cost.rays) / 36; }));
    report.laws.push_back(
        {fmt::format("cut after {} rays", cut), fmt::format("rho^{} is missing, whatever N is", cut), LawKind::exact,
         std::pow(albedo, cut), curve.estimate(curve.knobs().size() - 1), 1e-5,
         "This room has no noise; one direction in 2^23 lies in the horizon itself and brings nothing."});
  }
  report.figures.push_back(
      {chance,
       "Paths in the room of albedo 0.8. Cut off after a fixed number of rays they show the same wrong picture however "
       "many samples are taken. Roulette ends a path by chance and lets those that survive count for more: noisy, but "
       "right on the average, so that samples always help. Where the lines cross is where bias becomes dearer than "
       "noise."});
  return report;
}

}  // namespace

Experiment endings_experiment(Effort effort) {
  constexpr int edge = 6;
  const int samples = by_effort(effort, 4096, 1024, 64);
  const int width = by_effort(effort, 120, 48, 16);
  Experiment e;
  e.number = "E5", e.name = "endings", e.title = "Ends of a ray tree";
  e.question = "Every hit spawns new rays. What ends that, and at what cost: bias, or noise?";
  e.weight = 5;
  e.columns = {"setting", "error", "pixels_or_mean_error"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    const double pixels = edge * edge, truth = endless_furnace(1, albedo);
    for (double x = 0.5; x > 1e-5; x /= 2) {
      Scene scene = room(true, round);
      scene.limits.threshold = x;
      const Shot shot = shoot(scene, {edge, edge}, {1, seed_of(round)});
      trials.push_back({round, threshold_room, x, compared(shot.film, [&](int, int) { return truth; }).rms / truth,
                        pixels, shot.cost});
    }
    const ImageSize size{width, width * 3 / 4};
    Scene scene = balls(round);
    scene.limits.depth = 30;
    const Shot deep = shoot(scene, size, {});
    const auto try_balls = [&](const std::string& method, double knob) {
      const Shot shot = shoot(scene, size, {});
      trials.push_back({round, method, knob,
                        compared(shot.film, [&](int column, int row) { return deep.film.at(column, row).x; }).rms,
                        static_cast<double>(size.width) * size.height, shot.cost});
    };
    for (int step = 1; step <= 12 && !stop.asked(); ++step) {
      scene.limits.depth = step;
      try_balls(by_depth, step);
      scene.limits = {30, std::ldexp(1.0, -step)};
      try_balls(by_threshold, scene.limits.threshold);
      scene.limits.threshold = 0;
    }
    const Scene paths = room(false, round);
    constexpr int never = 1 << 30;
    for (int n = 1; n <= samples; n *= 4) {
      const auto try_paths = [&](const std::string& method, const PathSettings& settings) {
        if (stop.asked()) return;
        const Shot shot = shoot(paths, {edge, edge}, {n, seed_of(round)}, false, settings);
        const Compared off = compared(shot.film, [&](int, int) { return truth; });
        trials.push_back({round, method, static_cast<double>(n), off.rms / truth, off.mean / truth, shot.cost});
      };
      try_paths(roulette, {0, 1, PathStrategy::directions});
      for (const int cut : cuts) try_paths(fmt::format("cut {}", cut), {cut, never, PathStrategy::directions});
    }
    return trials;
  };
  e.conclude = [=](const std::vector<Trial>& trials) { return conclude_endings(trials, samples); };
  return e;
}

}  // namespace raywalk::study
