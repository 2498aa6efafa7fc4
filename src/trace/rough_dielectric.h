#pragma once
// Rough glass: a boundary of many small facets between two media that are transparent. Directions are unit vectors away
// from the surface; a normal is on the side of the eye.

#include "trace/microfacets.h"
#include "trace/optics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <optional>

namespace raywalk {

/// Facets that reflect and refract by Fresnel's equations (B. Walter et al., "Microfacet Models for Refraction through
/// Rough Surfaces", EGSR 2007). Those that face the eye hide each other as in Microfacets; for what goes through, being
/// seen and being lit are independent, as Walter has it. Light that met several facets comes back evenly on both sides
/// (after Kulla and Conty 2017): of what is lost, 1 - E, the share (1 - F) of the other side's loss over the larger of
/// both goes through, F being the mean of Fresnel's reflectance. So clear glass loses nothing, and what goes through is
/// the same both ways but for the square of the indices: f(v, l) n_v^2 = f(l, v) n_l^2, where radiance counts over n^2,
/// as paths from the eye count it.
template <class T>
class RoughDielectric : public Ggx<T> {
 public:
  /// On which side the eye is.
  enum class Side { rarer, denser };

  /// `alpha`: see Ggx. Indices of refraction > 0, which `bends` tells apart.
  RoughDielectric(T alpha, T one, T other);
  /// Whether the indices are so different that facets matter: else light goes straight through, however rough.
  [[nodiscard]] static bool bends(T one, T other) {
    constexpr T alike = T(1e-3);
    return std::abs(one - other) > alike * std::max(one, other);
  }
  [[nodiscard]] bool is_between(T one, T other) const {
    return std::min(one, other) == sides_[0].index && std::max(one, other) == sides_[1].index;
  }
  /// `index`: where the eye is.
  [[nodiscard]] Side side_of(T index) const { return index > sides_[0].index ? Side::denser : Side::rarer; }

  /// What comes back on the eye's side of light from everywhere there; the rest, to 1, of light from beyond. `cos`: of
  /// the angle to the eye, in 0..1.
  [[nodiscard]] T reflectance(Side side, T cos) const {
    const Boundary& own = of(side);
    const T at = std::clamp(cos, T(0), T(1)) * static_cast<T>(steps), all = own.albedo(cos);
    const auto below = std::min(static_cast<std::size_t>(at), steps - 1);
    const T share = at - static_cast<T>(below);
    const T once = own.reflected[below] + share * (own.reflected[below + 1] - own.reflected[below]);
    return std::min(once, all) + (1 - all) * (1 - own.through);
  }

  /// A scattering function times the cosine, and the densities with which directions are drawn.
  struct Value {
    T once = 0, again = 0;  ///< by one facet, and by several
    T pdf = 0;              ///< by `sample`, of a lobe alone
    T pdf_of_both = 0;      ///< by `sample_both`
  };
  /// Light from above the surface is reflected, from below transmitted; the density is that of one or the other. 0
  /// where the eye is below.
  [[nodiscard]] Value evaluate(Side side, const Vec3<T>& normal, const Vec3<T>& to_eye, const Vec3<T>& to_light) const;
  /// A direction to light that is reflected, or, if `through`, transmitted: by the facets that the eye sees, or by what
  /// is lost at first. Lies on the wrong side where the drawn facet sends nothing.
  [[nodiscard]] Vec3<T> sample(Side side, bool through, const Vec3<T>& normal, const Vec3<T>& to_eye,
                               Vec2<T> unit) const;
  /// A direction to light either way: a facet that the eye sees reflects as often as Fresnel says.
  struct Sample {
    Vec3<T> direction;
    bool through;  ///< whether it should be below the surface; else nothing is sent there
  };
  [[nodiscard]] Sample sample_both(Side side, const Vec3<T>& normal, const Vec3<T>& to_eye, Vec2<T> unit, T u) const;
  /// In colour, of glass of which each facet keeps `both` of the light (kr + kt).
  [[nodiscard]] Rgb<T> value(const Rgb<T>& both, const Value& at) const {
    const T seen = mean_;
    return both * at.once + both * both * (seen * at.again) / (Rgb<T>(1) - both * (1 - seen));
  }
  /// At the facet that turns one direction into another one beyond the surface; none where no facet does, but several.
  [[nodiscard]] std::optional<Refraction<T>> bends_by(Side side, const Vec3<T>& incident, const Vec3<T>& out) const {
    const Vec3<T> half = half_through(side, -incident, out);
    const T size = length(half);
    if (!(size > 0) || !(dot(half, incident) < 0) || !(dot(half, out) < 0)) return std::nullopt;
    return at_facet(side, incident, half / size);
  }

 private:
  using Ggx<T>::density, Ggx<T>::root, Ggx<T>::sample_half;
  /// `half`: unit, the normal of a facet.
  [[nodiscard]] Refraction<T> at_facet(Side side, const Vec3<T>& incident, const Vec3<T>& half) const {
    return refraction_at(incident, half, of(side).index, beyond(side).index);
  }
  /// The normal of the facets that turn one direction into another one on the other side: along -(n_v v + n_l l),
  /// towards the eye.
  [[nodiscard]] Vec3<T> half_through(Side side, const Vec3<T>& to_eye, const Vec3<T>& to_light) const {
    const Vec3<T> along = of(side).index * to_eye + beyond(side).index * to_light;
    return side == Side::rarer ? -along : along;
  }

