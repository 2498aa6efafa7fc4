#pragma once
// Intersections as textbooks give them, in the scalar type and without regard to rounding: for study, and to measure
// what the robust ones cost and save. The ray's type selects them. They ignore a ray's departure: who spawns a ray has
// to move its origin off the surface.

#include "shape/object_transform.h"

#include <cmath>
#include <utility>

namespace raywalk {

/// Keeps an intersection in (0, t_max) that is nearer than the one found so far.
template <class T>
void keep_nearer(std::optional<Intersection<T>>& nearest, T t, int part, T t_max) {
  if (t > 0 && t < t_max && (!nearest || t < nearest->t)) nearest = Intersection<T>{t, part};
}

/// The quadratic formula, as taught in school.
template <class T>
struct TextbookRoots {
  T near, far;  ///< NaN where there are none
};
template <class T, class Explain>
[[nodiscard]] TextbookRoots<T> textbook_roots(T a, T b, T c, Explain& explain) {
  const T discriminant = b * b - 4 * a * c;
  const T root = std::sqrt(discriminant);
  TextbookRoots<T> roots{(-b - root) / (2 * a), (-b + root) / (2 * a)};
  if (roots.near > roots.far) std::swap(roots.near, roots.far);
  if constexpr (std::decay_t<Explain>::wanted)
    explain.quadratic(static_cast<double>(a), static_cast<double>(b), static_cast<double>(c),
                      static_cast<double>(discriminant), static_cast<double>(roots.near),
                      static_cast<double>(roots.far));
  return roots;
}

template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Sphere<T>& sphere, const NaiveRay<T>& ray, T t_max,
                                                       int /*departed_part*/ = no_part, Explain&& explain = {}) {
  const Vec3<T> o = ray.origin - sphere.centre;
  const T a = dot(ray.direction, ray.direction), b = 2 * dot(ray.direction, o);
  const auto roots = textbook_roots(a, b, dot(o, o) - sphere.radius * sphere.radius, explain);
  const T t = roots.near > 0 || ray.near_root_only ? roots.near : roots.far;
  if (!(t > 0 && t < t_max)) return std::nullopt;
  return Intersection<T>{t};
}

/// t at which the ray meets the plane through `point`; infinite or NaN when it runs along it.
template <class T, class Explain>
[[nodiscard]] T intersect_plane_naively(const Vec3<T>& normal, const Vec3<T>& point, const NaiveRay<T>& ray,
                                        Explain& explain) {
  const T numerator = dot(normal, point - ray.origin), denominator = dot(normal, ray.direction);
  explain.plane(static_cast<double>(numerator), static_cast<double>(denominator));
  return numerator / denominator;
}

template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Plane<T>& plane, const NaiveRay<T>& ray, T t_max,
                                                       int /*departed_part*/ = no_part, Explain&& explain = {}) {
  const T t = intersect_plane_naively(plane.normal, plane.point, ray, explain);
  if (!(t > 0 && t < t_max)) return std::nullopt;
  return Intersection<T>{t};
}

template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Disk<T>& disk, const NaiveRay<T>& ray, T t_max,
                                                       int /*departed_part*/ = no_part, Explain&& explain = {}) {
  const T t = intersect_plane_naively(disk.normal, disk.centre, ray, explain);
  if (!(t > 0 && t < t_max)) return std::nullopt;
  const Vec3<T> off = ray.at(t) - disk.centre;
  if (dot(off, off) > disk.radius * disk.radius) return std::nullopt;
  return Intersection<T>{t};
}

/// T. Moeller and B. Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", 1997, with their epsilon.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Triangle<T>& triangle, const NaiveRay<T>& ray, T t_max,
                                                       int /*departed_part*/ = no_part, Explain&& explain = {}) {
  constexpr T epsilon = T(0.000001);
  const Vec3<T> edge1 = triangle.b - triangle.a, edge2 = triangle.c - triangle.a;
  const Vec3<T> p = cross(ray.direction, edge2);
  const T determinant = dot(edge1, p);
  if (determinant > -epsilon && determinant < epsilon) return std::nullopt;
  const T inverse = 1 / determinant;
  const Vec3<T> off = ray.origin - triangle.a;
  const T u = dot(off, p) * inverse;
  if (u < 0 || u > 1) return std::nullopt;
  const Vec3<T> q = cross(off, edge1);
  const T v = dot(ray.direction, q) * inverse;
  if (v < 0 || u + v > 1) return std::nullopt;
  const T numerator = dot(edge2, q), t = numerator * inverse;
  explain.plane(static_cast<double>(numerator), static_cast<double>(determinant));
  if (!(t > 0 && t < t_max)) return std::nullopt;
  return Intersection<T>{t};
}

/// Plain slabs (T. Kay and J. Kajiya 1986): each axis by its two quotients, even if NaN.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Box<T>& box, const NaiveRay<T>& ray, T t_max,
                                                       int /*departed_part*/ = no_part, Explain&& explain = {}) {
  T in = -infinity<T>, out = infinity<T>;
  int in_part = 0, out_part = 0;
  for (int axis = 0; axis < 3; ++axis) {
    T t0 = (box.min[axis] - ray.origin[axis]) / ray.direction[axis];
    T t1 = (box.max[axis] - ray.origin[axis]) / ray.direction[axis];
    int part0 = 2 * axis, part1 = part0 + 1;
    if (t0 > t1) std::swap(t0, t1), std::swap(part0, part1);
    if (t0 > in) in = t0, in_part = part0;
    if (t1 < out) out = t1, out_part = part1;
    if (in > out) return std::nullopt;
  }
  const T t = in > 0 ? in : out;
  const int part = in > 0 ? in_part : out_part;
  const double slope = static_cast<double>(ray.direction[part / 2]);
  explain.plane(static_cast<double>(t) * slope, slope);
  if (!(t > 0 && t < t_max)) return std::nullopt;
  return Intersection<T>{t, part};
}

