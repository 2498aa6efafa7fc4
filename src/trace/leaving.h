#pragma once

#include "trace/world.h"

#include <cmath>
#include <type_traits>

namespace raywalk {

/// A ray that leaves a surface. It starts exactly there and tells its crossings what it departs from; a NaiveRay starts
/// epsilon off, along the unit normal on the side to which it goes.
template <class AnyRay, class T>
[[nodiscard]] AnyRay leaving(const World<T>& world, const Vec3<T>& position, const Vec3<T>& normal, Departure departure,
                             const Vec3<T>& direction, T time) {
  if constexpr (std::is_same_v<AnyRay, NaiveRay<T>>)
    return {{position + std::copysign(world.epsilon, dot(normal, direction)) * normal, direction, {}, time}};
  else
    return {position, direction, departure, time};
}

}  // namespace raywalk
