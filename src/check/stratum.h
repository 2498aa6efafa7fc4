#pragma once
// Where rays are aimed: the places where intersection tests are known to fail.

#include "check/random.h"
#include "shape/shape.h"

#include <array>
#include <string_view>

namespace raywalk::check {

enum class Stratum {
  random,
  tangent,
  exactly_tangent,
  far,
  scales,
  translations,
  zero_components,
  on_surface,
  inside,
  apex_and_rim,
  parallel,
  subnormal,
};
inline constexpr int stratum_count = 12;

[[nodiscard]] constexpr std::string_view stratum_name(Stratum stratum) {
  switch (stratum) {
    case Stratum::random:
      return "random";
    case Stratum::tangent:
      return "tangent +-2^-k";
    case Stratum::exactly_tangent:
      return "exactly tangent";
    case Stratum::far:
      return "distance 1..1e15";
    case Stratum::scales:
      return "scales 1e-6..1e9";
    case Stratum::translations:
      return "translations +-1e9";
    case Stratum::zero_components:
      return "components +-0";
    case Stratum::on_surface:
      return "on the surface";
    case Stratum::inside:
      return "inside";
    case Stratum::apex_and_rim:
      return "apex and rim";
    case Stratum::parallel:
      return "parallel";
    case Stratum::subnormal:
      return "subnormal";
  }
  return "";
}

/// A shape and a ray to test it with.
template <class S, class T>
struct Case {
  S shape;
  Ray<T> ray;
};

/// What a shape provides for aiming rays at it. `ShapeTraits<S>` has:
///   placed whether the shape is always about the origin, so that translations move the ray instead
///   make a shape of random proportions, of about the size `scale`, at `centre`
///   size, centre     of what was made, as stored
///   surface          a point of the surface
///   interior         a point inside (of a flat shape: on it)
///   silhouette       a point where, as seen from `eye`, hit and miss meet
///   special          an apex, a point of a rim, a corner
///   parallel         a direction along a face, a side or an asymptote
///   exactly_tangent  a case in whole numbers that touches and does not cross, or runs through an edge
template <class S>
struct ShapeTraits;

/// Numbers a^2 + b^2 = h^2.
struct Triple {
  int a, b, h;
};
[[nodiscard]] inline Triple pythagorean(Random& random) {
  constexpr std::array<Triple, 8> triples{
      {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}, {0, 1, 1}, {12, 35, 37}, {9, 40, 41}}};
  Triple t = triples[static_cast<std::size_t>(random.whole(0, 7))];
  if (random.coin()) t = {t.b, t.a, t.h};
  return {random.coin() ? t.a : -t.a, random.coin() ? t.b : -t.b, t.h};
}

/// The components rotated by `turns` places: integer cases are tested along all axes.
template <class V>
[[nodiscard]] V turned(const V& v, int turns) {
  return turns == 0 ? v : turns == 1 ? V{v.z, v.x, v.y} : V{v.y, v.z, v.x};
}

/// A random direction perpendicular to `axis`.
[[nodiscard]] inline Vec3d across(const Vec3d& axis, Random& random) {
  for (;;) {
    const Vec3d side = raywalk::cross(axis, random.unit());
    const double size = length(side);
    if (size > 1e-3 * length(axis)) return side / size;
  }
}

}  // namespace raywalk::check
