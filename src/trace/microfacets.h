#pragma once
// Mirrors of many small mirrors, and metals: how much a surface reflects that is rough, or whose colour changes with
// the angle. Directions are unit vectors away from the surface.

#include "math/sampling.h"
#include "scene/metals.h"
#include "trace/rough_diffuse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <optional>

namespace raywalk {

/// A metal by its index of refraction eta + i k for red, green and blue light.
template <class T>
struct Conductor {
  Rgb<T> eta{1}, k{0};

  /// Unpolarised reflectance of each colour, in 0..1: Fresnel's equations for a conductor in air (M. Born and E. Wolf,
  /// "Principles of Optics", 14.2). `cos`: of the angle of incidence, in 0..1.
  [[nodiscard]] Rgb<T> reflectance(T cos) const {
    Rgb<T> reflected;
    for (int c = 0; c < 3; ++c) reflected[c] = of_colour(eta[c], k[c], cos);
    return reflected;
  }

 private:
  [[nodiscard]] static T of_colour(T n, T k, T cos) {
    const T cos2 = cos * cos, sin2 = 1 - cos2;
    // (a + i b)^2 = (n + i k)^2 - sin^2
    const T real = n * n - k * k - sin2, both = std::sqrt(real * real + 4 * n * n * k * k);
    const T a = std::sqrt(std::max((both + real) / 2, T(0)));
    const T s_even = both + cos2, s_odd = 2 * a * cos;
    const T p_even = cos2 * both + sin2 * sin2, p_odd = s_odd * sin2;
    const T s = (s_even - s_odd) / (s_even + s_odd);
    return std::clamp(s * (1 + (p_even - p_odd) / (p_even + p_odd)) / 2, T(0), T(1));
  }
};

/// Normals of small facets, whose slopes are distributed as those of an ellipsoid (GGX; T. Trowbridge and K. Reitz
/// 1975; B. Walter et al., "Microfacet Models for Refraction through Rough Surfaces", EGSR 2007).
template <class T>
class Ggx {
 public:
  /// `alpha`: in 0..1; half of the surface is steeper. At 0 it would be one facet: `narrowest` is the least.
  explicit Ggx(T alpha) : alpha_(std::max(alpha, narrowest)) {}
  static constexpr T narrowest = T(0.001);

  [[nodiscard]] T alpha() const { return alpha_; }
  /// The density of normals over the hemisphere, by the projected area of the facets. Of unit vectors whose cosine is
  /// near 1 the sine says more.
  [[nodiscard]] T density(T cos, T squared_sin) const {
    const T at = squared_sin + alpha_ * alpha_ * cos * cos;
    return alpha_ * alpha_ / (pi_v<T> * at * at);
  }
  /// The share of the facets that is seen is G1 = 2 cos / (cos + root), and that is seen and lit from the same side
  /// G2 = 2 cos cos' / (cos root' + cos' root).
  [[nodiscard]] T root(T cos) const { return std::sqrt(alpha_ * alpha_ + (1 - alpha_ * alpha_) * cos * cos); }
  /// One of the normals that the eye sees, by how much it sees of them, in a frame with the normal as +z (J. Dupuy and
  /// A. Benyoub, "Sampling Visible GGX Normals with Spherical Caps", HPG 2023).
  [[nodiscard]] Vec3<T> sample_half(const Vec3<T>& to_eye, const Vec2<T>& unit) const;

 private:
  T alpha_;
};

/// How much of the light from everywhere a rough surface sends on to an eye at once, E, in 0..1, by the cosine of the
/// angle to the eye. What is lost, 1 - E, met several facets and comes back evenly: in proportion to 1 - E at both ends
/// (C. Kulla and A. Conty, "Revisiting Physically Based Shading at Imageworks", SIGGRAPH courses 2017). `is_even`:
/// whether E changes at all cosines, as it does about a critical angle.
template <class T, bool is_even = false>
class DirectionalAlbedo {
 public:
  /// The knots of E, at equal steps of the root of cos (1 + alpha) / (cos + alpha): E changes where the cosine is about
  /// alpha or less. Where it changes everywhere, of the mean of that root and the cosine.
  static constexpr std::size_t knots = is_even ? 128 : 64;
  /// The cosine of a knot.
  [[nodiscard]] static double cos_of(std::size_t knot, double alpha);
  /// `at_knots`: E at their cosines.
  DirectionalAlbedo(T alpha, const std::array<double, knots>& at_knots);

