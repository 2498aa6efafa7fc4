#include "study/statistics.h"

#include <cmath>

#include "math/random.h"
#include "study/curve.h"
#include "study/report.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::study;

namespace {

double uniform(int trial, int which) {
  RandomKey key;
  key.seed = 77;
  key.sample = static_cast<std::uint32_t>(trial);
  key.dimension = static_cast<std::uint32_t>(which);
  return random_unit<double>(key);
}

Statistic mean_of(const std::vector<double>& values) {
  return [values](const std::vector<int>& rounds) {
    double sum = 0;
    for (const int round : rounds) sum += values[static_cast<std::size_t>(round)];
    return sum / static_cast<double>(rounds.size());
  };
}

Law law(LawKind kind, double expected, Estimate measured, double tolerance = 0) {
  return {"law", "says", kind, expected, measured, tolerance};
}

}  // namespace

TEST_CASE("the bootstrapped error of a mean is the one that the textbook gives") {
  std::vector<double> values;
  double mean = 0, squares = 0;
  for (int i = 0; i < 24; ++i) values.push_back(uniform(0, i)), mean += values.back() / 24;
  for (const double x : values) squares += (x - mean) * (x - mean);
  const Estimate estimate = bootstrap(24, mean_of(values), 4000);
  CHECK(estimate.value == Approx(mean));
  CHECK(estimate.freedom == 23);
  CHECK(estimate.error == Approx(std::sqrt(squares / 23 / 24)).epsilon(0.04));
  const Estimate again = bootstrap(24, mean_of(values), 4000);
  CHECK(again.error == estimate.error);
}

TEST_CASE("95% intervals hold the truth in 95% of the studies") {
  // Root mean squares of exponential errors, as skewed as any of ours: the truth is sqrt(2).
  int held = 0;
  constexpr int studies = 1500;
  for (int study = 0; study < studies; ++study) {
    std::vector<double> squares;
    for (int i = 0; i < 24; ++i) {
      double mean = 0;  // of the pixels of one picture
      for (int pixel = 0; pixel < 30; ++pixel) {
        const double error = -std::log(1 - uniform(study, i * 30 + pixel));
        mean += error * error / 30;
      }
      squares.push_back(mean);
    }
    const Statistic root = [&](const std::vector<int>& rounds) { return std::sqrt(mean_of(squares)(rounds)); };
    held += interval(bootstrap(24, root, 200), 0.95).holds(std::sqrt(2.0)) ? 1 : 0;
  }
  const double share = static_cast<double>(held) / studies;
  CHECK(share > 0.93);
  CHECK(share < 0.975);
}

TEST_CASE("the fitted slope's interval holds the law's exponent in 95% of the studies") {
  int held = 0;
  constexpr int studies = 800;
  for (int study = 0; study < studies; ++study) {
    const auto error_at = [&](int round, int k) {  // around 4^(-k/2), each round with luck of its own
      double sum = 0;
      for (int i = 0; i < 8; ++i) sum += uniform(study, (round * 8 + k) * 8 + i) / 4;
      return sum * std::pow(2.0, -k);
    };
    const Estimate slope = bootstrap(
        24,
        [&](const std::vector<int>& rounds) {
          std::vector<double> x, y;
          for (int k = 0; k < 5; ++k) {
            double squares = 0;
            for (const int round : rounds) squares += error_at(round, k) * error_at(round, k);
            x.push_back(k * std::log(4.0)), y.push_back(std::log(squares) / 2);
          }
          return fit_line(x, y).slope;
        },
        100);
    held += interval(slope, 0.95).holds(-0.5) ? 1 : 0;
  }
  const double share = static_cast<double>(held) / studies;
  CHECK(share > 0.925);
  CHECK(share < 0.98);
}

TEST_CASE("a line through points that lie on one is that line") {
  const LineFit line = fit_line({1, 2, 4}, {-1, -4, -10});
  CHECK(line.slope == Approx(-3));
  CHECK(line.intercept == Approx(2));
  CHECK(fit_line({0, 1, 2}, {0, 0, 3}).slope == Approx(1.5));
}

TEST_CASE("Holm's levels, by hand") {
  const std::vector<double> levels = holm_levels({0.01, 0.04, 0.03, 0.005}, 0.05);
  // In order 0.005 <= 0.05/4, 0.01 <= 0.05/3, 0.03 > 0.05/2: that one and all after it stand.
  CHECK(levels[3] == Approx(0.0125));
  CHECK(levels[0] == Approx(0.05 / 3));
  CHECK(levels[2] == Approx(0.025));
  CHECK(levels[1] == Approx(0.025));
  CHECK(holm_levels({0.04}, 0.05)[0] == Approx(0.05));
  CHECK(holm_levels({}, 0.05).empty());
}

TEST_CASE("medians and the order statistics around them") {
  CHECK(median({3, 1, 2}) == 2);
  CHECK(median({4, 1, 3, 2}) == 2.5);
  std::vector<double> values;
  for (int i = 24; i >= 1; --i) values.push_back(i);
  // Of 24 values 6 may be left out at each end: 1 - 2 P(at most 6 of 24) = 0.977; with 7 it would be 0.936.
  const Interval reach = median_interval(values);
  CHECK(reach.low == 7);
  CHECK(reach.high == 18);
  CHECK(median_interval({5}).low == 5);
  CHECK(median_interval({1, 2, 3}).high == 3);
}

