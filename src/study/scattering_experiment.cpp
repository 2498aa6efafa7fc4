// E13: light inside bodies: what walks inside of a half-space bring back, and how far the dipole is from that.
#include "study/curve.h"
#include "study/shot.h"

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <vector>

namespace raywalk::study {

namespace {

/// The share of the light that is scattered, not absorbed, wherever it meets something inside.
constexpr std::array albedos{0.3, 0.5, 0.7, 0.8, 0.9, 0.95};
constexpr double albedo_of_curves = 0.9;

/// How light comes in: along the normal, or alike from everywhere.
enum class Incidence { normal, diffuse };
constexpr std::array incidences{Incidence::normal, Incidence::diffuse};
std::string name_of(Incidence incidence) { return incidence == Incidence::normal ? "normal" : "diffuse"; }

/// Nodes and weights on (0, 1), by Newton's iteration on the Legendre polynomial.
struct GaussLegendre {
  static constexpr int size = 48;
  std::array<double, size> at{}, weight{};

  GaussLegendre() {
    for (int i = 0; i < size; ++i) {
      double x = std::cos(std::numbers::pi * (i + 0.75) / (size + 0.5)), slope = 1;
      for (int iteration = 0; iteration < 20; ++iteration) {
        double before = 1, value = x;
        for (int k = 2; k <= size; ++k) {
          const double next = ((2 * k - 1) * x * value - (k - 1) * before) / k;
          before = value, value = next;
        }
        slope = size * (x * value - before) / (x * x - 1);
        x -= value / slope;
      }
      const auto index = static_cast<std::size_t>(i);
      at[index] = (1 + x) / 2;
      weight[index] = 1 / ((1 - x * x) * slope * slope);
    }
  }
};

/// What a half-space reflects that scatters evenly and bends nothing: by the function H of S. Chandrasekhar ("Radiative
/// Transfer", 1950), found by iterating its integral equation.
class HalfSpace {
 public:
  explicit HalfSpace(double albedo) : kept_(std::sqrt(1 - albedo)), albedo_(albedo) {
    h_.fill(1);
    for (int iteration = 0; iteration < 200; ++iteration) {
      std::array<double, GaussLegendre::size> next{};
      for (std::size_t i = 0; i < next.size(); ++i) next[i] = h(nodes().at[i]);
      h_ = next;
    }
  }
  /// Of light that comes in at this cosine to the normal.
  [[nodiscard]] double reflectance_at(double cos) const { return 1 - kept_ * h(cos); }
  [[nodiscard]] double reflectance(Incidence incidence) const {
    if (incidence == Incidence::normal) return reflectance_at(1);
    double moment = 0;
    for (std::size_t i = 0; i < h_.size(); ++i) moment += nodes().weight[i] * nodes().at[i] * h_[i];
    return 1 - 2 * kept_ * moment;
  }

