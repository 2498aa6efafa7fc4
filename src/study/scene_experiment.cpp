// E10: a scene without a closed form, with gloss, penumbras, a lens and motion at once, against two references.
#include "study/curve.h"
#include "study/shot.h"

#include <array>
#include <cmath>
#include <memory>
#include <mutex>

namespace raywalk::study {

namespace {

constexpr ImageSize picture_size{24, 18};

Scene everything_at_once() {
  Scene scene;
  Material floor, brushed, frosted, matte;
  floor.checker = Checker{Rgbd(0.9), Rgbd(0.25), 0.6};
  brushed.diffuse = Rgbd(0.15), brushed.reflection = Rgbd(0.7), brushed.gloss = 6;
  frosted.diffuse = Rgbd(0.05), frosted.transmission = Rgbd(0.8), frosted.translucency = 5, frosted.ior = 1.3;
  matte.diffuse = Rgbd(0.7);
  scene.objects = {{"Floor", Plane<double>{{0, 0, -1}, {0, 0, 1}}, floor},
                   {"Brushed", Sphere<double>{{0.6, 1.1, 0}, 1}, brushed},
                   {"Frosted", Sphere<double>{{-0.4, -1.0, -0.1}, 0.9}, frosted},
                   {"Flying", Sphere<double>{{-2, 0.2, 0.5}, 0.35}, matte}};
  scene.objects[3].motion = {{0, Vec3d(0.0)}, {1, Vec3d(0, 0.6, 0.2)}};
  scene.lights = {{"Panel", Rgbd(0.9), RectangleLight{{-3, -1.5, 5}, {2, 0, 0}, {0, 3, 0}, 1, {}}}};
  scene.background = Rgbd(0.25);
  scene.camera.eye = {-7, 0, 1.5};
  scene.camera.look_at = {0, 0, -0.1};
  scene.camera.screen = {1, 0.75, 1};
  scene.camera.aperture = 0.12;
  scene.render.integrator = Integrator::distributed;
  scene.limits.depth = 4;
  return scene;
}

/// Two pictures with independent random numbers, and their difference.
struct References {
  Film<double> first, second;
  double apart = 0;
  [[nodiscard]] double mean(int column, int row) const {
    return (first.at(column, row).x + second.at(column, row).x) / 2;
  }
};

References references(int samples) {
  Scene scene = everything_at_once();
  References made;
  scene.render.sampler = Sampler::sobol;
  made.first = shoot(scene, picture_size, {samples, 1}).film;
  scene.render.sampler = Sampler::jittered;
  made.second = shoot(scene, picture_size, {samples, 2}).film;
  made.apart = compared(made.first, [&](int column, int row) { return made.second.at(column, row).x; }).rms;
  return made;
}

Report conclude_scene(const std::vector<Trial>& trials, double most) {
  Report report;
  Plot plot, time;
  plot.title = "Gloss, penumbra, lens and motion at once";
  plot.x_label = "samples of a pixel, N";
  plot.y_label = time.y_label = "root mean square error, light of 0 to 1";
  time.title = "The same against time";
  time.x_label = "processor seconds a picture, median";
  plot.floor = time.floor = trials.empty() ? 0 : trials.front().other;
  plot.floor_name = time.floor_name = "difference of the two references";
  for (const Sampler sampler : values_of<Sampler>) {
    const std::string name(name_of(sampler));
    const ErrorCurve curve(trials, name);
    PlotSeries series = curve.series(name);
    time.series.push_back(curve.series(name, [](const Trial& t) { return t.cost.seconds; }));
    const bool random = sampler == Sampler::random;
    if (random) series.law = -0.5, series.law_name = "N^-1/2";
    plot.series.push_back(std::move(series));
    report.laws.push_back({name,
                           random ? "error falls as N^-1/2, whatever the scene"
                                  : "error falls at least as fast as that of random samples",
                           random ? LawKind::equals : LawKind::at_most, -0.5, curve.exponent(4, most), 0,
                           "The error may have come down to that of the references, whose difference is drawn."});
  }
  report.figures.push_back(
      {plot,
       "No formula knows this picture. It is compared to the mean of two others, of at least a hundred times the "
       "samples, that share no random number: one by Sobol's points, one jittered. How far these two are apart is the "
       "dashed line; errors near it would say nothing. Ten numbers are drawn for each sample, for pixel, lens, time, "
       "lamp and lobes. With so many, what good placing wins in each pair is partly lost between the pairs: the curves "
       "lie closer together than for a single edge, and none falls like N^-1."});
  report.figures.push_back({time, "Placing samples well costs next to nothing beside tracing them."});
  return report;
}

}  // namespace

Experiment scene_experiment(Effort effort) {
  const int most = by_effort(effort, 256, 64, 16);
  const int of_reference = effort == Effort::glance ? 400 : 100 * most;
  struct Once {
    std::once_flag flag;
    References made;
  };
  const auto once = std::make_shared<Once>();
  Experiment e;
  e.number = "E10", e.name = "scene", e.title = "A scene without a formula";
  e.question = "Does what holds for an edge and a penumbra hold where everything comes together?";
  e.weight = 4;
  e.columns = {"samples", "rms_error", "references_apart"};
  e.run = [=](int round, const Stop& stop) {
    std::call_once(once->flag, [&] { once->made = references(of_reference); });
    const References& truth = once->made;
    std::vector<Trial> trials;
    for (int n = 1; n <= most; n *= 4)
      for (const Sampler sampler : values_of<Sampler>) {
        if (stop.asked()) return trials;
        Scene scene = everything_at_once();
        scene.render.sampler = sampler;
        const Shot shot = shoot(scene, picture_size, {n, seed_of(round)});
        const Compared off = compared(shot.film, [&](int column, int row) { return truth.mean(column, row); });
        trials.push_back(
            {round, std::string(name_of(sampler)), static_cast<double>(n), off.rms, truth.apart, shot.cost});
      }
    return trials;
  };
  e.conclude = [=](const std::vector<Trial>& trials) { return conclude_scene(trials, most); };
  return e;
}

}  // namespace raywalk::study
