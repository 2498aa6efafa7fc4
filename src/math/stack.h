#pragma once
// How much stack there is: what calls itself as deep as a scene says needs to know.

#include <cstddef>

namespace raywalk {

/// Bytes that are left of the present thread's stack; a guess on systems that do not say.
[[nodiscard]] std::size_t stack_left();

}  // namespace raywalk
