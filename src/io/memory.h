#pragma once
// What the machine's memory still has room for, so that what is too large is said before the memory is taken.

#include "io/error.h"

#include <optional>
#include <string>
#include <string_view>

namespace raywalk {

/// Bytes that this program may still take, and what sets the limit, as in "expected at most 3 GiB, which ...".
struct MemoryLeft {
  double bytes;
  std::string_view limit;
};
/// The least of what the machine has free, the process's address-space limit (ulimit -v) and its control group leave;
/// none where nothing of this is known, as in a browser.
[[nodiscard]] std::optional<MemoryLeft> memory_left();

/// Something large to be: what it is, with its number ("10000000 objects"), about how many bytes it takes, and what to
/// do where they are not there.
struct MemoryNeed {
  std::string what;
  double bytes;
  std::string hint;
};
/// Why it does not fit; none where it does. What every machine has is not asked for.
[[nodiscard]] std::optional<Error> why_too_large(const MemoryNeed& need, const std::string& file);
/// The same of a machine that has just this much.
[[nodiscard]] std::optional<Error> why_too_large(const MemoryNeed& need, const std::string& file,
                                                 const std::optional<MemoryLeft>& left);

}  // namespace raywalk
