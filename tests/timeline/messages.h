// The messages of a walk, by who says them.
#pragma once

#include "text/catalogue.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>

namespace raywalk::test {

/// Of FOLLOW PATH alone.
inline constexpr std::array<std::string_view, 27> path_messages{"walk.path_called",
                                                                "walk.path_goes_on",
                                                                "walk.path_over",
                                                                "walk.path_met",
                                                                "walk.path_met_nothing",
                                                                "walk.background_added",
                                                                "walk.emits_nothing",
                                                                "walk.emission_added",
                                                                "walk.emission_weighted",
                                                                "walk.object_aimed_at",
                                                                "walk.object_not_aimed_at",
                                                                "walk.object_seen",
                                                                "walk.object_hidden",
                                                                "walk.light_adds_nothing",
                                                                "walk.light_added",
                                                                "walk.light_added_weighted",
                                                                "walk.direction_none",
                                                                "walk.direction_diffuse",
                                                                "walk.direction_highlight",
                                                                "walk.direction_mirror",
                                                                "walk.direction_transparent",
                                                                "walk.path_survives",
                                                                "walk.path_survives_roulette",
                                                                "walk.path_lost_roulette",
                                                                "walk.path_too_long",
                                                                "walk.path_absorbed",
                                                                "walk.next_formed"};

/// Of a pixel of the 3-D image.
inline constexpr std::array<std::string_view, 3> image_messages{"walk.image_pixel_begun", "walk.image_primary_formed",
                                                                "walk.image_pixel_put"};

/// All others that have a text.
inline std::set<std::string> strip_messages() {
  std::set<std::string> ids;
  for (const std::string_view id : Catalogue::embedded().ids())
    if (id.starts_with("walk.") && std::count(id.begin(), id.end(), '.') == 1 &&
        std::find(path_messages.begin(), path_messages.end(), id) == path_messages.end() &&
        std::find(image_messages.begin(), image_messages.end(), id) == image_messages.end())
      ids.emplace(id);
  return ids;
}

}  // namespace raywalk::test
