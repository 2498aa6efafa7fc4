#pragma once
// Sampling: maps from the unit square to disks, cones, hemispheres, triangles and the solid angle of a light, each with
// its pdf. The maps are continuous where possible, so that stratification is preserved. Directions in a local frame
// have the axis as +z.

#include "math/elementary.h"
#include "math/power.h"
#include "math/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace raywalk {

using std::numbers::pi_v;

/// Two axes that make a right-handed frame with a unit vector (T. Duff et al., "Building an Orthonormal Basis,
/// Revisited", JCGT 6(1), 2017).
template <class T>
struct Basis {
  [[gnu::always_inline]] explicit Basis(const Vec3<T>& unit) : n(unit) {
    const T sign = std::copysign(T(1), n.z);
    const T a = -1 / (sign + n.z);
    const T b = n.x * n.y * a;
    s = {1 + sign * n.x * n.x * a, sign * b, -sign * n.x};
    t = {b, sign + n.y * n.y * a, -n.y};
  }
  [[nodiscard]] Vec3<T> to_world(const Vec3<T>& local) const { return local.x * s + local.y * t + local.z * n; }

  Vec3<T> s, t, n;
};

namespace detail {

/// Of an angle in -pi / 4..pi / 4 by their Taylor series, within two units in the last place of T: all that a sample's
/// place needs, at a third of the price of correct rounding.
template <class T>
[[nodiscard]] constexpr portable::SineCosine<T> sin_cos_of_octant(T angle) {
  const auto series = [square = angle * angle](auto first, auto... divisors) {
    T sum = T(1) / T(first);
    ((sum = sum * square + T(1) / T(divisors)), ...);
    return sum * square;
  };
  return {angle + angle * series(355687428096000, -1307674368000, 6227020800, -39916800, 362880, -5040, 120, -6),
          1 + series(20922789888000, -87178291200, 479001600, -3628800, 40320, -720, 24, -2)};
}

}  // namespace detail

/// A point of the unit disk; pdf 1 / pi. Squares about the centre become circles (P. Shirley and K. Chiu, "A Low
/// Distortion Map Between Disk and Square", JGT 2(3), 1997).
template <class T>
[[nodiscard]] Vec2<T> sample_concentric_disk(const Vec2<T>& u) {
  const T x = 2 * u.x - 1, y = 2 * u.y - 1;
  if (x == 0 && y == 0) return {0, 0};
  const bool wide = std::abs(x) > std::abs(y);
  const T radius = wide ? x : y;
  const auto [sin, cos] = detail::sin_cos_of_octant(pi_v<T> / 4 * (wide ? y / x : x / y));
  return {radius * (wide ? cos : sin), radius * (wide ? sin : cos)};
}

/// A direction uniform within the cone about +z whose 1 - cos(half angle) is given, in (0, 2]. Accurate for the
/// narrowest cones, where cos(half angle) rounds to 1.
template <class T>
[[nodiscard]] Vec3<T> sample_uniform_cone(const Vec2<T>& u, T one_minus_cos) {
  const Vec2<T> disk = sample_concentric_disk(u);
  // Archimedes: equal areas of the disk map to equal steps of 1 - cos.
  const T share = std::min(dot(disk, disk), T(1));
  const T down = share * one_minus_cos;                     // 1 - cos of the direction itself
  const T stretch = std::sqrt(one_minus_cos * (2 - down));  // sin / radius
  return {disk.x * stretch, disk.y * stretch, 1 - down};
}
template <class T>
[[nodiscard]] constexpr T uniform_cone_pdf(T one_minus_cos) {
  return 1 / (2 * pi_v<T> * one_minus_cos);
}
/// 1 - cos of an angle in radians, without cancellation.
template <class T>
[[nodiscard]] T one_minus_cos_of(T angle) {
  const T half = portable::sin(angle / 2);
  return 2 * half * half;
}

/// A direction uniform on the sphere; pdf 1 / (4 pi).
template <class T>
[[nodiscard]] Vec3<T> sample_uniform_sphere(const Vec2<T>& u) {
  return sample_uniform_cone(u, T(2));
}

/// One of `grid` * `grid` points all around the sphere, for grid > 1: in belts of as many, every second one half a step
/// on. The heights are the middles of belts of equal area, moved apart until the points have the sphere's own mean and
/// mean squares (a spherical 2-design: P. Delsarte, J. M. Goethals and J. J. Seidel, "Spherical codes and designs",
/// 1977; of 2 x 2 the regular tetrahedron). `sample_uniform_sphere` at the middles of squares has not: of 2 x 2 all
/// have z = 1/2.
template <class T>
[[nodiscard]] Vec3<T> regular_on_sphere(int point, int grid) {
  const int belt = point / grid, step = point % grid;
  const T z = static_cast<T>(grid - 1 - 2 * belt) / std::sqrt(static_cast<T>(grid) * static_cast<T>(grid) - 1);
  const auto [sin, cos] = portable::sin_cos(pi_v<T> * static_cast<T>(2 * step + belt % 2) / static_cast<T>(grid));
  const T radius = std::sqrt(1 - z * z);
  return {radius * cos, radius * sin, z};
}

/// A cosine-weighted direction above z = 0 (N. Malley: a point of the disk, projected up).
template <class T>
[[nodiscard]] Vec3<T> sample_cosine_hemisphere(const Vec2<T>& u) {
  const Vec2<T> disk = sample_concentric_disk(u);
  return {disk.x, disk.y, std::sqrt(std::max(1 - dot(disk, disk), T(0)))};
}
template <class T>
[[nodiscard]] constexpr T cosine_hemisphere_pdf(T cos) {
  return cos > 0 ? cos / pi_v<T> : T(0);
}

