// E8: does "known to X with 95% confidence" hold for 95% of the pixels?
#include "image/srgb.h"
#include "render/render.h"
#include "study/curve.h"
#include "study/subjects.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace raywalk::study {

namespace {

std::vector<Subject> subjects() { return {smooth_subject(), edge_subject(), lens_subject()}; }

double shown_as(double linear) { return srgb_encode(std::clamp(linear, 0.0, 1.0)); }

Report conclude_adaptive(const std::vector<Trial>& trials) {
  Report report;
  Plot share, price;
  share.title = "Pixels that are off by more than the tolerance";
  share.x_label = "tolerance X, of what a screen shows from 0 to 1";
  share.y_label = "share of the pixels";
  share.log_y = false;
  share.ceiling = 0.05, share.ceiling_name = "the 5% that 95% confidence allows";
  price.title = "What the tolerance costs on edges";
  price.x_label = "tolerance X";
  price.y_label = "samples a pixel, mean";
  for (const Sampler sampler : values_of<Sampler>) {
    const std::string name(name_of(sampler));
    for (const Subject& subject : subjects()) {
      const std::string method = name + " " + subject.name;
      const ErrorCurve curve(trials, method, error_of, Pool::mean);
      // The worst tolerance, determined anew in each resample.
      const Estimate worst = bootstrap(curve.rounds(), [&](const std::vector<int>& rounds) {
        double most = 0;
        for (std::size_t i = 0; i < curve.knobs().size(); ++i) most = std::max(most, curve.at(i, rounds));
        return most;
      });
      report.laws.push_back(
          {name + ", " + subject.name, "at every tolerance at most 5% of the pixels are off by more", LawKind::at_most,
           0.05, worst, 0,
           "A pixel stops when its samples agree. Where a thin sliver of light slips between the first 16 samples of a "
           "pixel and of its neighbours, they agree on what is wrong: no confidence can be put in what was never "
           "met."});
      if (sampler == Sampler::random || subject.name == "edge")
        share.series.push_back(curve.series(name + ", " + subject.name));
      if (subject.name == "edge") price.series.push_back(ErrorCurve(trials, method, other_of, Pool::mean).series(name));
    }
  }
  report.figures.push_back(
      {share,
       "Adaptive sampling stops at a pixel once the 95% interval of its mean lies within X. Here the right answers are "
       "known, so that the promise can be counted: which share of the pixels is off by more than X in the end? At most "
       "5% may be. Pixels of flat colour are always right and would flatter the count, so that only pixels on edges, "
       "in the blur of a lens and under a changing light are looked at. Samples that are placed well err less than the "
       "interval, made for random ones, supposes."});
  report.figures.push_back(
      {price,
       "Half the tolerance takes up to four times the samples: the price of noise that falls as one over the root. On "
       "edges jittered and Sobol's samples cost as much as random ones here: the interval does not know that they are "
       "better, and the surplus shows as the smaller share of wrong pixels on the left."});
  return report;
}

}  // namespace

Experiment adaptive_experiment(Effort effort) {
  const int edge = effort == Effort::full ? 16 : 8;
  const double least = effort == Effort::glance ? 0.05 : effort == Effort::quick ? 0.02 : 0.01;
  Experiment e;
  e.number = "E8", e.name = "adaptive", e.title = "Adaptive sampling";
  e.question = "A pixel is sampled until it is known to X with 95% confidence. Is it, in 95% of the cases?";
  e.weight = 11;
  e.columns = {"tolerance", "share_off_by_more", "samples_a_pixel"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    for (double tolerance = 0.16; tolerance > 0.9 * least; tolerance /= 2)
      for (Subject& subject : subjects())
        for (const Sampler sampler : values_of<Sampler>) {
          if (stop.asked()) return trials;
          subject.scene.render.sampler = sampler;
          RenderSettings settings{ImageSize{edge, edge}, {1 << 16, seed_of(round)}};
          settings.threads = 1;
          settings.stop = stop;
          settings.tolerance = tolerance;
          const double start = thread_seconds();
          const auto rendering = render(subject.scene, settings);
          const double seconds = thread_seconds() - start;
          if (!rendering || !rendering->finished) return trials;
          int counted = 0, off = 0;
          for_each_pixel(subject, rendering->film_of<double>(), [&](double shown, double truth) {
            ++counted;
            if (std::abs(shown_as(shown) - shown_as(truth)) > tolerance) ++off;
          });
          const double taken = static_cast<double>(rendering->statistics.formed(RayKind::primary)) / (edge * edge);
          trials.push_back({round, std::string(name_of(sampler)) + " " + subject.name, tolerance,
                            static_cast<double>(off) / counted, taken, cost_of(rendering->statistics, seconds)});
        }
    return trials;
  };
  e.conclude = conclude_adaptive;
  return e;
}

}  // namespace raywalk::study
