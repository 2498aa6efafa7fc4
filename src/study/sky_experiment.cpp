// E14: how directions towards the sky are sampled: uniformly, by the sky's brightness, by the surface, by both.
#include "study/curve.h"
#include "study/shot.h"
#include "trace/sky_light.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>

namespace raywalk::study {

namespace {

enum class Heaven { overcast, sunny };
constexpr std::array heavens{Heaven::overcast, Heaven::sunny};
std::string name_of(Heaven heaven) { return heaven == Heaven::overcast ? "overcast" : "sunny"; }

struct Aim {
  std::string name;
  PathStrategy strategy;
  SkySampling sky;
};
const std::array<Aim, 4>& aims() {
  static const std::array<Aim, 4> all{{{"uniform", PathStrategy::lights, SkySampling::uniform},
                                       {"sky", PathStrategy::lights, SkySampling::by_brightness},
                                       {"surface", PathStrategy::directions, SkySampling::by_brightness},
                                       {"both", PathStrategy::both, SkySampling::by_brightness}}};
  return all;
}

/// A dim picture with one bright spot of 12 degrees, half way up.
Sky sunny_sky() {
  constexpr int columns = 64, rows = 32;
  Image picture{columns, rows, std::vector<Rgb<float>>(std::size_t{columns} * rows, Rgb<float>(0.1F))};
  for (const int row : {7, 8})
    for (const int column : {31, 32}) picture.at(column, row) = Rgb<float>(60);
  return {ImageSky{"sunny", Rgbd(1.0), std::make_shared<const Image>(std::move(picture))}, {0, 0, 1}, 0};
}
Sky sky_of(Heaven heaven) { return heaven == Heaven::overcast ? Sky{OvercastSky{Rgbd(1.0)}} : sunny_sky(); }

/// What a matt white floor under it sends out: its irradiance / pi.
double truth_of(Heaven heaven) {
  if (heaven == Heaven::overcast) return 7.0 / 9;  // Moon and Spencer 1942
  const SkyLight light(sky_of(heaven), Rgbd(0.0));
  // Midpoints in the square of the sine of the polar angle, which is what a cosine weights evenly, and in longitude.
  constexpr int heights = 2000, longitudes = 2000;
  double sum = 0;
  for (int i = 0; i < heights; ++i) {
    const double share = (i + 0.5) / heights, z = std::sqrt(1 - share), radius = std::sqrt(share);
    for (int j = 0; j < longitudes; ++j) {
      const double angle = 2 * std::numbers::pi * (j + 0.5) / longitudes;
      sum += light.radiance({radius * std::cos(angle), radius * std::sin(angle), z}).x;
    }
  }
  return sum / heights / longitudes;
}

Scene floor_under(Heaven heaven) {
  Scene scene;
  Material white;
  white.diffuse = Rgbd(1.0);
  scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, white}};
  scene.sky = sky_of(heaven);
  scene.camera = looking_down(0, 0, 1, 1);
  scene.render.integrator = Integrator::path;
  scene.render.sampler = Sampler::random;
  return scene;
}

constexpr int never = 1 << 30;
/// From the eye to the floor, from there to the sky.
PathSettings settings_of(const Aim& aim) { return {2, never, aim.strategy, aim.sky}; }

/// How many times the variance of one method is that of another, over all knobs from `low` on.
Estimate variance_ratio(const ErrorCurve& of, const ErrorCurve& to, double low) {
  return bootstrap(of.rounds(), [&](const std::vector<int>& rounds) {
    double above = 0, below = 0;
    for (std::size_t knob = 0; knob < of.knobs().size(); ++knob) {
      if (of.knobs()[knob] < low) continue;
      above += std::pow(of.at(knob, rounds), 2) * of.knobs()[knob];
      below += std::pow(to.at(knob, rounds), 2) * of.knobs()[knob];
    }
    return above / below;
  });
}

CaptionedImage ball_under_the_sun(const Aim& aim, int samples) {
  Scene scene = floor_under(Heaven::sunny);
  Material matt;
  matt.diffuse = Rgbd(0.7, 0.6, 0.5);
  scene.objects.push_back({"Ball", Sphere<double>{{0, 0, 1}, 1}, matt});
  scene.objects[0].material = matt;
  scene.camera.eye = {-5, -1, 2};
  scene.camera.look_at = {0, 0, 0.6};
  scene.camera.up = {0, 0, 1};
  scene.camera.screen = {1, 1, 1};
  const Shot shot =
      shoot(scene, {128, 96}, {samples, seed_of(0)}, false, PathSettings{4, never, aim.strategy, aim.sky});
  Image image{128, 96, {}};
  for (int row = 0; row < image.height; ++row)
    for (int column = 0; column < image.width; ++column)
      image.pixels.emplace_back(Rgb<float>(shot.film.at(column, row)));
  return {aim.name + ", " + std::to_string(samples) + " samples", std::move(image)};
}

