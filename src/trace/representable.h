#pragma once

#include "math/vec.h"

namespace raywalk {

/// Whether a picture's file, which holds floats, can represent the colour: neither NaN nor infinite once it is rounded.
/// Inlined, without a branch a component: asked of every sample. What is infinite or NaN differs from itself by NaN.
template <class T>
[[nodiscard, gnu::always_inline]] inline bool is_representable(const Rgb<T>& colour) {
  // Colours are not negative, so that one comparison tells almost always.
  if (colour.x + colour.y + colour.z < T(1e38)) [[likely]]
    return true;
  const Rgb<float> c(colour);
  return (c.x - c.x) + (c.y - c.y) + (c.z - c.z) == 0;
}

}  // namespace raywalk
