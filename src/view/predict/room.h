#pragma once
// Predictions on any walk.

#include "timeline/timeline.h"
#include "view/drawing/display_list.h"
#include "view/fields.h"
#include "view/room.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

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
  // What was asked: the same of another walk, as after an effect was switched off and on, has been answered.
  Vec3d origin{0.0}, direction{0.0};  ///< of the ray
  Target met{};                       ///< for an end: what it did meet
};

}  // namespace raywalk

namespace raywalk::action {

struct SetPredictions {
  static constexpr std::string_view word = "predictions";
  bool on;
  static void fields(auto& f, auto& a) { f(a.on, on_or_off); }
  void apply(State& state) const;
};
/// Only if a direction is asked for, by a lesson or here.
struct GuessWay {
  static constexpr std::string_view word = "guess-way";
  Vec2d towards;  ///< the arrow's tip, scene units
  static void fields(auto& f, auto& a) { f(a.towards); }
  void apply(State& state) const;
};
/// The same by a number.
struct GuessAngle {
  static constexpr std::string_view word = "guess-angle";
  double degrees;  ///< 0 to the right, 90 up
  static void fields(auto& f, auto& a) { f(a.degrees); }
  void apply(State& state) const;
};
/// The arrow that there is; else the first one points up.
struct TurnGuess {
  static constexpr std::string_view word = "turn-guess";
  double degrees;  ///< to the left
  static void fields(auto& f, auto& a) { f(a.degrees); }
  void apply(State& state) const;
};
/// Only if asked for.
struct GuessEnd {
  static constexpr std::string_view word = "guess-end";
  Target met;  ///< an object, a light or nothing
  static void fields(auto& f, auto& a) { f(a.met); }
  void apply(State& state) const;
};
/// In place of it the one so many farther in the scene: of its objects, its lights, and nothing.
struct NextGuess {
  static constexpr std::string_view word = "next-guess";
  int by;
  static void fields(auto& f, auto& a) { f(a.by); }
  void apply(State& state) const;
};
struct AskSavePredictions {
  static constexpr std::string_view word = "ask-save-predictions";
  void apply(State& state) const;
};
/// As comma-separated values.
struct SavePredictions {
  static constexpr std::string_view word = "save-predictions";
  std::string path;
  static void fields(auto& f, auto& a) { f(a.path, FilePath{}); }
  static constexpr Traits traits{.answers_prompt = true};
  void apply(State& state) const;
};

}  // namespace raywalk::action

namespace raywalk {

/// Predictions on any walk. For this session only.
struct PredictRoom {
  using Actions = Types<action::SetPredictions, action::GuessWay, action::GuessAngle, action::TurnGuess,
                        action::GuessEnd, action::NextGuess, action::AskSavePredictions, action::SavePredictions>;
  static Commands commands();
  static constexpr Layer layer = Layer::on_top;
  static void draw_in_plan(Painter& painter);
  static void follow(State& state, const Before& before);

  static constexpr double right_within = 10;  ///< degrees

  bool on = false;
  std::optional<Prediction> open;             ///< in progress
  std::vector<Prediction> judged;             ///< of the current walk, in order
  std::vector<PredictionRecord> made;         ///< of all walks
  std::size_t saved = 0;                      ///< of `made`, so many are in a file
  std::shared_ptr<const Timeline> of_walk{};  ///< of `open` and `judged`

  [[nodiscard]] int right() const;
  [[nodiscard]] bool unsaved() const { return made.size() > saved; }
};

}  // namespace raywalk
