#include "study/statistics.h"

#include "math/random.h"
#include "render/adaptive.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace raywalk::study {

Interval interval(const Estimate& estimate, double confidence) {
  if (estimate.error == 0) return {estimate.value, estimate.value};
  const double reach = student_quantile(1 - confidence, estimate.freedom) * estimate.error;
  return {estimate.value - reach, estimate.value + reach};
}

double two_sided_p(const Estimate& estimate, double truth) {
  const double away = std::abs(estimate.value - truth);
  if (estimate.error == 0) return away == 0 ? 1 : 0;
  // By bisection of the logarithm: the quantile falls as the probability grows.
  double low = std::log(1e-300), high = 0;
  for (int i = 0; i < 50; ++i) {
    const double middle = (low + high) / 2;
    const bool beyond = student_quantile(std::exp(middle), estimate.freedom) * estimate.error > away;
    (beyond ? low : high) = middle;
  }
  return std::exp(high);
}

Estimate bootstrap(int count, const Statistic& statistic, int resamples) {
  std::vector<int> rounds(static_cast<std::size_t>(count));
  std::iota(rounds.begin(), rounds.end(), 0);
  const double value = statistic(rounds);
  if (count < 2) return {value, 0, 0};
  double mean = 0, squares = 0;
  for (int i = 0; i < resamples; ++i) {
    for (std::size_t k = 0; k < rounds.size(); ++k) {
      RandomKey key;
      key.seed = 0x626f6f74;  // "boot"
      key.sample = static_cast<std::uint32_t>(i);
      key.dimension = static_cast<std::uint32_t>(k);
      rounds[k] = static_cast<int>(random_unit<double>(key) * count);
    }
    const double again = statistic(rounds), step = again - mean;
    mean += step / (i + 1);
    squares += step * (again - mean);
  }
  const double narrow = static_cast<double>(count) / (count - 1);
  return {value, std::sqrt(squares / (resamples - 1) * narrow), count - 1};
}

LineFit fit_line(const std::vector<double>& x, const std::vector<double>& y) {
  const double n = static_cast<double>(x.size());
  const double middle_x = std::accumulate(x.begin(), x.end(), 0.0) / n;
  const double middle_y = std::accumulate(y.begin(), y.end(), 0.0) / n;
  double xx = 0, xy = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    xx += (x[i] - middle_x) * (x[i] - middle_x);
    xy += (x[i] - middle_x) * (y[i] - middle_y);
  }
  const double slope = xy / xx;
  return {slope, middle_y - slope * middle_x};
}

std::vector<double> holm_levels(const std::vector<double>& p, double alpha) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return p[a] < p[b]; });
  std::vector<double> levels(p.size());
  double level = 0;
  bool rejecting = true;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    // After the first one that is not rejected, none is.
    if (rejecting) level = alpha / static_cast<double>(p.size() - rank);
    rejecting = rejecting && p[order[rank]] <= level;
    levels[order[rank]] = level;
  }
  return levels;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return (values[(n - 1) / 2] + values[n / 2]) / 2;
}

Interval median_interval(std::vector<double> values, double confidence) {
  std::sort(values.begin(), values.end());
  const int n = static_cast<int>(values.size());
  // The number of n values below the median is binomial with 1/2: leaves out as many at each end as allowed.
  double below = std::pow(0.5, n), all_below = below;
  int left_out = 0;
  for (int k = 0; 2 * (k + 1) < n && 2 * all_below <= 1 - confidence; ++k) {
    left_out = k;
    below *= static_cast<double>(n - k) / (k + 1);
    all_below += below;
  }
  return {values[static_cast<std::size_t>(left_out)], values[static_cast<std::size_t>(n - 1 - left_out)]};
}

}  // namespace raywalk::study
