#pragma once

#include <functional>

namespace raywalk {

/// Calls body(i) once for each i in 0..count - 1, in any order, possibly at the same time.
using RunAll = std::function<void(int count, const std::function<void(int)>& body)>;

/// By `run_all`; without one, here and in order.
template <class Body>
void for_all(const RunAll& run_all, int count, const Body& body) {
  if (run_all) return run_all(count, body);
  for (int i = 0; i < count; ++i) body(i);
}

}  // namespace raywalk
