#pragma once

#include "math/inlining.h"
#include "math/power.h"
#include "math/vec.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace raywalk {

/// Reflects `incident` (towards the surface) at unit `normal`; keeps the length.
template <class T>
[[nodiscard]] Vec3<T> reflect(const Vec3<T>& incident, const Vec3<T>& normal) {
  return incident - 2 * dot(incident, normal) * normal;
}

/// The cosine along / sqrt(square) to a power >= 0; negative cosines count as 0. Even powers need no root.
template <class T>
[[nodiscard]] T power_of_cosine(T along, T square, T exponent) {
  if (!(along > 0)) return exponent == 0 ? T(1) : T(0);
  if (const auto half = small_whole(exponent / 2)) return whole_power(along * along / square, *half);
  return power(along / std::sqrt(square), exponent);
}

/// A unit ray hits a surface between indices n1 (its side) and n2. The normal faces the ray.
template <class T>
struct Refraction {
  T n1, n2;
  T cos_in;  ///< cosine of the angle of incidence, in 0..1
  T k;       ///< squared cosine beyond; < 0: total internal reflection. Exactly 0 is still refracted, along the surface
  T cos_out;  ///< sqrt(k), or 0

  [[nodiscard]] bool total() const { return k < 0; }
  /// Unpolarised reflectance, in 0..1: Fresnel's equations for a dielectric. At grazing incidence both cosines may be
  /// 0: everything is reflected. Computed on demand: it costs two divisions.
  [[nodiscard, RAYWALK_INLINE]] T fresnel() const {
    const T s_sum = n1 * cos_in + n2 * cos_out, p_sum = n2 * cos_in + n1 * cos_out;
    if (total() || s_sum == 0 || p_sum == 0) return 1;
    const T rs = (n1 * cos_in - n2 * cos_out) / s_sum, rp = (n2 * cos_in - n1 * cos_out) / p_sum;
    return (rs * rs + rp * rp) / 2;
  }
};

template <class T>
[[nodiscard, RAYWALK_INLINE]] inline Refraction<T> refraction_at(const Vec3<T>& unit_incident,
                                                                 const Vec3<T>& facing_normal, T n1, T n2) {
  const T cos_in = std::clamp(-dot(unit_incident, facing_normal), T(0), T(1));
  // 1 - eta^2 (1 - cos^2), over n2^2 so that neither equal indices nor the critical angle lose digits: the difference
  // of similar indices is exact, and no rounded eta is involved.
  const T inwards = n1 * cos_in;
  const T k = ((n2 - n1) * (n2 + n1) + inwards * inwards) / (n2 * n2);
  return {n1, n2, cos_in, k, k < 0 ? T(0) : std::sqrt(k)};
}

/// The refracted direction by Snell's law, unit length up to rounding; none under total internal reflection.
template <class T>
[[nodiscard]] std::optional<Vec3<T>> refract(const Vec3<T>& unit_incident, const Vec3<T>& facing_normal,
                                             const Refraction<T>& at) {
  if (at.total()) return std::nullopt;
  const T eta = at.n1 / at.n2;
  return eta * unit_incident + (eta * at.cos_in - at.cos_out) * facing_normal;
}

/// The interpolated normal `smooth`, turned towards the geometric one (which faces the ray) as far as needed for it to
/// face the ray too, and for the reflected ray to stay on that side: near silhouettes interpolated normals may point
/// away.
template <class T>
[[nodiscard]] Vec3<T> consistent_shading_normal(const Vec3<T>& unit_incident, const Vec3<T>& geometric_normal,
                                                const Vec3<T>& smooth) {
  constexpr int steps = 8;
  for (int step = 0; step < steps; ++step) {
    const Vec3<T> normal =
        step == 0 ? smooth : normalize(smooth + static_cast<T>(step) / steps * (geometric_normal - smooth));
    if (dot(normal, unit_incident) < 0 && dot(reflect(unit_incident, normal), geometric_normal) > 0) return normal;
  }
  return geometric_normal;
}

/// The same of a normal that a map has bent, without steps, for maps bend normals everywhere: where the reflected ray
/// would come too close to the surface, or into it, it is lifted along the bent normal, and the normal is halfway
/// between that and the eye (A. Keller et al., "The Iray Light Transport Simulation and Rendering System", SIGGRAPH
/// talks 2017, as its normals are clamped). It is lifted as high as the ray came, up to 3 degrees, and not to the
/// horizon alone, from where a ray inside of a ball would only meet the same place again. The result faces the ray.
template <class T>
[[nodiscard]] Vec3<T> clamped_shading_normal(const Vec3<T>& unit_incident, const Vec3<T>& geometric_normal,
                                             const Vec3<T>& bent) {
  const T facing = -dot(unit_incident, geometric_normal), least = std::min(facing, T(0.05));
  const auto height_by = [&](const Vec3<T>& normal) {
    return dot(normal, unit_incident) < 0 ? dot(reflect(unit_incident, normal), geometric_normal) : T(-1);
  };
  if (const T height = height_by(bent); height > 0 && height >= least) return bent;
  const Vec3<T> along = reflect(unit_incident, bent);
  const T lean = std::max(dot(bent, geometric_normal), T(1e-3));
  const Vec3<T> lifted = along + (least - dot(along, geometric_normal)) / lean * bent;
  const Vec3<T> aside = lifted - dot(lifted, geometric_normal) * geometric_normal;
  const T far = length(aside);
  if (!(far > 0)) return geometric_normal;
  // At that height, in the direction in which it was lifted.
  const Vec3<T> mirrored = std::sqrt(1 - least * least) / far * aside + least * geometric_normal;
  const Vec3<T> half = mirrored - unit_incident;
  const T size = length(half);
  if (!(size > 0)) return geometric_normal;
  const Vec3<T> normal = half / size;
  return height_by(normal) > 0 ? normal : geometric_normal;
}

}  // namespace raywalk
