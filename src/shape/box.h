#pragma once

#include "shape/crossing.h"

#include <cmath>
#include <utility>

namespace raywalk {

/// An axis-parallel box, solid; flat in at most one axis. Parts: 2 axis + (0 for the low face, 1 for the high one).
template <class T>
struct Box {
  Vec3<T> min{-1}, max{1};  ///< min <= max in each component
  friend bool operator==(const Box&, const Box&) = default;
};

/// Nearest t in (0, t_max) at which the ray crosses a face; edges and corners count.
///
/// Slabs (T. Kay and J. Kajiya 1986), chosen by the sign of the direction and compared so that the NaN of an origin in
/// a face's plane without slope passes (T. Ize 2013). All slabs are in double. The face departed from lies at t = 0.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Crossing<T>> intersect(const Box<T>& box, const Ray<T>& ray, T t_max,
                                                   int departed_part = no_part, Explain&& explain = {}) {
  double in = -infinity<double>, out = infinity<double>;
  int in_part = 0, out_part = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = ray.origin[axis], d = ray.direction[axis];
    const double low = box.min[axis], high = box.max[axis];
    if (d == 0) {
      if (!(low <= o && o <= high)) return std::nullopt;
      continue;
    }
    double t_in = departed_part == 2 * axis ? 0 : (low - o) / d;
    double t_out = departed_part == 2 * axis + 1 ? 0 : (high - o) / d;
    int first = 2 * axis, second = first + 1;
    if (d < 0) std::swap(t_in, t_out), std::swap(first, second);
    if (t_in > in) in = t_in, in_part = first;
    if (t_out < out) out = t_out, out_part = second;
  }
  if (!(in <= out)) return std::nullopt;
  const bool entering = in > 0;
  const T t = static_cast<T>(entering ? in : out);
  const int part = entering ? in_part : out_part;
  if constexpr (std::decay_t<Explain>::wanted) {
    const double slope = static_cast<double>(ray.direction[part / 2]);
    explain.plane(static_cast<double>(t) * slope, slope);
  }
  if (!(t > 0 && t < t_max)) return std::nullopt;
  return Crossing<T>{t, part};
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Box<T>& box, const Ray<T>& ray, Crossing<T> crossing) {
  const int axis = crossing.part / 2;
  const bool high = crossing.part % 2 != 0;
  SurfacePoint<T> point{ray.at(crossing.t), Vec3<T>(0)};
  point.position[axis] = high ? box.max[axis] : box.min[axis];
  point.normal[axis] = high ? T(1) : T(-1);
  return point;
}

/// The two axes of the face, from the box's low corner.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Box<T>& box, const SurfacePoint<T>& point, int part) {
  const Vec3<T> from_corner = point.position - box.min;
  const int axis = part / 2;
  return {from_corner[axis == 0 ? 1 : 0], from_corner[axis == 2 ? 1 : 2]};
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Box<T>& box) {
  return {box.min, box.max};
}

}  // namespace raywalk
