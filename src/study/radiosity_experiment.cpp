// E12: what patches cost: how fast the error falls with their size, and the unshot light with the shots.
#include "math/sampling.h"
#include "study/curve.h"
#include "study/shot.h"
#include "trace/radiosity_kernel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <mutex>

namespace raywalk::study {

namespace {

/// The inside of a ball of radius 1, as patches. Its form factors are computed once for all patterns of light.
struct HollowBall {
  std::mutex in_use;
  std::unique_ptr<Patches> patches;
  std::unique_ptr<FormFactors> factors;

  void prepare(int around, const Stop& stop) {
    if (factors) return;
    Scene scene;
    scene.objects = {{"Ball", Sphere<double>{{0, 0, 0}, 1}, Material{}}};
    scene.camera.eye = {0, 0, 0};
    const double side = 2 * 3.14159265358979 / around;
    patches = std::make_unique<Patches>(scene, PatchSettings{side * (1 + 1e-9), false}, stop);
    factors = std::make_unique<FormFactors>(*patches);
  }
};

/// A pattern of emission and reflectance, another one in each round: with mean E and mean rho, irradiance is E / (1 -
/// rho) everywhere, whatever the pattern.
void add_ball(std::vector<Trial>& trials, int round, int around, HollowBall& ball, double reference, const Stop& stop) {
  const std::lock_guard lock(ball.in_use);
  ball.prepare(around, stop);
  constexpr double mean_emission = 1, mean_reflectance = 0.5;
  const Vec3d bright = sample_uniform_sphere(Vec2d(drawn_for(round, 0), drawn_for(round, 1)));
  const Vec3d light = sample_uniform_sphere(Vec2d(drawn_for(round, 2), drawn_for(round, 3)));
  Patches& patches = *ball.patches;
  for (int i = 0; i < patches.size(); ++i) {
    const Vec3d at = normalize(patches[i].centre);
    patches.paint(i, Rgbd(mean_emission * (1 + 0.8 * dot(at, bright))), Rgbd(mean_reflectance + 0.4 * dot(at, light)));
  }
  RadiositySettings settings;
  settings.tolerance = 1e-6;
  const RadiosityState state = shoot_light(*ball.factors, settings, {}, stop);
  const double truth = reference * mean_emission / (1 - mean_reflectance);
  double squares = 0, mean = 0, area = 0;
  for (int i = 0; i < patches.size(); ++i) {
    const double ratio = state.lights[static_cast<std::size_t>(i)].irradiance.x / truth, own = patches[i].area;
    squares += own * (ratio - 1) * (ratio - 1), mean += own * ratio, area += own;
  }
  trials.push_back({round, "ball", 1.0 / around, std::sqrt(squares / area), mean / area, {}});
}

/// A square in the plane, whose one side glows and the others are black: between the corners of the opposite side's
/// patches.
void add_square(std::vector<Trial>& trials, int round, int pieces, double reference, const Stop& stop) {
  Scene scene;
  scene.objects = {{"Glow", Box<double>{{0, -1, -1}, {1, 0, 1}}, Material{}},
                   {"Wall", Box<double>{{0, 1, -1}, {1, 2, 1}}, Material{}}};
  scene.objects[0].material.emission = Rgbd(1.0);
  for (Object& object : scene.objects) object.material.diffuse = Rgbd(0.0);
  const Patches patches(scene, PatchSettings{1.0 / pieces * (1 + 1e-9), true}, stop);
  FormFactors factors(patches);
  RadiositySettings settings;
  settings.patches.flat = true;
  settings.tolerance = 0;
  const RadiosityState state = shoot_light(factors, settings, {}, stop);
  const PatchIrradiance irradiance(factors, state.lights);
  constexpr int points = 40;
  double squares = 0;
  for (int i = 0; i < points; ++i) {
    // Away from the ends, where a corner has patches on both of its sides.
    const double x = 0.25 + 0.5 * drawn_for(round, i);
    const double truth = reference * 2 * 0.5 * (x / std::sqrt(x * x + 1) + (1 - x) / std::sqrt((1 - x) * (1 - x) + 1));
    const double found = irradiance.at(patches.place_of(1, {x, 1, 0}, {0, -1, 0})).x;
    squares += (found / truth - 1) * (found / truth - 1) / points;
  }
  trials.push_back({round, "square", 1.0 / pieces, std::sqrt(squares), 0, {}});
}

/// Walls of the square with random reflectances: unshot light after each number of shots, and by how much a single shot
/// lessened it at least.
void add_shots(std::vector<Trial>& trials, int round, const Stop& stop) {
  Scene scene;
  scene.objects = {{"Room", Box<double>{{0, 0, -1}, {1, 1, 1}}, Material{}}};
  scene.camera.eye = {0.5, 0.5, 0};
  Patches patches(scene, PatchSettings{0.125 * (1 + 1e-9), true}, stop);
  for (int i = 0; i < patches.size(); ++i)
    patches.paint(i, Rgbd(drawn_for(round, 100 + i)), Rgbd(0.3 + 0.6 * drawn_for(round, 300 + i)));
  FormFactors factors(patches);
  RadiositySettings settings;
  settings.patches.flat = true;
  settings.tolerance = 1e-4;
  std::vector<double> shares;
  Shooting shooting;
  shooting.shot = [&](double share) { shares.push_back(share); };
  static_cast<void>(shoot_light(factors, settings, shooting, stop));
  double before = 1, most = 0;
  for (const double share : shares) most = std::max(most, share / before), before = share;
  for (std::size_t shots = 8; shots <= shares.size(); shots *= 2)
    trials.push_back({round, "unshot", static_cast<double>(shots), shares[shots - 1], most, {}});
}

Report conclude_radiosity(const std::vector<Trial>& trials) {
  Report report;
  Plot size;
  size.title = "Patches and their size";
  size.x_label = "longest side of a patch, share of the surface";
  size.y_label = "root mean square error, share of the light";
  const ErrorCurve ball(trials, "ball"), square(trials, "square");
  PlotSeries in_ball = ball.series("hollow ball"), in_square = square.series("square in the plane");
  in_ball.law = in_square.law = 2, in_ball.law_name = in_square.law_name = "h^2";
  size.series = {in_ball, in_square};
  report.laws.push_back({"square", "between patches the error falls as h^2", LawKind::exact, 2, square.exponent(0, 1),
                         0.05, "Form factors would be off, or light looked up in the wrong place."});
  report.laws.push_back({"ball", "the error of a polygon in place of a ball falls nearly as h^2", LawKind::exact, 2,
                         ball.exponent(0, 1), 0.2, "Light would be lost or won between patches."});
  const ErrorCurve mean(trials, "ball", other_of, Pool::mean);
  report.laws.push_back({"ball, mean", "irradiance is mean(E) / (1 - mean(rho)) for any pattern", LawKind::exact, 1,
                         mean.estimate(0), 1e-3, "The light of patches would not add up."});
  report.figures.push_back(
      {size,
       "In a ball, whatever glows and whatever reflects, every place receives the same light: what is emitted on "
       "average, over what is not reflected on average. Patches make a polygon of it. In a square whose one side glows "
       "the light on the opposite one has a closed form too. Patches half as long are four times as right; they are "
       "twice as many in the plane and four times in space, and their form factors four and sixteen times."});
  Plot shots;
  shots.title = "Shots";
  shots.x_label = "shots";
  shots.y_label = "unshot light, share of the first";
  shots.series = {ErrorCurve(trials, "unshot", error_of, Pool::mean).series("square of 32 patches, light everywhere")};
  const ErrorCurve lessened(trials, "unshot", other_of, Pool::mean);
  report.laws.push_back({"shots", "every shot leaves less unshot light than there was", LawKind::at_most, 1,
                         lessened.estimate(0), 0, "Light would come from nowhere."});
  report.figures.push_back(
      {shots,
       "The patch with most unshot light shoots first. Each shot brings its light to others, which absorb a part of it "
       "and keep the rest to shoot it later: together they have less than before."});
  return report;
}

}  // namespace

Experiment radiosity_experiment(Effort effort, const Faults& faults) {
  const int balls = by_effort(effort, 4, 4, 3), squares = by_effort(effort, 6, 5, 4);
  constexpr std::array around{16, 20, 24, 32};
  auto hollow = std::make_shared<std::array<HollowBall, around.size()>>();
  Experiment e;
  e.number = "E12", e.name = "radiosity", e.title = "Radiosity";
  e.question = "How small do patches have to be, and how many shots do they take?";
  e.weight = 0.6;
  e.columns = {"size or shots", "error", "mean"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    try {
      for (std::size_t i = static_cast<std::size_t>(balls); i-- > 0;)
        add_ball(trials, round, around[i], (*hollow)[i], faults.reference, stop);
      for (int i = squares; i-- > 0;) add_square(trials, round, 4 << i, faults.reference, stop);
      add_shots(trials, round, stop);
    } catch (const Stopped&) {
    }
    return trials;
  };
  e.conclude = conclude_radiosity;
  return e;
}

}  // namespace raywalk::study
