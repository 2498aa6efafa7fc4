#pragma once

#include "math/exact.h"
#include "shape/crossing.h"

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

/// Why this is no flat polygon, in words; empty when it is: three corners or more a loop, an area, and no corner
/// farther from the plane than a millionth of the polygon's size.
[[nodiscard]] std::string why_not_flat(const Polygon<double>& polygon);

/// t in (0, t_max) at which the ray crosses the polygon; one that runs in its plane crosses it nowhere.
///
/// Whether the crossing lies inside is decided in the plan along the normal's largest component, by half-open edges and
/// exact orientation: each corner counts for one of its edges.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Crossing<T>> intersect(const Polygon<T>& polygon, const Ray<T>& ray, T t_max,
                                                   int departed_part = no_part, Explain&& explain = {}) {
  const Vec3<T> normal = polygon.area_vector();
  const Vec3<T>& corner = polygon.outline.front();
  const Vec3d wide_normal(normal), o(ray.origin), d(ray.direction);
  const double denominator = dot(wide_normal, d), numerator = dot(wide_normal, Vec3d(corner) - o);
  if constexpr (std::decay_t<Explain>::wanted) explain.plane(numerator, denominator);
  if (departed_part != no_part || denominator == 0) return std::nullopt;
  const double t_wide = numerator / denominator;
  const T t = static_cast<T>(t_wide);
  if (!(t > 0 && t < t_max)) return std::nullopt;

  int kz = std::abs(normal.x) > std::abs(normal.y) ? 0 : 1;
  if (std::abs(normal.z) > std::abs(normal[kz])) kz = 2;
  const int kx = (kz + 1) % 3, ky = (kz + 2) % 3;
  const double x = o[kx] + t_wide * d[kx], y = o[ky] + t_wide * d[ky];
  bool inside = false;
  const auto count = [&](const std::vector<Vec3<T>>& loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3d p(loop[i]), q(loop[i + 1 == loop.size() ? 0 : i + 1]);
      const bool p_above = p[ky] > y, q_above = q[ky] > y;
      if (p_above == q_above) continue;
      const double side = difference_of_products(q[kx] - p[kx], y - p[ky], q[ky] - p[ky], x - p[kx]);
      if (q_above ? side > 0 : side < 0) inside = !inside;
    }
  };
  count(polygon.outline);
  for (const auto& hole : polygon.holes) count(hole);
  if (!inside) return std::nullopt;
  return Crossing<T>{t};
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Polygon<T>& polygon, const Ray<T>& ray, Crossing<T> crossing) {
  const Vec3<T> normal = normalize(polygon.area_vector());
  const Vec3<T> position = ray.at(crossing.t);
  return {position - dot(position - polygon.outline.front(), normal) * normal, normal};
}

/// Along the plane's own two directions, from the first corner.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Polygon<T>& polygon, const SurfacePoint<T>& point, int /*part*/) {
  const Frame<T> frame = frame_of(point.normal);
  const Vec3<T> offset = point.position - polygon.outline.front();
  return {dot(offset, frame.u), dot(offset, frame.v)};
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Polygon<T>& polygon) {
  Bounds<T> box;
  for (const Vec3<T>& corner : polygon.outline) box.include(corner);
  return box;
}

}  // namespace raywalk
