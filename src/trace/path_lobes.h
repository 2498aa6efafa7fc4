#pragma once
// How a surface scatters light where a path has met it, as densities that can be drawn from.

#include "trace/event.h"
#include "trace/optics.h"
#include "trace/sampling.h"

#include <array>
#include <optional>

namespace raywalk {

/// The balance between two ways to draw the same direction, by the squares of their densities (E. Veach and L. Guibas,
/// "Optimally Combining Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995): the weight of the first. The
/// two weights of a pair sum to 1. Densities >= 0, the first > 0; either may be infinite.
template <class T>
[[nodiscard]] T power_heuristic(T first, T second) {
  if (first >= second) {
    const T ratio = second / first;
    return std::isnan(ratio) ? T(0.5) : 1 / (1 + ratio * ratio);
  }
  const T ratio = first / second;
  return ratio * ratio / (1 + ratio * ratio);
}

/// What multiplies a highlight so that it never gives back more than ks. By Blinn's formula and kd / pi's convention a
/// highlight returns at most, for light and eye along the normal, 8 / (s + 2) (1 - 2^(-(s + 2) / 2)) ks: too much where
/// the exponent s is below about 5.
template <class T>
[[nodiscard]] T highlight_scale(T shininess) {
  const T most = 8 / (shininess + 2) * (1 - std::exp2(-(shininess + 2) / 2));
  return most > 1 ? 1 / most : T(1);
}

/// The lobes of a surface at a point, for one incoming ray. Whitted's terms as a scattering function f, times the
/// cosine: kd / pi cos, the highlight ks / pi (n.h)^s as the tracer has it for lamps, kr' and kt' in one direction each
/// or evenly over a cone, whose part beyond the surface is folded back.
template <class T>
struct Lobes {
  Vec3<T> incident;  ///< unit, towards the surface
  Vec3<T> normal;    ///< unit, facing the ray; smooth where the surface is
  Vec3<T> side;      ///< the flat normal, facing the ray: tells what is before and behind the surface
  Rgb<T> diffuse{0}, highlight{0}, mirror{0}, transparent{0};  ///< kd, ks (scaled), kr', kt'
  T shininess = 0;
  Vec3<T> mirror_axis{0}, transparent_axis{0};  ///< unit
  T mirror_width = 0, transparent_width = 0;    ///< 1 - cos of the cones' half angles; 0: sharp

  struct Density {
    Rgb<T> value{0};  ///< f times the cosine
    T density = 0;    ///< by solid angle, with which `choose` draws this direction
  };
  struct Choice {
    Lobe lobe;
    Vec3<T> direction;  ///< unit
    Rgb<T> weight;      ///< f cos / density
    T density;          ///< 0 for a sharp lobe
  };

  /// Shares the draws among the lobes by what each can bring to a ray of this `share`. To be called once all is set.
  void prepare(const Rgb<T>& share);
  [[nodiscard]] bool absorbs() const { return lobes_ == 0; }
  /// Whether one lobe must be chosen among several.
  [[nodiscard]] bool several() const { return lobes_ > 1; }
  /// Whether the one direction that is left needs no draw.
  [[nodiscard]] bool needs_direction(Lobe lobe) const { return !sharp(lobe); }
  [[nodiscard]] bool all_sharp() const {
    return !(has(Lobe::diffuse) || has(Lobe::highlight) || (has(Lobe::mirror) && !sharp(Lobe::mirror)) ||
             (has(Lobe::transparent) && !sharp(Lobe::transparent)));
  }

  /// All lobes that are not sharp, together. `drawn`: of which lobe the direction comes, where it was drawn.
  [[nodiscard]] Density evaluate(const Vec3<T>& direction, std::optional<Lobe> drawn = {}) const;
  [[nodiscard]] Lobe choose_lobe(T u) const;
  /// Weight 0 when the direction drawn leads nowhere: below the horizon.
  [[nodiscard]] Choice choose(Lobe lobe, const Vec2<T>& u) const;

 private:
  [[nodiscard]] bool sharp(Lobe lobe) const {
    return (lobe == Lobe::mirror && mirror_width == 0) || (lobe == Lobe::transparent && transparent_width == 0);
  }
  [[nodiscard]] T chance(Lobe lobe) const { return chances_[static_cast<std::size_t>(lobe)]; }
  [[nodiscard]] bool has(Lobe lobe) const { return chance(lobe) > 0; }
  /// `direction` seen in the mirror of the surface.
  [[nodiscard]] Vec3<T> folded(const Vec3<T>& direction) const {
    return direction - 2 * dot(direction, normal) * normal;
  }
  /// Of a cone whose part beyond the surface is folded back. What was drawn lies within, whatever rounding says.
  [[nodiscard]] T cone_density(const Vec3<T>& axis, T width, const Vec3<T>& direction, bool drawn) const {
    const auto within = [&](const Vec3<T>& one) {
      const Vec3<T> apart = one - axis;
      return dot(apart, apart) <= 2 * width;
    };
    const int times = static_cast<int>(within(direction)) + static_cast<int>(within(folded(direction)));
    return static_cast<T>(drawn ? std::max(times, 1) : times) * uniform_cone_pdf(width);
  }

