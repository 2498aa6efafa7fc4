// E3: how the error of a pixel falls with its samples, by sampler.
#include "study/curve.h"
#include "study/subjects.h"

#include <array>
#include <cmath>

namespace raywalk::study {

namespace {

/// Root mean square over the pixels that count.
double error_in(const Subject& subject, const Film<double>& film, double factor) {
  double squares = 0;
  int counted = 0;
  for_each_pixel(subject, film, [&](double shown, double truth) {
    squares += (shown - factor * truth) * (shown - factor * truth);
    ++counted;
  });
  return std::sqrt(squares / counted);
}

struct ExpectedBySampler {
  double smooth, edge;
  std::string smooth_name, edge_name, why;
};
ExpectedBySampler expected_of(Sampler sampler) {
  switch (sampler) {
    case Sampler::random:
      return {-0.5, -0.5, "N^-1/2", "N^-1/2", "each sample by itself, the central limit theorem"};
    case Sampler::jittered:
      return {-1, -0.75, "N^-1", "N^-3/4", "what varies is left within a cell, or in the sqrt(N) cells of an edge"};
    case Sampler::sobol:
      return {-1.5, -0.75, "N^-3/2", "N^-3/4", "a scrambled net (A. Owen 1997; Z. He and X. Wang 2015)"};
  }
  return {};
}

/// Owen's bound for smooth integrands in two dimensions is N^-3/2 sqrt(log N): over the fitted range of N, that is this
/// exponent.
double owen_bound(double least, double most) {
  std::vector<double> x, y;
  for (double n = least; n <= most; n *= 4)
    x.push_back(std::log(n)), y.push_back(-1.5 * x.back() + std::log(x.back()) / 2);
  return fit_line(x, y).slope;
}

Report conclude_samples(const std::vector<Trial>& trials, double most) {
  Report report;
  for (const char* subject : {"smooth", "edge"}) {
    const bool smooth = std::string(subject) == "smooth";
    Plot plot;
    plot.title = smooth ? "A smooth pixel: error against samples" : "A pixel on an edge: error against samples";
    plot.x_label = "samples of a pixel, N (each is one ray to the eye)";
    plot.y_label = "root mean square error, light of 0 to 1";
    Plot cost = plot;
    cost.title = smooth ? "A smooth pixel: error against time" : "A pixel on an edge: error against time";
    cost.x_label = "processor seconds a picture, median";
    for (const Sampler sampler : values_of<Sampler>) {
      const std::string name(name_of(sampler)), method = name + " " + subject;
      const ErrorCurve curve(trials, method);
      const ExpectedBySampler law = expected_of(sampler);
      PlotSeries series = curve.series(name);
      series.law = smooth ? law.smooth : law.edge;
      const std::string series_law = smooth ? law.smooth_name : law.edge_name;
      series.law_name = series_law;
      plot.series.push_back(series);
      cost.series.push_back(curve.series(name, [](const Trial& t) { return t.cost.seconds; }));
      constexpr double least = 16;
      Law judged{name + ", " + subject,
                 "error falls as " + series_law + ": " + law.why,
                 LawKind::equals,
                 smooth ? law.smooth : law.edge,
                 curve.exponent(least, most),
                 0,
                 "Such a law holds in the limit. Where the fit excludes it, N is not yet large enough for what the "
                 "pixel holds, or something is wrong with the sampler or the reference."};
      if (smooth && sampler == Sampler::sobol) {
        judged.says = "error falls at least as fast as N^-3/2 sqrt(log N): " + law.why;
        judged.kind = LawKind::at_most;
        judged.expected = owen_bound(least, most);
      }
      report.laws.push_back(std::move(judged));
    }
    if (smooth) plot.floor = 3e-8, plot.floor_name = "step of the numbers drawn, 2^-25";
    report.figures.push_back(
        {plot, smooth ? "A floor under a point light: over a pixel the light changes smoothly, and its mean is a solid "
                        "angle, known exactly. Random samples clump and leave gaps; four times the samples halve the "
                        "error, whatever is in the pixel. Jittered samples cannot clump: with N cells each sample only "
                        "has to speak for its own. Sobol's samples fill rows and columns evenly besides, and where all "
                        "is smooth that pays most. (One sample alone stands in the middle of its "
                        "pixel, not at random.)"
                      : "The edge of a glowing disk: a sample is inside or outside, and the exact answer is the area "
                        "of the pixel that the disk covers. Cells wholly inside or outside make no error; only the "
                        "sqrt(N) cells that the edge crosses do. That is why well placed samples still win, but by "
                        "less than where all is smooth."});
    report.figures.push_back(
        {cost,
         "The same errors against what they cost. A ray meets little here, so that the care with which a sample "
         "is placed shows in its time, up to twice that of a random one; among more objects it would not. Even so "
         "the curve that lies lower is the better bargain. Read across: the same error for how much less time?"});
  }
  return report;
}

}  // namespace

Experiment samples_experiment(Effort effort, const Faults& faults) {
  const int edge = effort == Effort::full ? 16 : 8;
  const int most = by_effort(effort, 4096, 1024, 256);
  Experiment e;
  e.number = "E3", e.name = "samples", e.title = "Samples and samplers";
  e.question = "How much better is a pixel when it takes four times the samples, and does it matter where they lie?";
  e.weight = 2;
  e.columns = {"samples", "rms_error", "pixels"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    for (int n = 1; n <= most; n *= 4)
      for (const Subject& from : {smooth_subject(), edge_subject()})
        for (const Sampler sampler : values_of<Sampler>) {
          if (stop.asked()) return trials;
          Subject subject = from;
          subject.scene.render.sampler = sampler;
          Camera& camera = subject.scene.camera;
          camera.eye.x = camera.look_at.x = faults.shifted * pixel_at(0, 0, edge).area() / 2 * edge;
          const Shot shot = shoot(subject.scene, {edge, edge}, {n, seed_of(round)}, faults.shuffled_seed);
          trials.push_back({round, std::string(name_of(sampler)) + " " + subject.name, static_cast<double>(n),
                            error_in(subject, shot.film, faults.reference), static_cast<double>(edge * edge),
                            shot.cost});
        }
    return trials;
  };
  e.conclude = [=](const std::vector<Trial>& trials) { return conclude_samples(trials, most); };
  return e;
}

}  // namespace raywalk::study
