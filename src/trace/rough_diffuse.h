#pragma once
// Rough matt surfaces. Directions are unit vectors away from the surface.

#include "math/elementary.h"
#include "math/sampling.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

/// A matt surface that is rough: it sends back more of the light to where it came from, and so looks flatter than one
/// by Lambert, as the full moon does. M. Oren and S. Nayar ("Generalization of Lambert's Reflectance Model", SIGGRAPH
/// 1994) as M. Fujii simplified it, by a roughness in 0..1; and what it loses, for light met the surface again, comes
/// back evenly (J. Portsmouth, P. Kutz and S. Hill, "EON: A Practical Energy-Preserving Rough Diffuse BRDF", JCGT
/// 14(1), 2025). So a white one is white at any roughness, and at 0 it is Lambert's.
template <class T>
class RoughDiffuse {
 public:
  /// `roughness`: in 0..1.
  explicit RoughDiffuse(T roughness)
      : roughness_(roughness),
        once_(1 / (1 + (T(0.5) - 2 / (3 * pi_v<T>)) * roughness)),
        mean_(once_ * (1 + roughness * (T(2) / 3 - 28 / (15 * pi_v<T>)))) {}

  /// pi times the scattering function, in colour, of what reflects `albedo` of white light. Not negative; the same
  /// both ways. The directions' sides count alike: below the surface as above.
  [[nodiscard]] Rgb<T> value(const Rgb<T>& albedo, const Vec3<T>& normal, const Vec3<T>& to_eye,
                             const Vec3<T>& to_light) const {
    const T eye = dot(normal, to_eye), light = dot(normal, to_light);
    const T out = std::min(std::abs(eye), T(1)), in = std::min(std::abs(light), T(1));
    // s: of the parts along the surface, in -1..1.
    const T s = dot(to_eye, to_light) - eye * light;
    const T stretched = s > 0 ? s / std::max(std::max(out, in), std::abs(s) * least) : std::max(s, T(-1));
    Rgb<T> sum = albedo * (once_ * (1 + roughness_ * stretched));
    if (!(mean_ < 1)) return sum;  // at 0, and where it is all but 0
    const T lost = (1 - reflectance(out)) * (1 - reflectance(in)) / (1 - mean_);
    for (int c = 0; c < 3; ++c) sum[c] += albedo[c] * albedo[c] * mean_ / (1 - albedo[c] * (1 - mean_)) * lost;
    return sum;
  }

  /// E: what a white surface sends back at once of light from everywhere. `cos`: of the angle to the eye, in 0..1.
  [[nodiscard]] T reflectance(T cos) const {
    const T sin = std::sqrt(std::max(1 - cos * cos, T(0)));
    // The paper's (2 / 3) (tan (1 - sin^3) - sin), without its division by the cosine.
    const T g =
        sin * (portable::atan2(sin, cos) - sin * cos) + T(2) / 3 * sin * (cos * (1 + sin + sin * sin) / (1 + sin) - 1);
    return std::min(once_ * (1 + roughness_ * g / pi_v<T>), T(1));
  }
  /// Its mean over the hemisphere, by the cosine.
  [[nodiscard]] T mean_reflectance() const { return mean_; }

 private:
  /// So that two directions along the surface give a finite value, which no cosine has to make up for.
  static constexpr T least = T(1e-9);
  T roughness_;
  T once_;  ///< A of the paper
  T mean_;
};

}  // namespace raywalk
