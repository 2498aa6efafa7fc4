#pragma once
// The stack that the recursion of SHADE needs.

#include "math/stack.h"
#include "text/error.h"

#include <optional>

namespace raywalk {

// Of any kernel, from one SHADE to the next; a test measures it. Sanitizers pad variables, and without optimisation all
// of them are on the stack.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || !defined(__OPTIMIZE__)
inline constexpr std::size_t stack_a_level = 7 << 10;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr std::size_t stack_a_level = 7 << 10;
#else
inline constexpr std::size_t stack_a_level = 3 << 10;
#endif
#else
inline constexpr std::size_t stack_a_level = 3 << 10;
#endif
/// For everything around the recursion.
inline constexpr std::size_t stack_beside = std::size_t{128} << 10;

/// The stack for a trace that is `depth` levels deep.
[[nodiscard]] constexpr std::size_t stack_for(int depth) {
  return stack_beside + static_cast<std::size_t>(depth) * stack_a_level;
}

/// Why a trace of that depth does not fit into the rest of the current thread's stack; nothing where it does.
[[nodiscard]] std::optional<Error> why_too_deep(int depth);

}  // namespace raywalk
