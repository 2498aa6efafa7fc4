#pragma once

#include "math/ray.h"

namespace raywalk {

/// A primary ray in a flat world. Samples are spread over the height of the pixel too, where such a world is the same.
template <class T>
[[nodiscard]] Ray<T> flattened(Ray<T> ray) {
  ray.origin.z = ray.direction.z = 0;
  ray.direction = normalize(ray.direction);
  return ray;
}

}  // namespace raywalk
