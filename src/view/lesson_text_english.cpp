// The English words of the lesson pane.

#include "view/lesson_text.h"

namespace raywalk {

std::string_view english(LessonWord word) {
  switch (word) {
    case LessonWord::lessons:
      return "Lessons";
    case LessonWord::next:
      return "Next";
    case LessonWord::back:
      return "Back";
    case LessonWord::reveal:
      return "Reveal";
    case LessonWord::all_lessons:
      return "All lessons";
    case LessonWord::finish:
      return "Finish";
    case LessonWord::presenter:
      return "Presenter";
    case LessonWord::unlock:
      return "Unlock all";
    case LessonWord::predict:
      return "Predict";
    case LessonWord::drag_arrow:
      return "Drag an arrow in the plan";
    case LessonWord::type_number:
      return "Type a number, then Enter";
    case LessonWord::change:
      return "Now change something";
    case LessonWord::teacher:
      return "Teacher's notes";
    case LessonWord::right:
      return "Right";
    case LessonWord::wrong:
      return "Not quite";
    case LessonWord::error:
      return "off by";
    case LessonWord::of:
      return "of";
    case LessonWord::locked:
      return "Locked: finish the lesson above it first, or choose Unlock all";
    case LessonWord::done:
      return "done";
    case LessonWord::hands:
      return "{0} of {1} hands were right";
    case LessonWord::hands_hint:
      return "Show of hands: 1, 2, ... count a hand each; with Shift one less";
    case LessonWord::predict_first:
      return "Predict first, then STEP shows the answer.";
    case LessonWord::back_to_question:
      return "Back to the question";
    case LessonWord::not_a_number:
      return "This is no number: type one such as 12";
    case LessonWord::presenter_hint:
      return "For teachers: shows of hands, the script and notes on request, and every lesson open";
    case LessonWord::unlock_hint:
      return "Every lesson and every answer open, without a prediction";
    case LessonWord::sources:
      return "Sources";
    case LessonWord::hand_more:
      return "One hand more";
    case LessonWord::hand_less:
      return "One hand less";
    case LessonWord::extra:
      return "if time allows";
    case LessonWord::time:
      return "until {0} of {1}";
    case LessonWord::notes:
      return "Notes";
    case LessonWord::notes_hint:
      return "What to say, here in the pane, where the class sees it too";
    case LessonWord::script:
      return "Script...";
    case LessonWord::script_hint:
      return "The whole lesson as a page for yourself alone: to print, or to read on another screen";
    case LessonWord::no_lesson:
      return "A presenter's script is of a lesson: open one first (F2)";
    case LessonWord::script_screen:
      return "On the screen";
    case LessonWord::script_say:
      return "Say and do";
    case LessonWord::script_ask:
      return "Ask";
    case LessonWord::script_keys:
      return "Keys: Enter reveals the answer, then goes on to the next step. Page Down or \u2192 goes one line on, "
             "Page Up or \u2190 back. 1 to 9 count hands for a choice, with Shift one less. P makes it bright for a "
             "projector, F11 fills the screen, Ctrl "
             "+ and Ctrl \u2212 make everything larger or smaller.";
    case LessonWord::close:
      return "Close the lesson: your own scene comes back";
    case LessonWord::score:
      return "predictions right at the first try";
  }
  return {};
}

}  // namespace raywalk
