#pragma once
// What the presenter's window shows, as data: a class sees none of it.

#include "view/state.h"

#include <string>
#include <vector>

namespace raywalk {

struct NotesPanel {
  std::string lesson;  ///< its title and the number of the step: "Reflection · 3/7"
  std::string time;    ///< when the step is planned to end, of how long; empty without a lesson
  std::string heading;
  struct Part {
    std::string title, text;
    bool later = false;  ///< of a step to come
  };
  std::vector<Part> parts;  ///< what to say, to ask with the answer, to say then; and the next question
};
[[nodiscard]] NotesPanel notes_panel(const State& state);

}  // namespace raywalk
