#pragma once
// What can be said about a number that was measured in a few rounds, each with random numbers of its own.

#include <cstdint>
#include <functional>
#include <vector>

namespace raywalk::study {

struct Interval {
  double low = 0, high = 0;
  [[nodiscard]] bool holds(double x) const { return low <= x && x <= high; }
};

/// A measured number and how sure it is.
struct Estimate {
  double value = 0;
  double error = 0;  ///< standard error; 0 for what does not vary
  int freedom = 0;   ///< rounds - 1, at least 15 where the error is used
};

/// Of Student's distribution, the interval that holds the true number in `confidence` (0..1) of all studies.
[[nodiscard]] Interval interval(const Estimate& estimate, double confidence);

/// How likely an estimate is to be as far from `truth` as this one is, to either side, if that is the truth.
[[nodiscard]] double two_sided_p(const Estimate& estimate, double truth);

/// A number that follows from rounds; the same round may come several times.
using Statistic = std::function<double(const std::vector<int>& rounds)>;

/// The statistic of rounds 0..count-1, and its standard error by the bootstrap (B. Efron 1979): the spread of the
/// statistic over `resamples` choices of `count` rounds with repetition, times sqrt(count / (count - 1)), for the
/// bootstrap of few rounds is too narrow by that (T. Hesterberg, "What Teachers Should Know About the Bootstrap", The
/// American Statistician 69(4), 2015). Always the same choices.
[[nodiscard]] Estimate bootstrap(int count, const Statistic& statistic, int resamples = 500);

/// The straight line through points by least squares.
struct Line {
  double slope = 0, intercept = 0;
};
[[nodiscard]] Line fit_line(const std::vector<double>& x, const std::vector<double>& y);

/// S. Holm, "A Simple Sequentially Rejective Multiple Test Procedure", 1979. For each of several tests, by its p: the
/// level at which it is to be judged so that the chance of any wrong rejection stays below `alpha`. It is rejected
/// when its p is at most its level.
[[nodiscard]] std::vector<double> holm_levels(const std::vector<double>& p, double alpha);

/// Not empty. The mean of the two in the middle where their number is even.
[[nodiscard]] double median(std::vector<double> values);

/// Order statistics between which the median lies with at least `confidence`, whatever the distribution; the least and
/// the largest value where there are too few.
[[nodiscard]] Interval median_interval(std::vector<double> values, double confidence = 0.95);

}  // namespace raywalk::study
