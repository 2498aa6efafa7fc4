// E7: what each structure costs to build and to search, by the number of objects.
#include "accel/accelerator.h"
#include "study/curve.h"
#include "study/shot.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace raywalk::study {

namespace {

using Kind = AcceleratorKind;
constexpr std::array structures{Kind::none, Kind::spheres, Kind::ellipsoids, Kind::boxes,
                                Kind::bvh,  Kind::grid,    Kind::octree,     Kind::kdtree};
/// Without a hierarchy, every ray is tested against every object or its volume.
constexpr bool is_flat(Kind kind) { return kind <= Kind::boxes; }

/// Points of the cube from -size to size.
class Points {
 public:
  explicit Points(int round, int which) : round_(round), next_(which) {}
  double number(double low, double high) { return low + (high - low) * drawn_for(round_, next_++); }
  Vec3d point(double size) {
    const double x = number(-size, size), y = number(-size, size), z = number(-size, size);
    return {x, y, z};
  }

 private:
  int round_, next_;
};

/// Spheres scattered over a cube; equally dense for any number, so that a ray has about equally many around it.
Primitives<double> field(int count, int round) {
  Points random(round, 1 << 20);
  const double spacing = 2 * std::cbrt(1.0 / count);
  Primitives<double> spheres;
  for (int i = 0; i < count; ++i) spheres.add(Sphere<double>{random.point(1), 0.25 * spacing});
  return spheres;
}

std::vector<Ray<double>> rays_into(int count, int round) {
  Points random(round, 0);
  std::vector<Ray<double>> rays;
  for (int i = 0; i < count; ++i) {
    const Vec3d from = 3.0 * normalize(random.point(1)), at = random.point(1);
    rays.push_back({from, normalize(at - from)});
  }
  return rays;
}

/// A digest of all answers, bit by bit.
std::uint64_t digest(std::uint64_t so_far, const std::optional<Hit<double>>& hit) {
  const std::uint64_t bits =
      hit ? std::bit_cast<std::uint64_t>(hit->t) ^ static_cast<std::uint64_t>(hit->primitive) << 1 : 0x6d697373;
  return (so_far ^ bits) * 0x9e3779b97f4a7c15u + (so_far >> 29);
}

TrialValue microseconds() {
  return [](const Trial& t) { return 1e6 * t.cost.seconds / static_cast<double>(t.cost.rays); };
}

Report conclude_structures(const std::vector<Trial>& trials) {
  Report report;
  Plot work, time, build, even;
  work.title = "What a ray meets, by the number of spheres";
  work.x_label = time.x_label = build.x_label = even.x_label = "spheres, N";
  work.y_label = "nodes and spheres tested for a ray";
  time.title = "What a ray takes";
  time.y_label = "microseconds, median";
  build.title = "What building takes";
  build.y_label = "seconds, median";
  even.title = "From how many rays on building pays";
  even.y_label = "rays until it is cheaper than no structure";
  const ErrorCurve none(trials, std::string(name_of(Kind::none)), microseconds(), Pool::median);
  for (const Kind kind : structures) {
    const std::string name(name_of(kind));
    const ErrorCurve curve(trials, name, error_of, Pool::mean);
    const auto look =
        static_cast<std::size_t>(std::find(structures.begin(), structures.end(), kind) - structures.begin());
    const auto add = [&](Plot& plot, PlotSeries more) {
      more.look = look;
      plot.series.push_back(std::move(more));
    };
    PlotSeries series = curve.series(name);
    if (kind == Kind::none) series.law = 1, series.law_name = "N";
    add(work, series);
    const ErrorCurve seconds(trials, name, microseconds(), Pool::median);
    add(time, seconds.series(name));
    const ErrorCurve built(trials, name, other_of, Pool::median);
    if (kind != Kind::none) add(build, built.series(name));
    PlotSeries pays{name, {}};
    for (std::size_t i = 0; i < curve.knobs().size() && i < none.knobs().size() && kind != Kind::none; ++i) {
      const double saved = 1e-6 * (none.at(i) - seconds.at(i));
      if (saved > 0) pays.points.push_back({curve.knobs()[i], built.at(i) / saved, 0, 0});
    }
    for (PlotPoint& p : pays.points) p.low = p.high = p.y;
    if (!is_flat(kind)) add(even, pays);
    if (kind == Kind::none)
      report.laws.push_back({"none", "every ray meets all N", LawKind::exact, 1, curve.exponent(1, 1e9), 1e-9,
                             "Without a structure nothing can be left out, nor tested twice."});
    const std::size_t n = curve.knobs().size();
    if (is_flat(kind) || n < 3) continue;
    // a + b log N: each factor in N adds the same cost. Less is better.
    const Estimate bend = bootstrap(curve.rounds(), [&](const std::vector<int>& rounds) {
      const double last = curve.at(n - 1, rounds) - curve.at(n - 2, rounds);
      const double before = curve.at(n - 2, rounds) - curve.at(n - 3, rounds);
      return last - before;
    });
    report.laws.push_back({name,
                           "a ray's cost grows no faster than log N: the last ten-fold adds no more than the one "
                           "before",
                           LawKind::at_most, 0, bend, 0,
                           "Few spheres leave rays that meet nothing; the law is one of the limit.",
                           "what the last ten-fold adds to a ray's nodes and tests, less what the one before added"});
  }
  double different = 0;
  for (const Trial& t : trials) {
    if (t.method != "answers") continue;
    different += t.error;
  }
  report.laws.push_back({"same answers",
                         "all structures find the same sphere at the same t, bit for bit",
                         LawKind::exact,
                         0,
                         {different, 0, 0},
                         0,
                         "A structure would miss spheres, or find those behind.",
                         "how many structures answered otherwise"});
  report.figures.push_back(
      {work,
       "Spheres strewn evenly over a cube, as dense for every N. Without a structure a ray meets all of them: a line "
       "of "
       "slope 1. A volume around each (sphere, ellipsoid or box) makes each test cheaper and leaves their number. In a "
       "hierarchy ten times the spheres add about the same few nodes each time: the curves flatten. A grid is at home "
       "in such an even field; with clusters it would not be."});
  report.figures.push_back(
      {time,
       "The same in time. Counting nodes and tests says how costs grow, the clock says what one of them weighs: a "
       "cell of a grid is cheaper than a node of a tree."});
  report.figures.push_back({build, "Before the first ray, the structure has to be made; that grows about as N log N."});
  report.figures.push_back(
      {even,
       "Time to build, over the time that a ray then saves: from that many rays on the structure has paid for "
       "itself. A small picture has 150,000 rays to the eye alone."});
  return report;
}

}  // namespace

