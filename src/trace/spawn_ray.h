#pragma once

#include "trace/world.h"

#include <cmath>
#include <type_traits>

namespace raywalk {

/// A ray that leaves a surface. It starts exactly on it and carries its departure, which intersection tests use; a
/// NaiveRay starts epsilon off the surface along the unit normal, on the side that it goes to.
template <class AnyRay, class T>
[[nodiscard]] AnyRay spawn_ray(const World<T>& world, const Vec3<T>& position, const Vec3<T>& normal,
                               Departure departure, const Vec3<T>& direction, T time) {
  if constexpr (std::is_same_v<AnyRay, NaiveRay<T>>)
    return NaiveRay<T>({position + std::copysign(world.epsilon, dot(normal, direction)) * normal, direction, {}, time});
  else
    return {position, direction, departure, time};
}

}  // namespace raywalk
