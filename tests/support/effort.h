#pragma once
// How much a test tries.
#include <cstddef>
#include <cstdlib>

namespace raywalk::test {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
#else
inline constexpr bool sanitized = false;
#endif

#ifdef NDEBUG  // tests themselves may be compiled without
inline constexpr bool optimized = true;
#else
inline constexpr bool optimized = false;
#endif

/// `count` rounds of the same with other numbers; an eighth of them under sanitizers, which make each ten times slower
/// and watch the memory, not the odds, and without optimisation.
[[nodiscard]] constexpr int rounds(int count) { return sanitized || !optimized ? count / 8 : count; }

/// Whether the case `number` of many that are asked the same is left out: under sanitizers all but every `every`-th
/// are.
[[nodiscard]] constexpr bool left_out(std::size_t number, std::size_t every) {
  return sanitized && number % every != 0;
}

/// Whether all is tried, however long it takes: `./run test --all`.
[[nodiscard]] inline bool thorough() {
  static const bool asked = std::getenv("RAYWALK_THOROUGH") != nullptr;
  return asked;
}
/// Whether it is left to `./run test --all` without sanitizers: all but every `every`-th are, where neighbours are
/// alike.
[[nodiscard]] inline bool left_to_all(std::size_t number, std::size_t every) {
  return !sanitized && !thorough() && number % every != 0;
}

}  // namespace raywalk::test
