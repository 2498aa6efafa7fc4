#pragma once
// How paths walk inside of bodies that scatter light (S. Chandrasekhar, "Radiative Transfer", 1950): straight on for a
// free path, whose length is drawn, and on in a direction that the phase function says; until they get to a surface.
// Red, green and blue have free paths of their own: one of them is chosen by what it can still bring, its free path is
// walked, and what was found is weighted by the odds of all three to get there (A. Wilkie et al., "Hero Wavelength
// Spectral Sampling", EGSR 2014; M. Chiang, P. Kutz and B. Burley, "Practical and Controllable Subsurface Scattering",
// SIGGRAPH Talks 2016).

#include "trace/dipole_exit.h"
#include "trace/media.h"
#include "trace/phase.h"
#include "trace/surface_vertex.h"

#include <algorithm>
#include <limits>
#include <optional>

namespace raywalk {

/// What a path with the throughput `throughput` may do along a ray in a medium.
template <class T>
struct FreePath {
  const typename World<T>::Medium* medium = nullptr;  ///< null: it scatters nothing
  typename World<T>::Scattering scattering{};
  Rgb<T> odds{0};          ///< with which each channel's free path is walked; they sum to 1
  T length = infinity<T>;  ///< to where it scatters, unless it gets to a surface before

  FreePath() = default;
  /// `choice`, `u`: drawn, in [0, 1).
  FreePath(const typename World<T>::Medium& within, const typename World<T>::Scattering& how, const Rgb<T>& throughput,
           T choice, T u)
      : medium(&within), scattering(how) {
    const T sum = throughput.x + throughput.y + throughput.z;
    odds = sum > 0 ? throughput * (1 / sum) : Rgb<T>(T(1) / 3);
    int channel = 0;
    while (channel < 2 && !(choice < odds[channel])) choice -= odds[channel++];
    while (channel > 0 && odds[channel] == 0) --channel;  // rounding left a little
    const T extinction = within.extinction[channel];
    if (extinction > 0) length = -portable::log1p(-u) / extinction;
  }

  /// 1 / the probability to get as far as to a surface.
  [[nodiscard]] T weight_at_surface(T distance) const { return 1 / dot(odds, transmittance(distance)); }
  /// The light that goes on where it scatters, over the pdf of being scattered there.
  [[nodiscard]] Rgb<T> weight_where_scattered() const {
    const Rgb<T> left = transmittance(length);
    return left * scattering.coefficient * (1 / dot(odds, left * medium->extinction));
  }
  [[nodiscard]] Rgb<T> transmittance(T distance) const {
    return beer_lambert(medium->extinction, std::min(distance, std::numeric_limits<T>::max()));
  }
};

/// A vertex of a path that may walk inside: at a surface, or where a medium scatters, which then has a phase function.
template <class T, bool with_facets = true, bool with_maps = true>
struct MediumVertex : SurfaceVertex<T, with_facets, with_maps> {
  std::optional<PhaseFunction<T>> phase;
  bool seamless = false;  ///< the surface between two media of equal index, which lets everything through
  // Of the ray that led here:
  Vec3<T> scattered_at{0};  ///< where it got its direction
  T pdf = 0;                ///< of this direction

  MediumVertex(const SurfaceVertex<T, with_facets, with_maps>& at) : SurfaceVertex<T, with_facets, with_maps>(at) {}
};

/// The same where light may leave a body by the dipole, which has then led here.
template <class T, bool with_facets = true, bool with_maps = true>
struct DipoleVertex : MediumVertex<T, with_facets, with_maps> {
  const Dipole<T>* left_by = nullptr;

  DipoleVertex(const SurfaceVertex<T, with_facets, with_maps>& at) : MediumVertex<T, with_facets, with_maps>(at) {}
};
/// A direction that may lead into a body, to where it is left.
template <class T>
struct DipoleSample : BsdfSample<T> {
  std::optional<DipoleExit<T>> exit{};

  DipoleSample(const BsdfSample<T>& sample) : BsdfSample<T>(sample) {}
};

/// Whether the primitive is of the body's surface that the medium is in. `nested`: the media where bodies nest.
template <class T, class Nested>
[[nodiscard]] bool bounds_medium(const World<T>& world, const typename World<T>::Medium* medium, int primitive) {
  if (world.bodies.empty()) return medium == &world.surface(primitive);
  return holds(Nested::bodies_in(medium), world.bodies.of_primitive(primitive));
}

}  // namespace raywalk
