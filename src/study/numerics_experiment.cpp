// E1: the arithmetic of one intersection test, from float to exact, on rays that nearly touch a sphere.
#include "math/expansion.h"
#include "shape/naive.h"
#include "study/curve.h"
#include "study/shot.h"

#include <array>
#include <cmath>
#include <numbers>

namespace raywalk::study {

namespace {

template <class T>
struct Aimed {
  Sphere<T> sphere;
  Ray<T> ray;
};

/// Past a sphere many radii away, almost tangent: off by 2^-3 of a radius down to the last digits of T.
template <class T>
Aimed<T> aimed(int round, int which, double distance) {
  int dimension = 0;
  const auto draw = [&] { return drawn_for(round, 16 * which + dimension++); };
  const Vec3d centre(2 * draw() - 1, 2 * draw() - 1, 2 * draw() - 1);
  const Vec3d way = sample_uniform_sphere(Vec2d(draw(), draw()));
  const Basis<double> across(way);
  const double turn = 2 * std::numbers::pi * draw();
  constexpr int digits = std::numeric_limits<T>::digits;
  const double side = draw() < 0.5 ? -1 : 1, radius = 0.5 + draw();
  const double aside = radius * (1 + side * std::exp2(-3 - (digits - 3) * draw()));
  const Vec3d origin =
      centre - distance * radius * way + aside * (std::cos(turn) * across.s + std::sin(turn) * across.t);
  return {{Vec3<T>(centre), static_cast<T>(radius)}, {Vec3<T>(origin), Vec3<T>(way)}};
}

/// The ray's intersection with the sphere, from the numbers as stored: the sign of b^2 - a c decided exactly, t rounded
/// once. NaN: a miss.
template <class T>
double truth(const Aimed<T>& at) {
  Expansion a, b, c = -(Expansion(static_cast<double>(at.sphere.radius)) * static_cast<double>(at.sphere.radius));
  for (int axis = 0; axis < 3; ++axis) {
    const auto d = static_cast<double>(at.ray.direction[axis]);
    const Expansion o =
        Expansion(static_cast<double>(at.ray.origin[axis])) - static_cast<double>(at.sphere.centre[axis]);
    a = a + Expansion(d) * d, b = b + o * d, c = c + o * o;
  }
  const Expansion discriminant = b * b - a * c;
  if (discriminant.sign() < 0) return NAN;
  // Towards the sphere b < 0: nothing cancels.
  return static_cast<double>(c.rounded() / (sqrt(discriminant.rounded()) - b.rounded()));
}

/// The textbook formula, b^2 - 4ac, as the naive tracer computes it, with numbers of type N. NaN: a miss.
template <class N, class T>
double textbook(const Aimed<T>& at) {
  const Sphere<N> sphere{Vec3<N>(at.sphere.centre), static_cast<N>(at.sphere.radius)};
  const NaiveRay<N> ray{{Vec3<N>(at.ray.origin), Vec3<N>(at.ray.direction)}};
  const auto crossing = intersect(sphere, ray, infinity<N>);
  return crossing ? static_cast<double>(crossing->t) : NAN;
}

/// a r^2 - |o x d|^2 (E. Haines et al., Ray Tracing Gems, ch. 7, 2019).
double perpendicular(const Aimed<double>& at) {
  const Vec3d o = at.ray.origin - at.sphere.centre, d = at.ray.direction, m = cross(o, d);
  const double a = dot(d, d), discriminant = a * at.sphere.radius * at.sphere.radius - dot(m, m);
  return discriminant < 0 ? NAN : (-dot(o, d) - std::sqrt(discriminant)) / a;
}

double double_double(const Aimed<double>& at) {
  DoubleDouble a, b, c = -two_product(at.sphere.radius, at.sphere.radius);
  for (int axis = 0; axis < 3; ++axis) {
    const DoubleDouble o = two_sum(at.ray.origin[axis], -at.sphere.centre[axis]), d(at.ray.direction[axis]);
    a = a + d * d, b = b + o * d, c = c + o * o;
  }
  const DoubleDouble discriminant = b * b - a * c;
  return discriminant.hi < 0 ? NAN : static_cast<double>((-b - sqrt(discriminant)) / a);
}

/// Exact arithmetic for each ray.
double exact(const Aimed<double>& at) {
  const detail::SphereTerms terms =
      detail::exact_sphere_terms(at.ray.origin, at.ray.direction, at.sphere.centre, at.sphere.radius);
  const Vec3d o = at.ray.origin - at.sphere.centre;
  return terms.discriminant.hi < 0
             ? NAN
             : static_cast<double>((DoubleDouble(-dot(o, at.ray.direction)) - sqrt(terms.discriminant)) /
                                   DoubleDouble(dot(at.ray.direction, at.ray.direction)));
}

/// Raywalk's own: the perpendicular form with an error bound, and exact arithmetic where the bound requires it.
template <class T>
double filtered(const Aimed<T>& at) {
  const auto crossing = intersect(at.sphere, at.ray, infinity<T>);
  return crossing ? static_cast<double>(crossing->t) : NAN;
}

struct Method {
  const char *name, *says;
};
constexpr std::array<Method, 8> methods{{{"float", "textbook, 24 bits"},
                                         {"float in, double inside", "the same rays, computed with 53 bits"},
                                         {"double", "textbook, 53 bits"},
                                         {"perpendicular", "53 bits, what is large left out"},
                                         {"double-double", "about 106 bits"},
                                         {"exact", "as many bits as it takes"},
                                         {"filtered float", "Raywalk's, 24-bit rays"},
                                         {"filtered double", "Raywalk's, 53-bit rays"}}};

double nanoseconds(const Trial& t) { return 1e9 * t.cost.seconds / static_cast<double>(t.cost.rays); }

Report conclude_numerics(const std::vector<Trial>& trials) {
  Report report;
  Plot wrong, bargain;
  wrong.title = "Near the outline: rays decided wrongly, by distance";
  wrong.x_label = "distance of the ray's origin, in radii";
  wrong.y_label = "share of rays, hit taken for miss or miss for hit";
  wrong.log_y = false;
  bargain.title = "What a right decision costs, 1000 radii away";
  bargain.x_label = "nanoseconds a ray, median";
  bargain.y_label = "share of rays decided wrongly";
  bargain.log_y = false;
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const ErrorCurve curve(trials, methods[i].name, error_of, Pool::mean);
    const ErrorCurve time(trials, methods[i].name, nanoseconds, Pool::median);
    PlotSeries series = curve.series(methods[i].name);
    series.look = i;
    PlotSeries one{methods[i].name, {}};
    one.look = i;
    for (std::size_t k = 0; k < curve.knobs().size(); ++k)
      if (curve.knobs()[k] == 1000) one.points.push_back(series.points[k]), one.points.back().x = time.at(k);
    bargain.series.push_back(std::move(one));
    const std::string name = methods[i].name;
    wrong.series.push_back(std::move(series));
    if (name != "exact" && !name.starts_with("filtered")) continue;
    double most = 0;
    for (const Trial& t : trials)
      if (t.method == name) most = std::max(most, t.error);
    report.laws.push_back({name,
                           "no ray is decided wrongly, at any distance",
                           LawKind::exact,
                           0,
                           {most, 0, 0},
                           0,
                           "A filter's bound or the exact arithmetic is wrong.",
                           "the largest share of any round"});
  }
  const ErrorCurve naive(trials, "double", error_of, Pool::mean), better(trials, "perpendicular", error_of, Pool::mean);
  const Estimate saved = bootstrap(naive.rounds(), [&](const std::vector<int>& rounds) {
    double sum = 0;
    for (std::size_t i = 0; i < naive.knobs().size(); ++i) sum += naive.at(i, rounds) - better.at(i, rounds);
    return sum / static_cast<double>(naive.knobs().size());
  });
  report.laws.push_back({"perpendicular", "for the same bits it errs less than the textbook's formula",
                         LawKind::at_least, 0, saved, 0, "The distances would be too small to tell them apart.",
                         "how much smaller its share of wrongly decided rays is"});
  report.figures.push_back(
      {wrong,
       "Rays past the outline of a sphere, half of them just inside, half just outside, down to the last digit. From "
       "far, b^2 and 4ac are two large numbers whose small difference decides: its digits are lost with the square of "
       "the distance. The perpendicular form loses them with the distance itself. Double the digits and the same "
       "happens "
       "later. Raywalk's test, like exact arithmetic, decides none of them wrongly; the truth is found by exact "
       "arithmetic in another form."});
  report.figures.push_back(
      {bargain,
       "And what that takes. Exact arithmetic costs about a hundred times a rounded test. The filter computes a bound "
       "of "
       "its own error beside the fast formula and asks for the exact one only where the bound leaves a doubt. These "
       "rays are the hardest there are, so it asks often here; of the rays of a picture about one in a thousand needs "
       "it, and the filter is nearly as fast as what it filters."});
  return report;
}

}  // namespace

