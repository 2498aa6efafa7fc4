#pragma once
// What is said about bugs, by id, in the languages of the lessons: bug_text_*.cpp. {0} stands for an argument.

#include "trace/fault.h"

#include <string>
#include <string_view>
#include <vector>

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

[[nodiscard]] std::string_view bug_text(BugText id, std::string_view language);
[[nodiscard]] std::string bug_text(BugText id, std::string_view language, const std::vector<std::string>& arguments);
[[nodiscard]] std::string_view fault_text(Fault fault, FaultText id, std::string_view language);
/// What a line of MAIN ALGORITHM or SHADE is there for, as a clause: "it aims from the hit at the light".
[[nodiscard]] std::string_view line_duty(Line line, std::string_view language);

namespace detail {
// bug_text_english.cpp, bug_text_portuguese.cpp
[[nodiscard]] std::string_view english(BugText id);
[[nodiscard]] std::string_view english(Fault fault, FaultText id);
[[nodiscard]] std::string_view english(Line line);
[[nodiscard]] std::string_view portuguese(BugText id);
[[nodiscard]] std::string_view portuguese(Fault fault, FaultText id);
[[nodiscard]] std::string_view portuguese(Line line);
}  // namespace detail

}  // namespace raywalk
