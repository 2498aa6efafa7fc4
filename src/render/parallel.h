#pragma once
// The one seam between us and threads. Without them (the web's default build) everything runs in the caller.

#include "math/stop.h"

#include <cstddef>
#include <functional>

namespace raywalk {

/// How many threads this machine runs at once; 1 where there are none.
[[nodiscard]] int hardware_threads();

/// Of the stacks of the threads that are made here, whatever the system's own limit is.
inline constexpr std::size_t usual_stack = std::size_t{8} << 20;

/// Calls body(index) once for each index in 0..count - 1, the lower ones first, in up to `threads` threads at a time of
/// which the caller is one (0: hardware_threads()). Returns when all calls have. `body` must not throw, and calls for
/// different indices must not write to the same place. Returns the number of threads that took part: fewer than asked
/// for when there are fewer indices or the system refuses more. `stack`: bytes that each of them has, but for the
/// caller. `waiting` is called now and then while the caller waits for the others.
int parallel_for(int count, int threads, const std::function<void(int index)>& body, std::size_t stack = usual_stack,
                 const std::function<void()>& waiting = {});

/// Runs `body` in another thread with that much stack, and waits for it; whatever it throws is thrown here. False where
/// there is no such thread to be had: then nothing was run.
[[nodiscard]] bool run_on_stack(std::size_t stack, const std::function<void()>& body);

/// Runs in another thread what cannot be stopped, and waits for it while `stop` is not asked; then throws Stopped and
/// leaves it alone: `body` holds what it needs by itself, and the program has to end without waiting for it. Where
/// there are no threads, it runs here to its end.
void run_aside(const Stop& stop, std::function<void()> body);
/// Whether something that was left alone is still running.
[[nodiscard]] bool left_alone();

}  // namespace raywalk
