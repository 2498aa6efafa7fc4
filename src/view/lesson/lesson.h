#pragma once
// What other rooms ask of an open lesson.

#include "view/state.h"

#include <string>

namespace raywalk {

/// Opens the lesson, once unsaved work is settled.
void begin_lesson(State& state, const std::string& name);
/// Back to the list, and to the previous scene, once unsaved work is settled.
void end_lesson(State& state);
/// Back to the list, when another scene is about to replace the lesson's.
void close_lesson(State& state);
/// STEP while a lesson's question waits: shows the answer, or asks for a prediction first. Returns whether a question
/// took the press.
[[nodiscard]] bool answered_by_step(State& state);

}  // namespace raywalk