  std::array<T, lobe_count> chances_{};
  int lobes_ = 0;
};

template <class T>
void Lobes<T>::prepare(const Rgb<T>& share) {
  const auto brings = [&share](const Rgb<T>& reflectance) { return dot(share, reflectance); };
  chances_ = {brings(diffuse), brings(highlight) * std::min(T(1), 8 / (shininess + 2)), brings(mirror),
              brings(transparent)};
  T sum = 0;
  lobes_ = 0;
  for (const T chance : chances_) sum += chance, lobes_ += chance > 0;
  for (T& chance : chances_) chance = sum > 0 ? chance / sum : 0;
}

template <class T>
auto Lobes<T>::evaluate(const Vec3<T>& direction, std::optional<Lobe> drawn) const -> Density {
  Density at;
  if (dot(side, direction) > 0) {
    const T cos = dot(normal, direction);
    if (cos > 0) {
      if (has(Lobe::diffuse)) {
        at.value += diffuse * (cos / pi_v<T>);
        at.density += chance(Lobe::diffuse) * cosine_hemisphere_pdf(cos);
      }
      if (has(Lobe::highlight)) {
        const Vec3<T> h = direction - incident;
        const T size = length(h);
        const T n_h = dot(normal, h) / size, v_h = -dot(incident, h) / size;
        if (n_h > 0 && v_h > 0) {
          at.value += highlight * (power(n_h, shininess) / pi_v<T>);
          at.density += chance(Lobe::highlight) * power_cosine_pdf(n_h, shininess) / (4 * v_h);
        }
      }
    }
    if (has(Lobe::mirror) && !sharp(Lobe::mirror)) {
      const T density = cone_density(mirror_axis, mirror_width, direction, drawn == Lobe::mirror);
      at.value += mirror * density;
      at.density += chance(Lobe::mirror) * density;
    }
  } else if (has(Lobe::transparent) && !sharp(Lobe::transparent)) {
    const T density = cone_density(transparent_axis, transparent_width, direction, drawn == Lobe::transparent);
    at.value += transparent * density;
    at.density += chance(Lobe::transparent) * density;
  }
  return at;
}

template <class T>
Lobe Lobes<T>::choose_lobe(T u) const {
  Lobe last = Lobe::diffuse;
  for (const Lobe lobe : {Lobe::diffuse, Lobe::highlight, Lobe::mirror, Lobe::transparent}) {
    if (!has(lobe)) continue;
    last = lobe;
    if (u < chance(lobe)) return lobe;
    u -= chance(lobe);
  }
  return last;  // rounding left a little
}

template <class T>
auto Lobes<T>::choose(Lobe lobe, const Vec2<T>& u) const -> Choice {
  Choice choice{lobe, Vec3<T>(0), Rgb<T>(0), 0};
  switch (lobe) {
    case Lobe::diffuse:
      choice.direction = Basis<T>(normal).to_world(cosine_hemisphere(u));
      break;
    case Lobe::highlight:
      choice.direction = renormalize(reflect(incident, Basis<T>(normal).to_world(power_cosine(u, shininess))));
      break;
    case Lobe::mirror:
      choice.direction = mirror_axis;
      if (sharp(lobe)) break;
      choice.direction = renormalize(Basis<T>(mirror_axis).to_world(uniform_cone(u, mirror_width)));
      if (!(dot(choice.direction, normal) > 0)) choice.direction = folded(choice.direction);
      break;
    case Lobe::transparent:
      choice.direction = transparent_axis;
      if (sharp(lobe)) break;
      choice.direction = renormalize(Basis<T>(transparent_axis).to_world(uniform_cone(u, transparent_width)));
      if (!(dot(choice.direction, normal) < 0)) choice.direction = folded(choice.direction);
      break;
  }
  if (sharp(lobe)) {
    choice.weight = (lobe == Lobe::mirror ? mirror : transparent) * (1 / chance(lobe));
    return choice;
  }
  const bool behind = dot(side, choice.direction) <= 0;
  if (behind != (lobe == Lobe::transparent)) return choice;
  const Density at = evaluate(choice.direction, lobe);
  if (!(at.density > 0)) return choice;
  choice.weight = at.value * (1 / at.density);
  choice.density = at.density;
  return choice;
}

}  // namespace raywalk
