#pragma once
// How a surface scatters light at a path vertex: a BSDF that can be evaluated and sampled.

#include "math/sampling.h"
#include "trace/event.h"
#include "trace/microfacets.h"
#include "trace/optics.h"

#include <array>
#include <optional>
#include <type_traits>

namespace raywalk {

/// The power heuristic for two sampling strategies of the same direction (E. Veach and L. Guibas, "Optimally Combining
/// Sampling Techniques for Monte Carlo Rendering", SIGGRAPH 1995): the weight of the first. The two weights of a pair
/// sum to 1. Pdfs >= 0, the first > 0; either may be infinite.
template <class T>
[[nodiscard]] T power_heuristic(T first, T second) {
  if (first >= second) {
    const T ratio = second / first;
    return std::isnan(ratio) ? T(0.5) : 1 / (1 + ratio * ratio);
  }
  const T ratio = first / second;
  return ratio * ratio / (1 + ratio * ratio);
}

/// The scale of a highlight so that it never reflects more than ks. By Blinn's formula and the convention of kd / pi a
/// highlight reflects at most, for light and eye along the normal, 8 / (s + 2) (1 - 2^(-(s + 2) / 2)) ks: too much
/// where the exponent s is below about 5.
template <class T>
[[nodiscard]] T highlight_scale(T shininess) {
  const T most = 8 / (shininess + 2) * (1 - power(T(0.5), (shininess + 2) / 2));
  return most > 1 ? 1 / most : T(1);
}

template <class T>
struct BsdfValue {
  Rgb<T> value{0};  ///< f times the cosine
  T pdf = 0;        ///< per solid angle, with which `sample` returns this direction
};
template <class T>
struct BsdfSample {
  Lobe lobe;
  Vec3<T> direction;  ///< unit
  Rgb<T> weight;      ///< f cos / density
  T pdf;              ///< 0 for a sharp lobe
};

/// The BSDF of a surface at a point, for one incoming ray. Whitted's terms as a scattering function f, times the
/// cosine: kd / pi cos, the highlight ks / pi (n.h)^s as the tracer has it for lights, kr' and kt' in one direction
/// each or uniformly over a cone, whose part beyond the surface is folded back; or kr by small mirrors. `with_facets`:
/// whether there may be small mirrors; without, nothing asks for them.
template <class T, bool with_facets = true>
struct Bsdf {
  struct NoFacets {};
  Vec3<T> incident;          ///< unit, towards the surface
  Vec3<T> shading_normal;    ///< unit, facing the ray; interpolated on smooth meshes
  Vec3<T> geometric_normal;  ///< unit, facing the ray: decides what is in front of and behind the surface
  Rgb<T> diffuse{0}, highlight{0}, mirror{0}, transparent{0};  ///< kd, ks (scaled), kr', kt'
  T shininess = 0;
  Vec3<T> mirror_axis{0}, transparent_axis{0};  ///< unit
  T mirror_width = 0, transparent_width = 0;    ///< 1 - cos of the cones' half angles; 0: sharp
  /// The small mirrors that reflect `mirror`, if any.
  [[no_unique_address]] std::conditional_t<with_facets, const Microsurface<T>*, NoFacets> facets{};
  [[nodiscard]] const Microsurface<T>* microsurface() const {
    if constexpr (with_facets) return facets;
    return nullptr;
  }

  using BsdfValue = raywalk::BsdfValue<T>;
  using BsdfSample = raywalk::BsdfSample<T>;

  /// Sets the selection probabilities of the lobes by what each can contribute at this throughput. To be called once
  /// all members are set.
  void prepare(const Rgb<T>& throughput);
  [[nodiscard]] bool absorbs() const { return lobes_ == 0; }
  /// With which `sample_lobe` returns this one.
  [[nodiscard]] T probability(Lobe lobe) const { return probabilities_[static_cast<std::size_t>(lobe)]; }
  /// With this lobe alone.
  [[nodiscard]] Bsdf only(Lobe lobe) const;
  /// Whether there are several lobes to choose from.
  [[nodiscard]] bool several() const { return lobes_ > 1; }
  /// Whether the lobe's direction has to be drawn.
  [[nodiscard]] bool needs_direction(Lobe lobe) const { return !sharp(lobe); }
  [[nodiscard]] bool all_sharp() const {
    return !(has(Lobe::diffuse) || has(Lobe::highlight) || (has(Lobe::mirror) && !sharp(Lobe::mirror)) ||
             (has(Lobe::transparent) && !sharp(Lobe::transparent)));
  }

