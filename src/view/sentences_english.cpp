// The English names of rays and of how they end, and the sentences of the walk.

#include "view/text.h"

namespace raywalk {

std::string_view english(RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return "primary ray";
    case RayKind::shadow:
      return "shadow ray";
    case RayKind::reflect:
      return "reflect ray";
    case RayKind::refract:
      return "refract ray";
  }
  return "";
}

std::string_view english(Ending ending) {
  switch (ending) {
    case Ending::hit:
      return "hit";
    case Ending::missed:
      return "left the scene";
    case Ending::blocked:
      return "blocked";
    case Ending::reached_light:
      return "reached the light";
    case Ending::depth:
      return "not formed: depth limit";
    case Ending::threshold:
      return "not formed: share too small";
    case Ending::total_internal_reflection:
      return "not formed: total internal reflection";
    case Ending::path_length:
      return "not formed: path length";
    case Ending::facing_away:
      return "not formed: faces away from the light";
    case Ending::outside_cone:
      return "not formed: outside the light's cone";
  }
  return "";
}

std::string_view english(MessageId id) {
  switch (id) {
    case MessageId::start:
      return "Nothing has run yet.";
    case MessageId::pixel_begun:
      return "Pixel {0} is next; SCREEN has pixels 0 to {1}.";
    case MessageId::sample_begun:
      return "Sample {0} of the same pixel is next: its rays are drawn anew.";
    case MessageId::primary_formed:
      return "A primary ray leaves EYE through pixel {0} of SCREEN.";
    case MessageId::found_hit:
      return "The {0} hits {1} at distance {2}.";
    case MessageId::left_through_surface:
      return "Inside {1}, the {0} reaches its surface again after {2}.";
    case MessageId::found_missed:
      return "The {0} hits nothing: it leaves the scene.";
    case MessageId::intersected:
      return "It hit {0}, so that has to be shaded.";
    case MessageId::intersected_nothing:
      return "It hit nothing, so there is nothing to shade: the pixel gets the background.";
    case MessageId::shade_called:
      return "SHADE is called with DEPTH {0} for the point of {1} that the {2} hit.";
    case MessageId::shade_called_unlit:
      return "SHADE is called with DEPTH {0} for the point of {1} that the {2} hit; without a light there are no "
             "shadow rays.";
    case MessageId::shade_missed:
      return "The {0} left the scene, so SHADE returns the background {1}.";
    case MessageId::shadow_formed:
      return "A shadow ray leaves {0} towards {1}.";
    case MessageId::shadow_facing_away:
      return "No shadow ray is formed: here {0} faces away from {1}, which cannot light it.";
    case MessageId::shadow_outside_cone:
      return "No shadow ray is formed: {0} lies outside the cone that {1} shines into.";
    case MessageId::light_reached:
      return "The shadow ray reaches {0}: its light arrives.";
    case MessageId::light_filtered:
      return "The shadow ray reaches {0} through something transparent: {1} of its light arrives.";
    case MessageId::light_blocked:
      return "The shadow ray is blocked by {1}: no light arrives from {0}.";
    case MessageId::light_blocked_by_itself:
      return "The shadow ray is blocked by {1} itself: no light arrives from {0}.";
    case MessageId::reflective:
      return "{0} reflects with weight {1}, so a reflect ray is wanted.";
    case MessageId::reflective_totally:
      return "Total internal reflection: no light leaves {0} here, so the reflect ray gets both shares, weight {1}.";
    case MessageId::reflective_totally_in:
      return "Total internal reflection: no light goes into {0} here, so the reflect ray gets both shares, weight {1}.";
    case MessageId::not_reflective:
      return "{0} does not reflect here: these lines are skipped.";
    case MessageId::reflect_formed:
      return "A reflect ray leaves {0}; it can bring at most {1} of the pixel.";
    case MessageId::reflect_depth:
      return "No reflect ray is formed: SHADE may not go deeper than DEPTH {0}.";
    case MessageId::reflect_threshold:
      return "No reflect ray is formed: it could bring only {0} of the pixel, less than the threshold of {1}.";
    case MessageId::transparent:
      return "{0} lets light through with weight {1}, so a refract ray is wanted.";
    case MessageId::not_transparent:
      return "{0} lets no light through: these lines are skipped.";
    case MessageId::totally_reflected:
      return "No refract ray is formed: total internal reflection lets nothing out of {0} here.";
    case MessageId::totally_reflected_in:
      return "No refract ray is formed: total internal reflection lets nothing into {0} here.";
    case MessageId::refract_formed_in:
      return "A refract ray goes into {0}: {1} degrees to the normal become {2}.";
    case MessageId::refract_formed_out:
      return "A refract ray comes out of {0}: {1} degrees to the normal become {2}.";
    case MessageId::refract_formed_within:
      return "At {0} a refract ray goes from index {3} to index {4}: {1} degrees to the normal become {2}.";
    case MessageId::refract_depth:
      return "No refract ray is formed: SHADE may not go deeper than DEPTH {0}.";
    case MessageId::refract_threshold:
      return "No refract ray is formed: it could bring only {0} of the pixel, less than the threshold of {1}.";
    case MessageId::path_length:
      return "No {0} is formed: the path is as long as it may be.";
    case MessageId::rtnshade_to_main:
      return "All parts are added up: SHADE returns {1} for {0} to MAIN ALGORITHM.";
    case MessageId::rtnshade_to_caller:
      return "All parts are added up: SHADE returns {1} for {0} to the SHADE of DEPTH {3}, which waited for its {2}.";
    case MessageId::pixel_put:
      return "Pixel {0} of SCREEN gets its final shade {1}.";
    case MessageId::sample_put:
      return "Sample {0} brings {1}; the mean of all samples so far, {2}, stands in the pixel.";
    case MessageId::image_pixel_begun:
      return "The image's pixel in column {0}, row {1} is next.";
    case MessageId::image_primary_formed:
      return "A primary ray leaves EYE through the image's pixel in column {0}, row {1}.";
    case MessageId::image_pixel_put:
      return "The image's pixel in column {0}, row {1} gets its final shade {2}.";
    case MessageId::path_called:
      return "FOLLOW PATH is called: it follows one path of light backwards, from EYE to wherever chance leads.";
    case MessageId::path_goes_on:
      return "There is a ray, a {0}: the path goes on with it.";
    case MessageId::path_over:
      return "No ray is left: the path has ended, and FOLLOW PATH returns {0}.";
    case MessageId::path_met:
      return "It hit {0}: light that leaves there towards it counts.";
    case MessageId::path_met_nothing:
      return "It hit nothing, so the path ends here.";
    case MessageId::background_added:
      return "The background adds {0} to the pixel; the path has left the scene and ends.";
    case MessageId::emits_nothing:
      return "{0} gives off no light: nothing is added.";
    case MessageId::emission_added:
      return "{0} gives off light itself, which adds {1} to the pixel.";
    case MessageId::emission_weighted:
      return "{0} gives off light; a shadow ray might have found it too, so it counts for {1} and adds {2}.";
    case MessageId::object_aimed_at:
      return "A shadow ray leaves {0} towards a point, drawn at random, of an object that gives off light.";
    case MessageId::object_not_aimed_at:
      return "No shadow ray is formed: here {0} faces away from the point drawn on an object that gives off light.";
    case MessageId::object_seen:
      return "The shadow ray reaches {0}: its light arrives.";
    case MessageId::object_hidden:
      return "The shadow ray is blocked by {0}: no light arrives.";
    case MessageId::light_adds_nothing:
      return "Nothing arrives, so nothing is added.";
    case MessageId::light_added:
      return "{0} adds {1} to the pixel.";
    case MessageId::light_added_weighted:
      return "The path might have led to {0} too, so this counts for {1}: it adds {2} to the pixel.";
    case MessageId::direction_none:
      return "No direction is chosen: the path does not go on from {0}.";
    case MessageId::direction_diffuse:
      return "By chance {0} scatters it like a matte surface; along the new direction it can bring {1} of the pixel.";
    case MessageId::direction_highlight:
      return "By chance {0} scatters it near its highlight; along the new direction it can bring {1} of the pixel.";
    case MessageId::direction_mirror:
      return "By chance {0} reflects it as a mirror; along the new direction it can bring {1} of the pixel.";
    case MessageId::direction_transparent:
      return "By chance {0} lets it through; along the new direction it can bring {1} of the pixel.";
    case MessageId::path_survives:
      return "The path survives: as yet no chance is taken with it.";
    case MessageId::path_survives_roulette:
      return "Russian roulette: the path survives, as {0} of such do, and counts as much more.";
    case MessageId::path_lost_roulette:
      return "Russian roulette ends the path, which could bring only {0} of the pixel.";
    case MessageId::path_too_long:
      return "The path ends: it may have at most {0} rays.";
    case MessageId::path_absorbed:
      return "The path ends: {0} swallows what comes.";
    case MessageId::next_formed:
      return "The path leaves {0} by a {1}, which can bring {2} of the pixel.";
  }
  return "";
}

}  // namespace raywalk
