#pragma once

#include "math/vec.h"

namespace raywalk {

/// Whether a picture's file, which holds floats, can represent the colour: neither NaN nor infinite once it is rounded.
/// Inlined, without a branch a component: asked of every sample. What is infinite or NaN differs from itself by NaN.
template <class T>
[[nodiscard, gnu::always_inline]] inline bool is_representable(const Rgb<T>& colour) {
  // Of doubles, one comparison tells almost always: within 1e38 of black, which is below the largest float.
  if constexpr (sizeof(T) > sizeof(float))
    if (dot(colour, colour) < T(1e76)) [[likely]]
      return true;
  const Rgb<float> c(colour);
  return (c.x - c.x) + (c.y - c.y) + (c.z - c.z) == 0;
}

}  // namespace raywalk