Experiment structures_experiment(Effort effort) {
  constexpr int least = 100;
  const int most = effort == Effort::full ? 100000 : 10000;
  const int rays = by_effort(effort, 4000, 1000, 100);
  Experiment e;
  e.number = "E7", e.name = "structures", e.title = "Structures over the scene";
  e.question = "What does a ray cost among N things, and when does building a structure pay?";
  e.weight = 4;
  e.columns = {"spheres", "tested_a_ray", "build_seconds"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    for (int count = least; count <= most; count *= 10) {
      const Primitives<double> spheres = field(count, round);
      constexpr int few = 100;  // rays, for structures that test everything
      const std::vector<Ray<double>> all = rays_into(rays, round);
      std::optional<std::uint64_t> right;
      int different = 0;
      for (const Kind kind : structures) {
        if (stop.asked()) return trials;
        if (is_flat(kind) && count > 10000) continue;  // their growth is known by then
        const double before = thread_seconds();
        const Accelerator<double> accelerator(spheres, kind);
        const double start = thread_seconds();
        TestCounts counts;
        std::uint64_t of_few = 0, answers = 0;
        const std::size_t asked = is_flat(kind) && count > 1000 ? few : all.size();
        for (std::size_t i = 0; i < asked; ++i) {
          const auto hit = accelerator.closest(all[i], infinity<double>, counts);
          answers = digest(answers, hit);
          if (i + 1 == few) of_few = answers;
        }
        const double seconds = thread_seconds() - start;
        const Cost cost{asked, counts.nodes, counts.primitives, 0, seconds};
        trials.push_back({round, std::string(name_of(kind)), static_cast<double>(count),
                          static_cast<double>(counts.nodes + counts.primitives) / static_cast<double>(asked),
                          start - before, cost});
        if (!right) right = of_few;
        different += of_few == *right ? 0 : 1;
      }
      trials.push_back({round, "answers", static_cast<double>(count), static_cast<double>(different), 0, {}});
    }
    return trials;
  };
  e.conclude = conclude_structures;
  return e;
}

}  // namespace raywalk::study
