#pragma once
// The rows of the 3-D picture, traced by workers: what they are told and what they answer, as bytes. Both sides are the
// same program, so a value is its bytes.

#include "gui/workers.h"
#include "render/preview.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A worker's side: the tracer of the scene that it was told last.
class RowServer {
 public:
  /// What to answer to a message; empty: nothing.
  [[nodiscard]] std::string answer(std::string_view message);

 private:
  std::uint64_t job_ = 0;
  WorldCache worlds_;
  std::optional<RowTracer> tracer_;
};

/// The page's side: gives each worker a few rows at a time, so that it never waits and soon hears of an edit.
class RowWorkers {
 public:
  explicit RowWorkers(Workers& workers) : channel_(workers) {}

  /// Has this scene, of the file `path`, traced by the workers from now on; what they were told before is void. False
  /// if there are none, or if the scene has no text.
  [[nodiscard]] bool begin(const Scene& scene, const std::string& path, const PreviewSettings& settings);
  /// Ends it.
  void end() { at_work_ = false; }
  [[nodiscard]] bool at_work() const { return at_work_; }

  /// Takes what was answered, and hands out more if wanted. False if workers are lost: the picture must be begun anew.
  [[nodiscard]] bool serve(Preview& preview, bool more);
  /// Whether an answer is to come.
  [[nodiscard]] bool waits() const;

 private:
  struct Worker {
    int messages = 0;          ///< not answered yet
    double seconds_a_row = 0;  ///< of late
  };
  /// The rows of an answer of this job; none if the worker could not.
  [[nodiscard]] std::optional<std::vector<TracedRow>> take(int worker, std::string_view answer);

  Workers& channel_;
  bool at_work_ = false;
  std::uint64_t job_ = 0;
  std::vector<Worker> workers_;
};

}  // namespace raywalk
