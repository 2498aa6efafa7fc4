#pragma once

#include "math/exact.h"
#include "shape/intersection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace raywalk {

/// A flat triangle, hit from both sides; counter-clockwise seen from the front.
template <class T>
struct Triangle {
  Vec3<T> a{0}, b{1, 0, 0}, c{0, 1, 0};
  friend bool operator==(const Triangle&, const Triangle&) = default;
};

/// t in (0, t_max) at which the ray crosses the triangle; a ray in its plane does not.
///
/// S. Woop, C. Benthin and I. Wald, "Watertight ray/triangle intersection", JCGT 2(1), 2013: the corners are sheared
/// into the ray's own frame, where the ray is the z axis, and the signs of three edge functions decide. Where an error
/// bound does not settle a sign, exact arithmetic does, so that hit and miss are right for each triangle, and a closed
/// mesh has no gaps. A ray exactly through an edge or corner is treated as if slightly displaced, by the same rule for
/// all triangles (H. Edelsbrunner and E. Muecke, "Simulation of simplicity", 1990): it crosses a shared edge once.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Triangle<T>& triangle, const Ray<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {});

/// The terms of a ray that all triangle tests share, computed once per ray.
template <class T>
struct ShearedRay {
  ShearedRay() = default;
  explicit ShearedRay(const Ray<T>& ray);
  Vec3d origin{0.0}, direction{0.0, 0.0, 1.0};
  std::array<double, 3> from{};      ///< the origin along the axes below
  int kx = 0, ky = 1, kz = 2;        ///< the axes that become x, y and z: z the largest component of the direction
  double x = 0, y = 0, inverse = 1;  ///< the shear, and 1 / direction[kz]

  /// A corner, `coordinate(axis)`, in the ray's own frame: the ray is the z axis.
  template <class Coordinate>
  [[nodiscard, gnu::always_inline]] Vec3d sheared(const Coordinate& coordinate) const {
    const double px = static_cast<double>(coordinate(kx)) - from[0];
    const double py = static_cast<double>(coordinate(ky)) - from[1];
    const double pz = static_cast<double>(coordinate(kz)) - from[2];
    return {px - x * pz, py - y * pz, pz};
  }
};

/// The same, bit for bit.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Triangle<T>& triangle, const ShearedRay<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {});

/// The same for a triangle that is stored otherwise: `coordinate(corner, axis)`. `sifted`: most that are missed have
/// been left out already.
template <bool sifted = false, class T, class Coordinate, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect_corners(const Coordinate& coordinate, const ShearedRay<T>& ray,
                                                               T t_max, int departed_part, Explain&& explain = {});

/// Of unit length, towards the front; 0 only where the area is exactly 0. Exact arithmetic finds it where the cross
/// product of the edges has no digits in T: the corners lie on a line but for rounding, or are very near or far apart.
template <class T>
[[nodiscard]] Vec3<T> normal_of(const Triangle<T>& triangle) {
  const Vec3<T> area = cross(triangle.b - triangle.a, triangle.c - triangle.a);
  if (!square_in_range(area)) [[unlikely]]
    return Vec3<T>(detail::exact_normal(wide(triangle.a), wide(triangle.b), wide(triangle.c)));
  return normalize(area);
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Triangle<T>& triangle, const Ray<T>& ray,
                                         const Intersection<T>& intersection) {
  const Vec3<T> normal = normal_of(triangle);
  const Vec3<T> position = ray.at(intersection.t);
  return {position - dot(position - triangle.a, normal) * normal, normal};
}

namespace detail {

/// `barycentric_along` where the cross product of the edges has no digits in T: with edges scaled to about 1. Of a
/// triangle that is thinner than a rounded point is known the weights along it count, not those across.
template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] Vec2<T> barycentric_along_scaled(const Triangle<T>& triangle,
                                                                         const Vec3<T>& vector) {
  Vec3d ab = wide(triangle.b) - wide(triangle.a), ac = wide(triangle.c) - wide(triangle.a);
  const double size = std::fmax(max_component(absolute(ab)), max_component(absolute(ac)));
  ab /= size, ac /= size;
  const Vec3d along = wide(vector) / size, normal = cross(ab, ac);
  constexpr double thin = 16 * static_cast<double>(std::numeric_limits<T>::epsilon());
  if (const double area2 = dot(normal, normal); area2 > thin * thin)
    return Vec2<T>(Vec2d(dot(cross(along, ac), normal), dot(cross(ab, along), normal)) / area2);
  const double to_b = dot(along, ab), to_c = dot(along, ac);
  return Vec2<T>(to_b > to_c ? Vec2d(to_b / dot(ab, ab), 0) : Vec2d(0, to_c / dot(ac, ac)));
}

}  // namespace detail

