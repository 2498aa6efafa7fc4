#pragma once

#include <functional>

namespace raywalk {

/// Calls body(i) once for each i in 0..count - 1, in any order, possibly at the same time.
using RunAll = std::function<void(int count, const std::function<void(int)>& body)>;

}  // namespace raywalk
