#pragma once

#include "math/elementary.h"
#include "math/expansion.h"
#include "shape/intersection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace raywalk {

template <class T>
struct Sphere {
  Vec3<T> centre{0};
  T radius{1};  ///< > 0
  friend bool operator==(const Sphere&, const Sphere&) = default;
};

/// The nearest t in (0, t_max) at which the ray crosses the sphere; a tangent ray counts as a hit.
///
/// With o the origin seen from the centre, a = d.d, b = d.o, c = o.o - r^2: the roots of a t^2 + 2 b t + c. Hit or miss
/// is decided by the perpendicular form a r^2 - |o x d|^2 of b^2 - a c (Haines et al., "Precision Improvements for
/// Ray/Sphere Intersection", Ray Tracing Gems 2019), computed in double even for float rays. Where its error bound does
/// not settle the sign, or the origin is so near the surface that c has lost its digits, the same formulas run in
/// double-double, and exactly where even those cancel. A ray that departs from this sphere has c = 0 exactly: the other
/// root is -2b/a.
template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Sphere<T>& sphere, const Ray<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {});

/// The number of intersections with the sphere in (0, t_max): 0, 1 or 2. A tangent ray has one.
template <class T, class Explain = NoExplanation>
[[nodiscard]] int intersection_count(const Sphere<T>& sphere, const Ray<T>& ray, T t_max, int departed_part = no_part,
                                     Explain&& explain = {}) {
  const auto first = intersect(sphere, ray, t_max, departed_part, explain);
  if (!first) return 0;
  // Both are equally far from the point closest to the centre; the first one found is the nearer, if both lie ahead.
  const Vec3d d = wide(ray.direction);
  const double middle = -dot(d, wide(ray.origin) - wide(sphere.centre)) / dot(d, d);
  const T other = static_cast<T>(2 * middle - static_cast<double>(first->t));
  return other > first->t && other < t_max ? 2 : 1;
}

template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Sphere<T>& sphere, const Ray<T>& ray,
                                         const Intersection<T>& intersection);

/// Longitude from +x and latitude from the plan, each times the radius.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Sphere<T>& sphere, const SurfacePoint<T>& point, int /*part*/) {
  const T longitude = portable::atan2(point.normal.y, point.normal.x);
  const T latitude = portable::atan2(point.normal.z, length(plan(point.normal)));
  return {sphere.radius * longitude, sphere.radius * latitude};
}

template <class T>
[[nodiscard]] Vec3<T> normal_derivative(const Sphere<T>& sphere, const SurfacePoint<T>& /*point*/, int /*part*/,
                                        const Vec3<T>& along) {
  return along / sphere.radius;
}

template <class T>
[[nodiscard]] Vec2<T> uv_derivative(const Sphere<T>& /*sphere*/, const SurfacePoint<T>& point, int /*part*/,
                                    const Vec3<T>& along) {
  const Vec3<T>& n = point.normal;
  const T square = n.x * n.x + n.y * n.y, level = std::sqrt(square);
  const T outwards = (n.x * along.x + n.y * along.y) / level;
  return {(n.x * along.y - n.y * along.x) / square, level * along.z - n.z * outwards};
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Sphere<T>& sphere) {
  return {sphere.centre - Vec3<T>(sphere.radius), sphere.centre + Vec3<T>(sphere.radius)};
}

