#pragma once

#include "math/vec.h"

#include <limits>

namespace raywalk {

/// Where a ray leaves from, when that is a surface: the primitive and which of its parts (the face of a prism; 0 for
/// shapes of one part). An intersection test that meets its own departure knows the root t = 0 exactly and takes the
/// other one, so no epsilon is needed at any scale. primitive -1: the ray starts in the open.
struct Departure {
  int primitive = -1;
  int part = 0;
  friend bool operator==(const Departure&, const Departure&) = default;
};

/// Points origin + t * direction, t > 0. The direction need not be of unit length: t counts multiples of it.
template <class T>
struct Ray {
  Vec3<T> origin;
  Vec3<T> direction;
  Departure departure{};
  T time = 0;  ///< what moves is met where it is then

  [[nodiscard]] Vec3<T> at(T t) const { return origin + t * direction; }
};

/// A ray whose crossings are computed as books print it (shape/naive.h); what it departs from is not heeded.
template <class T>
struct NaiveRay : Ray<T> {
  bool near_root_only = false;  ///< a mistake made on purpose: what it starts in is left unseen
};

template <class T>
inline constexpr T infinity = std::numeric_limits<T>::infinity();

}  // namespace raywalk
