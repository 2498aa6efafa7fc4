#pragma once
// Light that goes into a body which scatters it often, and where it comes out again, without a walk: H. Jensen, S.
// Marschner, M. Levoy and P. Hanrahan, "A Practical Model for Subsurface Light Transport", SIGGRAPH 2001. In place of
// all that is scattered, two sources stand under and above the surface, which is taken as flat and endless. What is
// scattered once only is left to them, too.

#include "math/elementary.h"
#include "math/sampling.h"
#include "trace/optics.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace raywalk {

/// The dipole of a medium below a surface, per channel.
template <class T>
class Dipole {
 public:
  /// `absorption`, `scattering`: sigma_a and sigma_s, per unit of length. `anisotropy`: g. `ior`: of the medium, in
  /// air; `by_fresnel`: the surface reflects by Fresnel's equations; else only where nothing gets out.
  Dipole(const Rgb<T>& absorption, const Rgb<T>& scattering, T anisotropy, T ior, bool by_fresnel);

  /// R_d(r): the light that comes out at a distance r, per area, of all that went in.
  [[nodiscard]] T diffuse_reflectance(int channel, T r) const;
  [[nodiscard]] Rgb<T> diffuse_reflectance(T r) const {
    return {diffuse_reflectance(0, r), diffuse_reflectance(1, r), diffuse_reflectance(2, r)};
  }
  /// Its integral over the plane.
  [[nodiscard]] const Rgb<T>& total_reflectance() const { return total_; }

  /// A distance, with the pdf R_d(r) / total, per area. `u`: in [0, 1). The channel reflects something.
  [[nodiscard]] T sample_radius(int channel, T u) const;
  [[nodiscard]] T pdf(int channel, T r) const {
    return total_[channel] > 0 ? diffuse_reflectance(channel, r) / total_[channel] : T(0);
  }

  /// F_t: what the surface lets through of light that comes in at this cosine, or goes out there.
  [[nodiscard]] T transmittance(T cos) const;
  /// Of what comes out: how much goes there, over the mean of all directions by their cosines. (Jensen et al. leave out
  /// the mean; light would be lost.)
  [[nodiscard]] T leaving(T cos) const { return transmittance(cos) / mean_transmittance_; }

  /// The mean free path, of the channel with the longest one.
  [[nodiscard]] T mean_free_path() const { return std::max({real_.x, real_.y, real_.z}); }

 private:
  /// Of a source at depth z > 0: the light that comes out within r, 1 for all of r > 0 were nothing absorbed.
  [[nodiscard]] T share(int channel, T z) const { return portable::exp(-falloff_[channel] * z); }

  T ior_;
  bool by_fresnel_;
  T mean_transmittance_ = 1;
  Rgb<T> albedo_;                ///< alpha' = sigma_s' / sigma_t'
  Rgb<T> falloff_;               ///< sigma_tr = sqrt(3 sigma_a sigma_t')
  Rgb<T> real_{0}, virtual_{0};  ///< z_r and z_v: how far below, and above the surface
  Rgb<T> total_{0};
};

template <class T>
Dipole<T>::Dipole(const Rgb<T>& absorption, const Rgb<T>& scattering, T anisotropy, T ior, bool by_fresnel)
    : ior_(ior), by_fresnel_(by_fresnel) {
  // The mean over directions by the midpoint rule.
  constexpr int steps = 4096;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double cos = (i + 0.5) / steps;
    sum += 2 * cos * static_cast<double>(transmittance(static_cast<T>(cos))) / steps;
  }
  mean_transmittance_ = static_cast<T>(sum);
  // From inside, as much gets out of each direction as gets in there: over n^2 as many directions.
  const T reflected_inside = 1 - mean_transmittance_ / (ior * ior);
  const T a = (1 + reflected_inside) / (1 - reflected_inside);
  for (int c = 0; c < 3; ++c) {
    const T scattered = scattering[c] * (1 - anisotropy), extinction = absorption[c] + scattered;
    if (!(scattered > 0)) continue;
    albedo_[c] = scattered / extinction;
    falloff_[c] = std::sqrt(3 * absorption[c] * extinction);
    real_[c] = 1 / extinction;
    virtual_[c] = real_[c] * (1 + 4 * a / 3);
    total_[c] = albedo_[c] / 2 * (share(c, real_[c]) + share(c, virtual_[c]));
  }
}

template <class T>
T Dipole<T>::transmittance(T cos) const {
  const Vec3<T> incident(std::sqrt(std::max(1 - cos * cos, T(0))), 0, -cos);
  const Refraction<T> at = refraction_at(incident, Vec3<T>(0, 0, 1), T(1), ior_);
  if (at.total()) return 0;
  return by_fresnel_ ? 1 - at.fresnel() : T(1);
}

template <class T>
T Dipole<T>::diffuse_reflectance(int channel, T r) const {
  if (!(total_[channel] > 0)) return 0;
  const auto from = [&](T z) {
    const T d = std::sqrt(r * r + z * z), fallen = falloff_[channel] * d;
    return z * (1 + fallen) * portable::exp(-fallen) / (d * d * d);
  };
  return albedo_[channel] / (4 * pi_v<T>)*(from(real_[channel]) + from(virtual_[channel]));
}

/// One of the sources, by what it sends; of that, a share z / d exp(-sigma_tr (d - z)) comes out farther from it than
/// d.
template <class T>
T Dipole<T>::sample_radius(int channel, T u) const {
  const T of_real = share(channel, real_[channel]), of_virtual = share(channel, virtual_[channel]);
  const T odds = of_real / (of_real + of_virtual);
  const T z = u < odds ? real_[channel] : virtual_[channel];
  const T within = std::min(u < odds ? u / odds : (u - odds) / (1 - odds), 1 - std::numeric_limits<T>::epsilon() / 2);
  // sigma_tr z (e^t - 1) + t = -log(1 - u) for t = log(d / z): Newton's iteration, from above.
  const T fall = falloff_[channel] * z, wanted = -portable::log1p(-within);
  T t = fall > 0 ? std::min(wanted, portable::log1p(wanted / fall)) : wanted;
  for (int iteration = 0; iteration < 6; ++iteration) {
    const T grown = portable::expm1(t);
    t = std::max(t - (fall * grown + t - wanted) / (fall * (1 + grown) + 1), T(0));
  }
  const T grown = portable::expm1(t);  // d = z (1 + grown)
  return z * std::sqrt(grown * (2 + grown));
}

}  // namespace raywalk
