#pragma once

#include "math/bounds.h"
#include "math/elementary.h"

#include <cmath>
#include <optional>

namespace raywalk {

/// An affine map p -> M p + move, as 3 columns of M. Directions and normals leave `move` out.
template <class T>
struct Affine {
  Vec3<T> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  ///< images of the three axes
  Vec3<T> move{0};
  friend bool operator==(const Affine&, const Affine&) = default;

  [[nodiscard]] Vec3<T> direction(const Vec3<T>& v) const { return v.x * x + v.y * y + v.z * z; }
  [[nodiscard]] Vec3<T> point(const Vec3<T>& p) const { return direction(p) + move; }
  [[nodiscard]] T determinant() const { return dot(x, cross(y, z)); }

  /// The image of a surface's normal, not of unit length: by the cofactor matrix, turned so that outside stays outside
  /// under a reflection. Correct for every invertible map.
  [[nodiscard]] Vec3<T> normal(const Vec3<T>& n) const {
    const Vec3<T> image = n.x * cross(y, z) + n.y * cross(z, x) + n.z * cross(x, y);
    return determinant() < 0 ? -image : image;
  }
};

/// |M| v: the sizes of the terms that a point with coordinates up to `v` is mapped by. The rounding of its image is in
/// proportion to them.
template <class T>
[[nodiscard]] Vec3<T> term_sizes(const Affine<T>& m, const Vec3<T>& v) {
  return v.x * absolute(m.x) + v.y * absolute(m.y) + v.z * absolute(m.z);
}

/// The composition: first `inner`, then `outer`.
template <class T>
[[nodiscard]] Affine<T> operator*(const Affine<T>& outer, const Affine<T>& inner) {
  return {outer.direction(inner.x), outer.direction(inner.y), outer.direction(inner.z), outer.point(inner.move)};
}

template <class T>
[[nodiscard]] Affine<T> translation(const Vec3<T>& by) {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, by};
}

template <class T>
[[nodiscard]] Affine<T> scaling(const Vec3<T>& by) {
  return {{by.x, 0, 0}, {0, by.y, 0}, {0, 0, by.z}, Vec3<T>(0)};
}

/// Right-hand rule about `axis` (any length but 0) through the origin. Quarter turns are exact.
template <class T>
[[nodiscard]] Affine<T> rotation(const Vec3<T>& axis, T degrees) {
  const T turn = std::remainder(degrees, T(360));
  constexpr T pi = static_cast<T>(3.14159265358979323846L);
  auto [s, c] = portable::sin_cos(turn * (pi / 180));
  if (turn == 0) c = 1, s = 0;
  if (std::abs(turn) == 90) c = 0, s = turn > 0 ? T(1) : T(-1);
  if (std::abs(turn) == 180) c = -1, s = 0;
  const Vec3<T> a = normalize(axis);
  const auto image = [&](const Vec3<T>& v) { return c * v + s * cross(a, v) + ((1 - c) * dot(a, v)) * a; };
  return {image({1, 0, 0}), image({0, 1, 0}), image({0, 0, 1}), Vec3<T>(0)};
}

/// None when the map is singular, or so close to it that the inverse is not finite.
template <class T>
[[nodiscard]] std::optional<Affine<T>> inverse(const Affine<T>& m) {
  const T determinant = m.determinant();
  const Vec3<T> yz = cross(m.y, m.z) / determinant, zx = cross(m.z, m.x) / determinant,
                xy = cross(m.x, m.y) / determinant;
  Affine<T> inverted{{yz.x, zx.x, xy.x}, {yz.y, zx.y, xy.y}, {yz.z, zx.z, xy.z}, Vec3<T>(0)};
  inverted.move = -inverted.direction(m.move);
  if (determinant == 0 || !is_finite(inverted.x) || !is_finite(inverted.y) || !is_finite(inverted.z) ||
      !is_finite(inverted.move))
    return std::nullopt;
  return inverted;
}

/// The bounds of a box's image; unbounded stays unbounded.
template <class T>
[[nodiscard]] Bounds<T> image_of(const Affine<T>& m, const Bounds<T>& box) {
  if (box.empty()) return box;
  if (!box.bounded()) return {Vec3<T>(-infinity<T>), Vec3<T>(infinity<T>)};
  Bounds<T> image;
  for (int corner = 0; corner < 8; ++corner)
    image.include(m.point(
        {(corner & 1 ? box.max : box.min).x, (corner & 2 ? box.max : box.min).y, (corner & 4 ? box.max : box.min).z}));
  return image;
}

}  // namespace raywalk