  /// The sum of all lobes that are not sharp. `drawn`: the lobe that the direction was sampled from, if it was.
  [[nodiscard]] BsdfValue evaluate(const Vec3<T>& direction, std::optional<Lobe> drawn = {}) const;
  /// What a light's strength is multiplied by, as kd cos and ks (n.h)^s are; `direction`: unit, to the light. Small
  /// mirrors show lights that have no extent.
  [[nodiscard]] Rgb<T> highlight_of_facets(const Vec3<T>& direction) const {
    const Microsurface<T>* own = microsurface();
    if (own == nullptr) return Rgb<T>(0);
    return pi_v<T> * mirror * own->value(own->facets->evaluate(shading_normal, -incident, direction));
  }
  [[nodiscard]] Lobe sample_lobe(T u) const;
  /// Weight 0 when the sampled direction is below the horizon.
  [[nodiscard]] BsdfSample sample(Lobe lobe, const Vec2<T>& u) const;

 private:
  [[nodiscard]] bool sharp(Lobe lobe) const {
    return (lobe == Lobe::mirror && mirror_width == 0 && microsurface() == nullptr) ||
           (lobe == Lobe::transparent && transparent_width == 0);
  }
  [[nodiscard]] bool has(Lobe lobe) const { return probability(lobe) > 0; }
  /// `direction` mirrored in the surface.
  [[nodiscard]] Vec3<T> folded(const Vec3<T>& direction) const {
    return direction - 2 * dot(direction, shading_normal) * shading_normal;
  }
  /// The pdf of a cone whose part beyond the surface is folded back. A sampled direction counts as inside despite
  /// rounding.
  [[nodiscard]] T cone_pdf(const Vec3<T>& axis, T width, const Vec3<T>& direction, bool drawn) const {
    const auto within = [&](const Vec3<T>& one) {
      const Vec3<T> apart = one - axis;
      return dot(apart, apart) <= 2 * width;
    };
    const int times = static_cast<int>(within(direction)) + static_cast<int>(within(folded(direction)));
    return static_cast<T>(drawn ? std::max(times, 1) : times) * uniform_cone_pdf(width);
  }

