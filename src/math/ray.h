#pragma once

#include "math/vec.h"

#include <limits>

namespace raywalk {

/// The surface a ray starts on, if any: the primitive and which of its parts (the face of a prism; 0 for shapes of one
/// part). An intersection test with that very surface knows the root t = 0 exactly and takes the other one, so no
/// epsilon is needed at any scale. primitive -1: the ray starts on no surface.
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
  T time = 0;  ///< moving objects are hit where they are at this time

  [[nodiscard]] Vec3<T> at(T t) const { return origin + t * direction; }
};

/// A ray whose intersections are computed as textbooks give them (shape/naive.h): it knows no departure. No Ray, so
/// that a shape without a naive form does not compile.
template <class T>
struct NaiveRay {
  Vec3<T> origin;
  Vec3<T> direction;
  T time = 0;
  bool near_root_only = false;  ///< a deliberate mistake: the far side of what it starts inside of is missed

  explicit NaiveRay(const Ray<T>& ray) : origin(ray.origin), direction(ray.direction), time(ray.time) {}

  [[nodiscard]] Vec3<T> at(T t) const { return origin + t * direction; }
  /// The same ray, for what is computed in one way only.
  [[nodiscard]] Ray<T> plain() const { return {origin, direction, {}, time}; }
};

template <class T>
inline constexpr T infinity = std::numeric_limits<T>::infinity();

}  // namespace raywalk
