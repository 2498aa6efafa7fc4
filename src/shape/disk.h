#pragma once

#include "shape/crossing.h"

#include <cmath>

namespace raywalk {

/// A flat disk, seen from both sides; its rim belongs to it.
template <class T>
struct Disk {
  Vec3<T> centre{0};
  Vec3<T> normal{0, 0, 1};  ///< towards the front; any length but 0
  T radius{1};              ///< > 0
  friend bool operator==(const Disk&, const Disk&) = default;
};

/// t in (0, t_max) at which the ray crosses the disk; one that runs in its plane crosses it nowhere.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Crossing<T>> intersect(const Disk<T>& disk, const Ray<T>& ray, T t_max,
                                                   int departed_part = no_part, Explain&& explain = {}) {
  const Vec3d normal(disk.normal), d(ray.direction);
  const Vec3d to_centre = Vec3d(disk.centre) - Vec3d(ray.origin);
  const double numerator = dot(normal, to_centre), denominator = dot(normal, d);
  if constexpr (std::decay_t<Explain>::wanted) explain.plane(numerator, denominator);
  if (departed_part != no_part || denominator == 0) return std::nullopt;
  const double t_wide = numerator / denominator;
  const T t = static_cast<T>(t_wide);
  if (!(t > 0 && t < t_max)) return std::nullopt;
  const Vec3d offset = t_wide * d - to_centre;
  const double radius = static_cast<double>(disk.radius);
  if (!(dot(offset, offset) <= radius * radius)) return std::nullopt;
  return Crossing<T>{t};
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Disk<T>& disk, const Ray<T>& ray, Crossing<T> crossing) {
  const Vec3<T> normal = normalize(disk.normal);
  const Vec3<T> position = ray.at(crossing.t);
  return {position - dot(position - disk.centre, normal) * normal, normal};
}

template <class T>
[[nodiscard]] Vec2<T> uv_at(const Disk<T>& disk, const SurfacePoint<T>& point, int /*part*/) {
  const Frame<T> frame = frame_of(point.normal);
  const Vec3<T> offset = point.position - disk.centre;
  return {dot(offset, frame.u), dot(offset, frame.v)};
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Disk<T>& disk) {
  const Vec3<T> n = normalize(disk.normal);
  Vec3<T> reach;
  for (int axis = 0; axis < 3; ++axis) reach[axis] = disk.radius * std::sqrt(std::fmax(T(0), 1 - n[axis] * n[axis]));
  return {disk.centre - reach, disk.centre + reach};
}

}  // namespace raywalk