  std::array<T, lobe_count> probabilities_{};
  int lobes_ = 0;
};

template <class T, bool with_facets>
void Bsdf<T, with_facets>::prepare(const Rgb<T>& throughput) {
  const auto contribution = [&throughput](const Rgb<T>& reflectance) { return dot(throughput, reflectance); };
  probabilities_ = {contribution(diffuse), contribution(highlight) * std::min(T(1), 8 / (shininess + 2)),
                    contribution(mirror), contribution(transparent)};
  T sum = 0;
  lobes_ = 0;
  for (const T probability : probabilities_) sum += probability, lobes_ += probability > 0;
  for (T& probability : probabilities_) probability = sum > 0 ? probability / sum : 0;
}

template <class T, bool with_facets>
Bsdf<T, with_facets> Bsdf<T, with_facets>::only(Lobe lobe) const {
  Bsdf alone = *this;
  if (lobe != Lobe::diffuse) alone.diffuse = Rgb<T>(0);
  if (lobe != Lobe::highlight) alone.highlight = Rgb<T>(0);
  if (lobe != Lobe::mirror) alone.mirror = Rgb<T>(0);
  if (lobe != Lobe::transparent) alone.transparent = Rgb<T>(0);
  alone.prepare(Rgb<T>(1));
  return alone;
}

template <class T, bool with_facets>
auto Bsdf<T, with_facets>::evaluate(const Vec3<T>& direction, std::optional<Lobe> drawn) const -> BsdfValue {
  BsdfValue at;
  if (dot(geometric_normal, direction) > 0) {
    const T cos = dot(shading_normal, direction);
    if (cos > 0) {
      if (has(Lobe::diffuse)) {
        at.value += diffuse * (cos / pi_v<T>);
        at.pdf += probability(Lobe::diffuse) * cosine_hemisphere_pdf(cos);
      }
      if (has(Lobe::highlight)) {
        const Vec3<T> h = direction - incident;
        const T size = length(h);
        const T n_h = dot(shading_normal, h) / size, v_h = -dot(incident, h) / size;
        if (n_h > 0 && v_h > 0) {
          at.value += highlight * (power(n_h, shininess) / pi_v<T>);
          at.pdf += probability(Lobe::highlight) * power_cosine_pdf(n_h, shininess) / (4 * v_h);
        }
      }
    }
    if (const Microsurface<T>* own = microsurface(); own != nullptr && has(Lobe::mirror)) {
      const auto by_facets = own->facets->evaluate(shading_normal, -incident, direction);
      at.value += mirror * own->value(by_facets);
      at.pdf += probability(Lobe::mirror) * by_facets.pdf;
    } else if (has(Lobe::mirror) && !sharp(Lobe::mirror)) {
      const T pdf = cone_pdf(mirror_axis, mirror_width, direction, drawn == Lobe::mirror);
      at.value += mirror * pdf;
      at.pdf += probability(Lobe::mirror) * pdf;
    }
  } else if (has(Lobe::transparent) && !sharp(Lobe::transparent)) {
    const T pdf = cone_pdf(transparent_axis, transparent_width, direction, drawn == Lobe::transparent);
    at.value += transparent * pdf;
    at.pdf += probability(Lobe::transparent) * pdf;
  }
  return at;
}

template <class T, bool with_facets>
Lobe Bsdf<T, with_facets>::sample_lobe(T u) const {
  Lobe last = Lobe::diffuse;
  for (const Lobe lobe : {Lobe::diffuse, Lobe::highlight, Lobe::mirror, Lobe::transparent}) {
    if (!has(lobe)) continue;
    last = lobe;
    if (u < probability(lobe)) return lobe;
    u -= probability(lobe);
  }
  return last;  // rounding left a little
}

template <class T, bool with_facets>
auto Bsdf<T, with_facets>::sample(Lobe lobe, const Vec2<T>& u) const -> BsdfSample {
  BsdfSample choice{lobe, Vec3<T>(0), Rgb<T>(0), 0};
  switch (lobe) {
    case Lobe::diffuse:
      choice.direction = Basis<T>(shading_normal).to_world(sample_cosine_hemisphere(u));
      break;
    case Lobe::highlight:
      choice.direction =
          renormalize(reflect(incident, Basis<T>(shading_normal).to_world(sample_power_cosine(u, shininess))));
      break;
    case Lobe::mirror:
      choice.direction = mirror_axis;
      if (sharp(lobe)) break;
      if (const Microsurface<T>* own = microsurface(); own != nullptr) {
        choice.direction = own->facets->sample(shading_normal, -incident, u);
        break;
      }
      choice.direction = renormalize(Basis<T>(mirror_axis).to_world(sample_uniform_cone(u, mirror_width)));
      if (!(dot(choice.direction, shading_normal) > 0)) choice.direction = folded(choice.direction);
      break;
    case Lobe::phase:
      break;
    case Lobe::transparent:
      choice.direction = transparent_axis;
      if (sharp(lobe)) break;
      choice.direction = renormalize(Basis<T>(transparent_axis).to_world(sample_uniform_cone(u, transparent_width)));
      if (!(dot(choice.direction, shading_normal) < 0)) choice.direction = folded(choice.direction);
      break;
  }
  if (sharp(lobe)) {
    choice.weight = (lobe == Lobe::mirror ? mirror : transparent) * (1 / probability(lobe));
    return choice;
  }
  const bool behind = dot(geometric_normal, choice.direction) <= 0;
  if (behind != (lobe == Lobe::transparent)) return choice;
  const BsdfValue at = evaluate(choice.direction, lobe);
  if (!(at.pdf > 0)) return choice;
  choice.weight = at.value * (1 / at.pdf);
  choice.pdf = at.pdf;
  return choice;
}

}  // namespace raywalk