/// By how much the barycentric weights of b and c change along a vector.
template <class T>
[[nodiscard]] Vec2<T> barycentric_along(const Triangle<T>& triangle, const Vec3<T>& vector) {
  const Vec3<T> ab = triangle.b - triangle.a, ac = triangle.c - triangle.a;
  const Vec3<T> normal = cross(ab, ac);
  if (!square_in_range(normal)) [[unlikely]]
    return detail::barycentric_along_scaled(triangle, vector);
  const T area2 = dot(normal, normal);
  return {dot(cross(vector, ac), normal) / area2, dot(cross(ab, vector), normal) / area2};
}

/// Barycentric weights of b and c; a has 1 - u - v.
template <class T>
[[nodiscard]] Vec2<T> barycentric(const Triangle<T>& triangle, const Vec3<T>& point) {
  return barycentric_along(triangle, point - triangle.a);
}

/// Lengths along the edge from a to b, and perpendicular to it.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Triangle<T>& triangle, const SurfacePoint<T>& point, int /*part*/) {
  const Vec3<T> along = normalize(triangle.b - triangle.a), offset = point.position - triangle.a;
  return {dot(offset, along), dot(offset, cross(point.normal, along))};
}

template <class T>
[[nodiscard]] Vec3<T> normal_derivative(const Triangle<T>& /*triangle*/, const SurfacePoint<T>& /*point*/, int /*part*/,
                                        const Vec3<T>& /*along*/) {
  return Vec3<T>(0);
}

template <class T>
[[nodiscard]] Vec2<T> uv_derivative(const Triangle<T>& triangle, const SurfacePoint<T>& point, int /*part*/,
                                    const Vec3<T>& along) {
  const Vec3<T> u = normalize(triangle.b - triangle.a);
  return {dot(along, u), dot(along, cross(point.normal, u))};
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

/// On which side of the edge from p to q the ray passes, 1 or -1: the sign of d . (p - o) x (q - o). One that hits the
/// edge is displaced by (e, e^2, e^3); 0 when it is parallel to the edge, and the other edges decide.
[[nodiscard]] inline int exact_side(const Vec3d& o, const Vec3d& d, const Vec3d& p, const Vec3d& q) {
  const Expansion px = Expansion(p.x) - o.x, py = Expansion(p.y) - o.y, pz = Expansion(p.z) - o.z;
  const Expansion qx = Expansion(q.x) - o.x, qy = Expansion(q.y) - o.y, qz = Expansion(q.z) - o.z;
  const int side = ((py * qz - pz * qy) * d.x + (pz * qx - px * qz) * d.y + (px * qy - py * qx) * d.z).sign();
  if (side != 0) return side;
  const Expansion ex = qx - px, ey = qy - py, ez = qz - pz;
  if (const int x = (ez * d.y - ey * d.z).sign(); x != 0) return x;
  if (const int y = (ex * d.z - ez * d.x).sign(); y != 0) return y;
  return (ey * d.x - ex * d.y).sign();
}

template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] std::optional<Intersection<T>> intersect_exactly(const Triangle<T>& triangle,
                                                                                         const Vec3d& o, const Vec3d& d,
                                                                                         T t_max) {
  const Vec3d a(triangle.a), b(triangle.b), c(triangle.c);
  const int side = exact_side(o, d, a, b);
  if (side == 0 || exact_side(o, d, b, c) != side || exact_side(o, d, c, a) != side) return std::nullopt;
  const auto along = [&](const Vec3d& to, int axis) { return Expansion(to[axis]) - a[axis]; };
  Expansion numerator, denominator;
  for (int axis = 0; axis < 3; ++axis) {
    const int next = (axis + 1) % 3, after = (axis + 2) % 3;
    const Expansion normal = along(b, next) * along(c, after) - along(b, after) * along(c, next);
    numerator = numerator + normal * (Expansion(a[axis]) - o[axis]);
    denominator = denominator + normal * d[axis];
  }
  if (denominator.sign() == 0) return std::nullopt;
  return intersection_ahead(static_cast<double>(numerator.rounded() / denominator.rounded()), t_max);
}

}  // namespace detail

template <class T>
ShearedRay<T>::ShearedRay(const Ray<T>& ray) : origin(wide(ray.origin)), direction(wide(ray.direction)) {
  const Vec3d& d = direction;
  // Without branches, which no processor foresees.
  const double ax = std::abs(d.x), ay = std::abs(d.y), az = std::abs(d.z);
  const int beside = static_cast<int>(!(ax > ay));
  kz = az > (ax > ay ? ax : ay) ? 2 : beside;
  constexpr int after[] = {1, 2, 0, 1};
  kx = after[kz], ky = after[kz + 1];  // x and y keep their orientation
  const std::array<double, 3> o{origin.x, origin.y, origin.z}, slope{d.x, d.y, d.z};
  const auto at = [](int axis) { return static_cast<std::size_t>(axis); };
  from = {o[at(kx)], o[at(ky)], o[at(kz)]};
  inverse = 1 / slope[at(kz)], x = slope[at(kx)] * inverse, y = slope[at(ky)] * inverse;
}

