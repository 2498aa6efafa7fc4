#pragma once
// Statistics of a number that was measured in a few rounds, each with its own random numbers.

#include <cstdint>
#include <functional>
#include <vector>

namespace raywalk::study {

struct Interval {
  double low = 0, high = 0;
  [[nodiscard]] bool holds(double x) const { return low <= x && x <= high; }
};

/// A measured number and its uncertainty.
struct Estimate {
  double value = 0;
  double error = 0;  ///< standard error; 0 if it does not vary
  int freedom = 0;   ///< rounds - 1, at least 15 where the error is used
};

/// By Student's distribution, the interval that contains the true number in `confidence` (0..1) of all studies.
[[nodiscard]] Interval interval(const Estimate& estimate, double confidence);

/// The probability that an estimate is at least as far from `truth` as this one, to either side, if that is the truth.
[[nodiscard]] double two_sided_p(const Estimate& estimate, double truth);

/// A number computed from rounds; a round may occur several times.
using Statistic = std::function<double(const std::vector<int>& rounds)>;

/// The statistic of rounds 0..count-1, and its standard error by the bootstrap (B. Efron 1979): the spread of the
/// statistic over `resamples` choices of `count` rounds with repetition, times sqrt(count / (count - 1)), because the
/// bootstrap of few rounds is too narrow by that factor (T. Hesterberg, "What Teachers Should Know About the
/// Bootstrap", The American Statistician 69(4), 2015). Deterministic.
[[nodiscard]] Estimate bootstrap(int count, const Statistic& statistic, int resamples = 500);

/// The straight line through points by least squares.
struct LineFit {
  double slope = 0, intercept = 0;
};
[[nodiscard]] LineFit fit_line(const std::vector<double>& x, const std::vector<double>& y);

/// S. Holm, "A Simple Sequentially Rejective Multiple Test Procedure", 1979. For each p of several tests: the level at
/// which to judge it so that the probability of any wrong rejection stays below `alpha`. It is rejected if its p is at
/// most its level.
[[nodiscard]] std::vector<double> holm_levels(const std::vector<double>& p, double alpha);

/// Of at least one value. The mean of the two middle ones if their number is even.
[[nodiscard]] double median(std::vector<double> values);

/// Order statistics that enclose the median with at least `confidence`, for any distribution; the smallest and largest
/// value if there are too few.
[[nodiscard]] Interval median_interval(std::vector<double> values, double confidence = 0.95);

}  // namespace raywalk::study
