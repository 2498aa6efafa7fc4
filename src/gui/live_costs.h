#pragma once
// The Cost panel's attempts with the state's scene, rendered in time slices, or by a worker where there is one, and the
// picture that shows them.

#include "gui/platform.h"
#include "gui/try_workers.h"
#include "study/effect_costs.h"
#include "study/workbench.h"
#include "view/state.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace raywalk {

class LiveCosts {
 public:
  explicit LiveCosts(Workers& workers = platform::workers()) : workers_(workers) {}

  /// Starts the state's attempts, and works for about `milliseconds` while the panel is open, or until cancelled
  /// through `stop`. Returns whether more is to be done.
  bool work(const State& state, double milliseconds, const Stop& stop = {});
  /// Nothing is to be done for this state.
  [[nodiscard]] bool rests(const State& state) const;
  /// Nothing can be done before a worker answers.
  [[nodiscard]] bool waits(const State& state) const;

  [[nodiscard]] const study::Workbench& bench() const { return bench_; }
  /// What each effect adds, as measured so far: a fraction survey_done().
  [[nodiscard]] const std::optional<study::SceneCost>& survey() const { return survey_result_; }
  [[nodiscard]] double surveyed() const { return survey_ ? survey_->done() : 0; }
  /// The chosen picture and the one it is compared with; 4 bytes per pixel, empty if none.
  [[nodiscard]] const std::vector<std::uint8_t>& rgba() const { return rgba_; }
  [[nodiscard]] ImageSize size() const { return size_; }
  /// The largest difference, for a difference picture.
  [[nodiscard]] double largest() const { return largest_; }
  /// Changes whenever any of the above does.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }

 private:
  [[nodiscard]] bool follows(const State& state) const;
  void show(const State& state);
  [[nodiscard]] bool surveyed(const State& state) const;
  void take_survey(const State& state, double milliseconds, const Stop& stop);

  study::Workbench bench_;
  TryWorkers workers_;
  std::optional<study::CostSurvey> survey_;
  std::optional<study::SceneCost> survey_result_;
  std::uint64_t survey_revision_ = 0;
  std::uint64_t scene_revision_ = 0, bench_revision_ = 0, revision_ = 0;
  CostRoom shown_;  ///< what bench_ and rgba_ were made for
  bool begun_ = false;
  ImageSize size_{0, 0};
  std::vector<std::uint8_t> rgba_;
  double largest_ = 0;
};

}  // namespace raywalk
