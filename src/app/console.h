#pragma once
// The program's output: results on standard output, everything else on standard error. Only `app` prints.

#include "text/error.h"

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

/// Standard streams that are closed get descriptors that cannot be used, so that no file or connection opened later
/// takes their numbers and with them what is printed. To be called first of all.
void hold_closed_streams();

/// Writes a result. Fails if standard output does, as on a full disk.
[[nodiscard]] Result<void> print(std::string_view text);

/// Reports an error on standard error, and returns ExitCode::failed.
ExitCode fail(const Error& error);
/// The same for a wrong command line: ExitCode::wrong_usage.
ExitCode refuse(const Error& error);

/// One line each on standard error.
void warn(const std::vector<std::string>& warnings);
void note(std::string_view line);

/// The width in characters of the terminal on standard error; 0 if it is not a terminal.
[[nodiscard]] int terminal_width();

}  // namespace raywalk
