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

/// While predictions are on: what to do now, how the last guess turned out, or how many were right.
[[nodiscard]] std::string prediction_sentence(const State& state);
/// Every guess of the session, one per line, under a heading.
[[nodiscard]] std::string prediction_table(const PredictRoom& predictions);

}  // namespace raywalk
