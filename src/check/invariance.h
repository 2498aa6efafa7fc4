#pragma once

#include "check/judge.h"

namespace raywalk::check {

enum class Invariance { mirrored, scaled };

/// The mirror image in the plane x = 0. Quadrics are symmetric.
template <class T>
Vec3<T> mirrored(const Vec3<T>& v) {
  return {-v.x, v.y, v.z};
}
template <class T>
Sphere<T> mirrored(const Sphere<T>& s) {
  return {mirrored(s.centre), s.radius};
}
template <class T>
Plane<T> mirrored(const Plane<T>& s) {
  return {mirrored(s.point), mirrored(s.normal)};
}
template <class T>
Disk<T> mirrored(const Disk<T>& s) {
  return {mirrored(s.centre), mirrored(s.normal), s.radius};
}
template <class T>
Box<T> mirrored(const Box<T>& s) {
  return {{-s.max.x, s.min.y, s.min.z}, {-s.min.x, s.max.y, s.max.z}};
}
template <class T, QuadricKind Kind>
Quadric<T, Kind> mirrored(const Quadric<T, Kind>& s) {
  return s;
}

/// All lengths times 4^k.
template <class T>
T scaled(T length, int k) {
  return std::ldexp(length, 2 * k);
}
template <class T>
Vec3<T> scaled(const Vec3<T>& v, int k) {
  return {scaled(v.x, k), scaled(v.y, k), scaled(v.z, k)};
}
template <class T>
Sphere<T> scaled(const Sphere<T>& s, int k) {
  return {scaled(s.centre, k), scaled(s.radius, k)};
}
template <class T>
Plane<T> scaled(const Plane<T>& s, int k) {
  return {scaled(s.point, k), s.normal};
}
template <class T>
Disk<T> scaled(const Disk<T>& s, int k) {
  return {scaled(s.centre, k), s.normal, scaled(s.radius, k)};
}
template <class T>
Box<T> scaled(const Box<T>& s, int k) {
  return {scaled(s.min, k), scaled(s.max, k)};
}
template <class T, QuadricKind Kind>
Quadric<T, Kind> scaled(Quadric<T, Kind> s, int k) {
  s.z_min = scaled(s.z_min, k), s.z_max = scaled(s.z_max, k);
  if (Kind == QuadricKind::cone) return s;                               // its radii are slopes
  const int own = Kind == QuadricKind::elliptic_paraboloid ? k : 2 * k;  // x^2 / rx^2 = z
  for (int axis = 0; axis < 3; ++axis) s.radii[axis] = std::ldexp(s.radii[axis], own);
  return s;
}

template <class S, class T>
[[nodiscard]] Tally test_invariance(Invariance invariance, std::uint64_t seed, std::uint64_t first,
                                    std::uint64_t count) {
  Tally tally;
  for (std::uint64_t number = first; number < first + count; ++number) {
    Random random(seed, 60, number);
    const auto stratum = static_cast<Stratum>(random.whole(0, stratum_count - 1));
    // Numbers that underflow do not scale bit by bit.
    if (invariance == Invariance::scaled && stratum == Stratum::subnormal) continue;
    const auto tried = aim<S, T>(stratum, random);
    if (!tried) continue;
    const int k = invariance == Invariance::scaled ? random.whole(-8, 8) : 0;
    const Case<S, T> image =
        invariance == Invariance::mirrored
            ? Case<S, T>{mirrored(tried->shape), {mirrored(tried->ray.origin), mirrored(tried->ray.direction)}}
            : Case<S, T>{scaled(tried->shape, k), {scaled(tried->ray.origin, k), tried->ray.direction}};
    const auto one = intersect(tried->shape, tried->ray, infinity<T>),
               other = intersect(image.shape, image.ray, infinity<T>);
    if (one && !std::isfinite(scaled(one->t, k))) continue;  // out of range, and so no intersection
    ++tally.rays;
    tally.hits += one.has_value();
    tally.unequal += one.has_value() != other.has_value() || (one && other->t != scaled(one->t, k));
  }
  return tally;
}

}  // namespace raywalk::check
