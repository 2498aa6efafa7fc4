#pragma once

#include "math/exact.h"
#include "shape/intersection.h"

#include <cmath>
#include <utility>

namespace raywalk {

/// An axis-parallel box, solid; flat in at most one axis. Parts: 2 axis + (0 for the low face, 1 for the high one).
template <class T>
struct Box {
  Vec3<T> min{-1}, max{1};  ///< min <= max in each component
  friend bool operator==(const Box&, const Box&) = default;
};

namespace detail {

/// The interval of a line inside the closed box, and the faces by which it enters and leaves.
struct BoxInterval {
  double in = -infinity<double>, out = infinity<double>;
  int in_part = 0, out_part = 0;
};

/// The same in exact arithmetic: the line hits the box when no entry comes after an exit.
template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] std::optional<BoxInterval> exact_interval(const Box<T>& box, const Ray<T>& ray,
                                                                                  int departed_part) {
  struct Face {
    Expansion distance;  ///< along the axis, times the sign of the direction
    double slope = 0;    ///< > 0; 0: the line is parallel to the face
    int part = 0;
    [[nodiscard]] DoubleDouble t() const { return distance.rounded() / DoubleDouble(slope); }
  };
  Face entry[3], exit[3];
  for (int axis = 0; axis < 3; ++axis) {
    const double o = static_cast<double>(ray.origin[axis]), d = static_cast<double>(ray.direction[axis]);
    const int low = 2 * axis, high = low + 1;
    const auto face = [&](int part) {
      const double place = static_cast<double>(part == low ? box.min[axis] : box.max[axis]);
      const Expansion away = part == departed_part ? Expansion() : Expansion(place) - o;
      return Face{d < 0 ? -away : away, std::abs(d), part};
    };
    entry[axis] = face(d < 0 ? high : low);
    exit[axis] = face(d < 0 ? low : high);
  }
  BoxInterval interval;
  DoubleDouble in(interval.in), out(interval.out);
  for (const Face& enters : entry) {
    if (enters.slope == 0) continue;
    for (const Face& leaves : exit)
      if (leaves.slope != 0 && (enters.distance * leaves.slope - leaves.distance * enters.slope).sign() > 0)
        return std::nullopt;
    if (const DoubleDouble t = enters.t(); t.hi > in.hi || (t.hi == in.hi && t.lo > in.lo))
      in = t, interval.in_part = enters.part;
  }
  for (const Face& leaves : exit) {
    if (leaves.slope == 0) continue;
    if (const DoubleDouble t = leaves.t(); t.hi < out.hi || (t.hi == out.hi && t.lo < out.lo))
      out = t, interval.out_part = leaves.part;
  }
  interval.in = in.hi, interval.out = out.hi;
  return interval;
}

}  // namespace detail

/// Nearest t in (0, t_max) at which the ray crosses a face; edges and corners count.
///
/// Slabs (T. Kay and J. Kajiya 1986), chosen by the sign of the direction and compared so that the NaN of an origin in
/// a face's plane without slope passes (T. Ize 2013). All slabs are in double; whether the ray enters one before it
/// leaves another is decided exactly where the two are nearly equal, at an edge. The face that the ray departs from is
/// at t = 0.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Box<T>& box, const Ray<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {}) {
  detail::BoxInterval interval;
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
    if (t_in > interval.in) interval.in = t_in, interval.in_part = first;
    if (t_out < interval.out) interval.out = t_out, interval.out_part = second;
  }
  // Each is correct to two roundings.
  if (std::abs(interval.in - interval.out) <= 8 * detail::half_ulp * std::abs(interval.out)) {
    note_exact(explain);
    const auto exact = detail::exact_interval(box, ray, departed_part);
    if (!exact) return std::nullopt;
    interval = *exact;
  } else if (!(interval.in <= interval.out)) {
    return std::nullopt;
  }
  const bool entering = interval.in > 0;
  const T t = static_cast<T>(entering ? interval.in : interval.out);
  const int part = entering ? interval.in_part : interval.out_part;
  if constexpr (std::decay_t<Explain>::wanted) {
    const double slope = static_cast<double>(ray.direction[part / 2]);
    explain.plane(static_cast<double>(t) * slope, slope);
  }
  if (!(t > 0 && t < t_max)) return std::nullopt;
  return Intersection<T>{t, part};
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Box<T>& box, const Ray<T>& ray, const Intersection<T>& intersection) {
  const int axis = intersection.part / 2;
  const bool high = intersection.part % 2 != 0;
  SurfacePoint<T> point{ray.at(intersection.t), Vec3<T>(0)};
  point.position[axis] = high ? box.max[axis] : box.min[axis];
  point.normal[axis] = high ? T(1) : T(-1);
  return point;
}

/// Whether the first of a face's two axes runs to the right for who looks at it from outside, with the second one up.
[[nodiscard]] constexpr bool runs_to_the_right(int part) { return part == 1 || part == 2 || part == 5; }

/// The two axes of the face, from the corner that is at the lower left seen from outside: what is drawn on it is read
/// from left to right on each face.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Box<T>& box, const SurfacePoint<T>& point, int part) {
  const int across = part / 2 == 0 ? 1 : 0, up = part / 2 == 2 ? 1 : 2;
  return {runs_to_the_right(part) ? point.position[across] - box.min[across] : box.max[across] - point.position[across],
          point.position[up] - box.min[up]};
}

template <class T>
[[nodiscard]] Vec3<T> normal_derivative(const Box<T>& /*box*/, const SurfacePoint<T>& /*point*/, int /*part*/,
                                        const Vec3<T>& /*along*/) {
  return Vec3<T>(0);
}

template <class T>
[[nodiscard]] Vec2<T> uv_derivative(const Box<T>& /*box*/, const SurfacePoint<T>& /*point*/, int part,
                                    const Vec3<T>& along) {
  const T across = along[part / 2 == 0 ? 1 : 0];
  return {runs_to_the_right(part) ? across : -across, along[part / 2 == 2 ? 1 : 2]};
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Box<T>& box) {
  return {box.min, box.max};
}

template <class T>
[[nodiscard]] constexpr bool has_inside(const Box<T>& /*shape*/) {
  return true;
}

template <class Cutter>
void cut(Cutter& to, const Box<double>& box) {
  const Vec3d &l = box.min, &h = box.max;
  to.quad(0, {l.x, l.y, l.z}, {l.x, l.y, h.z}, {l.x, h.y, h.z}, {l.x, h.y, l.z});
  to.quad(1, {h.x, l.y, l.z}, {h.x, h.y, l.z}, {h.x, h.y, h.z}, {h.x, l.y, h.z});
  to.quad(2, {l.x, l.y, l.z}, {h.x, l.y, l.z}, {h.x, l.y, h.z}, {l.x, l.y, h.z});
  to.quad(3, {l.x, h.y, l.z}, {l.x, h.y, h.z}, {h.x, h.y, h.z}, {h.x, h.y, l.z});
  to.quad(4, {l.x, l.y, l.z}, {l.x, h.y, l.z}, {h.x, h.y, l.z}, {h.x, l.y, l.z});
  to.quad(5, {l.x, l.y, h.z}, {h.x, l.y, h.z}, {h.x, h.y, h.z}, {l.x, h.y, h.z});
}

}  // namespace raywalk
