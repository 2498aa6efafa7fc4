#pragma once
// Bugs put into the tracer on purpose, for people who learn to find them. Each breaks one line of the pseudocode and
// nothing else: up to the first time that the line runs, a broken walk has the bits of one that is whole. They are made
// by the hooks of a kernel of their own (Policy::faulty), over naive numerics, since an epsilon, or a root that is
// looked for, can only be wrong where there is one.

#include "trace/pseudocode.h"

#include <array>
#include <string_view>

namespace raywalk {

/// From easy to hard to find.
enum class Fault {
  shadow_ray_misaimed,    ///< it goes along the light's position, as if that were the way from the hit to the light
  reflection_flipped,     ///< the normal of the mirror's formula points into the body
  refraction_inverted,    ///< n2 / n1 in place of n1 / n2
  attenuation_forgotten,  ///< a light is as strong from afar as from near
  depth_not_counted,      ///< SHADE hands its own DEPTH on to the SHADE of what it mirrors
  epsilon_wrong_side,     ///< a reflect ray starts epsilon below the surface, and not above it
  second_root_dropped,    ///< of a quadratic's roots only the nearer is looked at, also from inside
  epsilon_too_small,      ///< a shadow ray starts on the surface itself
};
inline constexpr std::array all_faults{
    Fault::shadow_ray_misaimed, Fault::reflection_flipped, Fault::refraction_inverted, Fault::attenuation_forgotten,
    Fault::depth_not_counted,   Fault::epsilon_wrong_side, Fault::second_root_dropped, Fault::epsilon_too_small};

/// "shadow_ray_misaimed"
[[nodiscard]] constexpr std::string_view fault_name(Fault fault) {
  switch (fault) {
    case Fault::shadow_ray_misaimed:
      return "shadow_ray_misaimed";
    case Fault::reflection_flipped:
      return "reflection_flipped";
    case Fault::refraction_inverted:
      return "refraction_inverted";
    case Fault::attenuation_forgotten:
      return "attenuation_forgotten";
    case Fault::depth_not_counted:
      return "depth_not_counted";
    case Fault::epsilon_wrong_side:
      return "epsilon_wrong_side";
    case Fault::second_root_dropped:
      return "second_root_dropped";
    case Fault::epsilon_too_small:
      return "epsilon_too_small";
  }
  return "";
}

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
  }
  return Line::for_each_pixel;
}

}  // namespace raywalk
