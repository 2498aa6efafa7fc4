#pragma once
// Runs experiments and writes what they found into a folder: NAME.csv with every trial, NAME-1.svg and so on with the
// diagrams, and index.html with all of it explained.

#include "math/stop.h"
#include "render/tiles.h"
#include "study/experiment.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk::study {

struct StudyOptions {
  std::string folder;  ///< made when it does not exist
  Effort effort = Effort::full;
  int threads = 0;      ///< rounds in parallel; 0: one per hardware thread
  std::string machine;  ///< in words; measurements of another machine are repeated
  std::string command;  ///< that repeats the study, for the page
  /// Measures only these rounds of each experiment, of which every `of`-th is one, into tables of their own beside the
  /// others; the page is not made. Absent: all, and the parts that are in the folder need not be measured again.
  std::optional<Share> share{};
  std::function<void(const std::string& experiment, double done, double seconds_left)> progress{};
  Stop stop{};
};

struct Concluded {
  Experiment experiment;
  Report report;
  std::vector<Verdict> verdicts;  ///< of the report's laws
};

struct StudyResult {
  bool finished = true;  ///< false: it was stopped, and can be continued from the folder
  std::vector<Concluded> concluded;
  [[nodiscard]] int laws() const;
  [[nodiscard]] std::vector<std::string> broken() const;  ///< "samples: random, edge", the laws that do not hold
};

/// Continues from the rounds already in the folder, of the same effort and machine. Each file is replaced as a whole or
/// stays as it is.
[[nodiscard]] Result<StudyResult> run_study(const std::vector<Experiment>& experiments, const StudyOptions& options);

[[nodiscard]] std::string_view effort_name(Effort effort);

/// The processor's name if known, its number of hardware threads, and the compiler.
[[nodiscard]] std::string machine_text();

/// The title of every page that page_of makes, by which it is known again.
inline constexpr std::string_view page_title = "What accuracy costs";
/// The page: self-contained, without scripts.
[[nodiscard]] std::string page_of(const StudyResult& result, const StudyOptions& options);

}  // namespace raywalk::study
