#pragma once

#include "math/elementary.h"
#include "math/exact.h"
#include "shape/intersection.h"

#include <cmath>
#include <numbers>

namespace raywalk {

/// A flat disk, seen from both sides; its rim belongs to it.
template <class T>
struct Disk {
  Vec3<T> centre{0};
  Vec3<T> normal{0, 0, 1};  ///< towards the front; any length but 0
  T radius{1};              ///< > 0
  friend bool operator==(const Disk&, const Disk&) = default;
};

namespace detail {

/// Whether the line intersects the disk's plane inside the rim or on it.
template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] bool exactly_inside(const Disk<T>& disk, const Ray<T>& ray) {
  const Vec3d normal = wide(disk.normal), o = wide(ray.origin), d = wide(ray.direction), centre = wide(disk.centre);
  const Expansion numerator = exact_dot_of_difference(normal, centre, o), denominator = exact_dot(normal, d);
  Expansion square;
  for (int axis = 0; axis < 3; ++axis) {
    const Expansion offset = numerator * d[axis] - denominator * (Expansion(centre[axis]) - o[axis]);
    square = square + offset * offset;
  }
  const Expansion reach = denominator * static_cast<double>(disk.radius);
  return (square - reach * reach).sign() <= 0;
}

}  // namespace detail

/// t in (0, t_max) at which the ray crosses the disk; a ray in its plane does not. As reliable as for the plane: where
/// an error bound does not settle on which side of the rim the ray passes, exact arithmetic does.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Disk<T>& disk, const Ray<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {}) {
  // Early out: a ray that departs from the plane cannot hit it again.
  if (!std::decay_t<Explain>::wanted && departed_part != no_part) return std::nullopt;
  const Vec3d normal = wide(disk.normal), o = wide(ray.origin), d = wide(ray.direction), centre = wide(disk.centre);
  PlaneIntersection met = intersect_plane(normal, centre, o, d);
  if (met.exact) note_exact(explain);
  if constexpr (std::decay_t<Explain>::wanted) explain.plane(met.numerator.value, met.denominator.value);
  if (departed_part != no_part || met.denominator.value == 0) return std::nullopt;
  const Vec3d to_centre = centre - o, offset = met.t * d - to_centre;
  const double radius = static_cast<double>(disk.radius), square = dot(offset, offset);
  // |offset| errs by at most `error`, from t and from its own subtraction.
  const double reach = std::abs(met.t) * length(d);
  const double error = reach * met.error() + 4 * detail::half_ulp * (reach + length(to_centre));
  const double doubt = 2 * error * (radius + error) + 8 * detail::half_ulp * radius * radius;
  bool inside = square <= radius * radius;
  if (!(std::abs(square - radius * radius) > doubt)) {
    note_exact(explain);
    inside = detail::exactly_inside(disk, ray);
    met = intersect_plane_exactly(normal, centre, o, d);
  }
  if (!inside) return std::nullopt;
  return detail::intersection_ahead(met.t, t_max);
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Disk<T>& disk, const Ray<T>& ray, const Intersection<T>& intersection) {
  const Vec3<T> normal = normalize_any_length(disk.normal);
  const Vec3<T> position = ray.at(intersection.t);
  return {position - dot(position - disk.centre, normal) * normal, normal};
}

template <class T>
[[nodiscard]] Vec2<T> uv_at(const Disk<T>& disk, const SurfacePoint<T>& point, int /*part*/) {
  return in_plane(point.position - disk.centre, point.normal);
}

template <class T>
[[nodiscard]] Vec3<T> normal_derivative(const Disk<T>& /*disk*/, const SurfacePoint<T>& /*point*/, int /*part*/,
                                        const Vec3<T>& /*along*/) {
  return Vec3<T>(0);
}

template <class T>
[[nodiscard]] Vec2<T> uv_derivative(const Disk<T>& /*disk*/, const SurfacePoint<T>& point, int /*part*/,
                                    const Vec3<T>& along) {
  return in_plane(along, point.normal);
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Disk<T>& disk) {
  const Vec3<T> n = normalize_any_length(disk.normal);
  // By the normal's other two components: 1 - n^2 has no digits where the disk is nearly level.
  const auto reach = [&](T a, T b) { return disk.radius * std::sqrt(a * a + b * b); };
  const Vec3<T> half(reach(n.y, n.z), reach(n.z, n.x), reach(n.x, n.y));
  return {disk.centre - half, disk.centre + half};
}

template <class T>
[[nodiscard]] constexpr bool has_inside(const Disk<T>& /*shape*/) {
  return false;
}

template <class Cutter>
void cut(Cutter& to, const Disk<double>& disk) {
  const PlaneAxes<double> axes = plane_axes(normalize(disk.normal));
  const bool turned = dot(cross(axes.u, axes.v), disk.normal) < 0;
  const int around = to.sides(disk.radius), rings = to.pieces(to.world_length(disk.radius * axes.u));
  const auto at = [&](int ring, int i) {
    const auto [sine, cosine] = portable::sin_cos(2 * std::numbers::pi * (i % around) / around);
    const double radius = disk.radius * ring / rings;
    return disk.centre + radius * (cosine * axes.u + (turned ? -sine : sine) * axes.v);
  };
  for (int ring = 0; ring < rings && !to.too_many(); ++ring)
    for (int i = 0; i < around; ++i) to.cell(0, {at(ring, i), at(ring + 1, i), at(ring + 1, i + 1), at(ring, i + 1)});
}

}  // namespace raywalk
