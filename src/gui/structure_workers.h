#pragma once
// The structures of the Structure tab, built and searched by a worker (gui/workers.h) where there are so many
// primitives that a page would stand still meanwhile.

#include "gui/workers.h"
#include "inspect/search_walk.h"
#include "view/state.h"

#include <array>
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

/// A worker's side: the structures of the scene that it was told last.
class StructureServer {
 public:
  /// What to answer to a message; empty: nothing.
  [[nodiscard]] std::string answer(std::string_view message);

 private:
  std::uint64_t job_ = 0;
  WorldCache worlds_;
  std::optional<WatchedStructures> structures_;
};

/// The page's side. One message is under way at a time, so that a worker soon hears of an edit.
class StructureWorkers {
 public:
  static constexpr int most_here = 256;  ///< primitives whose structures a page builds itself, within a frame

  explicit StructureWorkers(Workers& workers) : channel_(workers) {}

  /// Has a worker do what the Structure tab waits for, and shows there what it has answered. True if that is new.
  bool serve(State& state);
  /// Seconds that the next frame may still wait for an answer, so that a step is shown with its search; 0: no longer.
  [[nodiscard]] double patience() const;

 private:
  /// A search that is under way.
  struct Asked {
    std::shared_ptr<const Timeline> timeline;
    int ray;
    AnySearchedRay searched;
    std::chrono::steady_clock::time_point at;
  };
  [[nodiscard]] std::optional<std::string> described(const State& state) const;
  void tell(std::string message);
  bool ask(State& state);
  bool take(State& state, std::string_view answer);
  bool do_it_here(State& state);

  Workers& channel_;
  std::uint64_t job_ = 0;
  std::string scene_;                         ///< of the job, as it was told
  std::shared_ptr<const Timeline> timeline_;  ///< the last one of that scene
  std::array<WatchedBuild, watched_count> builds_;
  std::size_t built_ = 0;
  bool building_ = false;  ///< one is under way
  std::optional<Asked> asked_;
};

}  // namespace raywalk
