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

/// Of rough surfaces alone.
inline constexpr std::array<std::string_view, 9> rough_messages{
    "walk.direction_small_mirror", "walk.direction_small_facet", "walk.direction_rough_matt",
    "walk.photon_small_mirror",    "walk.photon_small_facet",    "walk.refract_formed_facet",
    "walk.refract_formed_facets",  "walk.reflect_wrong_side",    "walk.refract_wrong_side"};

/// Of PHOTON MAPPING alone.
inline constexpr std::array<std::string_view, 40> photon_messages{
    "walk.photon_begun",          "walk.photon_emitted",       "walk.photon_emitted_far",  "walk.photon_from_object",
    "walk.photon_from_sky",       "walk.photon_called",        "walk.photon_goes_on",      "walk.photon_over",
    "walk.photon_left",           "walk.photon_diffuse",       "walk.photon_not_diffuse",  "walk.photon_stored",
    "walk.photon_stored_caustic", "walk.photon_stored_direct", "walk.photon_not_kept",     "walk.photon_no_direction",
    "walk.photon_diffused",       "walk.photon_in_highlight",  "walk.photon_mirrored",     "walk.photon_passed",
    "walk.photon_survives",       "walk.photon_lost_roulette", "walk.photon_absorbed",     "walk.photon_next",
    "walk.gather_called",         "walk.gather_goes_on",       "walk.gather_over",         "walk.gather_no_direction",
    "walk.gather_ends",           "walk.background_counted",   "walk.emission_counted",    "walk.no_photons",
    "walk.photons_found",         "walk.caustic_found",        "walk.both_found",          "walk.photons_within",
    "walk.caustic_within",        "walk.both_within",          "walk.photons_add_nothing", "walk.photons_added"};

/// Of RADIOSITY alone.
inline constexpr std::array<std::string_view, 20> radiosity_messages{
    "walk.edges_cut",      "walk.patches_cut",    "walk.patches_lit",    "walk.patches_dark",
    "walk.unshot_light",   "walk.unshot_rest",    "walk.patch_taken",    "walk.patch_shoots",
    "walk.patch_shot",     "walk.patch_in_front", "walk.factor_found",   "walk.factor_partly",
    "walk.factor_blocked", "walk.light_arrives",  "walk.light_absorbed", "walk.no_light_arrives",
    "walk.patch_emptied",  "walk.looked_up",      "walk.looked_up_dark", "walk.looked_up_nothing"};

/// Of BEAM TRACING alone.
inline constexpr std::array<std::string_view, 30> beam_messages{"walk.beam_formed",
                                                                "walk.image_beam_formed",
                                                                "walk.beam_cut",
                                                                "walk.beam_whole",
                                                                "walk.beam_sees_nothing",
                                                                "walk.parts_called",
                                                                "walk.mirrored_parts_called",
                                                                "walk.refracted_parts_called",
                                                                "walk.straight_beam_formed",
                                                                "walk.refracted_beam_formed",
                                                                "walk.part_background_no_glass",
                                                                "walk.part_no_glass",
                                                                "walk.part_refracts",
                                                                "walk.part_sees",
                                                                "walk.part_sees_nothing",
                                                                "walk.part_shaded",
                                                                "walk.part_background",
                                                                "walk.part_background_no_mirror",
                                                                "walk.part_no_mirror",
                                                                "walk.part_mirrors",
                                                                "walk.mirrored_beam_formed",
                                                                "walk.beam_depth",
                                                                "walk.beam_threshold",
                                                                "walk.part_background_no_ray",
                                                                "walk.part_sends_no_rays",
                                                                "walk.part_sends_rays",
                                                                "walk.part_added",
                                                                "walk.part_added_off",
                                                                "walk.last_part_added_off",
                                                                "walk.last_part_added"};

