#pragma once

#include "math/exact.h"
#include "shape/intersection.h"

#include <cmath>
#include <string>
#include <vector>

namespace raywalk {

/// A flat polygon anywhere in space, convex or concave, with holes: the even-odd rule over its outline and holes. Seen
/// from both sides; the outline runs counter-clockwise seen from the front.
template <class T>
struct Polygon {
  std::vector<Vec3<T>> outline;             ///< at least 3 corners, all in one plane
  std::vector<std::vector<Vec3<T>>> holes;  ///< the same, in the same plane
  friend bool operator==(const Polygon&, const Polygon&) = default;

  /// Normal of the outline, as long as twice its area (M. Newell; I. Sutherland et al. 1974).
  [[nodiscard]] Vec3<T> area_vector() const {
    Vec3<T> sum(0);
    for (std::size_t i = 1; i + 1 < outline.size(); ++i)
      sum += cross(outline[i] - outline[0], outline[i + 1] - outline[0]);
    return sum;
  }
};

/// Why this is not a flat polygon, in words; empty when it is one: three corners or more a loop, an area, and no corner
/// further from the plane than a millionth of the polygon's size.
[[nodiscard]] std::string why_not_flat(const Polygon<double>& polygon);

namespace detail {

/// The axis along which a polygon's projection is largest: inside and outside are decided in that projection.
template <class T>
[[nodiscard]] int plan_axis(const Vec3<T>& normal) {
  const int axis = std::abs(normal.x) > std::abs(normal.y) ? 0 : 1;
  return std::abs(normal.z) > std::abs(normal[axis]) ? 2 : axis;
}

/// The even-odd rule in the projection along `kz`. `above(p)`: whether corner p is above the point; `left(p, q)`:
/// whether the point is to the left of the edge (1), on it (0) or to its right (-1).
template <class T, class Above, class Left>
[[nodiscard]] bool even_odd(const Polygon<T>& polygon, Above above, Left left) {
  bool inside = false;
  const auto count = [&](const std::vector<Vec3<T>>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3d p(loop[i]), q(loop[i + 1 == loop.size() ? 0 : i + 1]);
      const bool p_above = above(p), q_above = above(q);
      if (p_above == q_above) continue;
      const int side = left(p, q);
      if (q_above ? side > 0 : side < 0) inside = !inside;
    }
  };
  count(polygon.outline);
  for (const auto& hole : polygon.holes) count(hole);
  return inside;
}

/// The same with the intersection itself exact: everything is multiplied by the denominator of t.
template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] bool exactly_inside(const Polygon<T>& polygon, const Ray<T>& ray,
                                                            const Vec3d& normal, int kx, int ky) {
  const Vec3d o = wide(ray.origin), d = wide(ray.direction);
  Expansion numerator = exact_dot_of_difference(normal, Vec3d(polygon.outline.front()), o);
  Expansion denominator = exact_dot(normal, d);
  if (denominator.sign() < 0) numerator = -numerator, denominator = -denominator;
  const Expansion x = denominator * o[kx] + numerator * d[kx], y = denominator * o[ky] + numerator * d[ky];
  return even_odd(
      polygon, [&](const Vec3d& p) { return (denominator * p[ky] - y).sign() > 0; },
      [&](const Vec3d& p, const Vec3d& q) {
        const Expansion along_x = Expansion(q[kx]) - p[kx], along_y = Expansion(q[ky]) - p[ky];
        return (along_x * (y - denominator * p[ky]) - along_y * (x - denominator * p[kx])).sign();
      });
}

}  // namespace detail

