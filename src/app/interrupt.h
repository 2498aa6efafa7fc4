#pragma once

#include "math/stop.h"

namespace raywalk {

/// From now on Ctrl-C (SIGINT), SIGTERM and the end of the terminal (SIGHUP) end the program at once, with exit code 1
/// and a word on standard error; old files stay intact. To be called once.
void end_at_signals();

/// How long an interrupted command may take to keep its results.
enum class Patience {
  full,   ///< as long as it needs: it polls often, and keeps its results
  brief,  ///< less than half a second, then the program ends
};

/// While one exists, the first such signal only raises its stop; a second one a while later ends the program at once.
/// At most one exists at a time.
class Interrupt {
 public:
  /// `word`: printed when patience ends; must outlive this.
  explicit Interrupt(Patience patience, const char* word = "interrupted\n");
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] Stop stop() const;
  /// The work has stopped, or is done: the rest has no time limit.
  void heeded() const;
};

}  // namespace raywalk
