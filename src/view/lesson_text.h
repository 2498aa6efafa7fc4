#pragma once
// The words of the lesson pane itself: a family of view/text.h.

#include <string_view>

namespace raywalk {

enum class LessonWord {
  lessons,
  next,
  back,
  reveal,
  all_lessons,
  finish,
  presenter,
  unlock,
  predict,
  drag_arrow,
  type_number,
  change,
  teacher,
  right,
  wrong,
  error,
  of,
  locked,
  done,
  score,
  hands,             ///< {0} for what is right, {1} of how many
  hands_hint,        ///< for presenters
  predict_first,     ///< said when STEP would show the answer
  back_to_question,  ///< a button, once one has walked away from it
  not_a_number,
  presenter_hint,
  unlock_hint,
  sources,
  hand_more,
  hand_less,
  extra,  ///< of a step: for whoever has time
  time,   ///< {0} of {1}, on a clock, at the end of a step
  notes,  ///< a button for presenters
  notes_hint,
  script,  ///< a button for presenters
  script_hint,
  no_lesson,      ///< said where a script is wanted and no lesson is open
  script_screen,  ///< what stands on the screen
  script_say,
  script_ask,
  script_keys,
  close,
};

[[nodiscard]] std::string_view english(LessonWord word);
[[nodiscard]] std::string_view portuguese(LessonWord word);

}  // namespace raywalk
