#pragma once

#include "math/vec.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace raywalk {

/// Mirrors `incident` (towards the surface) at unit `normal`; the length is kept.
template <class T>
[[nodiscard]] Vec3<T> reflect(const Vec3<T>& incident, const Vec3<T>& normal) {
  return incident - 2 * dot(incident, normal) * normal;
}

/// A unit ray meets a surface between indices n1 (its side) and n2. The normal faces the ray.
template <class T>
struct Refraction {
  T eta;     ///< n1 / n2
  T cos_in;  ///< cosine of the incidence, in 0..1
  T k;       ///< squared cosine beyond; < 0: total internal reflection. Exactly 0 is still refracted, along the surface
  T cos_out;  ///< sqrt(k), or 0
  T fresnel;  ///< unpolarised reflectance, in 0..1

  [[nodiscard]] bool total() const { return k < 0; }
};

template <class T>
[[nodiscard]] inline Refraction<T> refraction_at(const Vec3<T>& unit_incident, const Vec3<T>& facing_normal, T n1,
                                                 T n2) {
  const T eta = n1 / n2;
  const T cos_in = std::clamp(-dot(unit_incident, facing_normal), T(0), T(1));
  // 1 - eta^2 (1 - cos^2), over n2^2 so that neither equal indices nor the critical angle lose digits: the difference
  // of near indices is exact, and a rounded eta does not enter.
  const T inwards = n1 * cos_in;
  const T k = ((n2 - n1) * (n2 + n1) + inwards * inwards) / (n2 * n2);
  if (k < 0) return {eta, cos_in, k, 0, 1};
  const T cos_out = std::sqrt(k);
  // Fresnel's equations for a dielectric. At grazing incidence both cosines may vanish together: all is reflected.
  const T s_sum = n1 * cos_in + n2 * cos_out, p_sum = n2 * cos_in + n1 * cos_out;
  if (s_sum == 0 || p_sum == 0) return {eta, cos_in, k, cos_out, 1};
  const T rs = (n1 * cos_in - n2 * cos_out) / s_sum, rp = (n2 * cos_in - n1 * cos_out) / p_sum;
  return {eta, cos_in, k, cos_out, (rs * rs + rp * rp) / 2};
}

/// Direction beyond the surface by Snell's law, unit length up to rounding; none under total internal reflection.
template <class T>
[[nodiscard]] std::optional<Vec3<T>> refract(const Vec3<T>& unit_incident, const Vec3<T>& facing_normal,
                                             const Refraction<T>& at) {
  if (at.total()) return std::nullopt;
  return at.eta * unit_incident + (at.eta * at.cos_in - at.cos_out) * facing_normal;
}

/// The smoothed normal, turned towards `side` (the flat one, which faces the ray) as far as is needed for it to face
/// the ray too, and for the reflected ray to stay on that side: in silhouettes interpolation turns normals away.
template <class T>
[[nodiscard]] Vec3<T> smooth_normal_towards(const Vec3<T>& unit_incident, const Vec3<T>& side, const Vec3<T>& smooth) {
  constexpr int steps = 8;
  for (int step = 0; step < steps; ++step) {
    const Vec3<T> normal = step == 0 ? smooth : normalize(smooth + static_cast<T>(step) / steps * (side - smooth));
    if (dot(normal, unit_incident) < 0 && dot(reflect(unit_incident, normal), side) > 0) return normal;
  }
  return side;
}

}  // namespace raywalk
