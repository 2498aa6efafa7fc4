#pragma once
// From trials to curves: one method's error over the knob, each point with its interval, and the fitted exponent.

#include "study/experiment.h"

#include <string>
#include <vector>

namespace raywalk::study {

/// How the errors of the rounds are combined.
enum class Pool {
  root_mean_square,  ///< for errors that are root mean squares themselves
  mean,
  median,
};

/// Which value of a trial is studied.
using TrialValue = std::function<double(const Trial&)>;
[[nodiscard]] inline double error_of(const Trial& trial) { return trial.error; }
[[nodiscard]] inline double other_of(const Trial& trial) { return trial.other; }

/// The trials of one method, by knob, then round; each knob has each round once.
class ErrorCurve {
 public:
  ErrorCurve(const std::vector<Trial>& trials, const std::string& method, const TrialValue& value = error_of,
             Pool pool = Pool::root_mean_square);

  [[nodiscard]] const std::vector<double>& knobs() const { return knobs_; }
  [[nodiscard]] int rounds() const { return rounds_; }
  /// The value at the knob with this index, over these rounds.
  [[nodiscard]] double at(std::size_t knob, const std::vector<int>& rounds) const;
  [[nodiscard]] Estimate estimate(std::size_t knob) const;
  /// Over all rounds.
  [[nodiscard]] double at(std::size_t knob) const;

  /// The exponent of the power law that fits the curve where low <= knob <= high, by least squares of the logarithms.
  /// Requires at least two knobs there, and no value 0.
  [[nodiscard]] Estimate exponent(double low, double high) const;

  /// With a 95% interval for each point by itself. `x`: of a knob, the median over its rounds; default: the knob.
  [[nodiscard]] PlotSeries series(const std::string& name, const TrialValue& x = {}) const;

 private:
  std::string method_;
  Pool pool_;
  std::vector<double> knobs_;
  int rounds_ = 0;
  std::vector<std::vector<double>> values_;  ///< by knob, then round
  std::vector<std::vector<Trial>> trials_;   ///< likewise
};

}  // namespace raywalk::study
