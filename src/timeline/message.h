#pragma once
// What a step did, without language: an id and its arguments. `view` puts it into words.

#include "scene/scene.h"
#include "timeline/timeline.h"

#include <string>
#include <variant>
#include <vector>

namespace raywalk {

/// One id for each thing that a line of pseudocode can turn out to do. The arguments are listed in brackets.
enum class MessageId {
  start,                    ///< position 0
  pixel_begun,              ///< [cell from 1, cells]
  sample_begun,             ///< of the same pixel: [sample from 1]
  primary_formed,           ///< [cell from 1]
  found_hit,                ///< [ray kind, what was met, distance]
  found_missed,             ///< [ray kind]
  left_through_surface,     ///< a ray inside its own object met it from inside: [ray kind, what was met, distance]
  intersected,              ///< [object]
  intersected_nothing,      ///< []
  shade_called,             ///< [depth of the call, object, ray kind]
  shade_called_unlit,       ///< the same in a scene without lights
  shade_missed,             ///< a secondary ray that missed: the background returns: [ray kind, colour]
  shadow_formed,            ///< [object, light]
  shadow_facing_away,       ///< [object, light]
  shadow_outside_cone,      ///< [object, light]
  light_reached,            ///< [light]
  light_filtered,           ///< [light, share that passes, colour]
  light_blocked,            ///< [light, met]
  light_blocked_by_itself,  ///< [light, met]
  reflective,               ///< [object, kr']
  reflective_totally,       ///< total internal reflection made it so, on the way out: [object, kr']
  reflective_totally_in,    ///< the same, on the way in
  not_reflective,           ///< [object]
  reflect_formed,           ///< [object, share of the pixel]
  reflect_depth,            ///< [depth limit]
  reflect_threshold,        ///< [share of the pixel, threshold]
  transparent,              ///< [object, kt']
  not_transparent,          ///< [object]
  totally_reflected,        ///< nothing is transmitted on the way out: [object]
  totally_reflected_in,     ///< the same, on the way in
  refract_formed_in,        ///< into the object: [object, angle in degrees, angle out degrees]
  refract_formed_out,       ///< out of it: the same
  refract_formed_within,    ///< into it or out of it, inside of another: [the same, index before, index behind]
  refract_depth,            ///< [depth limit]
  refract_threshold,        ///< [share of the pixel, threshold]
  path_length,              ///< [ray kind]
  rtnshade_to_main,         ///< [object, colour]
  rtnshade_to_caller,       ///< [object, colour, ray kind that waited, depth of the caller]
  pixel_put,                ///< [cell from 1, colour]
  sample_put,               ///< [sample from 1, its colour, the mean]
  // The same three for a pixel of the 3-D image, which is named as --pixel names it.
  image_pixel_begun,     ///< [column from 0, row from 0]
  image_primary_formed,  ///< [column from 0, row from 0]
  image_pixel_put,       ///< [column from 0, row from 0, colour]
  // FOLLOW PATH.
  path_called,             ///< []
  path_goes_on,            ///< [ray kind]
  path_over,               ///< no ray is left: [colour]
  path_met,                ///< [object]
  path_met_nothing,        ///< []
  background_added,        ///< [colour]
  emits_nothing,           ///< [object]
  emission_added,          ///< [object, colour]
  emission_weighted,       ///< a light's sample might have found it: [object, weight, colour]
  object_aimed_at,         ///< a shadow ray to a point of an object that emits: [object it leaves]
  object_not_aimed_at,     ///< [object it would leave]
  object_seen,             ///< [met, which emits]
  object_hidden,           ///< [met]
  light_adds_nothing,      ///< []
  light_added,             ///< [light or object, colour]
  light_added_weighted,    ///< the path might lead there too: [object, weight, colour]
  direction_none,          ///< [object]
  direction_diffuse,       ///< [object, share of the pixel]
  direction_highlight,     ///< the same
  direction_mirror,        ///< the same
  direction_transparent,   ///< the same
  path_survives,           ///< []
  path_survives_roulette,  ///< [probability]
  path_lost_roulette,      ///< [share of the pixel]
  path_too_long,           ///< [most rays]
  path_absorbed,           ///< [object]
  next_formed,             ///< [object, ray kind, share of the pixel]
};

/// A part of the whole, 0..1.
struct Share {
  double value;
  friend bool operator==(const Share&, const Share&) = default;
};

/// What a ray met: an object, or more exactly a member of the group or a triangle of the mesh that it is.
struct Met {
  std::string object, member{};  ///< names; no member: empty
  int triangle = -1;             ///< from 0; none: -1
  friend bool operator==(const Met&, const Met&) = default;
};

/// A name is a string as it stands in the scene.
using Argument = std::variant<int, double, Rgbd, Share, RayKind, std::string, Met>;

struct Message {
  MessageId id = MessageId::start;
  std::vector<Argument> arguments;
};

/// What the line that has just run at `position` did. `timeline` was recorded from `scene`; 0 <= position <= steps().
[[nodiscard]] Message describe(const Scene& scene, const Timeline& timeline, int position);

}  // namespace raywalk