namespace detail {

/// With size = o.o + r^2: the discriminant errs by at most about 20 a size ulp, which this exceeds, and c by 5 size
/// ulp; c must keep half of its digits.
inline constexpr double sphere_sign_bound = 32 * 1.1102230246251565e-16, sphere_digits_bound = 1e-8;

/// The two roots of a t^2 + 2 b t + c, ascending, and b^2 - a c; no roots (NaN) when that is negative.
struct Roots {
  double near, far, discriminant;
};

/// c and the discriminant, rounded only once: for cancellation beyond double-double's digits, as at a tangent from afar
/// or right on the surface.
struct SphereTerms {
  DoubleDouble c, discriminant;
};
[[nodiscard, gnu::noinline, gnu::cold]] inline SphereTerms exact_sphere_terms(const Vec3d& origin, const Vec3d& d,
                                                                              const Vec3d& centre, double radius) {
  const Expansion x = Expansion(origin.x) - centre.x, y = Expansion(origin.y) - centre.y,
                  z = Expansion(origin.z) - centre.z, r2 = Expansion(radius) * radius;
  const Expansion cx = y * d.z - z * d.y, cy = z * d.x - x * d.z, cz = x * d.y - y * d.x;
  const Expansion a = Expansion(d.x) * d.x + Expansion(d.y) * d.y + Expansion(d.z) * d.z;
  return {(x * x + y * y + z * z - r2).rounded(), (a * r2 - (cx * cx + cy * cy + cz * cz)).rounded()};
}

/// The sphere's roots in double-double arithmetic on the ray as stored; exactly where that is not enough.
template <class T>
[[nodiscard, gnu::noinline, gnu::cold]] Roots roots_exactly(const Sphere<T>& sphere, const Ray<T>& ray) {
  const Vec3d origin = wide(ray.origin), direction = wide(ray.direction), centre = wide(sphere.centre);
  const double radius = static_cast<double>(sphere.radius);
  const DoubleDouble ox = two_sum(origin.x, -centre.x), oy = two_sum(origin.y, -centre.y),
                     oz = two_sum(origin.z, -centre.z);
  const DoubleDouble dx(direction.x), dy(direction.y), dz(direction.z);
  const DoubleDouble a = dx * dx + dy * dy + dz * dz;
  const DoubleDouble b = dx * ox + dy * oy + dz * oz;
  const DoubleDouble oo = ox * ox + oy * oy + oz * oz, r2 = two_product(radius, radius);
  const DoubleDouble cx = oy * dz - oz * dy, cy = oz * dx - ox * dz, cz = ox * dy - oy * dx;
  DoubleDouble c = oo - r2, discriminant = a * r2 - (cx * cx + cy * cy + cz * cz);
  // Each errs by less than 2^-96 of `size`; 43 bits may cancel before the last digit of a double is in doubt.
  constexpr double cancelled = 1e-13;
  const double size = oo.hi + r2.hi;
  if (!(std::abs(c.hi) > cancelled * size && std::abs(discriminant.hi) > cancelled * a.hi * size)) {
    const SphereTerms exact = exact_sphere_terms(origin, direction, centre, radius);
    c = exact.c, discriminant = exact.discriminant;
  }
  if (discriminant.hi < 0) return {NAN, NAN, discriminant.hi};
  const DoubleDouble root = sqrt(discriminant);
  // Only quantities of one sign are added, so that neither root cancels.
  const DoubleDouble q = b.hi > 0 ? -(b + root) : root - b;
  if (q.hi == 0) return {0, 0, discriminant.hi};
  const double t0 = static_cast<double>(q / a), t1 = static_cast<double>(c / q);
  return {std::min(t0, t1), std::max(t0, t1), discriminant.hi};
}

}  // namespace detail