TEST_CASE("a curve over time has at each knob the median of its rounds") {
  std::vector<Trial> trials;
  for (const double seconds : {9.0, 2.0, 1.0}) {
    Trial trial{static_cast<int>(trials.size()), "method", 4, 0.5};
    trial.cost.seconds = seconds;
    trials.push_back(trial);
  }
  const ErrorCurve curve(trials, "method");
  CHECK(curve.series("method", [](const Trial& trial) { return trial.cost.seconds; }).points.at(0).x == 2);
  CHECK(curve.series("method").points.at(0).x == 4);
}

TEST_CASE("p and interval say the same") {
  const Estimate estimate{-0.48, 0.01, 23};
  const double p = two_sided_p(estimate, -0.5);
  CHECK(p == Approx(0.0574).epsilon(0.02));  // Student's t = 2 with 23 degrees of freedom
  CHECK_FALSE(interval(estimate, 1 - 1.02 * p).holds(-0.5));
  CHECK(interval(estimate, 1 - 0.98 * p).holds(-0.5));
  CHECK(interval(estimate, 1 - p).low == Approx(-0.5).epsilon(1e-3));
  CHECK(two_sided_p({1, 0, 23}, 1) == 1);
  CHECK(two_sided_p({1, 0, 23}, 1.5) == 0);
}

TEST_CASE("laws are judged by what they say") {
  const auto holds = [](const Law& one) { return judged({one})[0].holds; };
  CHECK(holds(law(LawKind::equals, -0.5, {-0.51, 0.01, 23})));
  CHECK_FALSE(holds(law(LawKind::equals, -0.5, {-0.53, 0.01, 23})));
  CHECK(holds(law(LawKind::at_most, 0, {-5, 0.1, 23})));
  CHECK(holds(law(LawKind::at_most, 0, {0.1, 0.1, 23})));
  CHECK_FALSE(holds(law(LawKind::at_most, 0, {0.2, 0.1, 23})));  // one side: 2 errors are too many
  CHECK(holds(law(LawKind::equals, 0, {0.2, 0.1, 23})));         // both: they are not
  CHECK(holds(law(LawKind::at_least, 0, {5, 0.1, 23})));
  CHECK_FALSE(holds(law(LawKind::at_least, 0, {-0.3, 0.1, 23})));
  CHECK(holds(law(LawKind::exact, 2, {2.01, 0, 0}, 0.02)));
  CHECK_FALSE(holds(law(LawKind::exact, 2, {2.03, 0, 0}, 0.02)));
  CHECK_FALSE(holds(law(LawKind::exact, 0, {NAN, 0, 0}, 1)));
  CHECK_FALSE(holds(law(LawKind::equals, 0, {NAN, 0.1, 23})));
  CHECK_FALSE(holds(law(LawKind::equals, 0, {0, NAN, 23})));
  CHECK_FALSE(holds(law(LawKind::at_most, 0, {NAN, 0.1, 23})));
  CHECK_FALSE(holds(law(LawKind::at_least, 0, {0, NAN, 23})));
}

TEST_CASE("the interval excludes what theory expects exactly when the law does not hold") {
  std::vector<Law> laws;
  for (int i = 0; i < 40; ++i)
    laws.push_back(law(i % 3 == 0   ? LawKind::equals
                       : i % 3 == 1 ? LawKind::at_most
                                    : LawKind::at_least,
                       0, {0.6 * (uniform(1, i) - 0.5), 0.08, 23}));
  const std::vector<Verdict> verdicts = judged(laws);
  int broken = 0;
  for (std::size_t i = 0; i < laws.size(); ++i) {
    const double value = laws[i].measured.value;
    const bool wrong_side =
        laws[i].kind == LawKind::equals || (laws[i].kind == LawKind::at_most ? value > 0 : value < 0);
    CAPTURE(i, value, verdicts[i].level);
    CHECK(verdicts[i].holds == (verdicts[i].interval.holds(0) || !wrong_side));
    broken += verdicts[i].holds ? 0 : 1;
  }
  CHECK(broken > 0);
  CHECK(broken < 20);
}

TEST_CASE("of forty true laws, all together are condemned in at most 5% of the studies") {
  int condemned = 0;
  constexpr int studies = 200;
  for (int study = 0; study < studies; ++study) {
    std::vector<Law> laws;
    for (int i = 0; i < 40; ++i) {
      // A mean of 24 uniform numbers, whose truth is 1/2.
      std::vector<double> values;
      for (int k = 0; k < 24; ++k) values.push_back(uniform(10000 + study, i * 24 + k));
      double mean = 0, squares = 0;
      for (const double x : values) mean += x / 24;
      for (const double x : values) squares += (x - mean) * (x - mean);
      laws.push_back(law(LawKind::equals, 0.5, {mean, std::sqrt(squares / 23 / 24), 23}));
    }
    for (const Verdict& verdict : judged(laws))
      if (!verdict.holds) {
        ++condemned;
        break;
      }
  }
  CHECK(condemned > 0);
  CHECK(static_cast<double>(condemned) / studies < 0.09);
}
