#pragma once
// How the program speaks: results on standard output, everything else on standard error. Only `app` does.

#include "io/error.h"

#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// What the program returns to the shell.
enum class ExitCode : int {
  done = 0,
  failed = 1,       ///< the input or the machine
  wrong_usage = 2,  ///< the command line
};

/// Writes a result. Fails when standard output does not take it, as a full disk or /dev/full.
[[nodiscard]] Result<void> print(std::string_view text);

/// Says on standard error what went wrong, and returns ExitCode::failed.
ExitCode fail(const Error& error);
/// The same for a wrong command line: ExitCode::wrong_usage.
ExitCode refuse(const Error& error);

/// One line each on standard error.
void warn(const std::vector<std::string>& warnings);
void note(std::string_view line);

/// Whether a person reads standard error, and how many characters go in a line there (0 when nobody does).
[[nodiscard]] int terminal_width();

}  // namespace raywalk
