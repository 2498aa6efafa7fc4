#pragma once

#include <ctime>

namespace raywalk::test {

/// Processor time of this thread, ms: on a busy machine, too, it is what the thread's own work takes.
inline double thread_milliseconds() {
  std::timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace raywalk::test
