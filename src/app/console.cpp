#include "app/console.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

namespace raywalk {

namespace {

void to_stderr(std::string text) {
  text += '\n';
  // If standard error is closed, there is nowhere left to report to.
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stderr));
}

}  // namespace

void hold_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) {
      // Takes the lowest free number, which is that of the stream. Nothing can be read from the one, or written to the
      // others.
      [[maybe_unused]] const int held = open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
    }
}

Result<void> print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0) return {};
  return tl::unexpected(
      Error{"", 0, 0, "cannot write to standard output: " + system_message(errno), "check where it is redirected to"});
}

ExitCode fail(const Error& error) {
  to_stderr(error.text());
  return ExitCode::failed;
}

ExitCode refuse(const Error& error) {
  to_stderr(error.text());
  return ExitCode::wrong_usage;
}

void warn(const std::vector<std::string>& warnings) {
  for (const std::string& warning : warnings) to_stderr(warning);
}

void note(std::string_view line) { to_stderr(std::string(line)); }

int terminal_width() {
  if (isatty(STDERR_FILENO) == 0) return 0;
  winsize size{};
  constexpr int usual = 80;
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : usual;
}

}  // namespace raywalk
