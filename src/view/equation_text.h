#pragma once
// The words between the letters and numbers of the live equation: a family of view/text.h. Signs and letters, RTNSHADE
// and DEPTH stand in no language.

#include <string_view>

namespace raywalk {

enum class EquationText {
  pixel,  ///< before its number
  of,     ///< before the number of all
  unit_direction,
  stands_at,  ///< between a light's name and t
  as_far_from_normal,
  sine,  ///< the function
  slower_beyond,
  faster_beyond,
  as_fast_beyond,
  fresnel,
  depth_allowed,
  share_allowed,
  no_ray,
  light_behind,
  spot_elsewhere,
  nothing_between,
  nothing_ahead,
  blocked_before,
  nearer_root,
  other_root_behind,
  other_root_is_start,
  yes,
  no,
  above_zero,
  zero,
  no_such_angle,
  background,
  ambient,
  emission,
  diffuse,    ///< behind a light's name
  highlight,  ///< the same
  passed,
  direction,  ///< whose density is meant
  light,      ///< the same
  weight,
  share,
  share_left,
  absorbed,
  survival,
};

[[nodiscard]] std::string_view english(EquationText id);
[[nodiscard]] std::string_view portuguese(EquationText id);

}  // namespace raywalk
