#pragma once
// Runs experiments and writes what they found into a folder: NAME.csv with every trial, NAME-1.svg and so on with the
// diagrams, and index.html with all of it explained.

#include "math/stop.h"
#include "study/experiment.h"

#include <functional>
#include <string>
#include <vector>

namespace raywalk::study {

struct StudyOptions {
  std::string folder;  ///< made when it does not exist
  Effort effort = Effort::full;
  int threads = 0;      ///< rounds at a time; 0: as many as the machine runs at once
  std::string machine;  ///< in words; what was measured on another one is measured again
  std::string command;  ///< that repeats the study, for the page
  std::function<void(const std::string& experiment, double done, double seconds_left)> progress{};
  Stop stop{};
};

struct Concluded {
  Experiment experiment;
  Report report;
  std::vector<Verdict> verdicts;  ///< of the report's laws
};

struct StudyResult {
  bool finished = true;  ///< else it was stopped, and goes on from the folder
  std::vector<Concluded> concluded;
  [[nodiscard]] int laws() const;
  [[nodiscard]] std::vector<std::string> broken() const;  ///< "samples: random, edge", of laws that do not hold
};

/// Goes on from the rounds that the folder already holds, of the same effort and machine. All files are written anew or
/// stay as they are, whole.
[[nodiscard]] Result<StudyResult> run_study(const std::vector<Experiment>& experiments, const StudyOptions& options);

[[nodiscard]] std::string_view effort_name(Effort effort);

/// The processor's name where the system tells it, and how many threads it runs; the compiler.
[[nodiscard]] std::string machine_text();

/// The page: complete in itself, without scripts.
[[nodiscard]] std::string page_of(const StudyResult& result, const StudyOptions& options);

}  // namespace raywalk::study
