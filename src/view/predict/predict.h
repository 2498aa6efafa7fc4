#pragma once
// Predictions on any walk: before a ray is formed, an arrow in its direction; before it is followed, a click on what it
// will hit. The step that shows the answer judges the guess, which stays beside the ray. (A lesson asks its own
// questions: lesson_panel.h.)

#include "text/language.h"
#include "timeline/timeline.h"
#include "view/drawing/display_list.h"
#include "view/predict/room.h"

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

struct State;

/// What can be predicted at this position; nothing while a lesson or a hunt asks, while AUTO plays, or if the plan does
/// not show the walk.
[[nodiscard]] std::optional<PredictionAsked> prediction_asked(const State& state);
/// Whether an automatic walk pauses at `position` for a prediction.
[[nodiscard]] bool rests_for_prediction(const State& state, int position);

/// While predictions are on: what to do now, how the last guess turned out, or how many were right.
[[nodiscard]] std::string prediction_sentence(const State& state);
/// Every guess of the session, one per line, under a heading.
[[nodiscard]] std::string prediction_table(const PredictRoom& predictions);

/// The origin of the arrow that can be drawn now: of a lesson's question, or of a prediction.
[[nodiscard]] std::optional<Vec2d> aim_origin(const State& state);

void forget_aim(State& state);
/// Overwrites an existing file.
void write_predictions(State& state, const std::string& path);

}  // namespace raywalk
