#pragma once
// The Cost panel's tries, made by a worker (gui/workers.h): each in one place, for its seconds are measured.

#include "gui/workers.h"
#include "study/workbench.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A worker's side: a workbench.
class TryServer {
 public:
  /// What to answer to a message; empty: nothing.
  [[nodiscard]] std::string answer(std::string_view message);

 private:
  std::uint64_t job_ = 0;
  study::Workbench bench_;
  std::size_t images_told_ = 0;  ///< of the first attempts
  int samples_told_ = 0;         ///< of the reference
};

/// The page's side.
class TryWorkers {
 public:
  explicit TryWorkers(Workers& workers) : channel_(workers) {}

  /// Has a worker try these setups with this scene, of the file `path`; what it was told before is void. False if there
  /// is none, or if the scene has no text.
  [[nodiscard]] bool begin(const Scene& scene, const std::string& path, ImageSize size,
                           const std::vector<study::Setup>& setups);
  void try_out(const study::Setup& setup);
  [[nodiscard]] bool at_work() const { return at_work_; }

  /// Shows on `bench`, which has the same scene and setups, what was found, and has the worker go on if wanted. False
  /// if it is lost: `bench` must begin anew.
  [[nodiscard]] bool serve(study::Workbench& bench, bool more);
  /// Whether an answer is to come.
  [[nodiscard]] bool waits() const { return at_work_ && asked_ > 0; }

 private:
  Workers& channel_;
  bool at_work_ = false;
  std::uint64_t job_ = 0;
  int asked_ = 0;  ///< answers to come
};

}  // namespace raywalk
