#pragma once

#include <atomic>

namespace raywalk {

/// While one of these lives, the first Ctrl-C (or termination) only raises its flag; a second one ends the program as
/// usual. At most one lives at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;

  [[nodiscard]] static const std::atomic<bool>& flag();
};

}  // namespace raywalk
