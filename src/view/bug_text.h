#pragma once
// What is said about bugs, by id: a family of view/text.h. {0} stands for an argument.

#include "trace/fault.h"

#include <string_view>

namespace raywalk {

enum class BugText {
  title,
  intro,     ///< above the list
  surprise,  ///< the button
  surprise_title,
  number,  ///< {0} of the bug
  found,
  given_up,
  tally,  ///< {0} found, {1} all
  banner,
  banner_mended,
  seen,  ///< heading of the symptom
  task,  ///< {0} pixel
  task_of_lesson,
  no_line_marked,
  line_marked,  ///< {0} its text
  mark,         ///< the line that has just run
  judge,
  give_up,
  right,      ///< {0} the line
  not_right,  ///< {0} what the line does
  was,        ///< {0} the line
  hint,
  wrong,  ///< heading of what was wrong
  cure,   ///< heading of the cure
  mend,
  break_again,
  other_rays_whole,
  other_rays_broken,
  all_bugs,
  leave,
};

/// What is known about a fault.
enum class FaultText {
  symptom,  ///< what a person sees
  hint,     ///< where to look, without the line
  wrong,    ///< what the line did
  cure,     ///< what it should do
};

/// Of one fault.
struct FaultTextOf {
  Fault fault;
  FaultText id;
};

/// What a line of MAIN ALGORITHM or SHADE is there for, as a clause: "it aims from the hit at the light".
struct DutyOf {
  Line line;
};

// bug_text_english.cpp, bug_text_portuguese.cpp
[[nodiscard]] std::string_view english(BugText id);
[[nodiscard]] std::string_view english(FaultTextOf of);
[[nodiscard]] std::string_view english(DutyOf of);
[[nodiscard]] std::string_view portuguese(BugText id);
[[nodiscard]] std::string_view portuguese(FaultTextOf of);
[[nodiscard]] std::string_view portuguese(DutyOf of);

}  // namespace raywalk
