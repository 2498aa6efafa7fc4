#pragma once
// Ray differentials: H. Igehy, "Tracing Ray Differentials", SIGGRAPH 1999. A ray is a function of its place (x, y) in
// the picture; its derivatives by x and by y, followed through transfer, reflection and refraction, say how far the
// rays of the neighbouring pixels are away at a hit, without tracing them. Equations are numbered as in the paper.
//
// Here x is to the right and y is up, both in pixels (with n samples a pixel, in the distance of samples, 1 / sqrt(n)
// of a pixel). Lengths are those of the world. D is of unit length; N faces the ray or points away from it, as long as
// its derivative does the same.

#include "math/sampling.h"
#include "math/vec.h"
#include "shape/plane.h"
#include "shape/sphere.h"
#include "trace/optics.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

/// The derivative of a ray (P, D) by x, or by y.
template <class T>
struct RayDerivative {
  Vec3<T> dP{0};  ///< of its origin P
  Vec3<T> dD{0};  ///< of its direction D
};

/// Both: 0 of a ray that has no neighbours.
template <class T>
struct RayDifferential {
  RayDerivative<T> x, y;
};

/// The derivatives by x and by y of the place that a ray hits.
template <class T>
struct HitDifferential {
  Vec3<T> x{0}, y{0};
};

/// Of a ray that was transferred to it.
template <class T>
[[nodiscard]] HitDifferential<T> hit_differential(const RayDifferential<T>& ray) {
  return {ray.x.dP, ray.y.dP};
}

/// The derivatives of a unit normal by x and by y.
template <class T>
struct NormalDifferential {
  Vec3<T> x{0}, y{0};
};

/// Of a ray from the eye, D = d / |d| where d = view + x right + y up (equation 8). `per_length`: 1 / |d|; `right`: for
/// y, up.
template <class T>
[[nodiscard, gnu::always_inline]] inline RayDerivative<T> from_eye(const Vec3<T>& D, T per_length,
                                                                   const Vec3<T>& right) {
  return {Vec3<T>(0), (right - dot(D, right) * D) * per_length};
}

/// From P to the hit P + t D, whose geometric normal is N (equations 10 and 12).
template <class T>
[[nodiscard, gnu::always_inline]] inline RayDerivative<T> transfer(const RayDerivative<T>& ray, const Vec3<T>& D, T t,
                                                                   const Vec3<T>& N) {
  const Vec3<T> without_dt = ray.dP + t * ray.dD;
  const T dt = -dot(without_dt, N) * (1 / dot(D, N));  // divided once for x and y, and without waiting for either
  return {without_dt + dt * D, ray.dD};
}

/// Both from the eye to the hit: of its place alone. What `from_eye` leaves out along D, `transfer` would again.
template <class T>
[[nodiscard, gnu::always_inline]] inline Vec3<T> from_eye_to_hit(const Vec3<T>& D, T per_length, const Vec3<T>& right,
                                                                 T t, const Vec3<T>& N) {
  return (t * per_length) * (right - dot(right, N) * (1 / dot(D, N)) * D);
}

/// At the hit, into the direction D - 2 (D . N) N (equations 14 to 16). `dN`: by x, where the hit moves by dP.
template <class T>
[[nodiscard, gnu::always_inline]] inline RayDerivative<T> reflect(const RayDerivative<T>& ray, const Vec3<T>& D,
                                                                  const Vec3<T>& N, const Vec3<T>& dN) {
  const T D_N = dot(D, N), dD_N = dot(ray.dD, N) + dot(D, dN);
  return {ray.dP, ray.dD - T(2) * (D_N * dN + dD_N * N)};
}

/// At the hit, into the direction eta D - mu N, where mu = eta (D . N) - D' . N (equations 17 to 19). N faces the ray.
/// Not finite where the refracted ray runs along the surface.
template <class T>
[[nodiscard, gnu::always_inline]] inline RayDerivative<T> refract(const RayDerivative<T>& ray, const Vec3<T>& D,
                                                                  const Vec3<T>& N, const Vec3<T>& dN,
                                                                  const Refraction<T>& at) {
  const T eta = at.n1 / at.n2, D_N = -at.cos_in, refracted_N = -at.cos_out;
  const T dD_N = dot(ray.dD, N) + dot(D, dN);
  const T mu = eta * D_N - refracted_N;
  const T dmu = (eta - eta * eta * D_N / refracted_N) * dD_N;
  return {ray.dP, eta * ray.dD - (mu * dN + dmu * N)};
}

