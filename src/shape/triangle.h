#pragma once

#include "math/exact.h"
#include "shape/crossing.h"

#include <cmath>
#include <utility>

namespace raywalk {

/// A flat triangle, hit from both sides; counter-clockwise seen from the front.
template <class T>
struct Triangle {
  Vec3<T> a{0}, b{1, 0, 0}, c{0, 1, 0};
  friend bool operator==(const Triangle&, const Triangle&) = default;
};

/// t in (0, t_max) at which the ray crosses the triangle; one that runs in its plane crosses it nowhere.
///
/// S. Woop, C. Benthin and I. Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013: the corners are sheared
/// into the ray's own frame, where the ray is the z axis, and the signs of three edge functions decide. A corner's
/// place there is the same bits for every triangle that shares it, and the edge functions are right in sign, so a
/// closed mesh has no gaps. A ray exactly through an edge or corner is decided as if it passed a hair beside it, by the
/// same rule for all triangles (H. Edelsbrunner and E. Muecke, "Simulation of simplicity", 1990): it crosses a shared
/// edge once.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Crossing<T>> intersect(const Triangle<T>& triangle, const Ray<T>& ray, T t_max,
                                                   int departed_part = no_part, Explain&& explain = {});

/// What all triangles need of a ray, computed once a ray.
template <class T>
struct ShearedRay {
  ShearedRay() = default;
  explicit ShearedRay(const Ray<T>& ray);
  Vec3<T> origin{0};
  int kx = 0, ky = 1, kz = 2;  ///< the axes that become x, y and z
  T x = 0, y = 0, z = 1;       ///< the shear
};

/// The same, bit for bit.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Crossing<T>> intersect(const Triangle<T>& triangle, const ShearedRay<T>& ray, T t_max,
                                                   int departed_part = no_part, Explain&& explain = {});

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Triangle<T>& triangle, const Ray<T>& ray, Crossing<T> crossing) {
  const Vec3<T> normal = normalize(cross(triangle.b - triangle.a, triangle.c - triangle.a));
  const Vec3<T> position = ray.at(crossing.t);
  return {position - dot(position - triangle.a, normal) * normal, normal};
}

/// The weights of b and c; a has 1 - u - v.
template <class T>
[[nodiscard]] Vec2<T> barycentric(const Triangle<T>& triangle, const Vec3<T>& point) {
  const Vec3<T> ab = triangle.b - triangle.a, ac = triangle.c - triangle.a, ap = point - triangle.a;
  const Vec3<T> normal = cross(ab, ac);
  const T area2 = dot(normal, normal);
  return {dot(cross(ap, ac), normal) / area2, dot(cross(ab, ap), normal) / area2};
}

/// Lengths along a's edge to b, and across it.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Triangle<T>& triangle, const SurfacePoint<T>& point, int /*part*/) {
  const Vec3<T> along = normalize(triangle.b - triangle.a), offset = point.position - triangle.a;
  return {dot(offset, along), dot(offset, cross(point.normal, along))};
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Triangle<T>& triangle) {
  Bounds<T> box;
  box.include(triangle.a);
  box.include(triangle.b);
  box.include(triangle.c);
  return box;
}

// ---------------------------------------------------------------------------------------------------------------------

namespace detail {

/// A corner in the ray's frame: x and y across it, z along it in units of the direction.
template <class T>
struct Sheared {
  T x, y, z;
};

/// Sign of the edge function of p and q about the ray, which is never 0: a ray on the edge is moved by (e, e^2).
template <class T>
int side_of(double edge, const Sheared<T>& p, const Sheared<T>& q) {
  if (edge != 0) return edge > 0 ? 1 : -1;
  if (p.y != q.y) return p.y < q.y ? 1 : -1;
  if (p.x != q.x) return p.x > q.x ? 1 : -1;
  return 0;
}

}  // namespace detail

template <class T>
ShearedRay<T>::ShearedRay(const Ray<T>& ray) : origin(ray.origin) {
  const Vec3<T>& d = ray.direction;
  // The largest component of the direction becomes z; the other two keep their turn.
  kz = std::abs(d.x) > std::abs(d.y) ? 0 : 1;
  if (std::abs(d.z) > std::abs(d[kz])) kz = 2;
  kx = (kz + 1) % 3, ky = (kz + 2) % 3;
  if (d[kz] < 0) std::swap(kx, ky);
  x = d[kx] / d[kz], y = d[ky] / d[kz], z = T(1) / d[kz];
}

template <class T, class Explain>
std::optional<Crossing<T>> intersect(const Triangle<T>& triangle, const ShearedRay<T>& ray, T t_max, int departed_part,
                                     Explain&& explain) {
  const auto sheared = [&](const Vec3<T>& corner) {
    const Vec3<T> p = corner - ray.origin;
    return detail::Sheared<T>{p[ray.kx] - ray.x * p[ray.kz], p[ray.ky] - ray.y * p[ray.kz], ray.z * p[ray.kz]};
  };
  const detail::Sheared<T> a = sheared(triangle.a), b = sheared(triangle.b), c = sheared(triangle.c);
  constexpr bool explained = std::decay_t<Explain>::wanted;
  // Wholly on one side of the ray, or behind it: told without a product. The signs below would say the same.
  const bool aside = (a.x > 0 && b.x > 0 && c.x > 0) || (a.x < 0 && b.x < 0 && c.x < 0) ||
                     (a.y > 0 && b.y > 0 && c.y > 0) || (a.y < 0 && b.y < 0 && c.y < 0) ||
                     (a.z <= 0 && b.z <= 0 && c.z <= 0);
  if (aside && !explained) return std::nullopt;
  const double u = difference_of_products(c.x, b.y, c.y, b.x);
  const double v = difference_of_products(a.x, c.y, a.y, c.x);
  const double w = difference_of_products(b.x, a.y, b.y, a.x);
  const double determinant = u + v + w;
  const double scaled = u * static_cast<double>(a.z) + v * static_cast<double>(b.z) + w * static_cast<double>(c.z);
  if constexpr (explained) explain.plane(scaled, determinant);
  if (departed_part != no_part || determinant == 0) return std::nullopt;
  const int side = detail::side_of(u, c, b);
  if (side == 0 || detail::side_of(v, a, c) != side || detail::side_of(w, b, a) != side) return std::nullopt;
  const T t = static_cast<T>(scaled / determinant);
  if (!(t > 0 && t < t_max)) return std::nullopt;
  return Crossing<T>{t};
}

template <class T, class Explain>
std::optional<Crossing<T>> intersect(const Triangle<T>& triangle, const Ray<T>& ray, T t_max, int departed_part,
                                     Explain&& explain) {
  return intersect(triangle, ShearedRay<T>(ray), t_max, departed_part, std::forward<Explain>(explain));
}

}  // namespace raywalk
