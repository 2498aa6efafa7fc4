#pragma once

#include "math/stop.h"

#include <string_view>

namespace raywalk {

/// From here on Ctrl-C (SIGINT), a termination (SIGTERM) and the end of the terminal (SIGHUP) end the program at once,
/// whatever it is doing, with exit code 1 and a word on standard error; old files stay whole. To be called once.
void end_at_signals();

/// What a command that is interrupted may do with what it has done so far.
enum class Patience {
  full,   ///< all it needs: it asks often, and keeps what is done
  brief,  ///< less than half a second; then it is ended at once
};

/// While one of these lives, the first such signal only raises its stop; one that comes a while later ends the program
/// at once. At most one lives at a time.
class Interrupt {
 public:
  /// `word`: what is said when patience ends; outlives this.
  explicit Interrupt(Patience patience, std::string_view word = "interrupted\n");
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] Stop stop() const;
  /// The work has stopped, or is done: what remains takes as long as it takes.
  void heeded() const;
};

}  // namespace raywalk
