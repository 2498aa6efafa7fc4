#pragma once
// What experiments measure, and how it is kept.

#include "io/error.h"
#include "trace/statistics.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk::study {

/// What a trial took. All but the seconds are the same in each run of a study.
struct Cost {
  std::uint64_t rays = 0, nodes = 0, tests = 0, draws = 0;
  double seconds = 0;  ///< of one processor
};
[[nodiscard]] Cost cost_of(const Statistics& statistics, double seconds);

/// One method, at one setting of the experiment's knob, in one round.
struct Trial {
  int round = 0;
  std::string method;  ///< without commas
  double knob = 0;
  double error = 0;  ///< what it is an error of is the experiment's
  double other = 0;  ///< a second number that the experiment measures
  Cost cost{};
};

/// Names of the columns that mean something else in each experiment.
struct Columns {
  std::string knob, error, other;
};

/// Comma-separated values under `heading`, lines that begin with # and say what they are of. Numbers are written so
/// that reading them gives the same ones.
[[nodiscard]] std::string csv_of(const std::vector<Trial>& trials, const Columns& columns, const std::string& heading);

/// What csv_of wrote. Nothing where the heading or the columns are others, or a line is not understood: then the study
/// of that file was another one.
[[nodiscard]] std::vector<Trial> trials_of(std::string_view csv, const Columns& columns, const std::string& heading);

/// Seconds that this thread has computed, from some moment on; the clock on the wall where the system does not know.
[[nodiscard]] double thread_seconds();

}  // namespace raywalk::study
