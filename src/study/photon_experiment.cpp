// E11: what photons tell: how many to ask, what that costs in noise, and how fast the error falls with all of them.
#include "study/curve.h"
#include "study/shot.h"
#include "trace/photon_kernel.h"

#include <array>
#include <cmath>
#include <numbers>

namespace raywalk::study {

namespace {

constexpr double wall_albedo = 0.5, ball_radius = 2, lamp_height = 1;
constexpr std::array circles{3, 5, 9, 17, 33, 65};

Material matt_of(double albedo) {
  Material material;
  material.diffuse = Rgbd(albedo);
  return material;
}

/// From inside, with a lamp in its middle: equally bright all over.
Scene lit_ball(int photons) {
  Scene scene;
  scene.objects = {{"Ball", Sphere<double>{{0, 0, 0}, ball_radius}, matt_of(wall_albedo)}};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{0, 0, 0}, {0, 0, 1}}}};
  scene.render.integrator = Integrator::photons;
  scene.render.photons.count = photons;
  scene.render.photons.gather = true;  // so that photons straight from the lamp are kept too
  return scene;
}
/// Its irradiance: pi / R^2 from the lamp, and what bounces.
constexpr double ball_truth = std::numbers::pi / (ball_radius * ball_radius) / (1 - wall_albedo);

/// A floor under a lamp: brightest below it.
Scene lit_floor(int photons, double radius) {
  Scene scene;
  scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matt_of(wall_albedo)}};
  scene.lights = {{"Lamp", Rgbd(1.0), PointLight{{0, 0, lamp_height}, {0, 0, 1}}}};
  scene.render.integrator = Integrator::photons;
  scene.render.photons.count = photons;
  scene.render.photons.gather = true;
  scene.render.photons.progressive = true;
  scene.render.photons.radius = radius;
  return scene;
}
double floor_truth(double x) {
  return std::numbers::pi * lamp_height / std::pow(x * x + lamp_height * lamp_height, 1.5);
}

/// A floor under a ball that glows, for paths.
Scene under_glow(double emission) {
  Scene scene;
  scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matt_of(1)},
                   {"Glow", Sphere<double>{{0, 0, lamp_height}, lamp_height / 2}, matt_of(0)}};
  scene.objects[1].material.emission = Rgbd(emission);
  scene.render.integrator = Integrator::path;
  scene.render.sampler = Sampler::random;
  scene.camera = looking_down(0, 0, lamp_height / 4, lamp_height / 100);
  return scene;
}

/// Density estimates at points of the ball_radius: all k photons of the circle, or all but the one that marks it.
void add_circles(std::vector<Trial>& trials, int round, int photons, int points, double truth, const Stop& stop) {
  const Scene scene = lit_ball(photons);
  const World<double> world(scene);
  const Emitters<double> emitters(world);
  PhotonKernel<double> kernel(scene, world, emitters, photon_settings_of(scene));
  static_cast<void>(kernel.send(seed_of(round), 0, 1, stop));
  const PhotonMap& map = kernel.maps().front().other;
  for (const int k : circles) {
    double squares = 0, sum = 0, sum_of_all = 0;
    for (int i = 0; i < points; ++i) {
      const Vec3d outward = sample_uniform_sphere(Vec2d(drawn_for(round, 2 * i), drawn_for(round, 2 * i + 1)));
      const PhotonsNear near = map.nearest(ball_radius * outward, -outward, k);
      const double ratio = near.power.x * photon_density(near.squared_radius, false) / truth;
      squares += (ratio - 1) * (ratio - 1) / points;
      sum += ratio / points;
      sum_of_all += ratio * k / (k - 1) / points;
    }
    trials.push_back({round, "k - 1", static_cast<double>(k), std::sqrt(squares), sum, {}});
    trials.push_back({round, "k", static_cast<double>(k), std::abs(sum_of_all - 1), sum_of_all, {}});
  }
}

