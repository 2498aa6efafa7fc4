#pragma once

#include "trace/texture.h"
#include "trace/world.h"

namespace raywalk {

/// Multiplies a colour of the surface, such as its diffuse one, by what checker and texture have at a point.
/// Inlined, for each hit of a path asks it.
template <class T>
[[gnu::always_inline]] inline void apply_pattern(Rgb<T>& colour, const typename World<T>::Surface& surface,
                                                 const Primitives<T>& primitives, int primitive,
                                                 const SurfacePoint<T>& point, int part, T time = 0) {
  if (surface.checker) {
    const bool even = even_square(primitives.uv_at(primitive, point, part, time), surface.checker->size);
    colour *= even ? surface.checker->even : surface.checker->odd;
  }
  if (surface.texture) colour *= surface.texture->at(primitives.uv_at(primitive, point, part, time));
}

}  // namespace raywalk