template <class T>
[[nodiscard, gnu::always_inline]] inline RayDifferential<T> transfer(const RayDifferential<T>& ray, const Vec3<T>& D,
                                                                     T t, const Vec3<T>& N) {
  return {transfer(ray.x, D, t, N), transfer(ray.y, D, t, N)};
}

template <class T>
[[nodiscard, gnu::always_inline]] inline RayDifferential<T> reflect(const RayDifferential<T>& ray, const Vec3<T>& D,
                                                                    const Vec3<T>& N, const NormalDifferential<T>& dN) {
  return {reflect(ray.x, D, N, dN.x), reflect(ray.y, D, N, dN.y)};
}

template <class T>
[[nodiscard, gnu::always_inline]] inline RayDifferential<T> refract(const RayDifferential<T>& ray, const Vec3<T>& D,
                                                                    const Vec3<T>& N, const NormalDifferential<T>& dN,
                                                                    const Refraction<T>& at) {
  return {refract(ray.x, D, N, dN.x, at), refract(ray.y, D, N, dN.y, at)};
}

/// Of a ray whose direction was drawn from a lobe, which the paper does not have: a sample of density `pdf` stands for
/// a solid angle of 1 / pdf, n samples a pixel for 1 / (n pdf) each. So the derivatives of the direction are two sides
/// of a square of that angle, about the direction; they are never narrower than those of the ray that was scattered.
/// As in F. Suykens and Y. Willems, "Path Differentials and Applications", EGWR 2001, but for its root of n, which
/// shrinks with the distance of samples. `spacing`: that distance, 1 / sqrt(n).
template <class T>
[[nodiscard]] RayDifferential<T> scattered(const RayDifferential<T>& ray, const Vec3<T>& direction, T pdf, T spacing) {
  const T came = std::sqrt(std::max(dot(ray.x.dD, ray.x.dD), dot(ray.y.dD, ray.y.dD)));
  const T width = std::max(spacing / std::sqrt(pdf), came);
  const Basis<T> about(direction);
  return {{ray.x.dP, width * about.s}, {ray.y.dP, width * about.t}};
}

/// How far a pixel reaches in a pattern: the derivatives of (u, v) by x and by y, in the units of u and v.
template <class T>
struct Footprint {
  Vec2<T> x{0}, y{0};
};

/// A place in a pattern, (u, v), and the footprint about it.
template <class T>
struct PlaceInPattern {
  Vec2<T> uv;
  Footprint<T> reach;
};

/// Of a hit on a primitive. `Point`: a SurfacePoint.
template <class T, class Primitives, class Point>
[[nodiscard]] PlaceInPattern<T> place_in_pattern(const HitDifferential<T>& hit, const Primitives& primitives,
                                                 int primitive, const Point& point, int part, T time) {
  if (const auto* plane = primitives.template plain<Plane<T>>(primitive))
    return {uv_at(*plane, point, part),
            {uv_derivative(*plane, point, part, hit.x), uv_derivative(*plane, point, part, hit.y)}};
  return {primitives.uv_at(primitive, point, part, time),
          {primitives.uv_derivative(primitive, point, part, time, hit.x),
           primitives.uv_derivative(primitive, point, part, time, hit.y)}};
}

/// The same of the normal with which a hit is shaded, `shading_normal`: that of the surface, or an interpolated one, on
/// whichever side. One that was bent so as to face the ray (consistent_shading_normal) counts as if it were not.
template <class T, class Primitives, class Point>
[[nodiscard]] NormalDifferential<T> normal_differential(const HitDifferential<T>& hit, const Primitives& primitives,
                                                        int primitive, const Point& point, int part, T time,
                                                        const Vec3<T>& shading_normal) {
  const T side = dot(shading_normal, point.normal) < 0 ? T(-1) : T(1);
  if (primitives.template plain<Plane<T>>(primitive) != nullptr) return {};
  if (const auto* ball = primitives.template plain<Sphere<T>>(primitive))
    return {side * normal_derivative(*ball, point, part, hit.x), side * normal_derivative(*ball, point, part, hit.y)};
  return {side * primitives.normal_derivative(primitive, point, part, time, hit.x),
          side * primitives.normal_derivative(primitive, point, part, time, hit.y)};
}

}  // namespace raywalk
