#pragma once
// Runs families of tests in chunks on threads, keeps finished lines in a file so that a stopped run can be continued,
// and writes the table.

#include "check/family.h"
#include "math/stop.h"
#include "text/error.h"

#include <functional>
#include <string>
#include <vector>

namespace raywalk::check {

struct SuiteOptions {
  std::uint64_t rays = 1'000'000;  ///< per family, over all of its lines, each of which gets at least 20
  std::uint64_t seed = 1;
  int threads = 1;        ///< 0: one per hardware thread
  std::string state;      ///< the file that keeps finished lines; empty: none
  std::string program{};  ///< of which build they are, as a file of another must not be gone on with; may be empty
  Stop stop{};            ///< ends the run at the next chunk
  std::function<void(double done, double seconds_left)> progress{};  ///< called now and then; done in 0..1
};

/// A line that has run.
struct Tested {
  std::string family, line, scalar;
  Tally tally;
  std::string broken;  ///< the goals it breaks; empty: none
};

struct SuiteResult {
  std::vector<Tested> lines;
  bool finished = true;  ///< not stopped
  [[nodiscard]] bool good() const;
};

/// Runs all lines of `families`. Fails when the state file cannot be read or written, or is of another run.
[[nodiscard]] Result<SuiteResult> run_suite(const std::vector<Family>& families, const SuiteOptions& options);

/// Its heading, one row per line, and what holds instead where a family does not meet a goal.
[[nodiscard]] std::string table_text(const std::vector<Family>& families, const SuiteResult& result);

/// A state file's text and back: the settings of the run and its finished lines.
[[nodiscard]] std::string state_text(const SuiteOptions& options, const std::vector<Tested>& lines);
[[nodiscard]] Result<std::vector<Tested>> read_state(const std::string& path, const std::string& text,
                                                     const SuiteOptions& options);

}  // namespace raywalk::check