/// The mean over passes, with circles that shrink or stay.
void add_passes(std::vector<Trial>& trials, int round, int photons, int most, const Stop& stop) {
  constexpr double radius = 0.4;
  const Scene scene = lit_floor(photons, radius);
  const World<double> world(scene);
  const Emitters<double> emitters(world);
  PhotonKernel<double> kernel(scene, world, emitters, photon_settings_of(scene));
  constexpr int edge = 5, points = edge * edge;
  struct Sums {
    double shrinking = 0, fixed = 0;
  };
  std::array<Sums, points> sums{};
  int next = 4;
  double squared = radius * radius;
  for (int pass = 0; pass < most; ++pass) {
    static_cast<void>(kernel.send(seed_of(round), pass, pass + 1, stop));
    const PhotonMap& map = kernel.maps().front().other;
    for (int i = 0; i < points; ++i) {
      const Vec3d at(0.25 * (i % edge - edge / 2), 0.25 * (i / edge - edge / 2), 0), up(0, 0, 1);
      const auto density = [&](double reach) {
        const PhotonsNear near = map.within(at, up, reach);
        return near.power.x * photon_density(near.squared_radius, false) / floor_truth(length(at));
      };
      Sums& own = sums[static_cast<std::size_t>(i)];
      own.shrinking += density(std::sqrt(squared));
      own.fixed += density(radius);
    }
    squared *= (pass + 1 + PhotonSettings::alpha) / (pass + 2);  // PhotonSettings::squared_radius
    if (pass + 1 != next) continue;
    next *= 4;
    double shrinking = 0, fixed = 0;
    for (const Sums& own : sums) {
      shrinking += std::pow(own.shrinking / (pass + 1) - 1, 2) / points;
      fixed += std::pow(own.fixed / (pass + 1) - 1, 2) / points;
    }
    const double all = static_cast<double>(photons) * (pass + 1);
    trials.push_back({round, "shrinking", all, std::sqrt(shrinking), 0, {}});
    trials.push_back({round, "fixed", all, std::sqrt(fixed), 0, {}});
  }
}

void add_paths(std::vector<Trial>& trials, int round, int most) {
  constexpr int edge = 8, never = 1 << 30;
  constexpr double truth = 0.25;  // (radius / distance)^2
  for (int n = 4; n <= most; n *= 4) {
    const Shot shot = shoot(under_glow(1), {edge, edge}, {n, seed_of(round)}, false,
                            PathSettings{2, never, PathStrategy::directions});
    const Compared off = compared(shot.film, [&](int, int) { return truth; });
    trials.push_back({round, "paths", static_cast<double>(n), off.rms / truth, off.mean / truth, shot.cost});
  }
}

