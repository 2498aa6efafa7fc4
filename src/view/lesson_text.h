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
  close,
};

[[nodiscard]] std::string_view english(LessonWord word);
[[nodiscard]] std::string_view portuguese(LessonWord word);

}  // namespace raywalk
