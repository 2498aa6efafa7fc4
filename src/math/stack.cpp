#include "math/stack.h"

#include <cstdint>

#if defined(__EMSCRIPTEN__)
#include <emscripten/stack.h>
#elif defined(__linux__)
#include <pthread.h>
#endif

namespace raywalk {

#if defined(__EMSCRIPTEN__)

std::size_t stack_left() { return emscripten_stack_get_free(); }

#elif defined(__linux__)

namespace {

/// The lowest address of this thread's stack.
std::uintptr_t stack_end() {
  pthread_attr_t attributes;
  void* end = nullptr;
  std::size_t size = 0, guard = 0;
  if (pthread_getattr_np(pthread_self(), &attributes) != 0) return 0;
  pthread_attr_getstack(&attributes, &end, &size);
  pthread_attr_getguardsize(&attributes, &guard);
  pthread_attr_destroy(&attributes);
  return reinterpret_cast<std::uintptr_t>(end) + guard;
}

}  // namespace

std::size_t stack_left() {
  thread_local const std::uintptr_t end = stack_end();
  // Not of a local variable: a sanitizer may keep those elsewhere.
  const auto here = reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0));
  return here > end ? here - end : 0;
}

#else

std::size_t stack_left() { return std::size_t{512} << 10; }  // the smallest default for threads among systems

#endif

}  // namespace raywalk
