#pragma once
// Predictions on any walk: before a ray is formed, an arrow in its direction; before it is followed, a click on what it
// will hit. The step that shows the answer judges the guess, which stays beside the ray. (A lesson asks its own
// questions: lesson_panel.h.)

#include "text/language.h"
#include "timeline/timeline.h"
#include "view/drawing/display_list.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

struct State;

/// What can be predicted.
enum class PredictionKind {
  way,  ///< the direction of the ray that the next line forms
  end,  ///< what the ray that the next line follows will hit
};
struct PredictionAsked {
  int ray;  ///< in the timeline's rays
  PredictionKind what;
  friend bool operator==(const PredictionAsked&, const PredictionAsked&) = default;
};

/// A guess about one ray.
struct Prediction {
  PredictionAsked of;
  Vec2d arrow{0.0};    ///< for a direction: from the ray's origin, scene units, not 0
  Target met{};        ///< for an end: an object, a light, or nothing
  double degrees = 0;  ///< once judged, the error of a direction
  bool right = false;  ///< once judged
};

/// A judged guess as it is saved.
struct PredictionRecord {
  std::string scene;  ///< its file, or empty
  int step = 0;       ///< of the answer
  RayKind kind{};
  PredictionKind what{};
  double degrees = 0;
  bool right = false;
};

/// For this session only.
struct Predictions {
  static constexpr double right_within = 10;  ///< degrees

  bool on = false;
  std::optional<Prediction> open;             ///< in progress
  std::vector<Prediction> judged;             ///< of the current walk, in order
  std::vector<PredictionRecord> made;         ///< of all walks
  std::shared_ptr<const Timeline> of_walk{};  ///< of `open` and `judged`

  [[nodiscard]] int right() const;
};

/// What can be predicted at this position; nothing while a lesson or a hunt asks, while AUTO plays, or if the plan does
/// not show the walk.
[[nodiscard]] std::optional<PredictionAsked> prediction_asked(const State& state);
/// Whether an automatic walk pauses at `position` for a prediction.
[[nodiscard]] bool rests_for_prediction(const State& state, int position);

/// While predictions are on: what to do now, how the last guess turned out, or how many were right.
[[nodiscard]] std::string prediction_sentence(const State& state);
/// Every guess of the session, one per line, under a heading.
[[nodiscard]] std::string prediction_table(const Predictions& predictions);

/// The origin of the arrow that can be drawn now: of a lesson's question, or of a prediction.
[[nodiscard]] std::optional<Vec2d> aim_origin(const State& state);

void forget_aim(State& state);
/// Overwrites an existing file.
void write_predictions(State& state, const std::string& path);
/// Judges the guess whose answer is now shown, and forgets those of another walk.
void follow_with_predictions(State& state);

}  // namespace raywalk