/// Of CONE TRACING alone.
inline constexpr std::array<std::string_view, 24> cone_messages{"walk.cone_formed",
                                                                "walk.image_cone_formed",
                                                                "walk.cone_shared",
                                                                "walk.cone_whole",
                                                                "walk.cone_sees_nothing",
                                                                "walk.cone_called",
                                                                "walk.share_sees",
                                                                "walk.share_left",
                                                                "walk.shadow_cone_formed",
                                                                "walk.light_uncovered",
                                                                "walk.light_partly",
                                                                "walk.light_covered_by",
                                                                "walk.cone_mirror",
                                                                "walk.cone_no_mirror",
                                                                "walk.cone_glass",
                                                                "walk.cone_no_glass",
                                                                "walk.reflected_cone_spreads",
                                                                "walk.reflected_cone_converges",
                                                                "walk.refracted_cone_spreads",
                                                                "walk.refracted_cone_converges",
                                                                "walk.cone_depth",
                                                                "walk.cone_threshold",
                                                                "walk.share_added",
                                                                "walk.last_share_added"};

/// Of PENCIL TRACING alone.
inline constexpr std::array<std::string_view, 18> pencil_messages{"walk.pencil_formed",
                                                                  "walk.image_pencil_formed",
                                                                  "walk.pencil_transferred",
                                                                  "walk.pencil_folded",
                                                                  "walk.pencil_meets",
                                                                  "walk.pencil_spreads",
                                                                  "walk.pencil_parallel",
                                                                  "walk.pencil_lost",
                                                                  "walk.pencil_called",
                                                                  "walk.pencil_missed",
                                                                  "walk.pencil_shaded",
                                                                  "walk.space_pencil_round",
                                                                  "walk.space_pencil_transferred",
                                                                  "walk.space_pencil_folded",
                                                                  "walk.space_pencil_meets",
                                                                  "walk.space_pencil_half_meets",
                                                                  "walk.space_pencil_spreads",
                                                                  "walk.space_pencil_parallel"};

/// Of scenes under a sky.
inline constexpr std::array<std::string_view, 10> sky_messages{
    "walk.found_sky",          "walk.found_sky_below",    "walk.sky_aimed_at",   "walk.sky_not_aimed_at",
    "walk.sky_seen",           "walk.sky_hidden",         "walk.sky_seen_below", "walk.sky_added",
    "walk.sky_added_weighted", "walk.background_weighted"};

/// Of bodies that scatter light, and of those that are left by the dipole.
inline constexpr std::array<std::string_view, 2> scattering_messages{"walk.scattered_inside",
                                                                     "walk.direction_scattered"};
inline constexpr std::array<std::string_view, 2> dipole_messages{"walk.left_by_dipole", "walk.direction_leaves"};

/// Of a pixel of the 3-D image.
inline constexpr std::array<std::string_view, 3> image_messages{"walk.image_pixel_begun", "walk.image_primary_formed",
                                                                "walk.image_pixel_put"};

/// All others that have a text.
inline std::set<std::string> strip_messages() {
  std::set<std::string> ids;
  for (const std::string_view id : Catalogue::embedded().ids())
    if (id.starts_with("walk.") && std::count(id.begin(), id.end(), '.') == 1 &&
        std::find(path_messages.begin(), path_messages.end(), id) == path_messages.end() &&
        std::find(rough_messages.begin(), rough_messages.end(), id) == rough_messages.end() &&
        std::find(photon_messages.begin(), photon_messages.end(), id) == photon_messages.end() &&
        std::find(radiosity_messages.begin(), radiosity_messages.end(), id) == radiosity_messages.end() &&
        std::find(beam_messages.begin(), beam_messages.end(), id) == beam_messages.end() &&
        std::find(cone_messages.begin(), cone_messages.end(), id) == cone_messages.end() &&
        std::find(pencil_messages.begin(), pencil_messages.end(), id) == pencil_messages.end() &&
        std::find(sky_messages.begin(), sky_messages.end(), id) == sky_messages.end() &&
        std::find(scattering_messages.begin(), scattering_messages.end(), id) == scattering_messages.end() &&
        std::find(dipole_messages.begin(), dipole_messages.end(), id) == dipole_messages.end() &&
        std::find(image_messages.begin(), image_messages.end(), id) == image_messages.end())
      ids.emplace(id);
  return ids;
}

}  // namespace raywalk::test