template <bool sifted, class T, class Coordinate, class Explain>
std::optional<Intersection<T>> intersect_corners(const Coordinate& coordinate, const ShearedRay<T>& ray, T t_max,
                                                 int departed_part, Explain&& explain) {
  constexpr bool explained = std::decay_t<Explain>::wanted;
  if (!explained && departed_part != no_part) return std::nullopt;  // a plane is crossed once
  const auto sheared = [&](int corner) { return ray.sheared([&](int axis) { return coordinate(corner, axis); }); };
  const Vec3d a = sheared(0), b = sheared(1), c = sheared(2);
  // A sheared x or y errs by 5 half ulps of itself and of twice its z; the error of the edge functions follows from
  // that.
  const double across =
      std::max({std::abs(a.x), std::abs(a.y), std::abs(b.x), std::abs(b.y), std::abs(c.x), std::abs(c.y)});
  const double depth = std::max({std::abs(a.z), std::abs(b.z), std::abs(c.z)});
  const double corner_error = 8 * detail::half_ulp * (across + 2 * depth), error = 4 * across * corner_error;
  if constexpr (!explained && !sifted) {
    // Entirely on one side of the ray, or behind it: rejected without a product.
    const auto beside = [&](double p, double q, double r) {
      return std::min({p, q, r}) > corner_error || std::max({p, q, r}) < -corner_error;
    };
    const bool behind = ray.inverse > 0 ? std::max({a.z, b.z, c.z}) <= 0 : std::min({a.z, b.z, c.z}) >= 0;
    if (behind || beside(a.x, b.x, c.x) || beside(a.y, b.y, c.y)) return std::nullopt;
  }
  const double u = c.x * b.y - c.y * b.x, v = a.x * c.y - a.y * c.x, w = b.x * a.y - b.y * a.x;
  const double least = std::min({u, v, w}), most = std::max({u, v, w});
  const double determinant = u + v + w, weighted = u * a.z + v * b.z + w * c.z;
  if constexpr (explained) explain.plane(weighted * ray.inverse, determinant);
  if (departed_part != no_part || (most > error && least < -error)) return std::nullopt;
  const bool sure = (least > error || most < -error) && std::abs(weighted) > 4 * error * depth;
  if (!sure) {
    note_exact(explain);
    const auto corner = [&](int i) { return Vec3<T>(coordinate(i, 0), coordinate(i, 1), coordinate(i, 2)); };
    return detail::intersect_exactly(Triangle<T>{corner(0), corner(1), corner(2)}, ray.origin, ray.direction, t_max);
  }
  // The weights u, v, w should give the point (0, 0): the offset is corrected along the plane. In slivers they have few
  // correct digits, while the plane is as accurate as the corners are.
  const Vec3d off = (u * a + v * b + w * c) / determinant, ab = b - a, ac = c - a;
  const double slope =
      ((off.x * ac.y - off.y * ac.x) * ab.z + (ab.x * off.y - ab.y * off.x) * ac.z) / (ab.x * ac.y - ab.y * ac.x);
  return detail::intersection_ahead((off.z - slope) * ray.inverse, t_max);
}

template <class T, class Explain>
std::optional<Intersection<T>> intersect(const Triangle<T>& triangle, const ShearedRay<T>& ray, T t_max,
                                         int departed_part, Explain&& explain) {
  const std::array<T, 9> all{triangle.a.x, triangle.a.y, triangle.a.z, triangle.b.x, triangle.b.y,
                             triangle.b.z, triangle.c.x, triangle.c.y, triangle.c.z};
  const auto coordinate = [&](int corner, int axis) { return all[static_cast<std::size_t>(3 * corner + axis)]; };
  return intersect_corners(coordinate, ray, t_max, departed_part, explain);
}

template <class T, class Explain>
std::optional<Intersection<T>> intersect(const Triangle<T>& triangle, const Ray<T>& ray, T t_max, int departed_part,
                                         Explain&& explain) {
  return intersect(triangle, ShearedRay<T>(ray), t_max, departed_part, std::forward<Explain>(explain));
}

template <class T>
[[nodiscard]] constexpr bool has_inside(const Triangle<T>& /*shape*/) {
  return false;
}

template <class Cutter>
void cut(Cutter& to, const Triangle<double>& triangle) {
  to.triangle(0, triangle.a, triangle.b, triangle.c);
}

}  // namespace raywalk