/// t in (0, t_max) at which the ray crosses the polygon; a ray in its plane does not.
///
/// Whether the point lies inside is decided in the projection along the normal's largest component, by half-open edges:
/// each corner counts for one of its edges. Where the error of the computed point leaves a side in doubt, exact
/// arithmetic decides.
///
/// `area_vector` is the polygon's own, computed once for many rays. Never inlined: in the traversal loop it would
/// displace the code of more frequent shapes.
template <class T, class Explain = NoExplanation>
[[nodiscard, gnu::noinline]] std::optional<Intersection<T>> intersect(const Polygon<T>& polygon,
                                                                      const Vec3<T>& area_vector, const Ray<T>& ray,
                                                                      T t_max, int departed_part = no_part,
                                                                      Explain&& explain = {}) {
  // Early out: a ray that departs from the plane cannot hit it again.
  if (!std::decay_t<Explain>::wanted && departed_part != no_part) return std::nullopt;
  const Vec3d normal = wide(area_vector), corner = wide(polygon.outline.front());
  const Vec3d o = wide(ray.origin), d = wide(ray.direction);
  PlaneIntersection met = intersect_plane(normal, corner, o, d);
  if (met.exact) note_exact(explain);
  if constexpr (std::decay_t<Explain>::wanted) explain.plane(met.numerator.value, met.denominator.value);
  if (departed_part != no_part || met.denominator.value == 0) return std::nullopt;
  if (!(met.t > 0 && met.t < static_cast<double>(t_max) * 2)) return std::nullopt;

  const int kz = detail::plan_axis(normal), kx = (kz + 1) % 3, ky = (kz + 2) % 3;
  const double x = o[kx] + met.t * d[kx], y = o[ky] + met.t * d[ky];
  // x and y err by at most these.
  const auto error = [&](int axis) {
    const double reach = met.t * std::abs(d[axis]);
    return reach * met.error() + 4 * detail::half_ulp * (reach + std::abs(o[axis]));
  };
  const double x_error = error(kx), y_error = error(ky);
  bool sure = true;
  bool inside = detail::even_odd(
      polygon,
      [&](const Vec3d& p) {
        sure = sure && std::abs(p[ky] - y) > y_error;
        return p[ky] > y;
      },
      [&](const Vec3d& p, const Vec3d& q) {
        const double along_x = q[kx] - p[kx], along_y = q[ky] - p[ky];
        const double left = along_x * (y - p[ky]), right = along_y * (x - p[kx]);
        const double doubt = 2 * (std::abs(along_x) * y_error + std::abs(along_y) * x_error) +
                             8 * detail::half_ulp * (std::abs(left) + std::abs(right));
        sure = sure && std::abs(left - right) > doubt;
        return left > right ? 1 : -1;
      });
  if (!sure) {
    note_exact(explain);
    inside = detail::exactly_inside(polygon, ray, normal, kx, ky);
    met = intersect_plane_exactly(normal, corner, o, d);
  }
  if (!inside) return std::nullopt;
  return detail::intersection_ahead(met.t, t_max);
}

template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Polygon<T>& polygon, const Ray<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {}) {
  return intersect(polygon, polygon.area_vector(), ray, t_max, departed_part, explain);
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Polygon<T>& polygon, const Vec3<T>& area_vector, const Ray<T>& ray,
                                         const Intersection<T>& intersection) {
  const Vec3<T> normal = normalize_any_length(area_vector);
  const Vec3<T> position = ray.at(intersection.t);
  return {position - dot(position - polygon.outline.front(), normal) * normal, normal};
}
template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Polygon<T>& polygon, const Ray<T>& ray,
                                         const Intersection<T>& intersection) {
  return surface_at(polygon, polygon.area_vector(), ray, intersection);
}

/// Along the plane's own two axes, from the first corner.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Polygon<T>& polygon, const SurfacePoint<T>& point, int /*part*/) {
  return in_plane(point.position - polygon.outline.front(), point.normal);
}

template <class T>
[[nodiscard]] Vec3<T> normal_derivative(const Polygon<T>& /*polygon*/, const SurfacePoint<T>& /*point*/, int /*part*/,
                                        const Vec3<T>& /*along*/) {
  return Vec3<T>(0);
}

template <class T>
[[nodiscard]] Vec2<T> uv_derivative(const Polygon<T>& /*polygon*/, const SurfacePoint<T>& point, int /*part*/,
                                    const Vec3<T>& along) {
  return in_plane(along, point.normal);
}

/// Contains the corners and every possible intersection: these lie in the plane through the first corner, which the
/// others may miss slightly. By the even-odd rule a hole that extends beyond the outline is filled there.
template <class T>
[[nodiscard]] Bounds<T> bounds(const Polygon<T>& polygon) {
  const Vec3d normal = wide(polygon.area_vector()), first = wide(polygon.outline.front());
  const int kz = detail::plan_axis(normal);
  Bounds<T> box;
  const auto include = [&](const std::vector<Vec3<T>>& loop) {
    for (const Vec3<T>& corner : loop) {
      box.include(corner);
      Vec3<T> met = corner;
      met[kz] = static_cast<T>(wide(corner)[kz] - dot(wide(corner) - first, normal) / normal[kz]);
      if (std::isfinite(met[kz])) box.include(met);
    }
  };
  include(polygon.outline);
  for (const auto& hole : polygon.holes) include(hole);
  return box;
}

template <class T>
[[nodiscard]] constexpr bool has_inside(const Polygon<T>& /*shape*/) {
  return false;
}

template <class Cutter>
void cut(Cutter& to, const Polygon<double>& polygon) {
  const Vec3d up = normalize(polygon.area_vector());
  const Vec3d right = normalize(polygon.outline[1] - polygon.outline[0]);
  std::vector<std::vector<Vec3d>> loops{polygon.outline};
  loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
  to.polygon(0, loops, right, cross(up, right));
}

}  // namespace raywalk
