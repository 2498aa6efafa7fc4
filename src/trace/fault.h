#pragma once
// Bugs injected into the tracer on purpose, for people who learn to find them. Each breaks one line of the pseudocode
// and nothing else: until that line runs for the first time, a faulty walk has the same bits as a correct one. They are
// injected by hooks in a kernel of their own (Policy::faulty), with naive numerics, since only these have an epsilon
// and a choice of roots to get wrong.

#include "math/words.h"
#include "trace/pseudocode.h"

namespace raywalk {

/// From easy to hard to find.
enum class Fault {
  shadow_ray_misaimed,    ///< it takes the light's position for the vector from the hit to the light
  reflection_flipped,     ///< the normal in the reflection formula points inward
  refraction_inverted,    ///< n2 / n1 in place of n1 / n2
  attenuation_forgotten,  ///< the light is not attenuated with distance
  depth_not_counted,      ///< SHADE passes its own DEPTH to the SHADE of the reflect ray
  epsilon_wrong_side,     ///< a reflect ray starts epsilon below the surface instead of above it
  second_root_dropped,    ///< of a quadratic's roots only the nearer is considered, even from inside
  epsilon_too_small,      ///< a shadow ray starts on the surface itself
  // Of paths.
  second_side_black,       ///< of a surface seen from its other side, the normal is not turned to the ray
  cosine_counted_twice,    ///< by the direction that is drawn, and once more
  emission_not_weighted,   ///< what is met by chance counts whole, though lights are sampled too
  emitter_area_forgotten,  ///< the density of a point on an emitter is taken as 1
  // Of photons.
  photons_from_behind,    ///< a circle counts what arrived at the other side of a thin wall, too
  power_of_another_pass,  ///< the lights' power is divided by the photons of another pass, of half as many
  pi_forgotten,           ///< surfaces send on kd of the light of photons in place of kd / pi
  // Of radiosity.
  reflectance_forgotten,  ///< surfaces show the light that arrives, and not what they send on of it
};
template <>
inline constexpr Word<Fault> words_of<Fault>[] = {{Fault::shadow_ray_misaimed, "shadow_ray_misaimed"},
                                                  {Fault::reflection_flipped, "reflection_flipped"},
                                                  {Fault::refraction_inverted, "refraction_inverted"},
                                                  {Fault::attenuation_forgotten, "attenuation_forgotten"},
                                                  {Fault::depth_not_counted, "depth_not_counted"},
                                                  {Fault::epsilon_wrong_side, "epsilon_wrong_side"},
                                                  {Fault::second_root_dropped, "second_root_dropped"},
                                                  {Fault::epsilon_too_small, "epsilon_too_small"},
                                                  {Fault::second_side_black, "second_side_black"},
                                                  {Fault::cosine_counted_twice, "cosine_counted_twice"},
                                                  {Fault::emission_not_weighted, "emission_not_weighted"},
                                                  {Fault::emitter_area_forgotten, "emitter_area_forgotten"},
                                                  {Fault::photons_from_behind, "photons_from_behind"},
                                                  {Fault::power_of_another_pass, "power_of_another_pass"},
                                                  {Fault::pi_forgotten, "pi_forgotten"},
                                                  {Fault::reflectance_forgotten, "reflectance_forgotten"}};

/// The line of pseudocode that is broken.
[[nodiscard]] constexpr Line faulty_line(Fault fault) {
  switch (fault) {
    case Fault::shadow_ray_misaimed:
    case Fault::epsilon_too_small:
      return Line::form_shadow_ray;
    case Fault::reflection_flipped:
    case Fault::epsilon_wrong_side:
      return Line::form_reflect_ray;
    case Fault::refraction_inverted:
      return Line::form_refract_ray;
    case Fault::attenuation_forgotten:
      return Line::compute_rtnshade;
    case Fault::depth_not_counted:
      return Line::shade_reflect;
    case Fault::second_root_dropped:
      return Line::find_refract_intersect;
    case Fault::second_side_black:
      return Line::path_form_shadow_ray;
    case Fault::cosine_counted_twice:
      return Line::choose_direction;
    case Fault::emission_not_weighted:
      return Line::add_emission;
    case Fault::emitter_area_forgotten:
      return Line::add_light;
    case Fault::photons_from_behind:
      return Line::find_nearest_photons;
    case Fault::power_of_another_pass:
      return Line::emit_photon;
    case Fault::pi_forgotten:
      return Line::add_light_of_photons;
    case Fault::reflectance_forgotten:
      return Line::look_up_light;
  }
  return Line::for_each_pixel;
}

/// Whose procedure it breaks; `automatic`: the tracer's.
[[nodiscard]] constexpr Integrator integrator_of(Fault fault) { return pseudocode_with(faulty_line(fault)).integrator; }

}  // namespace raywalk
