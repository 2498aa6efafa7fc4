#pragma once
// Available memory, so that what is too large is refused before it is allocated.

#include "text/error.h"

#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

/// Bytes that this program may still allocate, and what limits it, as in "expected at most 3 GiB, which ...".
struct MemoryLeft {
  double bytes;
  std::string_view limit;
};
/// The minimum of what the machine has free, the process's address-space limit (ulimit -v) and its control group leave;
/// none if unknown, as in a browser.
[[nodiscard]] std::optional<MemoryLeft> memory_left();

/// A planned allocation: what it is, with its number ("10000000 objects"), about how many bytes it takes, and what to
/// do if they are not available.
struct MemoryNeed {
  std::string what;
  double bytes;
  std::string hint;
};
/// Why it does not fit; none if it does. Small amounts are not checked.
[[nodiscard]] std::optional<Error> why_too_large(const MemoryNeed& need, const std::string& file);
/// The same for a given amount of memory.
[[nodiscard]] std::optional<Error> why_too_large(const MemoryNeed& need, const std::string& file,
                                                 const std::optional<MemoryLeft>& left);

}  // namespace raywalk
