#pragma once
// From trials to curves: one method's error over the knob, each point with its interval, and the law that it follows.

#include "study/experiment.h"

#include <string>
#include <vector>

namespace raywalk::study {

/// How the errors of the rounds become one number.
enum class Pool {
  root_mean_square,  ///< of errors that are root mean squares themselves
  mean,
  median,
};

/// What of a trial is looked at.
using Value = std::function<double(const Trial&)>;
[[nodiscard]] inline double error_of(const Trial& trial) { return trial.error; }
[[nodiscard]] inline double other_of(const Trial& trial) { return trial.other; }

/// The trials of one method, ordered by knob, then round; every knob has every round once.
class Curve {
 public:
  Curve(const std::vector<Trial>& trials, const std::string& method, const Value& value = error_of,
        Pool pool = Pool::root_mean_square);

  [[nodiscard]] const std::vector<double>& knobs() const { return knobs_; }
  [[nodiscard]] int rounds() const { return rounds_; }
  /// At the knob with this index, of these rounds.
  [[nodiscard]] double at(std::size_t knob, const std::vector<int>& rounds) const;
  [[nodiscard]] Estimate estimate(std::size_t knob) const;
  /// Of all rounds.
  [[nodiscard]] double at(std::size_t knob) const;

  /// The exponent of the power of the knob that the curve follows where low <= knob <= high, by least squares over the
  /// logarithms. At least two knobs lie there, and no value is 0.
  [[nodiscard]] Estimate exponent(double low, double high) const;

  /// With 95% intervals for each by itself. `x` of a knob, from its first round; left out: the knob.
  [[nodiscard]] PlotSeries series(const std::string& name, const Value& x = {}) const;

 private:
  std::string method_;
  Pool pool_;
  std::vector<double> knobs_;
  int rounds_ = 0;
  std::vector<std::vector<double>> values_;  ///< by knob, then round
  std::vector<std::vector<Trial>> trials_;   ///< likewise
};

}  // namespace raywalk::study
