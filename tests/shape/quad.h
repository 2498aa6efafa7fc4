// Oracles in quadruple precision (113 bits; both compilers have it on x86-64) for shapes as stored in double or float.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "math/ray.h"
#include "shape/sphere.h"

namespace raywalk::test {

__extension__ using Quad = __float128;

struct QuadVec {
  Quad x, y, z;
};

template <class T>
QuadVec quad(const Vec3<T>& v) {
  return {v.x, v.y, v.z};
}
inline QuadVec operator-(const QuadVec& a, const QuadVec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Quad dot(const QuadVec& a, const QuadVec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Newton's method from the double root.
inline Quad square_root(Quad x) {
  if (x <= 0) return 0;
  Quad root = std::sqrt(static_cast<double>(x));
  if (root == 0) return 0;
  for (int i = 0; i < 3; ++i) root = (root + x / root) / 2;
  return root;
}

// Both roots of a ray and a sphere, ascending; none for a miss.
template <class T>
std::optional<std::pair<Quad, Quad>> sphere_roots(const Sphere<T>& sphere, const Ray<T>& ray) {
  const QuadVec o = quad(ray.origin) - quad(sphere.centre), d = quad(ray.direction);
  const Quad r = sphere.radius, a = dot(d, d), b = dot(d, o), c = dot(o, o) - r * r;
  const Quad cx = o.y * d.z - o.z * d.y, cy = o.z * d.x - o.x * d.z, cz = o.x * d.y - o.y * d.x;
  const Quad discriminant = a * r * r - (cx * cx + cy * cy + cz * cz);
  if (discriminant < 0) return std::nullopt;
  const Quad q = b > 0 ? -(b + square_root(discriminant)) : square_root(discriminant) - b;
  if (q == 0) return std::pair{Quad{0}, Quad{0}};
  return std::pair{std::min(q / a, c / q), std::max(q / a, c / q)};
}

}  // namespace raywalk::test
