#pragma once

#include "app/options.h"
#include "text/language.h"

#include <string>
#include <vector>

namespace raywalk {

/// The lessons' names and titles in every language.
[[nodiscard]] ExitCode lesson_list_command();
/// Plays the lessons of these names (none: all), and reports for each whether the trace confirms it. A name may be
/// short: "5" or "05" for the lesson whose folder begins so. `seeds`: how many other seeds the claims must hold for.
[[nodiscard]] ExitCode lesson_check_command(const std::vector<std::string>& names, int seeds);

/// Writes a lesson's presenter script to a path, in the format of its extension, or prints it if there is none.
[[nodiscard]] ExitCode lesson_script_command(const std::string& name, Language language,
                                             const std::optional<std::string>& path);

void declare_lesson(CLI::App& program, Run& run);

}  // namespace raywalk