template <class T, class Explain>
std::optional<Intersection<T>> intersect(const Sphere<T>& sphere, const Ray<T>& ray, T t_max, int departed_part,
                                         Explain&& explain) {
  constexpr bool explained = std::decay_t<Explain>::wanted;
  const Vec3d o = wide(ray.origin) - wide(sphere.centre), d = wide(ray.direction);
  // Rounded before comparison: a t that is positive in double may be 0 in float, and is then no intersection.
  const auto nearest = [&](double near, double far) -> std::optional<Intersection<T>> {
    T t = static_cast<T>(near);
    if (!(t > 0)) t = static_cast<T>(far);
    if (!(t > 0 && t < t_max)) return std::nullopt;  // NaN: no roots
    return Intersection<T>{t};
  };
  if (departed_part != no_part) {
    const double b = dot(d, o);
    if (!explained && b >= 0) return std::nullopt;
    const double a = dot(d, d), root = -2 * b / a;
    if constexpr (explained) explain.quadratic(a, 2 * b, 0, 4 * b * b, std::min(0.0, root), std::max(0.0, root));
    return nearest(root, root);
  }
  const double radius = static_cast<double>(sphere.radius), r2 = radius * radius;
  const double a = dot(d, d), b = dot(d, o), oo = dot(o, o), c = oo - r2, size = oo + r2;
  if constexpr (!explained) {  // an explainer is told everything
    // Outside and pointing away: both roots, if any, lie behind.
    if (b > 0 && c > detail::sphere_digits_bound * size) return std::nullopt;
    // Most other rays miss by so much that b^2 - a c can tell, which errs by about 21 a size ulp.
    if (b * b < a * (c - detail::sphere_sign_bound * size)) return std::nullopt;
  }
  const Vec3d oxd = cross(o, d);
  const double discriminant = a * r2 - dot(oxd, oxd), doubt = detail::sphere_sign_bound * a * size;
  if (std::abs(discriminant) <= doubt || std::abs(c) <= detail::sphere_digits_bound * size) {
    note_exact(explain);
    const detail::Roots roots = detail::roots_exactly(sphere, ray);
    if constexpr (explained) explain.quadratic(a, 2 * b, c, 4 * roots.discriminant, roots.near, roots.far);
    return nearest(roots.near, roots.far);
  }
  if constexpr (explained) {
    const double root = std::sqrt(discriminant), q = b > 0 ? -(b + root) : root - b;
    explain.quadratic(a, 2 * b, c, 4 * discriminant, std::min(q / a, c / q), std::max(q / a, c / q));
  }
  if (discriminant < 0) return std::nullopt;
  const double root = std::sqrt(discriminant);
  // Only quantities of one sign are added: no root cancels. From outside and approaching, c / q is the nearer one.
  if (b > 0) return nearest(c / -(b + root), NAN);  // from inside: the other root is behind
  const double q = root - b;
  return c > 0 ? nearest(c / q, q / a) : nearest(q / a, NAN);
}

template <class T>
SurfacePoint<T> surface_at(const Sphere<T>& sphere, const Ray<T>& ray, const Intersection<T>& intersection) {
  // The computed point is projected onto the sphere along the normal; a point in the plan stays in the plan. It is
  // formed relative to the centre: far from the scene's origin, the point itself has too few digits for a normal.
  const Vec3<T> offset = (ray.origin - sphere.centre) + intersection.t * ray.direction;
  // Its length is the radius up to rounding, usually so closely that one step of Newton's method normalises it without
  // a square root.
  constexpr T little = T(1) / (1 << (std::numeric_limits<T>::digits / 2 + 1));
  const Vec3<T> nearly_unit = offset * (1 / sphere.radius);
  if (std::abs(dot(nearly_unit, nearly_unit) - 1) < little) {
    const Vec3<T> normal = renormalize(nearly_unit);
    return {sphere.centre + sphere.radius * normal, normal};
  }
  const T distance = length(offset);
  // A sphere smaller than the last digit of t is hit in its centre: use the normal that faces the ray.
  const Vec3<T> normal = distance > 0 ? offset / distance : -normalize(ray.direction);
  return {sphere.centre + sphere.radius * normal, normal};
}

template <class T>
[[nodiscard]] constexpr bool has_inside(const Sphere<T>& /*shape*/) {
  return true;
}

template <class Cutter>
void cut(Cutter& to, const Sphere<double>& sphere) {
  const double pole = std::numbers::pi / 2, radius = sphere.radius;
  to.swept(0, Cutter::round_profile(to.sides(radius) / 2, -pole, pole, radius), radius, radius, sphere.centre);
}

}  // namespace raywalk