  /// `cos`: in 0..1.
  [[nodiscard]] T operator()(T cos) const {
    const auto [below, share] = place_of(cos);
    return albedo_[below] + share * (albedo_[below + 1] - albedo_[below]);
  }
  /// The mean of E over the hemisphere, by the cosine.
  [[nodiscard]] T mean() const { return mean_; }
  /// A direction by what is lost, in a frame with the normal as +z: from the cosines between two knots alike, by 1 - E
  /// there.
  [[nodiscard]] Vec3<T> sample_lost(const Vec2<T>& unit) const;
  /// `cos`: of that direction.
  [[nodiscard]] T pdf_lost(T cos) const { return lost_[place_of(cos).below] * cosine_hemisphere_pdf(cos); }

 private:
  struct Place {
    std::size_t below;  ///< the knot
    T share;            ///< of the way to the next
  };
  [[nodiscard]] Place place_of(T cos) const;
  T alpha_;
  std::array<T, knots> squared_cos_{}, albedo_{};
  std::array<T, knots> lost_{};  ///< from a knot to the next, over its mean
  std::array<T, knots> sum_{};   ///< of that, up to a knot
  T mean_ = 1;
};

/// Small mirrors, which hide each other as E. Heitz says ("Understanding the Masking-Shadowing Function in
/// Microfacet-Based BRDFs", JCGT 3(2), 2014; height-correlated). What one reflection loses, for light met a second
/// mirror, comes back evenly, so that a white surface is white.
template <class T>
class Microfacets : public Ggx<T> {
 public:
  /// `alpha`: see Ggx.
  explicit Microfacets(T alpha);

  /// A scattering function times the cosine, of mirrors that reflect everything, and the density with which `sample`
  /// returns the direction.
  struct Value {
    T once = 0, again = 0;  ///< by one mirror, and by several
    T half_cos = 0;         ///< of the angle of incidence at the mirrors that do it at once
    T pdf = 0;
  };
  /// 0 below the surface.
  [[nodiscard]] Value evaluate(const Vec3<T>& normal, const Vec3<T>& to_eye, const Vec3<T>& to_light) const;
  /// A direction to the light: by the mirrors that the eye sees, or, for what is reflected again, by what is lost at
  /// first. May lie below the surface.
  [[nodiscard]] Vec3<T> sample(const Vec3<T>& normal, const Vec3<T>& to_eye, Vec2<T> unit) const;

  /// E: what is reflected at once of light from everywhere. `cos`: of the angle to the eye, in 0..1.
  [[nodiscard]] T reflectance(T cos) const { return albedo_(cos); }
  /// Its mean over the hemisphere, by the cosine.
  [[nodiscard]] T mean_reflectance() const { return albedo_.mean(); }

