#pragma once
// A lesson's script for its presenter, beside the screen that the class sees.

#include "lesson/play.h"

#include <string>

namespace raywalk {

enum class ScriptForm {
  markdown,
  page,  ///< HTML in one file, to print or to read on a phone
};

/// The whole lesson: what is on the screen, what to say and to ask, the answer with the numbers of the trace, what
/// students answer, and when each step begins. `played` must contain every step of the lesson.
[[nodiscard]] std::string lesson_script(const PlayedLesson& played, Language language, ScriptForm form);

}  // namespace raywalk
