#pragma once
// What experiments measure, and how it is stored.

#include "text/error.h"
#include "trace/statistics.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk::study {

/// The cost of a trial. All but the seconds are the same in each run of a study.
struct Cost {
  std::uint64_t rays = 0, nodes = 0, tests = 0, draws = 0;
  double seconds = 0;  ///< of one processor
};
[[nodiscard]] Cost cost_of(const Statistics& statistics, double seconds);

/// One method, at one setting of the experiment's knob, in one round.
struct Trial {
  int round = 0;
  std::string method;  ///< on one line
  double knob = 0;
  double error = 0;  ///< defined by the experiment
  double other = 0;  ///< a second measured number
  Cost cost{};
};

/// Names of the columns whose meaning depends on the experiment.
struct Columns {
  std::string knob, error, other;
};

/// Comma-separated values (RFC 4180) under `heading`, lines that begin with # and describe them. Numbers are written so
/// that they are read back exactly.
[[nodiscard]] std::string csv_of(const std::vector<Trial>& trials, const Columns& columns, const std::string& heading);

/// Reads what csv_of wrote. Empty if the heading or the columns differ, or a line is malformed: then the file is of
/// another study.
[[nodiscard]] std::vector<Trial> trials_of(std::string_view csv, const Columns& columns, const std::string& heading);

/// CPU seconds of this thread, from an arbitrary start; wall-clock time where that is not available.
[[nodiscard]] double thread_seconds();

}  // namespace raywalk::study
