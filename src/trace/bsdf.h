#pragma once
// How a surface scatters light at a path vertex: a BSDF that can be evaluated and sampled.

#include "math/sampling.h"
#include "trace/event.h"
#include "trace/microfacets.h"
#include "trace/optics.h"
#include "trace/rough_dielectric.h"

#include <array>
#include <limits>
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

/// What of a BSDF is as small facets make it. Null: as a smooth surface has it.
template <class T>
struct FacetLobes {
  const Microsurface<T>* facets = nullptr;      ///< the small mirrors that reflect `mirror`
  const RoughDiffuse<T>* matt = nullptr;        ///< scatters `diffuse`
  const RoughDielectric<T>* glass = nullptr;    ///< reflects and transmits, `mirror` and `transparent` in all
  typename RoughDielectric<T>::Side side = {};  ///< of the glass, where the ray comes from
  Rgb<T> both{0};                               ///< kr + kt of the glass
};
struct NoFacetLobes {};

/// Where maps make the roughness of small facets, which then lies between two: those that are rougher, and how much of
/// them there is, the rest being of FacetLobes. Null: those alone.
template <class T>
struct RougherLobes {
  const Microsurface<T>* rougher = nullptr;
  const RoughDielectric<T>* rougher_glass = nullptr;
  T rougher_share = 0;  ///< in 0..1
};
struct NoRougherLobes {};

