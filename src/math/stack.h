#pragma once
// How much stack is left, for recursion as deep as a scene asks for.

#include <cstddef>

namespace raywalk {

/// Bytes left on the current thread's stack; a guess on systems that do not tell.
[[nodiscard]] std::size_t stack_left();

}  // namespace raywalk