/// A direction above z = 0 weighted by a power >= 0 of its cosine: the lobe about a mirrored ray (Phong) or of half
/// vectors (Blinn).
template <class T>
[[nodiscard]] Vec3<T> sample_power_cosine(const Vec2<T>& u, T exponent) {
  const Vec2<T> disk = sample_concentric_disk(u);
  // The fraction of directions nearer to the axis. The disk's rim would be the horizon, whatever the power: the last
  // step of the random numbers is kept off it.
  const T share = std::min(dot(disk, disk), 1 - T(0x1p-24));
  // cos = (1 - share)^(1 / (exponent + 1)). For a sharp lobe 1 - cos is small: computed directly.
  const T down = -portable::expm1(portable::log1p(-share) / (exponent + 1)), cos = 1 - down;
  const T stretch = share > 0 ? std::sqrt(down * (1 + cos) / share) : T(0);
  return {disk.x * stretch, disk.y * stretch, cos};
}
template <class T>
[[nodiscard]] T power_cosine_pdf(T cos, T exponent) {
  return cos > 0 ? (exponent + 1) / (2 * pi_v<T>)*power(cos, exponent) : T(0);
}

/// Barycentric weights of the second and third corner for a point uniform in a triangle; pdf 1 / area (G. Turk 1990).
template <class T>
[[nodiscard]] Vec2<T> sample_uniform_triangle(const Vec2<T>& u) {
  const T root = std::sqrt(u.x);
  return {root * (1 - u.y), root * u.y};
}

/// Converts a pdf per area at a point of a surface to one per solid angle; `to_point` (not 0) leads there, and `normal`
/// is its unit normal. Infinite edge-on.
template <class T>
[[nodiscard]] T solid_angle_pdf(T area_pdf, const Vec3<T>& to_point, const Vec3<T>& normal) {
  const T squared = dot(to_point, to_point);
  const T cos = std::abs(dot(to_point, normal)) / std::sqrt(squared);
  return cos > 0 ? area_pdf * squared / cos : std::numeric_limits<T>::infinity();
}

/// The cone that a sphere subtends at a point.
template <class T>
struct SubtendedCone {
  bool from_inside;  ///< or on it: the sphere subtends all directions
  T one_minus_cos;   ///< of the cone's half angle, from outside; 0 for radius 0
};
template <class T>
[[nodiscard]] SubtendedCone<T> subtended_cone(const Vec3<T>& point, const Vec3<T>& centre, T radius) {
  const Vec3<T> to_centre = centre - point;
  const T squared = dot(to_centre, to_centre);
  if (!(radius * radius < squared)) return {true, 0};
  const T sin2 = radius * radius / squared;
  // sin^2 / (1 + cos): computed directly, 1 - cos of a distant sphere would be 0 or one ulp.
  return {false, sin2 / (1 + std::sqrt(1 - sin2))};
}
/// A unit direction towards the sphere from outside, uniform over those that hit it (P. Shirley, C. Wang and K.
/// Zimmerman, "Monte Carlo Techniques for Direct Lighting Calculations", TOG 15(1), 1996). Its pdf is uniform_cone_pdf.
/// For radius 0: the direction of the centre.
template <class T>
[[nodiscard]] Vec3<T> sample_subtended_cone(const Vec2<T>& u, const Vec3<T>& point, const Vec3<T>& centre,
                                            const SubtendedCone<T>& seen) {
  const Basis<T> basis(normalize(centre - point));
  if (seen.one_minus_cos == 0) return basis.n;
  return basis.to_world(sample_uniform_cone(u, seen.one_minus_cos));
}

/// The falloff of a spot at an angle: 1 within the inner cone, 0 outside the outer one, between them a smooth step of
/// the cosine. cos_inner >= cos_outer; equal ones make a sharp edge, which is lit.
template <class T>
[[nodiscard]] constexpr T spot_falloff(T cos, T cos_inner, T cos_outer) {
  if (cos >= cos_inner) return 1;
  if (cos <= cos_outer) return 0;
  const T x = (cos - cos_outer) / (cos_inner - cos_outer);
  return x * x * (3 - 2 * x);
}

/// The solid angle that a rectangle subtends at a point: C. Ureña, M. Fajardo and A. King, "An Area-Preserving
/// Parametrization for Spherical Rectangles", EGSR 2013. Where its sum of angles would cancel, `usable` is false and
/// the solid angle is small enough to sample by area. In double for all scalars.
class SphericalRectangle {
 public:
  /// What of a rectangle is the same wherever it is seen from. Its unit of length is the rectangle's first edge.
  struct Axes {
    Axes() = default;  ///< mean nothing
    /// Of edges that are perpendicular, neither of them 0.
    Axes(const Vec3d& u, const Vec3d& v) : height(length(v) / length(u)) {
      const double unit = 1 / length(u);
      x = unit * normalize(u);
      y = unit * normalize(v);
      z = unit * normalize(cross(u, v));
    }
    double height;  ///< of the second edge
    Vec3d x, y, z;  ///< as long as makes a product with them a length in that unit
  };
  SphericalRectangle(const Vec3d& point, const Vec3d& corner, const Axes& axes);

  [[nodiscard]] bool usable() const { return solid_angle_ > 1e-5; }
  [[nodiscard]] double solid_angle() const { return solid_angle_; }
  /// A point on the rectangle, in fractions of u and v, uniform in solid angle: pdf 1 / solid_angle.
  [[nodiscard]] Vec2d point_at(const Vec2d& unit) const;

 private:
  double x0_, x1_, y0_, y1_, z_;  ///< the rectangle in its own axes, seen from the point; z >= 0
  double height_, solid_angle_;
  Vec2d left_;  ///< cosine and sine, times a length, of the angle at which its first edge x = x0 begins
};

}  // namespace raywalk
