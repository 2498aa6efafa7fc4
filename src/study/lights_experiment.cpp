// E6: an area light sampled at n x n points: on a grid, jittered, random, by the Sobol sequence.
#include "study/curve.h"
#include "study/reference.h"
#include "study/shot.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raywalk::study {

namespace {

constexpr double light_height = 2, blocker_height = 1, half_light = 0.4, half_view = 0.5, eye_height = 0.5;
constexpr int image_columns = 32, image_rows = 4;

enum class Placing { regular, random, jittered, sobol };
constexpr std::array placings{Placing::regular, Placing::random, Placing::jittered, Placing::sobol};
std::string name_of(Placing placing) {
  switch (placing) {
    case Placing::regular:
      return "regular";
    case Placing::random:
      return "random";
    case Placing::jittered:
      return "jittered";
    case Placing::sobol:
      return "sobol";
  }
  return "";
}

/// A floor below a square light; with `blocked`, an occluder at x < edge, half way up.
struct Setting {
  bool blocked;
  double edge;    ///< varied per round, so that no method is lucky
  double across;  ///< and the light
  [[nodiscard]] Rectangle light() const { return {across - half_light, across + half_light, -half_light, half_light}; }
};
Setting setting_of(bool blocked, int round) {
  return {blocked, 0.05 * (drawn_for(round, 0) - 0.5), blocked ? 0 : 0.3 + 0.1 * (drawn_for(round, 1) - 0.5)};
}

Scene scene_of(const Setting& setting, Placing placing, int n) {
  Scene scene;
  Material matte;
  matte.diffuse = Rgbd(1.0);
  scene.objects = {{"Floor", Plane<double>{{0, 0, 0}, {0, 0, 1}}, matte}};
  if (setting.blocked) {
    const double far = 1e4;
    scene.objects.push_back(
        {"Blocker",
         Triangle<double>{
             {setting.edge, -far, blocker_height}, {setting.edge, far, blocker_height}, {-far, 0, blocker_height}},
         matte});
  }
  const Rectangle light = setting.light();
  scene.lights = {
      {"Panel", Rgbd(1.0),
       RectangleLight{
           {light.x0, light.y0, light_height}, {2 * half_light, 0, 0}, {0, 2 * half_light, 0}, n, {0, 0, 1}}}};
  scene.camera = looking_down(0, 0, eye_height, half_view);
  scene.render.integrator = placing == Placing::regular ? Integrator::whitted : Integrator::distributed;
  scene.render.sampler = placing == Placing::sobol    ? Sampler::sobol
                         : placing == Placing::random ? Sampler::random
                                                      : Sampler::jittered;
  return scene;
}

/// The pixel's middle on the floor.
Vec2d middle_of_pixel(int column, int row) {
  const double pixel = 2 * half_view / image_columns;
  return {pixel * (column + 0.5) - half_view, pixel * (image_rows / 2.0 - row - 0.5)};
}

double truth_at(const Setting& setting, const Vec2d& p) {
  Rectangle seen = setting.light();
  const double area = seen.area();
  if (setting.blocked) {
    // The ray over the edge meets the light's plane here.
    const double from = p.x + (setting.edge - p.x) * light_height / blocker_height;
    seen.x0 = std::clamp(from, seen.x0, seen.x1);
  }
  return solid_angle(seen, p.x, p.y, light_height) / area;
}

struct ExpectedByLight {
  double smooth, blocked;
  std::string smooth_name, blocked_name;
};
ExpectedByLight expected_of(Placing placing) {
  switch (placing) {
    case Placing::regular:
      return {-1, -0.5, "N^-1", "N^-1/2"};
    case Placing::random:
      return {-0.5, -0.5, "N^-1/2", "N^-1/2"};
    case Placing::jittered:
      return {-1, -0.75, "N^-1", "N^-3/4"};
    case Placing::sobol:
      return {-1.5, -1, "N^-3/2", "N^-1"};
  }
  return {};
}

/// The penumbra as a strip, every pixel 12 wide and high.
Image strip(const std::function<double(int column, int row)>& at) {
  constexpr int zoom = 12;
  Image image{image_columns * zoom, image_rows * zoom, {}};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x) image.pixels.emplace_back(static_cast<float>(4 * at(x / zoom, y / zoom)));
  return image;
}

