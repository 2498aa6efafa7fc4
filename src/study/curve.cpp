#include "study/curve.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace raywalk::study {

ErrorCurve::ErrorCurve(const std::vector<Trial>& trials, const std::string& method, const TrialValue& value, Pool pool)
    : method_(method), pool_(pool) {
  std::map<double, std::vector<Trial>> by_knob;
  for (const Trial& trial : trials)
    if (trial.method == method) by_knob[trial.knob].push_back(trial);
  // A knob that some rounds did not reach, or whose table has lost a line, can be compared with none.
  std::size_t most = 0;
  for (const auto& [knob, of_knob] : by_knob) most = std::max(most, of_knob.size());
  std::erase_if(by_knob, [&](const auto& knob) { return knob.second.size() < most; });
  for (auto& [knob, of_knob] : by_knob) {
    std::stable_sort(of_knob.begin(), of_knob.end(), [](const Trial& a, const Trial& b) { return a.round < b.round; });
    knobs_.push_back(knob);
    std::vector<double> values;
    for (const Trial& trial : of_knob) values.push_back(value(trial));
    rounds_ = static_cast<int>(values.size());
    values_.push_back(std::move(values));
    trials_.push_back(std::move(of_knob));
  }
}

double ErrorCurve::at(std::size_t knob, const std::vector<int>& rounds) const {
  const std::vector<double>& values = values_[knob];
  double sum = 0;
  switch (pool_) {
    case Pool::root_mean_square:
      for (const int round : rounds)
        sum += values[static_cast<std::size_t>(round)] * values[static_cast<std::size_t>(round)];
      return std::sqrt(sum / static_cast<double>(rounds.size()));
    case Pool::mean:
      for (const int round : rounds) sum += values[static_cast<std::size_t>(round)];
      return sum / static_cast<double>(rounds.size());
    case Pool::median:
      break;
  }
  std::vector<double> chosen;
  for (const int round : rounds) chosen.push_back(values[static_cast<std::size_t>(round)]);
  return median(std::move(chosen));
}

double ErrorCurve::at(std::size_t knob) const {
  std::vector<int> all(static_cast<std::size_t>(rounds_));
  std::iota(all.begin(), all.end(), 0);
  return at(knob, all);
}

Estimate ErrorCurve::estimate(std::size_t knob) const {
  return bootstrap(rounds_, [&](const std::vector<int>& rounds) { return at(knob, rounds); });
}

Estimate ErrorCurve::exponent(double low, double high) const {
  return bootstrap(rounds_, [&](const std::vector<int>& rounds) {
    std::vector<double> x, y;
    for (std::size_t i = 0; i < knobs_.size(); ++i) {
      if (knobs_[i] < low || knobs_[i] > high) continue;
      x.push_back(std::log(knobs_[i]));
      y.push_back(std::log(at(i, rounds)));
    }
    return fit_line(x, y).slope;
  });
}

PlotSeries ErrorCurve::series(const std::string& name, const TrialValue& x) const {
  PlotSeries series{name, {}};
  for (std::size_t i = 0; i < knobs_.size(); ++i) {
    double at_x = knobs_[i];
    if (x) {
      std::vector<double> xs;
      for (const Trial& trial : trials_[i]) xs.push_back(x(trial));
      at_x = median(std::move(xs));
    }
    if (pool_ == Pool::median) {
      const Interval reach = median_interval(values_[i]);
      series.points.push_back({at_x, median(values_[i]), reach.low, reach.high});
      continue;
    }
    const Estimate all = estimate(i);
    const Interval reach = interval(all, 0.95);
    // The value cannot be negative: an interval of the logarithm, of the same relative width.
    const double low = all.value > 0 ? all.value * std::exp(-(reach.high - all.value) / all.value) : reach.low;
    series.points.push_back({at_x, all.value, low, reach.high});
  }
  return series;
}

}  // namespace raywalk::study