 private:
  static const GaussLegendre& nodes() {
    static const GaussLegendre all;
    return all;
  }
  [[nodiscard]] double h(double cos) const {
    double sum = 0;
    for (std::size_t i = 0; i < h_.size(); ++i)
      sum += nodes().weight[i] * nodes().at[i] * h_[i] / (cos + nodes().at[i]);
    return 1 / (kept_ + albedo_ / 2 * sum);
  }
  double kept_, albedo_;
  std::array<double, GaussLegendre::size> h_{};
};

/// Each is solved for once.
const HalfSpace& half_space_of(double albedo) {
  static const std::map<double, HalfSpace> all = [] {
    std::map<double, HalfSpace> solved;
    for (const double each : albedos) solved.emplace(each, HalfSpace(each));
    return solved;
  }();
  return all.at(albedo);
}

/// The same by the dipole, however the light comes in: two sources, one inside and one above the surface, in place of
/// all that is scattered (H. Jensen, S. Marschner, M. Levoy and P. Hanrahan, "A Practical Model for Subsurface Light
/// Transport", SIGGRAPH 2001; where nothing is bent, A = 1).
double dipole_reflectance(double albedo) {
  const double falloff = std::sqrt(3 * (1 - albedo));
  return albedo / 2 * (1 + std::exp(-4.0 / 3 * falloff)) * std::exp(-falloff);
}

/// A half-space under a background of 1. By reciprocity, what the eye sees along a direction is what is reflected of
/// light that comes along it.
Scene milk(double albedo, double cos, Subsurface subsurface) {
  Scene scene;
  Material material;
  material.diffuse = Rgbd(0.0);
  material.transmission = Rgbd(1.0);
  material.ior = 1;
  material.scattering = Rgbd(albedo);
  material.absorption = Rgbd(1 - albedo);
  scene.objects = {{"Milk", Plane<double>{{0, 0, 0}, {0, 0, 1}}, material}};
  scene.background = Rgbd(1.0);
  scene.camera.eye = {-std::sqrt(1 - cos * cos), 0, cos};
  scene.camera.look_at = {0, 0, 0};
  scene.camera.up = {0, 1, 0};
  scene.camera.screen = {1, 1e-9, 1};
  scene.render.integrator = Integrator::path;
  scene.render.subsurface = subsurface;
  scene.render.sampler = Sampler::random;
  return scene;
}

/// Whether the knob `absorbed` is that of an albedo.
bool is_albedo(double absorbed, double albedo) { return std::abs(1 - absorbed - albedo) < 1e-9; }

Report conclude_scattering(const std::vector<Trial>& trials, double most) {
  Report report;
  Plot noise;
  noise.title = "Walks in a half-space of albedo 0.9";
  noise.x_label = "samples of a pixel, N";
  noise.y_label = "root mean square error, share of the light";
  for (const Incidence incidence : incidences) {
    const ErrorCurve curve(trials, "walks " + name_of(incidence));
    PlotSeries series = curve.series(name_of(incidence) + " light");
    series.law = -0.5, series.law_name = "N^-1/2";
    noise.series.push_back(series);
    report.laws.push_back({"walks, " + name_of(incidence), "error falls as N^-1/2", LawKind::equals, -0.5,
                           curve.exponent(1, most), 0, "The estimate would be biased, or its variance not finite."});
  }
  report.figures.push_back(
      {noise,
       "Light that comes into something like milk is scattered again and again, until it is absorbed or gets out. "
       "Walks "
       "play this game; their mean is the exact value by Chandrasekhar, and their error is noise alone."});
  Plot reflectance;
  reflectance.title = "The dipole";
  reflectance.x_label = "absorbed wherever light meets something, 1 - albedo";
  reflectance.y_label = "too dark, share of the exact reflectance";
  for (const Incidence incidence : incidences) {
    const std::string light = name_of(incidence);
    const ErrorCurve walked(trials, "by albedo " + light, other_of, Pool::mean);
    const ErrorCurve dipole(trials, "dipole " + light, other_of, Pool::mean);
    for (std::size_t i = 0; i < walked.knobs().size(); ++i) {
      const bool half = is_albedo(walked.knobs()[i], 0.5);
      if (!half && !is_albedo(walked.knobs()[i], albedo_of_curves)) continue;
      report.laws.push_back({"walks, " + light + ", albedo " + (half ? "0.5" : "0.9"),
                             "the mean is what Chandrasekhar's equation says", LawKind::equals, 1, walked.estimate(i),
                             0, "Walks would lose or win light inside."});
    }
    for (std::size_t i = 0; i < dipole.knobs().size(); ++i) {
      if (!is_albedo(dipole.knobs()[i], albedo_of_curves)) continue;
      const bool normal = incidence == Incidence::normal;
      const double closed_form =
          dipole_reflectance(albedo_of_curves) / half_space_of(albedo_of_curves).reflectance(incidence);
      report.laws.push_back({"dipole, rendered, " + light, "the mean is its closed form", LawKind::exact, closed_form,
                             dipole.estimate(i), 0.001, "Light would not come out where the dipole says."});
      report.laws.push_back({"dipole, " + light,
                             normal ? "it is 7 % too dark at albedo 0.9, along the normal"
                                    : "it is 19 % too dark at albedo 0.9, under diffuse light",
                             LawKind::exact, normal ? 0.93 : 0.81, dipole.estimate(i), 0.005,
                             "The dipole would not be the one of the paper."});
    }
    reflectance.series.push_back(ErrorCurve(trials, "dipole " + light).series(light + " light"));
  }
  Plot time;
  time.title = "Its price";
  time.x_label = reflectance.x_label;
  time.y_label = "processor seconds a picture, median";
  const TrialValue seconds = [](const Trial& trial) { return trial.cost.seconds; };
  const std::string along = name_of(Incidence::normal);
  time.series.push_back(ErrorCurve(trials, "by albedo " + along, seconds, Pool::median).series("walks"));
  time.series.push_back(ErrorCurve(trials, "dipole " + along, seconds, Pool::median).series("dipole"));
  const char* text =
      "The dipole puts two lamps in place of all that is scattered inside. It costs next to nothing, has no noise, and "
      "knows nothing of the direction from which light comes in. It is good where light is scattered very often before "
      "it is absorbed, and too dark elsewhere: by 19 % at an albedo of 0.9 under light from everywhere. No number of "
      "samples mends that, as it mends the noise of walks.";
  report.figures.push_back({reflectance, text});
  report.figures.push_back(
      {time,
       "A walk takes as many steps as light is scattered before it is absorbed or gets out. The dipole takes one, "
       "whatever the albedo."});
  return report;
}

}  // namespace

Experiment scattering_experiment(Effort effort, const Faults& faults) {
  const int most = by_effort(effort, 256, 64, 16), by_albedo = by_effort(effort, 64, 32, 8), edge = 16;
  Experiment e;
  e.number = "E13", e.name = "scattering", e.title = "Light inside bodies";
  e.question = "What comes back from milk, and how far off is it to put two lamps in place of all that is scattered?";
  e.weight = 0.5;
  e.columns = {"samples or absorbed", "rms_error", "ratio"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    // Under diffuse light each round looks from cosines of its own, one from each eighth of what is reflected.
    const auto look = [&](const std::string& name, double knob, double albedo, int samples, Incidence incidence,
                          Subsurface subsurface) {
      const HalfSpace& exact = half_space_of(albedo);
      const int angles = incidence == Incidence::normal ? 1 : 8;
      double mean = 0, squares = 0, shown = 0;
      Cost cost;
      for (int i = 0; i < angles; ++i) {
        const double cos = angles == 1 ? 1 : std::sqrt((i + drawn_for(round, i)) / angles);
        const Shot shot = shoot(milk(albedo, cos, subsurface), {edge, edge / angles},
                                {samples, seed_of(round * angles + i)}, faults.shuffled_seed, PathSettings{}, stop);
        const double seen = faults.reference * exact.reflectance_at(cos);
        const Compared off = compared(shot.film, [&](int, int) { return seen; });
        mean += off.mean / angles, squares += off.rms * off.rms / angles, shown += (off.mean + seen) / angles;
        cost.rays += shot.cost.rays, cost.tests += shot.cost.tests, cost.draws += shot.cost.draws;
        cost.seconds += shot.cost.seconds;
      }
      const double truth = faults.reference * exact.reflectance(incidence);
      if (subsurface == Subsurface::walk)
        trials.push_back({round, name, knob, std::sqrt(squares) / truth, 1 + mean / truth, cost});
      else  // alike from everywhere
        trials.push_back({round, name, knob, std::abs(shown / truth - 1), shown / truth, cost});
    };
    for (const Incidence incidence : incidences) {
      for (int n = 1; n <= most; n *= 4) {
        if (stop.asked()) return trials;
        look("walks " + name_of(incidence), n, albedo_of_curves, n, incidence, Subsurface::walk);
      }
      for (const double albedo : albedos) {
        if (stop.asked()) return trials;
        look("by albedo " + name_of(incidence), 1 - albedo, albedo, by_albedo, incidence, Subsurface::walk);
        look("dipole " + name_of(incidence), 1 - albedo, albedo, by_albedo, incidence, Subsurface::dipole);
      }
    }
    return trials;
  };
  e.conclude = [=](const std::vector<Trial>& trials) { return conclude_scattering(trials, most); };
  return e;
}

}  // namespace raywalk::study