 private:
  using Ggx<T>::density, Ggx<T>::root, Ggx<T>::sample_half;
  DirectionalAlbedo<T> albedo_;
};

template <class T>
Vec3<T> Ggx<T>::sample_half(const Vec3<T>& to_eye, const Vec2<T>& unit) const {
  // The ellipsoid stretched to a sphere, of which the eye sees a cap.
  const Vec3<T> eye = normalize(Vec3<T>(alpha_ * to_eye.x, alpha_ * to_eye.y, to_eye.z));
  const Vec2<T> disk = sample_concentric_disk(unit);
  const T share = std::min(dot(disk, disk), T(1));
  const T z = (1 - share) * (1 + eye.z) - eye.z;
  const T stretch = share > 0 ? std::sqrt(std::max(1 - z * z, T(0)) / share) : T(0);
  const Vec3<T> half = Vec3<T>(stretch * disk.x, stretch * disk.y, z) + eye;
  return normalize(Vec3<T>(alpha_ * half.x, alpha_ * half.y, std::max(half.z, T(1e-12))));
}

template <class T>
Vec3<T> Microfacets<T>::sample(const Vec3<T>& normal, const Vec3<T>& to_eye, Vec2<T> unit) const {
  const Basis<T> basis(normal);
  const T cos = dot(normal, to_eye), again = 1 - reflectance(cos);
  if (unit.x < again) {
    unit.x /= again;
    return basis.to_world(albedo_.sample_lost(unit));
  }
  unit.x = (unit.x - again) / (1 - again);
  const Vec3<T> local(dot(basis.s, to_eye), dot(basis.t, to_eye), cos);
  const Vec3<T> half = sample_half(local, unit);
  return renormalize(basis.to_world(2 * dot(local, half) * half - local));
}

template <class T>
auto Microfacets<T>::evaluate(const Vec3<T>& normal, const Vec3<T>& to_eye, const Vec3<T>& to_light) const -> Value {
  const T eye = dot(normal, to_eye), light = dot(normal, to_light);
  if (!(eye > 0) || !(light > 0)) return {};
  Vec3<T> half = to_eye + to_light;
  half /= length(half);
  const Vec3<T> aside = cross(normal, half);
  const T facets = density(dot(normal, half), dot(aside, aside));
  const T eye_root = root(eye), light_root = root(light), mean = mean_reflectance();
  const T again = 1 - reflectance(eye);
  Value value;
  // D G2 / (4 cos cos') cos'
  value.once = facets * light / (2 * (eye * light_root + light * eye_root));
  value.again = mean < 1 ? again * (1 - reflectance(light)) / (pi_v<T> * (1 - mean)) * light : T(0);
  value.half_cos = std::clamp(dot(to_eye, half), T(0), T(1));
  // D G1 / (4 cos)
  value.pdf = (1 - again) * facets / (2 * (eye + eye_root)) + again * albedo_.pdf_lost(light);
  return value;
}

template <class T, bool is_even>
auto DirectionalAlbedo<T, is_even>::place_of(T cos) const -> Place {
  const T c = std::clamp(cos, T(0), T(1));
  const T root = std::sqrt(c * (1 + alpha_) / (c + alpha_));
  const T at = (is_even ? (root + c) / 2 : root) * static_cast<T>(knots - 1);
  const auto below = std::min(static_cast<std::size_t>(at), knots - 2);
  return {below, at - static_cast<T>(below)};
}

template <class T, bool is_even>
Vec3<T> DirectionalAlbedo<T, is_even>::sample_lost(const Vec2<T>& unit) const {
  const auto above = std::upper_bound(sum_.begin() + 1, sum_.end() - 1, unit.x) - sum_.begin();
  const auto next = static_cast<std::size_t>(above), below = next - 1;
  const T part = sum_[next] - sum_[below];
  const T share = part > 0 ? std::clamp((unit.x - sum_[below]) / part, T(0), T(1)) : T(0);
  const T square = squared_cos_[below] + share * (squared_cos_[next] - squared_cos_[below]);
  const auto [sin, cos] = portable::sin_cos(2 * pi_v<T> * unit.y);
  const T aside = std::sqrt(1 - square);
  return {aside * cos, aside * sin, std::sqrt(square)};
}

/// Those of an alpha. Prepared once as long as they are asked for now and then, for that takes 10 ms, and a scene is
/// prepared anew with each of its edits. May be called from any thread.
template <class T>
[[nodiscard]] std::shared_ptr<const Microfacets<T>> microfacets_of(T alpha);

/// What a surface consists of that is rough or of metal: what reflects at it, small mirrors or one, of metal or of
/// anything that reflects all colours alike; and what is matt.
template <class T>
struct Microsurface {
  std::optional<Conductor<T>> metal;
  std::shared_ptr<const Microfacets<T>> facets;  ///< null: one mirror
  Rgb<T> again{1};                               ///< what is left of light that met several of the small mirrors
  std::optional<RoughDiffuse<T>> matt;           ///< none: by Lambert
  T glass = 0;  ///< alpha of a boundary that also transmits (trace/rough_dielectric.h); 0: smooth

  /// Whether all of these are there is as the material says.
  explicit Microsurface(const Material& material);
  /// `cos`: of the angle of incidence, in 0..1.
  [[nodiscard]] Rgb<T> reflectance(T cos) const { return metal ? metal->reflectance(cos) : Rgb<T>(1); }
  /// The scattering function times the cosine.
  [[nodiscard]] Rgb<T> value(const typename Microfacets<T>::Value& at) const {
    return reflectance(at.half_cos) * at.once + again * at.again;
  }
};

template <class T>
Microsurface<T>::Microsurface(const Material& material) {
  if (material.is_metal()) {
    const MetalIndex index = refractive_index(material.mirror);
    metal = Conductor<T>{Rgb<T>(index.eta), Rgb<T>(index.k)};
  }
  if (material.is_rough_diffuse()) matt.emplace(static_cast<T>(material.diffuse_roughness));
  if (material.is_rough_glass()) glass = static_cast<T>(material.roughness);
  if (!material.is_rough_mirror()) return;
  facets = microfacets_of(static_cast<T>(material.roughness));
  if (!metal) return;
  constexpr int steps = 256;
  Rgb<T> mean(0);
  for (int i = 0; i < steps; ++i) {
    const T cos = (static_cast<T>(i) + T(0.5)) / steps;
    mean += metal->reflectance(cos) * (2 * cos / steps);
  }
  // Of each reflection again, the share 1 - E meets another mirror.
  const T seen = facets->mean_reflectance();
  again = mean * mean * seen / (Rgb<T>(1) - mean * (1 - seen));
}

}  // namespace raywalk