Experiment numerics_experiment(Effort effort) {
  const int rays = by_effort(effort, 4000, 600, 60);
  Experiment e;
  e.number = "E1", e.name = "numerics", e.title = "The arithmetic of one test";
  e.question = "How many digits does it take to say whether a ray meets a sphere?";
  e.weight = 4;
  e.columns = {"distance", "share_wrong", "worst_relative_error_of_t"};
  e.run = [=](int round, const Stop& stop) {
    std::vector<Trial> trials;
    for (double distance = 10; distance < 2e6 && !stop.asked(); distance *= 10) {
      std::vector<Aimed<float>> floats;
      std::vector<Aimed<double>> doubles;
      std::vector<double> float_truths, double_truths;
      for (int i = 0; i < rays; ++i) {
        floats.push_back(aimed<float>(round, i, distance));
        doubles.push_back(aimed<double>(round, i, distance));
        float_truths.push_back(truth(floats.back()));
        double_truths.push_back(truth(doubles.back()));
      }
      const auto judge = [&](std::size_t method, const auto& all, const std::vector<double>& truths, auto test) {
        std::vector<double> found;
        found.reserve(all.size());
        const double start = thread_seconds();
        for (const auto& one : all) found.push_back(test(one));
        const double seconds = thread_seconds() - start;
        int wrong = 0;
        double worst = 0;
        for (std::size_t i = 0; i < all.size(); ++i) {
          const bool hit = !std::isnan(found[i]), right = !std::isnan(truths[i]);
          wrong += hit == right ? 0 : 1;
          if (hit && right) worst = std::max(worst, std::abs(found[i] / truths[i] - 1));
        }
        const auto count = static_cast<std::uint64_t>(all.size());
        trials.push_back({round,
                          methods[method].name,
                          distance,
                          static_cast<double>(wrong) / rays,
                          worst,
                          {count, 0, count, 0, seconds}});
      };
      judge(0, floats, float_truths, textbook<float, float>);
      judge(1, floats, float_truths, textbook<double, float>);
      judge(2, doubles, double_truths, textbook<double, double>);
      judge(3, doubles, double_truths, perpendicular);
      judge(4, doubles, double_truths, double_double);
      judge(5, doubles, double_truths, exact);
      judge(6, floats, float_truths, filtered<float>);
      judge(7, doubles, double_truths, filtered<double>);
    }
    return trials;
  };
  e.conclude = conclude_numerics;
  return e;
}

}  // namespace raywalk::study
