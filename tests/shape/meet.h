#pragma once

#include <optional>

#include "shape/intersection.h"

namespace raywalk::test {

/// Where the ray meets the shape first, however far away.
template <template <class> class Shape, class T>
std::optional<Intersection<T>> meet(const Shape<T>& shape, const Ray<T>& ray, int departed_part = no_part) {
  return intersect(shape, ray, infinity<T>, departed_part);
}

}  // namespace raywalk::test
