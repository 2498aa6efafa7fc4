#pragma once
// The one seam between us and threads. Without them (the web's default build) everything runs in the caller.

#include <functional>

namespace raywalk {

/// How many threads this machine runs at once; 1 where there are none.
[[nodiscard]] int hardware_threads();

/// Calls body(index) once for each index in 0..count - 1, the lower ones first, in up to `threads` threads at a time of
/// which the caller is one (0: hardware_threads()). Returns when all calls have. `body` must not throw, and calls for
/// different indices must not write to the same place. Returns the number of threads that took part: fewer than asked
/// for when there are fewer indices or the system refuses more.
int parallel_for(int count, int threads, const std::function<void(int index)>& body);

}  // namespace raywalk