  static constexpr std::size_t steps = 64;
  /// Of light that comes from one side.
  struct Boundary {
    T index;
    DirectionalAlbedo<T, true> albedo;     ///< E: what goes either way at once
    std::array<T, steps + 1> reflected{};  ///< the part of it that is reflected, at even steps of the cosine
    T through = 0;                         ///< the share of the loss that goes through
    Boundary(T alpha, T own_index, T other_index);
  };
  [[nodiscard]] const Boundary& of(Side side) const { return sides_[static_cast<std::size_t>(side)]; }
  [[nodiscard]] const Boundary& beyond(Side side) const { return sides_[1 - static_cast<std::size_t>(side)]; }
  /// Of a lobe, the share that met several facets.
  [[nodiscard]] T again_share(Side side, bool through, T cos) const {
    const Boundary& own = of(side);
    const T lost = 1 - own.albedo(cos), again = lost * (through ? own.through : 1 - own.through);
    const T reflectance = this->reflectance(side, cos), all = through ? 1 - reflectance : reflectance;
    return all > 0 ? std::min(again / all, T(1)) : T(0);
  }

  std::array<Boundary, 2> sides_;
  T mean_;  ///< of E over both sides
};

template <class T>
auto RoughDielectric<T>::evaluate(Side side, const Vec3<T>& normal, const Vec3<T>& to_eye,
                                  const Vec3<T>& to_light) const -> Value {
  const T eye = dot(normal, to_eye), cos = dot(normal, to_light);
  if (!(eye > 0) || cos == 0 || std::isnan(cos)) return {};
  const Boundary &own = of(side), &far = beyond(side);
  const bool through = cos < 0;
  const T light = std::abs(cos), lost = 1 - own.albedo(eye), share = again_share(side, through, eye);
  const DirectionalAlbedo<T, true>& out = through ? far.albedo : own.albedo;
  const T returned = through ? own.through : 1 - own.through;
  Value value;
  if (const T mean = out.mean(); mean < 1)
    value.again = lost * (1 - out(light)) * returned / (pi_v<T> * (1 - mean)) * light;
  const T pdf_lost = out.pdf_lost(light);
  value.pdf = share * pdf_lost;
  value.pdf_of_both = lost * returned * pdf_lost;
  Vec3<T> half = through ? half_through(side, to_eye, to_light) : to_eye + to_light;
  const T size = length(half);
  if (!(size > 0)) return value;
  half /= size;
  const T up = dot(normal, half), eye_half = dot(to_eye, half), light_half = dot(to_light, half);
  if (!(up > 0) || !(eye_half > 0) || (light_half < 0) != through) return value;
  const Vec3<T> aside = cross(normal, half);
  const T facets = density(up, dot(aside, aside)), eye_root = root(eye), light_root = root(light);
  const T fresnel = at_facet(side, -to_eye, half).fresnel();
  if (!through) {
    // F D G2 / (4 cos cos') cos'; the density is that of the normals that the eye sees, over 4 cos of the half angle
    const T pdf = facets / (2 * (eye + eye_root));
    value.once = fresnel * facets * light / (2 * (eye * light_root + light * eye_root));
    value.pdf += (1 - share) * pdf;
    value.pdf_of_both += (1 - lost) * fresnel * pdf;
    return value;
  }
  // The density of normals that the eye sees, by the solid angle of the refracted directions.
  const T turned = far.index / size;
  const T pdf = facets * 2 * eye_half / (eye + eye_root) * (turned * turned * -light_half);
  value.once = (1 - fresnel) * pdf * (2 * light / (light + light_root));
  value.pdf += (1 - share) * pdf;
  value.pdf_of_both += (1 - lost) * (1 - fresnel) * pdf;
  return value;
}

template <class T>
Vec3<T> RoughDielectric<T>::sample(Side side, bool through, const Vec3<T>& normal, const Vec3<T>& to_eye,
                                   Vec2<T> unit) const {
  const Basis<T> basis(normal);
  const T cos = dot(normal, to_eye), share = again_share(side, through, cos);
  if (unit.x < share) {
    unit.x /= share;
    const Vec3<T> lost = (through ? beyond(side) : of(side)).albedo.sample_lost(unit);
    return basis.to_world(through ? -lost : lost);
  }
  unit.x = (unit.x - share) / (1 - share);
  const Vec3<T> local(dot(basis.s, to_eye), dot(basis.t, to_eye), cos);
  const Vec3<T> half = sample_half(local, unit);
  if (!through) return renormalize(basis.to_world(2 * dot(local, half) * half - local));
  const auto sent = refract(-local, half, at_facet(side, -local, half));
  return sent ? renormalize(basis.to_world(*sent)) : normal;
}

template <class T>
auto RoughDielectric<T>::sample_both(Side side, const Vec3<T>& normal, const Vec3<T>& to_eye, Vec2<T> unit, T u) const
    -> Sample {
  const Basis<T> basis(normal);
  const Boundary& own = of(side);
  const T cos = dot(normal, to_eye), lost = 1 - own.albedo(cos);
  if (unit.x < lost) {
    unit.x /= lost;
    const bool through = u < own.through;
    const Vec3<T> again = (through ? beyond(side) : own).albedo.sample_lost(unit);
    return {basis.to_world(through ? -again : again), through};
  }
  unit.x = (unit.x - lost) / (1 - lost);
  const Vec3<T> local(dot(basis.s, to_eye), dot(basis.t, to_eye), cos);
  const Vec3<T> half = sample_half(local, unit);
  const Refraction<T> at = at_facet(side, -local, half);
  if (u < at.fresnel()) return {renormalize(basis.to_world(2 * dot(local, half) * half - local)), false};
  const auto sent = refract(-local, half, at);
  return {sent ? renormalize(basis.to_world(*sent)) : normal, true};
}

/// Those of an alpha, between two indices. Kept as those of `microfacets_of` are: they take some 50 ms.
template <class T>
[[nodiscard]] std::shared_ptr<const RoughDielectric<T>> rough_dielectric_of(T alpha, T one, T other);

}  // namespace raywalk
