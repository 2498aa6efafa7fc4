#pragma once
// The only interface to threads. Without threads (the web's default build) everything runs in the caller.

#include "math/stop.h"

#include <cstddef>
#include <functional>

namespace raywalk {

/// The number of threads that this machine runs concurrently; 1 without threads.
[[nodiscard]] int hardware_threads();

/// The stack size of the threads created here, whatever the system's default is.
inline constexpr std::size_t default_stack = std::size_t{8} << 20;

/// Calls body(index) once for each index in 0..count - 1, lower ones first, in up to `threads` threads, of which the
/// caller is one (0: hardware_threads()). Returns when all calls have returned. Where one throws, no more begin, and
/// the first exception is thrown here in the end. Calls for different indices must not write to the same place. Returns
/// the number of threads that took part: fewer than requested when there are fewer indices or the system refuses more.
/// `stack`: bytes of stack of each, except the caller. `waiting` is called regularly while the caller waits for the
/// others.
int parallel_for(int count, int threads, const std::function<void(int index)>& body, std::size_t stack = default_stack,
                 const std::function<void()>& waiting = {});

/// Runs `body` in another thread with that much stack, and waits for it; rethrows its exceptions. False where no such
/// thread is available: then nothing was run.
[[nodiscard]] bool run_on_stack(std::size_t stack, const std::function<void()>& body);

/// Runs work that cannot be cancelled in another thread and waits for it unless cancelled through `stop`; then throws
/// Stopped and detaches it: `body` must own what it needs, and the program has to end without waiting for it. Without
/// threads, it runs here to its end.
void run_detached(const Stop& stop, std::function<void()> body);
/// Whether detached work is still running.
[[nodiscard]] bool has_detached_work();

}  // namespace raywalk
