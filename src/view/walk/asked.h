#pragma once
// What is asked at this position of the walk: by a lesson, by predictions, or in a hunt for a bug.

#include "view/state.h"

#include <cstddef>
#include <optional>
#include <string>

namespace raywalk {

/// Whether the open step asks, and its answer is not shown yet. (While one searches for a faulty line, one walks
/// freely.)
[[nodiscard]] bool is_open_question(const LessonRoom& sitting);

/// The pixel of the picture that a lesson's walk is of; none for the strip.
[[nodiscard]] std::optional<PixelWalk> pixel_of(const LessonWalk& walk);
/// Whether the open step's walk is the one that is walked: its positions are those of the timeline.
[[nodiscard]] bool is_staged(const State& state);

/// Whether the walk is where a lesson asks, and the prediction is still missing. (While searching a faulty line one
/// walks freely.)
[[nodiscard]] bool question_waits(const State& state);

/// Says that the answer is shown to whoever has predicted it.
void ask_to_predict(State& state);

/// Whether the answer of an open question would be in sight here, if it were shown: where the walk is asked about, and
/// in Move, whatever the scene is by then.
[[nodiscard]] bool withholds_answer(const State& state);

/// Whether what the current ray will meet must not be shown: a lesson or a prediction asks.
[[nodiscard]] bool withholds_end(const State& state);
/// Whether rays to come must not be shown: they would be the answer.
[[nodiscard]] bool hides_rays_to_come(const State& state);

/// Whether the plan takes an arrow from the mouse now, and where it starts.
[[nodiscard]] std::optional<Vec2d> arrow_origin(const State& state);

/// The origin of a guess's arrow, as long as its step is shown.
[[nodiscard]] std::optional<Vec2d> guess_origin(const State& state);

/// The angle between two arrows, 0 to 180.
[[nodiscard]] double degrees_between(const Vec2d& a, const Vec2d& b);

/// The number of decimals shown of a question's answer, or of its error.
[[nodiscard]] int decimals_of(const NumberQuestion& question, double number);

/// For a presenter: the question of step `i` with its choices, of which the right one is ticked, or the answer.
[[nodiscard]] std::string question_with_answer(const PlayedLesson& played, std::size_t i, const StepWords& said,
                                               Language language);

/// The open lesson's guess becomes the arrow from the ray's origin to `towards`, in scene units.
void guess_arrow(State& state, const Vec2d& towards);

/// What can be predicted at this position; nothing while a lesson or a hunt asks, while AUTO plays, or if the plan does
/// not show the walk.
[[nodiscard]] std::optional<PredictionAsked> prediction_asked(const State& state);
/// Whether an automatic walk pauses at `position` for a prediction.
[[nodiscard]] bool rests_for_prediction(const State& state, int position);

/// The origin of the arrow that can be drawn now: of a lesson's question, or of a prediction.
[[nodiscard]] std::optional<Vec2d> aim_origin(const State& state);
void forget_aim(State& state);

/// Whether a click on a line of code marks it now.
[[nodiscard]] bool asks_for_line(const State& state);
/// The line marked as faulty, in a hunt or in a lesson.
[[nodiscard]] std::optional<Line> marked_line(const State& state);
/// A line as the code shows it; where another one reads the same, with the line that governs it.
[[nodiscard]] std::string line_told(const State& state, Line line);

}  // namespace raywalk