Report conclude_lights(const std::vector<Trial>& trials, double most) {
  Report report;
  for (const bool blocked : {true, false}) {
    Plot plot;
    plot.title = blocked ? "In the penumbra of a straight edge" : "Where all of the light is seen";
    plot.x_label = "points of the light, N = n x n (each is one shadow ray)";
    plot.y_label = "root mean square error, light of 0 to 0.25";
    for (const Placing placing : placings) {
      const std::string name = name_of(placing), where = blocked ? "penumbra" : "open";
      const ErrorCurve curve(trials, name + " " + where);
      const ExpectedByLight law = expected_of(placing);
      PlotSeries series = curve.series(name);
      series.law = blocked ? law.blocked : law.smooth;
      series.law_name = blocked ? law.blocked_name : law.smooth_name;
      Law judged{name + ", " + where,
                 "error falls as " + series.law_name,
                 LawKind::equals,
                 *series.law,
                 curve.exponent(16, most),
                 0,
                 "The fit is over the largest N tried; a law of the limit may need larger ones."};
      if (placing == Placing::regular) {
        // These points are not random: the only error is that n is finite.
        judged.kind = LawKind::exact;
        judged.tolerance = 0.02;
      }
      report.laws.push_back(std::move(judged));
      plot.series.push_back(std::move(series));
    }
    report.figures.push_back(
        {plot,
         blocked
             ? "A square light, partly hidden by the straight edge of something half way up; what is seen of it is a "
               "smaller rectangle, known exactly. Points in rows and columns appear behind the edge one column at a "
               "time: the shadow falls in n steps, and its error falls as slowly as that of random points and is worse "
               "to look at, for the steps line up as bands. Jittered points break the bands into noise, and less of "
               "it. "
               "The edge runs along the light's side here, which suits Sobol's points: they share out each side evenly "
               "in N parts, not only in n."
             : "The same light with nothing before it. What arrives changes smoothly over the light, so regular points "
               "are as good as jittered ones, both far better than random ones: regular points only go wrong where "
               "something jumps."});
  }
  const Setting shown = setting_of(true, 0);
  report.pictures.push_back(
      {"exact", strip([&](int column, int row) { return truth_at(shown, middle_of_pixel(column, row)); })});
  for (const Placing placing : placings) {
    Scene scene = scene_of(shown, placing, 4);
    const Shot shot = shoot(scene, {image_columns, image_rows}, {1, seed_of(0)});
    report.pictures.push_back(
        {name_of(placing) + ", 4 x 4", strip([&](int column, int row) { return shot.film.at(column, row).x; })});
  }
  return report;
}

}  // namespace

Experiment lights_experiment(Effort effort, const Faults& faults) {
  const int most = by_effort(effort, 32, 16, 8);
  Experiment e;
  e.number = "E6", e.name = "lights", e.title = "Points on a light";
  e.question = "A penumbra by n x n shadow rays: where should they go?";
  e.weight = 0.7;
  e.columns = {"points", "rms_error", "mean_error"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    for (int n = 1; n <= most; n *= 2)
      for (const bool blocked : {true, false})
        for (const Placing placing : placings) {
          if (stop.asked()) return trials;
          const Setting setting = setting_of(blocked, round);
          const Shot shot = shoot(scene_of(setting, placing, n), {image_columns, image_rows}, {1, seed_of(round)},
                                  faults.shuffled_seed);
          const Compared off = compared(shot.film, [&](int column, int row) {
            return faults.reference * truth_at(setting, middle_of_pixel(column, row));
          });
          trials.push_back({round, name_of(placing) + (blocked ? " penumbra" : " open"), static_cast<double>(n * n),
                            off.rms, off.mean, shot.cost});
        }
    return trials;
  };
  e.conclude = [=](const std::vector<Trial>& trials) { return conclude_lights(trials, most * most); };
  return e;
}

}  // namespace raywalk::study
