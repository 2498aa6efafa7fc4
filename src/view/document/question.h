#pragma once
// An open question, as data.

#include "view/document/room.h"

#include <string>
#include <vector>

namespace raywalk {

/// Buttons and text of an open question.
struct QuestionPanel {
  std::string text;
  struct Choice {
    action::Answer answer;
    std::string label;
  };
  std::vector<Choice> choices;  ///< the safest first
};
[[nodiscard]] QuestionPanel question_panel(const State& state);

}  // namespace raywalk
