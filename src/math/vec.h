#pragma once
// Vectors: the one place that includes GLM.
//
// GLM is used for storage and componentwise arithmetic only. What a tracer's bits depend on (dot, length, normalize)
// is written out here, so that the order of operations is ours and the same for every compiler and GLM version.

// GLM then copies vectors by components, and so does the compiler for whatever contains them. As a block of memory they
// would be copied 8 bytes at a time: where the components have just been written one by one, as is usual in a tracer,
// the processor cannot forward two stores to one such load and stalls (a quarter of a float render).
#define GLM_FORCE_CTOR_INIT
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <limits>

namespace raywalk {

template <class T>
using Vec2 = glm::vec<2, T>;
template <class T>
using Vec3 = glm::vec<3, T>;

using Vec2d = Vec2<double>;
using Vec3d = Vec3<double>;

/// Linear RGB. A strength, a reflectance or a radiance, by context; never negative, may exceed 1.
template <class T>
using Rgb = glm::vec<3, T>;
using Rgbd = Rgb<double>;

/// v in double. By components: a copy of the whole goes through memory, where the processor would wait for components
/// that have just been written one by one.
template <class T>
[[nodiscard]] constexpr Vec3d wide(const Vec3<T>& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

template <class T>
[[nodiscard]] constexpr T dot(const Vec3<T>& a, const Vec3<T>& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class T>
[[nodiscard]] constexpr T dot(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.x + a.y * b.y;
}

/// Right-handed cross product.
template <class T>
[[nodiscard]] constexpr Vec3<T> cross(const Vec3<T>& a, const Vec3<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// z of the cross product of two plan vectors: positive when b lies to the left of a.
template <class T>
[[nodiscard]] constexpr T cross(const Vec2<T>& a, const Vec2<T>& b) {
  return a.x * b.y - a.y * b.x;
}

template <class T>
[[nodiscard]] T length(const Vec3<T>& v) {
  return std::sqrt(dot(v, v));
}

template <class T>
[[nodiscard]] T length(const Vec2<T>& v) {
  return std::sqrt(dot(v, v));
}

/// v scaled to length 1. v must not be zero (scene readers refuse zero directions; the tracer never forms one).
template <class T>
[[nodiscard]] Vec3<T> normalize(const Vec3<T>& v) {
  return v / length(v);
}

/// The size of each component.
template <class T>
[[nodiscard]] Vec3<T> absolute(const Vec3<T>& v) {
  return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}

/// Whether v . v neither over- nor underflows.
template <class T>
[[nodiscard]] bool square_in_range(const Vec3<T>& v) {
  const T square = dot(v, v);
  return square >= std::numeric_limits<T>::min() && square <= std::numeric_limits<T>::max();
}

/// v scaled to length 1, however short or long it is, but for 0.
template <class T>
[[nodiscard]] Vec3<T> normalize_any_length(const Vec3<T>& v) {
  if (square_in_range(v)) [[likely]]
    return normalize(v);
  const Vec3<T> size = absolute(v);
  return normalize(v / std::fmax(size.x, std::fmax(size.y, size.z)));
}

/// The derivative of a unit vector v / |v|, from that of v.
template <class T>
[[nodiscard]] Vec3<T> derivative_of_unit(const Vec3<T>& v, const Vec3<T>& derivative) {
  const T size = length(v);
  const Vec3<T> unit = v / size;
  return (derivative - dot(derivative, unit) * unit) / size;
}

/// v, whose length is 1 but for a few roundings, brought back to 1 by one step of Newton's method for 1 / length(v):
/// without root or division, for the directions that reflection and refraction derive from unit vectors.
template <class T>
[[nodiscard]] constexpr Vec3<T> renormalize(const Vec3<T>& v) {
  return (T(1.5) - T(0.5) * dot(v, v)) * v;
}

template <class T>
[[nodiscard]] constexpr T max_component(const Vec3<T>& v) {
  return v.x > v.y ? (v.x > v.z ? v.x : v.z) : (v.y > v.z ? v.y : v.z);
}

template <class T>
[[nodiscard]] bool is_finite(const Vec3<T>& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

template <class T>
[[nodiscard]] constexpr bool is_black(const Rgb<T>& c) {
  return c.x == 0 && c.y == 0 && c.z == 0;
}

/// A point's position in the plan (x, y).
template <class T>
[[nodiscard]] constexpr Vec2<T> plan(const Vec3<T>& v) {
  return {v.x, v.y};
}

}  // namespace raywalk
