#pragma once

#include "app/options.h"
#include "text/language.h"

#include <string>
#include <vector>

namespace raywalk {

/// The lessons' names and titles in every language.
[[nodiscard]] ExitCode lesson_list_command();
/// Plays the lessons of these names (none: all), and says for each whether the trace bears it out. A name may be short:
/// "5" or "05" for the lesson whose folder begins so. `seeds`: with how many other random numbers claims have to hold
/// too.
[[nodiscard]] ExitCode lesson_check_command(const std::vector<std::string>& names, int seeds);

/// Writes out what the presenter of a lesson says, asks and answers: to a path as its ending says, or prints it
/// where there is none.
[[nodiscard]] ExitCode lesson_script_command(const std::string& name, Language language,
                                             const std::optional<std::string>& path);

void declare_lesson(CLI::App& program, Run& run);

}  // namespace raywalk