Report conclude_photons(const std::vector<Trial>& trials, double fewest) {
  Report report;
  const auto mean_of = [&](const std::string& method) { return ErrorCurve(trials, method, other_of, Pool::mean); };
  const ErrorCurve right = mean_of("k - 1"), all = mean_of("k"), spread(trials, "k - 1");
  Plot noise;
  noise.title = "Noise of a density estimate";
  noise.x_label = "photons in the circle, k";
  noise.y_label = "root mean square error, share of the light";
  PlotSeries series = spread.series("k - 1 over the circle");
  series.law = -0.5, series.law_name = "k^-1/2";
  noise.series.push_back(series);
  noise.series.push_back(
      ErrorCurve(trials, "k", error_of, Pool::mean).series("k over the circle: what it is too bright"));
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const int k = circles[i];
    if (k != 5 && k != 17) continue;
    const std::string name = "k = " + std::to_string(k);
    report.laws.push_back({name + ", k over the circle", "is k / (k - 1) too bright", LawKind::equals, k / (k - 1.0),
                           all.estimate(i), 0, "The circle's edge would not be a photon."});
    report.laws.push_back({name + ", k - 1 over the circle", "is right on average", LawKind::equals, 1,
                           right.estimate(i), 0, "The edge would be counted, or photons lost."});
    const Estimate variance = bootstrap(spread.rounds(), [&](const std::vector<int>& rounds) {
      const double root = spread.at(i, rounds);
      return root * root;
    });
    report.laws.push_back({name + ", variance", "the relative variance is 1 / (k - 2)", LawKind::equals, 1 / (k - 2.0),
                           variance, 0, "Photons would not be scattered by chance alone."});
  }
  report.figures.push_back(
      {noise,
       "In a ball with a lamp in its middle all places are equally bright. The circle that reaches to the k-th photon "
       "holds k - 1 others: these over its area are right on average, all k are k / (k - 1) too bright. Their noise "
       "falls with the root of k only."});
  Plot passes;
  passes.title = "All photons together";
  passes.x_label = "photons, or samples of a path";
  passes.y_label = "root mean square error, share of the light";
  const ErrorCurve shrinking(trials, "shrinking"), fixed(trials, "fixed"), paths(trials, "paths");
  PlotSeries shrinks = shrinking.series("circles that shrink");
  shrinks.law = -1.0 / 3, shrinks.law_name = "N^-1/3";
  PlotSeries walked = paths.series("paths");
  walked.law = -0.5, walked.law_name = "N^-1/2";
  passes.series = {shrinks, fixed.series("circles of one size"), walked};
  report.laws.push_back(
      {"shrinking circles", "the mean squared error falls as N^-2/3 at alpha = 2/3", LawKind::equals, -2.0 / 3,
       bootstrap(shrinking.rounds(),
                 [&](const std::vector<int>& rounds) {
                   // Least squares through the logarithms of the squares.
                   double n = 0, x = 0, y = 0, xx = 0, xy = 0;
                   for (std::size_t i = 0; i < shrinking.knobs().size(); ++i) {
                     if (shrinking.knobs()[i] < fewest) continue;
                     const double lx = std::log(shrinking.knobs()[i]), ly = 2 * std::log(shrinking.at(i, rounds));
                     n += 1, x += lx, y += ly, xx += lx * lx, xy += lx * ly;
                   }
                   return (n * xy - x * y) / (n * xx - x * x);
                 }),
       0, "Bias and noise would not fall together."});
  report.laws.push_back({"paths", "their error falls as N^-1/2: the mean squared error as 1/N", LawKind::equals, -0.5,
                         paths.exponent(0, 1e9), 0, "The estimate would be biased."});
  report.figures.push_back(
      {passes,
       "A lamp above a floor. Circles of one size blur what is brightest below the lamp: their error soon stops to "
       "fall. "
       "Circles that shrink from pass to pass lose blur and noise together, though more slowly than paths lose noise; "
       "paths are worth it where they find the light at all."});
  return report;
}

}  // namespace

Experiment photon_experiment(Effort effort, const Faults& faults) {
  // Passes beyond the first few hundred: only there is the mean of the circles as large as the law says.
  const int passes = by_effort(effort, 16384, 4096, 1024), photons = 100, settled = by_effort(effort, 256, 256, 64);
  const int samples = by_effort(effort, 1024, 256, 64), points = by_effort(effort, 400, 200, 100);
  Experiment e;
  e.number = "E11", e.name = "photons", e.title = "Photons";
  e.question = "How many photons should an estimate ask, and how fast does more of them help?";
  e.weight = 0.8;
  e.columns = {"photons", "error", "mean"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    try {
      add_circles(trials, round, by_effort(effort, 200000, 100000, 60000), points, faults.reference * ball_truth, stop);
      add_passes(trials, round, photons, passes, stop);
      add_paths(trials, round, samples);
    } catch (const Stopped&) {
    }
    return trials;
  };
  e.conclude = [=](const std::vector<Trial>& trials) {
    return conclude_photons(trials, static_cast<double>(photons) * settled);
  };
  return e;
}

}  // namespace raywalk::study
