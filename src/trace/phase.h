#pragma once
// How a medium scatters light at a point: the phase function of L. Henyey and J. Greenstein ("Diffuse Radiation in the
// Galaxy", ApJ 93, 1941), in space and in a flat world (E. d'Eon and M. Williams, "Isotropic Scattering in a Flatland
// Half-Space", JCTT 47, 2018, has its isotropic case).

#include "math/elementary.h"
#include "math/sampling.h"
#include "trace/event.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

/// Light goes on along `axis` (unit, of the ray that was scattered) turned by an angle whose mean cosine is g, -1 < g <
/// 1. Its values integrate to 1 over all directions; in a flat world over those in the plane z = 0.
template <class T>
struct PhaseFunction {
  Vec3<T> axis;
  T g = 0;
  bool flat = false;

  /// Also the pdf with which `sample` returns this direction; unit.
  [[nodiscard]] T operator()(const Vec3<T>& direction) const { return value(dot(axis, direction)); }
  [[nodiscard]] T value(T cos) const {
    // 1 + g^2 - 2 g cos, without cancellation about the peak.
    const T least = 1 - std::abs(g), squared = least * least + 2 * (g < 0 ? -g * (1 + cos) : g * (1 - cos));
    const T lost = least * (1 + std::abs(g));  // 1 - g^2
    if (flat) return lost / (2 * pi_v<T> * squared);
    return lost / (4 * pi_v<T> * squared * std::sqrt(squared));
  }
  /// The cosine of which a share `u` of the light has a smaller one. The textbook's formula divides by g; this is the
  /// same, multiplied out.
  [[nodiscard]] T cos_of(T u) const {
    const T s = 2 * u - 1, g2 = g * g, below = 1 + g * s;
    const T above = s * (1 + g2) + g / 2 * (s * s + 3) + g * g2 / 2 * (s * s - 1);
    return std::clamp(above / (below * below), T(-1), T(1));
  }
  [[nodiscard]] Vec3<T> sample(const Vec2<T>& u) const {
    if (flat) {
      // tan(angle / 2) = (1 - g) / (1 + g) tan(pi (u - 1/2))
      const auto [sin_half, cos_half] = portable::sin_cos(pi_v<T> * (u.x - T(0.5)));
      const T ahead = (1 + g) * cos_half, aside = (1 - g) * sin_half, size = ahead * ahead + aside * aside;
      const T cos = (ahead * ahead - aside * aside) / size, sin = 2 * ahead * aside / size;
      return normalize(Vec3<T>(axis.x * cos - axis.y * sin, axis.x * sin + axis.y * cos, 0));
    }
    const T cos = cos_of(u.x), sin = std::sqrt((1 - cos) * (1 + cos));
    const auto [across, along] = portable::sin_cos(2 * pi_v<T> * u.y);
    return renormalize(Basis<T>(axis).to_world({sin * along, sin * across, cos}));
  }
};

}  // namespace raywalk
