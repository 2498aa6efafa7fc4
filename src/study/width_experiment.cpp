// E15: rays with width: beams and cones against samples, at equal numbers and at equal time, and where they lose.
#include "study/curve.h"
#include "study/subjects.h"

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>
#include <utility>

namespace raywalk::study {

namespace {

constexpr int edge_of_picture = 24;

Material glowing() {
  Material material;
  material.diffuse = Rgbd(0.0);
  material.emission = Rgbd(1.0);
  return material;
}

/// Two sheets that share an edge, which runs through a column of pixels: nothing is seen between them.
Subject halves(int round) {
  const double at = (drawn_for(round, 0) - 0.5) / 2, far = 9;
  Subject made = edge_subject();
  made.name = "shared edge", made.only_edges = false;
  made.scene.objects = {
      {"Left", Polygon<double>{{{-far, -far, 0}, {at, -far, 0}, {at, far, 0}, {-far, far, 0}}, {}}, glowing()},
      {"Right", Polygon<double>{{{at, -far, 0}, {far, -far, 0}, {far, far, 0}, {at, far, 0}}, {}}, glowing()}};
  made.truth = [](const Rectangle&) { return 1.0; };
  return made;
}

/// Four discs a pixel, each a quarter of it wide, one in each quarter.
Subject crumbs(int round) {
  constexpr int side = 2 * edge_of_picture;
  constexpr double quarter = 2.0 / side, radius = quarter / 4;
  Subject made = edge_subject();
  made.name = "crumbs", made.only_edges = false;
  made.scene.objects.clear();
  for (int i = 0; i < side * side; ++i) {
    const double x = quarter * (i % side + 0.5 + 0.4 * (drawn_for(round, 2 * i) - 0.5)) - 1;
    const double y = quarter * (i / side + 0.5 + 0.4 * (drawn_for(round, 2 * i + 1) - 0.5)) - 1;
    made.scene.objects.push_back({"Crumb", Disk<double>{{x, y, 0}, {0, 0, 1}, radius}, glowing()});
  }
  const double share = std::numbers::pi * radius * radius / (quarter * quarter);
  made.truth = [share](const Rectangle&) { return share; };
  return made;
}

/// A ball that mirrors, under a glowing ceiling: of the disc that it is seen as, what shows the ceiling is a smaller
/// one. Where a ray that meets the ball at the angle a from its top goes up, it came at the angle b to the vertical,
/// and 2 a + b is less than a quarter turn; by the law of sines, 2 sin b = R sin(a + b).
Subject curved(int round) {
  const double radius = 0.6 + 0.3 * drawn_for(round, 0), above = 2;
  double low = 0, high = std::numbers::pi / 4;
  for (int i = 0; i < 100; ++i) {
    const double a = (low + high) / 2, b = std::numbers::pi / 2 - 2 * a;
    // At this a the ray from the eye has a smaller b than that as long as the reflected one goes up.
    const double at = std::atan2(radius * std::sin(a), above - radius * std::cos(a));
    (at < b ? low : high) = a;
  }
  const double rim = above * radius * std::sin(low) / (above - radius * std::cos(low));
  Subject made = edge_subject();
  made.name = "curved mirror", made.only_edges = true;
  Material mirror;
  mirror.diffuse = Rgbd(0.0);
  mirror.reflection = Rgbd(1.0);
  made.scene.objects = {{"Ball", Sphere<double>{{0, 0, 0}, radius}, mirror},
                        {"Ceiling", Plane<double>{{0, 0, 5}, {0, 0, -1}}, glowing()}};
  made.truth = [rim](const Rectangle& pixel) { return disk_area_in(pixel, rim) / pixel.area(); };
  return made;
}

Subject subject_of(int which, int round) {
  if (which == 3) return curved(round);
  if (which == 1) return halves(round);
  if (which == 2) return crumbs(round);
  Subject edge = edge_subject();
  // Another place of the disc's edge in each round.
  const Vec2d off{0.08 * (drawn_for(round, 0) - 0.5), 0.08 * (drawn_for(round, 1) - 0.5)};
  std::get<Disk<double>>(edge.scene.objects[0].shape).centre = {off.x, off.y, 0};
  const auto truth = edge.truth;
  edge.truth = [=](const Rectangle& pixel) {
    return truth({pixel.x0 - off.x, pixel.x1 - off.x, pixel.y0 - off.y, pixel.y1 - off.y});
  };
  return edge;
}
constexpr std::array subjects{"edge", "shared edge", "crumbs", "curved mirror"};
constexpr std::size_t crumbs_subject = 2, curved_mirror = 3;

constexpr std::array<std::pair<std::string_view, Integrator>, 3> methods{
    {{"samples", Integrator::distributed}, {"cones", Integrator::cones}, {"beams", Integrator::beams}}};

/// How many times the error of one beam or cone that of some samples a pixel is.
Estimate against_one(const std::string& method, const std::vector<Trial>& trials, const std::string& subject,
                     std::size_t samples) {
  const ErrorCurve wide(trials, method + " " + subject), many(trials, "samples " + subject);
  return bootstrap(wide.rounds(),
                   [&](const std::vector<int>& rounds) { return many.at(samples, rounds) / wide.at(0, rounds); });
}

/// The same at equal time: of as many samples as take as long as one beam or cone, by their curve of error against
/// time, straight in logarithms from point to point, and beyond its ends.
Estimate at_equal_time(const std::string& method, const std::vector<Trial>& trials, const std::string& subject) {
  const auto seconds = [](const Trial& trial) { return trial.cost.seconds; };
  const std::string one = method + " " + subject, other = "samples " + subject;
  const ErrorCurve wide(trials, one), wide_times(trials, one, seconds, Pool::median);
  const ErrorCurve many(trials, other), many_times(trials, other, seconds, Pool::median);
  return bootstrap(wide.rounds(), [&](const std::vector<int>& rounds) {
    const double time = wide_times.at(0, rounds);
    std::size_t to = many.knobs().size() - 1;
    while (to > 1 && many_times.at(to - 1, rounds) > time) --to;
    const auto log_of = [&](const ErrorCurve& curve, std::size_t knob) { return std::log(curve.at(knob, rounds)); };
    const double from = log_of(many_times, to - 1);
    const double way = (std::log(time) - from) / (log_of(many_times, to) - from);
    return std::exp(std::lerp(log_of(many, to - 1), log_of(many, to), way)) / wide.at(0, rounds);
  });
}

/// What is clear by factors, for other machines have other times. Of two sheets that share an edge samples err by
/// nothing.
struct EqualTime {
  const char *method, *subject, *says;
  LawKind kind;
  double expected;
};
constexpr EqualTime at_equal_times[] = {
    {"cones", "edge", "one cone errs less than three times as much as samples", LawKind::at_least, 1.0 / 3},
    {"cones", "crumbs", "one cone errs more than samples", LawKind::at_most, 1},
    {"cones", "curved mirror", "one cone errs less than three times as much as samples", LawKind::at_least, 1.0 / 3},
    {"beams", "edge", "one beam errs less than samples", LawKind::at_least, 1},
    {"beams", "crumbs", "four beams err less than samples", LawKind::at_least, 1},
    {"beams", "curved mirror", "one beam errs more than twice as much as samples", LawKind::at_most, 0.5},
};

Report conclude_width(const std::vector<Trial>& trials) {
  Report report;
  const std::array texts{
      "A glowing disc, of which a pixel at its edge sees a part. A beam is cut by it exactly, but for the 64 sides "
      "that stand for a circle. A cone meets the same sides; what it errs by is that a cone is round and a pixel is "
      "square. In the time of one cone samples say about as much; in that of one beam they err more.",
      "Two sheets side by side, with nothing between them. Samples are right, and so are beams, which know where each "
      "sheet is. A cone knows how much each covers, not where, and takes the second to cover a part of what the first "
      "has left: of two halves a quarter is lost.",
      "Four small discs in each pixel. A beam is cut by all of them, and pays for each, but in as long samples err "
      "more. A cone takes each as if it had nothing to do with the others, although none hides another; more cones a "
      "pixel see fewer each. It pays for each, too, and in as long samples err less.",
      "The edge of a ceiling in a ball that mirrors. No beam comes back from a ball as a beam: one ray from the middle "
      "of each part has to do, and the edge is as jagged as by samples, which take less time. A cone only grows wider, "
      "and errs about as much as samples that take as long."};
  for (std::size_t i = 0; i < subjects.size(); ++i) {
    Plot plot;
    plot.title = std::string("Error against time: ") + subjects[i];
    plot.x_label = "processor seconds a picture, median";
    plot.y_label = "root mean square error, of 0 to 1";
    for (const auto& [name, integrator] : methods) {
      const std::string method(name);
      const ErrorCurve curve(trials, method + " " + subjects[i]);
      plot.series.push_back(curve.series(method, [](const Trial& trial) { return trial.cost.seconds; }));
    }
    report.figures.push_back({plot, texts[i]});
  }
  report.laws.push_back({"cones, edge", "one cone errs less than 4 samples", LawKind::at_least, 1,
                         against_one("cones", trials, "edge", 1), 0, "A cone is round, and pixels are square."});
  report.laws.push_back({"cones, crumbs", "one cone errs less than 1 sample", LawKind::at_least, 1,
                         against_one("cones", trials, "crumbs", 0), 0, "Too many things share the cone."});
  report.laws.push_back({"beams, edge", "one beam errs less than 16 samples", LawKind::at_least, 1,
                         against_one("beams", trials, "edge", 2), 0, "Its edges are those of polygons."});
  report.laws.push_back({"beams, crumbs", "four beams err less than 16 samples", LawKind::at_least, 1,
                         against_one("beams", trials, "crumbs", 2), 0, "It is cut by everything."});
  report.laws.push_back({"beams, shared edge", "nothing is seen between two that share an edge", LawKind::at_most, 1e-9,
                         ErrorCurve(trials, "beams shared edge").estimate(0), 0, "Its parts are the pixel."});
  report.laws.push_back({"beams, curved mirror", "one beam errs more than 16 samples", LawKind::at_most, 1,
                         against_one("beams", trials, "curved mirror", 2), 0, "One ray of each part is reflected."});
  for (const EqualTime& at : at_equal_times)
    report.laws.push_back({std::string(at.method) + ", " + at.subject + ", equal time", at.says, at.kind, at.expected,
                           at_equal_time(at.method, trials, at.subject), 0, "Its time is not that of other machines."});
  const ErrorCurve leak(trials, "cones shared edge");
  report.laws.push_back({"cones, shared edge", "an edge that two share is seen through", LawKind::at_least, 0.01,
                         leak.estimate(0), 0, "Shares would have to say where they are."});
  return report;
}

}  // namespace

Experiment width_experiment(Effort effort) {
  const int most = by_effort(effort, 1024, 256, 64);
  Experiment e;
  e.number = "E15", e.name = "width", e.title = "Rays with width";
  e.question = "Is one beam or cone a pixel worth more than many rays, and where is it not?";
  e.columns = {"a_pixel", "rms_error", "mean_error"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    for (std::size_t which = 0; which < subjects.size(); ++which)
      for (int n = 1; n <= most; n *= 4)
        for (const auto& [method, integrator] : methods) {
          if (stop.asked()) return trials;
          if (traits_of(integrator).has_width && n > 16) continue;
          // Where nothing changes within a part, more beams see the same; of many crumbs a few see theirs sooner.
          if (integrator == Integrator::beams && which != curved_mirror && n != (which == crumbs_subject ? 4 : 1))
            continue;
          Subject subject = subject_of(static_cast<int>(which), round);
          subject.scene.render.integrator = integrator;
          const Shot shot = shoot(subject.scene, {edge_of_picture, edge_of_picture}, {n, seed_of(round)});
          double squares = 0, sum = 0;
          int count = 0;
          for_each_pixel(subject, shot.film, [&](double shown, double truth) {
            squares += (shown - truth) * (shown - truth), sum += shown - truth, ++count;
          });
          trials.push_back({round, std::string(method) + " " + subjects[which], static_cast<double>(n),
                            std::sqrt(squares / count), sum / count, shot.cost});
        }
    return trials;
  };
  e.conclude = conclude_width;
  return e;
}

}  // namespace raywalk::study
