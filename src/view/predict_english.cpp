#include "view/predict.h"

namespace raywalk {

std::string_view english(PredictText id) {
  switch (id) {
    case PredictText::ask_way:
      return "Where will the {0} go? Drag an arrow from the ring, then STEP.";
    case PredictText::way_guessed:
      return "STEP shows the {0}; drag again to change your mind.";
    case PredictText::ask_end:
      return "What will the {0} meet? Click it, or the empty plan for nothing; then STEP.";
    case PredictText::end_guessed:
      return "Your guess: {0}. STEP shows it.";
    case PredictText::nothing:
      return "nothing";
    case PredictText::off:
      return "\u2713 {0}\u00b0 off.";
    case PredictText::off_too_far:
      return "\u2717 {0}\u00b0 off.";
    case PredictText::met_right:
      return "\u2713 Right: {0}.";
    case PredictText::met_wrong:
      return "\u2717 {0}, not {1}.";
    case PredictText::score:
      return "{0} of {1} right.";
    case PredictText::idle:
      return "Walk on: before each ray you are asked.";
    case PredictText::idle_at_end:
      return "CLEAR starts again: before each ray you are asked.";
    case PredictText::nothing_to_save:
      return "There is no prediction yet to be saved";
  }
  return {};
}

}  // namespace raywalk
