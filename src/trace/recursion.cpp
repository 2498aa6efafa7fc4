#include "trace/recursion.h"

namespace raywalk {

std::optional<Error> why_too_deep(int depth) {
  const std::size_t left = stack_left();
  if (stack_for(depth) <= left) return std::nullopt;
  const std::size_t fits = left > stack_beside ? (left - stack_beside) / stack_a_level : 0;
  const std::string hint = fits > 0 ? "a depth of " + std::to_string(fits) + " fits; or give it a larger stack"
                                    : std::string("give it a larger stack");
  return Error{"", 0, 0,
               "a depth of " + std::to_string(depth) + " needs " + std::to_string(stack_for(depth) >> 10) +
                   " KiB of stack, and there are " + std::to_string(left >> 10),
               hint};
}

}  // namespace raywalk
