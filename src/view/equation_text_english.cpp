// The English words of the live equation.

#include "view/equation_text.h"

namespace raywalk {

std::string_view english(EquationText id) {
  switch (id) {
    case EquationText::pixel:
      return "pixel";
    case EquationText::of:
      return "of";
    case EquationText::unit_direction:
      return "D has length 1, so t is the distance from EYE";
    case EquationText::stands_at:
      return "stands at";
    case EquationText::as_far_from_normal:
      return "as far from the normal as it came:";
    case EquationText::sine:
      return "sin";
    case EquationText::slower_beyond:
      return "slower beyond: towards the normal";
    case EquationText::faster_beyond:
      return "faster beyond: away from the normal";
    case EquationText::as_fast_beyond:
      return "as fast beyond: straight on";
    case EquationText::fresnel:
      return "Fresnel: the part that is reflected here";
    case EquationText::depth_allowed:
      return "DEPTH + 1 ≤ limit?";
    case EquationText::share_allowed:
      return "share of the pixel ≥ threshold?";
    case EquationText::no_ray:
      return "no ray is formed";
    case EquationText::light_behind:
      return "the light stands behind the surface";
    case EquationText::spot_elsewhere:
      return "the spot does not shine this way";
    case EquationText::nothing_between:
      return "no surface between the point and the light";
    case EquationText::nothing_ahead:
      return "no surface has a t above 0";
    case EquationText::blocked_before:
      return "before the light: it is blocked";
    case EquationText::nearer_root:
      return "t₀: the nearer one, and ahead";
    case EquationText::other_root_behind:
      return "t₁: the other one lies behind";
    case EquationText::other_root_is_start:
      return "t₁: at the other one the ray began";
    case EquationText::yes:
      return "yes";
    case EquationText::no:
      return "no";
    case EquationText::above_zero:
      return "above 0: yes";
    case EquationText::zero:
      return "0: no";
    case EquationText::no_such_angle:
      return "no such angle: total internal reflection";
    case EquationText::background:
      return "background";
    case EquationText::ambient:
      return "ambient";
    case EquationText::emission:
      return "emission";
    case EquationText::diffuse:
      return "diffuse";
    case EquationText::highlight:
      return "highlight";
    case EquationText::passed:
      return "all that times what the way through leaves:";
    case EquationText::direction:
      return "direction";
    case EquationText::light:
      return "light";
    case EquationText::weight:
      return "weight";
    case EquationText::share:
      return "share";
    case EquationText::share_left:
      return "share that is left";
    case EquationText::absorbed:
      return "absorbed: none";
    case EquationText::survival:
      return "goes on with probability";
  }
  return {};
}

}  // namespace raywalk