template <class T, QuadricKind Kind, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Quadric<T, Kind>& quadric, const NaiveRay<T>& ray, T t_max,
                                                       int /*departed_part*/ = no_part, Explain&& explain = {}) {
  using Part = Quadric<T, Kind>;
  const detail::QuadricEquation e = detail::equation_of(quadric);
  const T xx = static_cast<T>(e.xx), yy = static_cast<T>(e.yy), zz = static_cast<T>(e.zz);
  const T linear = static_cast<T>(e.linear), constant = static_cast<T>(e.constant);
  const Vec3<T>&o = ray.origin, &d = ray.direction;
  const T a = xx * d.x * d.x + yy * d.y * d.y + zz * d.z * d.z;
  const T b = 2 * (xx * o.x * d.x + yy * o.y * d.y + zz * o.z * d.z) + linear * d.z;
  const T c = xx * o.x * o.x + yy * o.y * o.y + zz * o.z * o.z + linear * o.z + constant;
  std::optional<Intersection<T>> nearest;
  const auto meet_wall = [&](T t) {
    const T z = o.z + t * d.z;
    if (quadric.z_min < z && z < quadric.z_max) keep_nearer(nearest, t, Part::wall, t_max);
  };
  if (a == 0) {
    meet_wall(-c / b);
  } else {
    const auto roots = textbook_roots(a, b, c, explain);
    meet_wall(roots.near);
    if (!ray.near_root_only) meet_wall(roots.far);
  }
  const auto meet_cap = [&](T z, int part) {
    const T t = (z - o.z) / d.z, x = o.x + t * d.x, y = o.y + t * d.y;
    if (xx * x * x + yy * y * y + zz * z * z + linear * z + constant <= 0) keep_nearer(nearest, t, part, t_max);
  };
  if (quadric.capped && std::isfinite(quadric.z_min)) meet_cap(quadric.z_min, Part::low_cap);
  if (quadric.capped && std::isfinite(quadric.z_max)) meet_cap(quadric.z_max, Part::high_cap);
  detail::explain_cap(quadric, static_cast<double>(o.z), static_cast<double>(d.z), nearest, explain);
  return nearest;
}

/// Whether the edge from p to q crosses the point's ray to the right: for the even-odd rule.
template <class T>
[[nodiscard]] bool is_right_of(const Vec2<T>& p, const Vec2<T>& q, const Vec2<T>& point) {
  return (p.y > point.y) != (q.y > point.y) && point.x < (q.x - p.x) * (point.y - p.y) / (q.y - p.y) + p.x;
}

template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Polygon<T>& polygon, const NaiveRay<T>& ray, T t_max,
                                                       int /*departed_part*/ = no_part, Explain&& explain = {}) {
  const Vec3<T> normal = polygon.area_vector();
  const T t = intersect_plane_naively(normal, polygon.outline.front(), ray, explain);
  if (!(t > 0 && t < t_max)) return std::nullopt;
  const int kz = detail::plan_axis(normal);
  const auto flat = [&](const Vec3<T>& p) { return Vec2<T>(p[(kz + 1) % 3], p[(kz + 2) % 3]); };
  const Vec2<T> point = flat(ray.at(t));
  bool inside = false;
  const auto count = [&](const std::vector<Vec3<T>>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i)
      inside = inside != is_right_of(flat(loop[i]), flat(loop[i + 1 == loop.size() ? 0 : i + 1]), point);
  };
  count(polygon.outline);
  for (const auto& hole : polygon.holes) count(hole);
  if (!inside) return std::nullopt;
  return Intersection<T>{t};
}

/// Each face by itself.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Prism<T>& prism, const NaiveRay<T>& ray, T t_max,
                                                       int /*departed_part*/ = no_part, Explain&& explain = {}) {
  const Vec2<T> o = plan(ray.origin), d = plan(ray.direction);
  const T half = prism.height / 2;
  std::optional<Intersection<T>> nearest;
  for (int i = 0; i < prism.sides(); ++i) {
    const Vec2<T> corner = prism.corner(i) - o, edge = prism.edge(i);
    const T rate = cross(d, edge), t = cross(corner, edge) / rate, along = cross(corner, d) / rate;
    const T z = ray.origin.z + t * ray.direction.z;
    if (along >= 0 && along <= 1 && -half <= z && z <= half) keep_nearer(nearest, t, i, t_max);
  }
  for (const int part : {prism.bottom(), prism.top()}) {
    const T t = ((part == prism.top() ? half : -half) - ray.origin.z) / ray.direction.z;
    const Vec2<T> point = o + t * d;
    bool inside = false;
    for (int i = 0; i < prism.sides(); ++i)
      inside = inside != is_right_of(prism.corner(i), prism.corner_after(i), point);
    if (inside) keep_nearer(nearest, t, part, t_max);
  }
  if (nearest) {
    const int part = nearest->part;
    const T rate = part < prism.sides() ? cross(d, prism.edge(part)) : ray.direction.z;
    explain.plane(static_cast<double>(nearest->t * rate), static_cast<double>(rate));
  }
  return nearest;
}

template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Shape<T>& shape, const NaiveRay<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {}) {
  return std::visit([&](const auto& s) { return intersect(s, ray, t_max, departed_part, explain); }, shape);
}

template <class T>
[[nodiscard]] NaiveRay<T> into_object_space(const ObjectTransform<T>& place, const NaiveRay<T>& ray) {
  NaiveRay<T> inside(into_object_space(place, ray.plain()));
  inside.near_root_only = ray.near_root_only;
  return inside;
}

}  // namespace raywalk
