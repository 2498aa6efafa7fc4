#pragma once
// Predictions on any walk: before a ray is formed, an arrow where it will go; before it is followed, a click on what it
// will meet. The step that shows the answer judges the guess, and the guess stays beside the ray. (A lesson asks
// questions of its own: lesson_panel.h.)

#include "text/language.h"
#include "timeline/timeline.h"
#include "view/display_list.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

struct State;

/// What can be guessed now.
enum class Foretold {
  way,  ///< of the ray that the next line forms
  end,  ///< what the ray meets that the next line follows
};
struct PredictionAsked {
  int ray;  ///< in the timeline's rays
  Foretold what;
  friend bool operator==(const PredictionAsked&, const PredictionAsked&) = default;
};

/// A guess about one ray.
struct Prediction {
  PredictionAsked of;
  Vec2d arrow{0.0};    ///< of a way: from the ray's origin, scene units, not of length 0
  Target met{};        ///< of an end: an object, a light, or nothing
  double degrees = 0;  ///< once it is judged, of a way: how far off it is
  bool right = false;  ///< once it is judged
};

/// A judged guess as it is saved.
struct PredictionRecord {
  std::string scene;  ///< its file, or empty
  int step = 0;       ///< that gave the answer
  RayKind kind{};
  Foretold what{};
  double degrees = 0;
  bool right = false;
};

/// All of it is of this sitting only.
struct Predictions {
  static constexpr double right_within = 10;  ///< degrees

  bool on = false;
  std::optional<Prediction> open;             ///< being made
  std::vector<Prediction> judged;             ///< of the walk under way, in the order in which they were made
  std::vector<PredictionRecord> made;         ///< of all walks
  std::shared_ptr<const Timeline> of_walk{};  ///< that `open` and `judged` are about

  [[nodiscard]] int right() const;
};

namespace action {
struct SetPredictions {
  bool on;
};
struct GuessWay {
  Vec2d towards;
};  ///< the arrow's tip, scene units; only where a way is asked for, by a lesson or here
struct GuessEnd {
  Target met;
};  ///< an object, a light or nothing; only where it is asked for
struct AskSavePredictions {};
struct SavePredictions {
  std::string path;
};  ///< as comma-separated values
}  // namespace action

/// What can be guessed at this position; nothing while a lesson or a hunt asks, while AUTO plays, or where the plan
/// does not show the walk.
[[nodiscard]] std::optional<PredictionAsked> prediction_asked(const State& state);
/// Whether a walk that runs by itself comes to rest at `position`, for a way to be guessed.
[[nodiscard]] bool rests_for_prediction(const State& state, int position);

/// What to do now, how the last guess came out, or how many were right: while predictions are on.
[[nodiscard]] std::string prediction_sentence(const State& state);
/// Every guess of the sitting, a line each, under a heading.
[[nodiscard]] std::string prediction_table(const Predictions& predictions);

/// Where the arrow starts that the plan takes from the mouse now: of a lesson's question, or of a prediction.
[[nodiscard]] std::optional<Vec2d> aim_origin(const State& state);

namespace detail {
void set_predictions(State& state, bool on);
void guess_way(State& state, const Vec2d& towards);
void guess_end(State& state, const Target& met);
void forget_aim(State& state);
void ask_save_predictions(State& state);
void save_predictions(State& state, const std::string& path);
/// Whatever stands at the path is written over.
void write_predictions(State& state, const std::string& path);
/// Judges the guess whose answer has come into sight, and forgets those of another walk.
void follow_with_predictions(State& state);
}  // namespace detail

}  // namespace raywalk
