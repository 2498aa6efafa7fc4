#pragma once

#include "math/stop.h"

namespace raywalk::test {

// Counts how often work asks whether it is still wanted, and says no the `last` time (0: never).
class Asked : public Stopper {
 public:
  explicit Asked(int last = 0) : last_(last) { raised = true; }
  bool stops() override { return ++times >= last_ && last_ > 0; }
  std::atomic<int> times{0};

 private:
  int last_;
};

}  // namespace raywalk::test