Report conclude_sky(const std::vector<Trial>& trials, double most, int picture_samples) {
  Report report;
  for (const Heaven heaven : heavens) {
    const bool overcast = heaven == Heaven::overcast;
    Plot plot;
    plot.title = overcast ? "A floor under an overcast sky" : "A floor under a sky with a small bright spot";
    plot.x_label = "samples of a pixel, N";
    plot.y_label = "root mean square error, share of the light";
    const auto curve_of = [&](std::size_t aim) { return ErrorCurve(trials, aims()[aim].name + " " + name_of(heaven)); };
    for (std::size_t i = 0; i < aims().size(); ++i) {
      const ErrorCurve curve = curve_of(i);
      PlotSeries series = curve.series(aims()[i].name);
      series.law = -0.5, series.law_name = "N^-1/2";
      plot.series.push_back(series);
      // Few samples seldom meet the spot by chance, and then their spread is not yet that of the limit.
      report.laws.push_back({aims()[i].name + ", " + name_of(heaven), "error falls as N^-1/2", LawKind::equals, -0.5,
                             curve.exponent(overcast ? 1 : 4, most), 0,
                             "The estimate would be biased, or its variance not finite."});
    }
    const ErrorCurve uniform = curve_of(0), sky = curve_of(1), surface = curve_of(2), both = curve_of(3);
    if (overcast) {
      // Integrals of polynomials in the cosine, over the square of the mean, 7/9: with L = (1 + 2 z) / 3,
      // 4 pi int L^2 z^2 = 256/135 pi^2, (int L) (int L z^2) = 20/27 pi^2 and pi int L^2 z = 17/27 pi^2.
      constexpr double mean = 49.0 / 81, by_uniform = 256.0 / 135 - mean, by_sky = 20.0 / 27 - mean,
                       by_surface = 17.0 / 27 - mean;
      report.laws.push_back({"uniform to sky, overcast",
                             "the variance is 9.51 times as large: 523/405 to 11/81, in closed form", LawKind::equals,
                             by_uniform / by_sky, variance_ratio(uniform, sky, 1), 0,
                             "A sampler would not have the density that it states."});
      report.laws.push_back({"sky to surface, overcast",
                             "the variance is 5.5 times as large: the cosine varies more than the sky", LawKind::equals,
                             by_sky / by_surface, variance_ratio(sky, surface, 1), 0,
                             "A sampler would not have the density that it states."});
    } else {
      report.laws.push_back({"uniform to sky, sunny", "the variance is at least 20 times as large", LawKind::at_least,
                             20, variance_ratio(uniform, sky, 4), 0, "The spot would not be aimed at."});
      report.laws.push_back({"surface to both, sunny", "the variance is at least 10 times as large", LawKind::at_least,
                             10, variance_ratio(surface, both, 4), 0,
                             "The weights would not favour the sky's own samples."});
    }
    report.figures.push_back(
        {plot,
         overcast
             ? "Clouds are three times as bright overhead as at the horizon: a gentle sky. What varies more is the "
               "floor's own cosine, so that directions drawn by the floor do best here; those drawn by the sky's "
               "brightness are next, and those drawn evenly over all directions, half of them below the floor, "
               "are far behind. How far is known in closed form."
             : "A spot of 12 degrees gives most of the light. Directions drawn by the floor or evenly seldom meet "
               "it, and when they do, it counts for much: noise of bright dots. Drawn by the sky's brightness, "
               "most go there. Both together, each weighted by how likely it was to find the direction (multiple "
               "importance sampling), are never far from the better of the two, under either sky."});
  }
  for (const Aim& aim : aims()) report.pictures.push_back(ball_under_the_sun(aim, picture_samples));
  return report;
}

}  // namespace

Experiment sky_experiment(Effort effort, const Faults& faults) {
  const int most = by_effort(effort, 1024, 256, 64), edge = 16;
  Experiment e;
  e.number = "E14", e.name = "sky", e.title = "Light from the sky";
  e.question = "Where should a ray towards the sky go: anywhere, where the sky is bright, or where the surface looks?";
  e.weight = 0.7;
  e.columns = {"samples", "rms_error", "mean_error"};
  e.run = [=](int round, const Stop& stop) {
    static const std::array truths{truth_of(Heaven::overcast), truth_of(Heaven::sunny)};
    std::vector<Trial> trials;
    for (int n = 1; n <= most; n *= 4)
      for (const Heaven heaven : heavens)
        for (const Aim& aim : aims()) {
          if (stop.asked()) return trials;
          const Shot shot =
              shoot(floor_under(heaven), {edge, edge}, {n, seed_of(round)}, faults.shuffled_seed, settings_of(aim));
          const double truth = faults.reference * truths[static_cast<std::size_t>(heaven)];
          const Compared off = compared(shot.film, [&](int, int) { return truth; });
          trials.push_back({round, aim.name + " " + name_of(heaven), static_cast<double>(n), off.rms / truth,
                            off.mean / truth, shot.cost});
        }
    return trials;
  };
  e.conclude = [=](const std::vector<Trial>& trials) {
    return conclude_sky(trials, most, by_effort(effort, 16, 16, 4));
  };
  return e;
}

}  // namespace raywalk::study