/// The BSDF of a surface at a point, for one incoming ray. Whitted's terms as a scattering function f, times the
/// cosine: kd / pi cos, the highlight ks / pi (n.h)^s as the tracer has it for lights, kr' and kt' in one direction
/// each or uniformly over a cone, whose part beyond the surface is folded back; or each of them as small facets make
/// it. `with_facets`: whether there may be facets, `with_maps`: and of two roughnesses; without, nothing asks for them.
template <class T, bool with_facets = true, bool with_maps = with_facets>
struct Bsdf : std::conditional_t<with_facets, FacetLobes<T>, NoFacetLobes>,
              std::conditional_t<with_facets && with_maps, RougherLobes<T>, NoRougherLobes> {
  Vec3<T> incident;          ///< unit, towards the surface
  Vec3<T> shading_normal;    ///< unit, facing the ray; interpolated on smooth meshes
  Vec3<T> geometric_normal;  ///< unit, facing the ray: decides what is in front of and behind the surface
  Rgb<T> diffuse{0}, highlight{0}, mirror{0}, transparent{0};  ///< kd, ks (scaled), kr', kt'
  T shininess = 0;
  Vec3<T> mirror_axis{0}, transparent_axis{0};  ///< unit
  T mirror_width = 0, transparent_width = 0;    ///< 1 - cos of the cones' half angles; 0: sharp
  /// Whether small facets reflect, or reflect and transmit.
  [[nodiscard]] bool by_facets() const {
    if constexpr (with_facets) return this->facets != nullptr || this->glass != nullptr;
    return false;
  }

  using BsdfValue = raywalk::BsdfValue<T>;
  using BsdfSample = raywalk::BsdfSample<T>;

  /// Rough glass of kr + kt, from a medium of this index; `cos`: of the angle of incidence, in 0..1.
  void take_glass(const RoughDielectric<T>& its, T index, T cos, const Rgb<T>& kept)
    requires with_facets
  {
    this->glass = &its;
    this->side = its.side_of(index);
    this->both = kept;
    mirror = its.reflectance(this->side, cos) * kept;
    transparent = kept - mirror;
  }
  static constexpr bool may_mix = with_facets && with_maps;
  /// With the share of rougher glass in it; after `take_glass`.
  void mix_glass(const RoughDielectric<T>& other, T share, T cos)
    requires may_mix
  {
    this->rougher_glass = &other;
    this->rougher_share = share;
    mirror += share * (other.reflectance(this->side, cos) * this->both - mirror);
    transparent = this->both - mirror;
  }
  /// Sets the selection probabilities of the lobes by what each can contribute at this throughput. To be called once
  /// all members are set.
  void prepare(const Rgb<T>& throughput);
  [[nodiscard]] bool absorbs() const { return lobes_ == 0; }
  /// With which `sample_lobe` returns this one.
  [[nodiscard]] T probability(Lobe lobe) const { return probabilities_[static_cast<std::size_t>(lobe)]; }
  /// With which `sample` is asked for this lobe; of rough glass, whose facets choose between mirror and transparent,
  /// for either.
  [[nodiscard]] T probability_of_choice(Lobe lobe) const {
    return is_glass(lobe) ? probability(Lobe::mirror) + probability(Lobe::transparent) : probability(lobe);
  }
  /// How far the number that chose the lobe is through those that choose it, in 0..1; of rough glass only.
  [[nodiscard]] T among_choices(Lobe lobe, T chosen_by) const {
    // They are the last, for mirror and transparent are.
    const T all = probability_of_choice(lobe);
    return is_glass(lobe) ? std::clamp((chosen_by - (1 - all)) / all, T(0), T(1)) : T(0);
  }
  /// With this lobe alone; of rough glass, with both.
  [[nodiscard]] Bsdf only(Lobe lobe) const;
  /// Whether there are several lobes to choose from.
  [[nodiscard]] bool several() const {
    if constexpr (with_facets)
      if (this->glass != nullptr) return true;
    return lobes_ > 1;
  }
  /// Whether the lobe's direction has to be drawn.
  [[nodiscard]] bool needs_direction(Lobe lobe) const { return !sharp(lobe); }
  [[nodiscard]] bool all_sharp() const {
    return !(has(Lobe::diffuse) || has(Lobe::highlight) || (has(Lobe::mirror) && !sharp(Lobe::mirror)) ||
             (has(Lobe::transparent) && !sharp(Lobe::transparent)));
  }

  /// The sum of all lobes that are not sharp. `drawn`: the lobe that the direction was sampled from, if it was.
  [[nodiscard]] BsdfValue evaluate(const Vec3<T>& direction, std::optional<Lobe> drawn = {}) const;
  /// kd times the cosine, or what a rough matt surface has in its place: what a light's strength is multiplied by.
  /// `cos`: of the angle between the shading normal and `direction`, unit, to a light in front of the surface.
  [[nodiscard]] Rgb<T> diffuse_answer(const Vec3<T>& direction, T cos) const {
    if constexpr (with_facets)
      if (this->matt != nullptr) return this->matt->value(diffuse, shading_normal, -incident, direction) * cos;
    return diffuse * cos;
  }
  /// The same of the highlight, as ks (n.h)^s is. Small facets show lights that have no extent, rough glass also those
  /// behind it.
  [[nodiscard]] Rgb<T> highlight_of_facets(const Vec3<T>& direction) const {
    if constexpr (with_facets) {
      if (this->glass != nullptr) return pi_v<T> * by_glass(direction).value;
      if constexpr (may_mix)
        if (this->rougher != nullptr) return pi_v<T> * by_two_mirrors(direction).value;
      if (this->facets != nullptr) {
        const auto by_facets = this->facets->facets->evaluate(shading_normal, -incident, direction);
        return pi_v<T> * mirror * this->facets->value(by_facets);
      }
    }
    return Rgb<T>(0);
  }
  /// Whether rough glass may send light on that comes from there, behind it.
  [[nodiscard]] bool is_behind_glass(const Vec3<T>& direction) const {
    if constexpr (with_facets)
      return this->glass != nullptr && dot(geometric_normal, direction) < 0 && dot(shading_normal, direction) < 0;
    return false;
  }
  [[nodiscard]] Lobe sample_lobe(T u) const;
  /// Weight 0 when the sampled direction is below the horizon. `chosen_by`: the number that `sample_lobe` chose by; of
  /// rough glass the sample's lobe may be the other one.
  [[nodiscard]] BsdfSample sample(Lobe lobe, const Vec2<T>& u, T chosen_by = 0) const;

 private:
  [[nodiscard]] bool sharp(Lobe lobe) const {
    if constexpr (with_facets)
      if (this->glass != nullptr) return false;
    return (lobe == Lobe::mirror && mirror_width == 0 && !by_facets()) ||
           (lobe == Lobe::transparent && transparent_width == 0);
  }
  [[nodiscard]] bool is_glass(Lobe lobe) const {
    if constexpr (with_facets) return this->glass != nullptr && (lobe == Lobe::mirror || lobe == Lobe::transparent);
    return false;
  }
  /// `evaluate`, inlined where directions are sampled: each vertex of a path pays for a call.
  [[nodiscard]] BsdfValue evaluate_inline(const Vec3<T>& direction, std::optional<Lobe> drawn) const;
  [[nodiscard]] BsdfSample sample_glass(const Vec2<T>& u, T chosen_by) const;
  /// What the glass reflects or transmits, whichever the direction says, and the density among all that it sends.
  [[nodiscard]] BsdfValue by_glass(const Vec3<T>& direction) const {
    // An interpolated normal may have it on another side than the surface.
    if ((dot(geometric_normal, direction) > 0) != (dot(shading_normal, direction) > 0)) return {};
    if constexpr (may_mix) {
      if (this->rougher_glass != nullptr) {
        const auto by = [&](const RoughDielectric<T>& its) -> BsdfValue {
          const auto at = its.evaluate(this->side, shading_normal, -incident, direction);
          return {its.value(this->both, at), at.pdf_of_both};
        };
        return mixed(by(*this->glass), by(*this->rougher_glass));
      }
    }
    const auto at = this->glass->evaluate(this->side, shading_normal, -incident, direction);
    return {this->glass->value(this->both, at), at.pdf_of_both};
  }
  /// What small mirrors of two roughnesses reflect.
  [[nodiscard]] BsdfValue by_two_mirrors(const Vec3<T>& direction) const {
    const auto by = [&](const Microsurface<T>& mirrors) -> BsdfValue {
      const auto at = mirrors.facets->evaluate(shading_normal, -incident, direction);
      return {mirror * mirrors.value(at), at.pdf};
    };
    return mixed(by(*this->facets), by(*this->rougher));
  }
  [[nodiscard]] BsdfValue mixed(const BsdfValue& less, const BsdfValue& more) const {
    return {less.value + this->rougher_share * (more.value - less.value),
            less.pdf + this->rougher_share * (more.pdf - less.pdf)};
  }
  /// Whether a direction is drawn of the rougher facets; `u` is then as it was, in 0..1 among those that say the same.
  [[nodiscard]] bool chooses_rougher(T& u) const {
    const T share = this->rougher_share;
    const bool chosen = u < share;
    u = std::clamp(chosen ? u / share : (u - share) / (1 - share), T(0), 1 - std::numeric_limits<T>::epsilon() / 2);
    return chosen;
  }
  [[nodiscard]] bool has(Lobe lobe) const { return probability(lobe) > 0; }
  /// `direction` mirrored in the surface itself, on one side of which each lobe has to stay.
  [[nodiscard]] Vec3<T> folded(const Vec3<T>& direction) const {
    return direction - 2 * dot(direction, geometric_normal) * geometric_normal;
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

template <class T, bool with_facets, bool with_maps>
void Bsdf<T, with_facets, with_maps>::prepare(const Rgb<T>& throughput) {
  const auto contribution = [&throughput](const Rgb<T>& reflectance) { return dot(throughput, reflectance); };
  probabilities_ = {contribution(diffuse), contribution(highlight) * std::min(T(1), 8 / (shininess + 2)),
                    contribution(mirror), contribution(transparent)};
  T sum = 0;
  lobes_ = 0;
  for (const T probability : probabilities_) sum += probability, lobes_ += probability > 0;
  for (T& probability : probabilities_) probability = sum > 0 ? probability / sum : 0;
}

template <class T, bool with_facets, bool with_maps>
auto Bsdf<T, with_facets, with_maps>::only(Lobe lobe) const -> Bsdf {
  Bsdf alone = *this;
  if (lobe != Lobe::diffuse) alone.diffuse = Rgb<T>(0);
  if (lobe != Lobe::highlight) alone.highlight = Rgb<T>(0);
  if (lobe != Lobe::mirror && !is_glass(lobe)) alone.mirror = Rgb<T>(0);
  if (lobe != Lobe::transparent && !is_glass(lobe)) alone.transparent = Rgb<T>(0);
  alone.prepare(Rgb<T>(1));
  return alone;
}

template <class T, bool with_facets, bool with_maps>
auto Bsdf<T, with_facets, with_maps>::evaluate(const Vec3<T>& direction, std::optional<Lobe> drawn) const -> BsdfValue {
  return evaluate_inline(direction, drawn);
}

template <class T, bool with_facets, bool with_maps>
[[gnu::always_inline]] inline auto Bsdf<T, with_facets, with_maps>::evaluate_inline(const Vec3<T>& direction,
                                                                                    std::optional<Lobe> drawn) const
    -> BsdfValue {
  BsdfValue at;
  if (dot(geometric_normal, direction) > 0) {
    const T cos = dot(shading_normal, direction);
    if (cos > 0) {
      if (has(Lobe::diffuse)) {
        if constexpr (with_facets)
          at.value +=
              this->matt != nullptr ? diffuse_answer(direction, cos) * (1 / pi_v<T>) : diffuse * (cos / pi_v<T>);
        else
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
    if constexpr (with_facets) {
      if (this->glass != nullptr && probability_of_choice(Lobe::mirror) > 0) {
        const BsdfValue reflected = by_glass(direction);
        at.value += reflected.value;
        at.pdf += probability_of_choice(Lobe::mirror) * reflected.pdf;
        return at;
      }
      if constexpr (may_mix) {
        if (this->rougher != nullptr && has(Lobe::mirror)) {
          const BsdfValue reflected = by_two_mirrors(direction);
          at.value += reflected.value;
          at.pdf += probability(Lobe::mirror) * reflected.pdf;
          return at;
        }
      }
      if (this->facets != nullptr && has(Lobe::mirror)) {
        const auto by_facets = this->facets->facets->evaluate(shading_normal, -incident, direction);
        at.value += mirror * this->facets->value(by_facets);
        at.pdf += probability(Lobe::mirror) * by_facets.pdf;
        return at;
      }
    }
    if (has(Lobe::mirror) && !sharp(Lobe::mirror)) {
      const T pdf = cone_pdf(mirror_axis, mirror_width, direction, drawn == Lobe::mirror);
      at.value += mirror * pdf;
      at.pdf += probability(Lobe::mirror) * pdf;
    }
  } else if (probability_of_choice(Lobe::transparent) > 0 && !sharp(Lobe::transparent)) {
    if constexpr (with_facets) {
      if (this->glass != nullptr) {
        const BsdfValue transmitted = by_glass(direction);
        at.value += transmitted.value;
        at.pdf += probability_of_choice(Lobe::transparent) * transmitted.pdf;
        return at;
      }
    }
    const T pdf = cone_pdf(transparent_axis, transparent_width, direction, drawn == Lobe::transparent);
    at.value += transparent * pdf;
    at.pdf += probability(Lobe::transparent) * pdf;
  }
  return at;
}

template <class T, bool with_facets, bool with_maps>
Lobe Bsdf<T, with_facets, with_maps>::sample_lobe(T u) const {
  Lobe last = Lobe::diffuse;
  for (const Lobe lobe : {Lobe::diffuse, Lobe::highlight, Lobe::mirror, Lobe::transparent}) {
    if (!has(lobe)) continue;
    last = lobe;
    if (u < probability(lobe)) return lobe;
    u -= probability(lobe);
  }
  return last;  // rounding left a little
}

template <class T, bool with_facets, bool with_maps>
auto Bsdf<T, with_facets, with_maps>::sample(Lobe lobe, const Vec2<T>& u, [[maybe_unused]] T chosen_by) const
    -> BsdfSample {
  BsdfSample choice{lobe, Vec3<T>(0), Rgb<T>(0), 0};
  if constexpr (with_facets)
    if (is_glass(lobe)) return sample_glass(u, chosen_by);
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
      if constexpr (with_facets) {
        if constexpr (may_mix) {
          if (this->rougher != nullptr) {
            Vec2<T> rest = u;
            const Microsurface<T>* const mirrors = chooses_rougher(rest.x) ? this->rougher : this->facets;
            choice.direction = mirrors->facets->sample(shading_normal, -incident, rest);
            break;
          }
        }
        if (this->facets != nullptr) {
          choice.direction = this->facets->facets->sample(shading_normal, -incident, u);
          break;
        }
      }
      choice.direction = renormalize(Basis<T>(mirror_axis).to_world(sample_uniform_cone(u, mirror_width)));
      if (!(dot(choice.direction, geometric_normal) > 0)) choice.direction = folded(choice.direction);
      break;
    case Lobe::phase:
      break;
    case Lobe::transparent:
      choice.direction = transparent_axis;
      if (sharp(lobe)) break;
      choice.direction = renormalize(Basis<T>(transparent_axis).to_world(sample_uniform_cone(u, transparent_width)));
      if (!(dot(choice.direction, geometric_normal) < 0)) choice.direction = folded(choice.direction);
      break;
  }
  if (sharp(lobe)) {
    choice.weight = (lobe == Lobe::mirror ? mirror : transparent) * (1 / probability(lobe));
    return choice;
  }
  const bool behind = dot(geometric_normal, choice.direction) <= 0;
  if (behind != (lobe == Lobe::transparent)) return choice;
  const BsdfValue at = evaluate_inline(choice.direction, lobe);
  if (!(at.pdf > 0)) return choice;
  choice.weight = at.value * (1 / at.pdf);
  choice.pdf = at.pdf;
  return choice;
}

template <class T, bool with_facets, bool with_maps>
auto Bsdf<T, with_facets, with_maps>::sample_glass(const Vec2<T>& u, T chosen_by) const -> BsdfSample {
  const T choice_of_facet = among_choices(Lobe::mirror, chosen_by);
  const RoughDielectric<T>* drawn = this->glass;
  Vec2<T> rest = u;
  if constexpr (may_mix)
    if (this->rougher_glass != nullptr && chooses_rougher(rest.x)) drawn = this->rougher_glass;
  const auto [direction, through] = drawn->sample_both(this->side, shading_normal, -incident, rest, choice_of_facet);
  BsdfSample choice{through ? Lobe::transparent : Lobe::mirror, direction, Rgb<T>(0), 0};
  if ((dot(geometric_normal, direction) <= 0) != through) return choice;
  const BsdfValue at = evaluate(direction, choice.lobe);
  if (!(at.pdf > 0)) return choice;
  choice.weight = at.value * (1 / at.pdf);
  choice.pdf = at.pdf;
  return choice;
}

}  // namespace raywalk
