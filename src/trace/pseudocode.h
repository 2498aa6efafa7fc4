#pragma once

#include "math/words.h"
#include "scene/render_choices.h"

#include <array>
#include <span>
#include <string_view>
#include <utility>

namespace raywalk {

/// The procedures of the tracer, of path tracing, of photon mapping, of radiosity, of beam tracing, of cone
/// tracing, and of pencil tracing.
enum class Procedure {
  main_algorithm,
  shade,
  path_tracing,
  follow_path,
  photon_mapping,
  follow_photon,
  gather_light,
  radiosity,
  shoot_light,
  beam_tracing,
  shade_parts,
  cone_tracing,
  shade_cone,
  pencil_tracing,
  shade_pencil,
};
template <>
inline constexpr Word<Procedure> words_of<Procedure>[] = {{Procedure::main_algorithm, "MAIN ALGORITHM"},
                                                          {Procedure::shade, "SHADE (DEPTH, RTNSHADE)"},
                                                          {Procedure::path_tracing, "PATH TRACING"},
                                                          {Procedure::follow_path, "FOLLOW PATH (RTNSHADE)"},
                                                          {Procedure::photon_mapping, "PHOTON MAPPING"},
                                                          {Procedure::follow_photon, "FOLLOW PHOTON (POWER)"},
                                                          {Procedure::gather_light, "GATHER LIGHT (RTNSHADE)"},
                                                          {Procedure::radiosity, "RADIOSITY"},
                                                          {Procedure::shoot_light, "SHOOT LIGHT (PATCH)"},
                                                          {Procedure::beam_tracing, "BEAM TRACING"},
                                                          {Procedure::shade_parts, "SHADE PARTS (DEPTH, RTNSHADE)"},
                                                          {Procedure::cone_tracing, "CONE TRACING"},
                                                          {Procedure::shade_cone, "SHADE CONE (DEPTH, RTNSHADE)"},
                                                          {Procedure::pencil_tracing, "PENCIL TRACING"},
                                                          {Procedure::shade_pencil, "SHADE PENCIL (DEPTH, RTNSHADE)"}};

/// The lines of the procedures, in the order shown on the screen. Each text is also the comment that heads its
/// statement in trace/tracer.h, path.h, photons.h, radiosity.h, beams.h and space_beams.h, cones.h or pencils.h; a test
/// holds the two together, and another each to its translations.
enum class Line {
  for_each_pixel,
  form_primary_ray,
  find_closest_intersection,
  if_intersect_something,
  shade_final,
  put_final_shade,
  form_shadow_ray,
  find_intersection,
  if_reflective,
  form_reflect_ray,
  find_reflect_intersect,
  shade_reflect,
  if_transparent,
  form_refract_ray,
  find_refract_intersect,
  shade_refract,
  compute_rtnshade,
  // Path tracing's.
  path_for_each_pixel,
  path_form_primary_ray,
  follow_path,
  path_put_final_shade,
  while_ray,
  path_find_closest_intersection,
  if_intersect_nothing,
  add_background,
  add_emission,
  path_form_shadow_ray,
  path_find_intersection,
  add_light,
  choose_direction,
  if_path_survives,
  form_next_ray,
  // Photon mapping's.
  for_each_photon,
  emit_photon,
  follow_photon,
  photon_for_each_pixel,
  photon_form_primary_ray,
  gather_light,
  photon_put_final_shade,
  while_photon,
  photon_find_closest_intersection,
  if_diffuse,
  store_photon,
  photon_choose_direction,
  if_photon_survives,
  photon_form_next_ray,
  gather_while_ray,
  gather_find_closest_intersection,
  gather_if_intersect_nothing,
  gather_add_background,
  gather_add_emission,
  gather_form_shadow_ray,
  gather_find_intersection,
  gather_add_light,
  find_nearest_photons,
  add_light_of_photons,
  gather_choose_direction,
  gather_if_path_survives,
  gather_form_next_ray,
  // Radiosity's.
  cut_patches,
  light_patches,
  while_unshot_light,
  take_patch,
  shoot_light,
  radiosity_for_each_pixel,
  radiosity_form_primary_ray,
  radiosity_find_closest_intersection,
  look_up_light,
  radiosity_put_final_shade,
  for_each_patch,
  compute_form_factor,
  add_what_arrives,
  forget_unshot_light,
  // Beam tracing's.
  beam_for_each_pixel,
  form_beam,
  cut_beam,
  shade_parts,
  beam_put_final_shade,
  for_each_part,
  beam_form_shadow_ray,
  beam_find_intersection,
  shade_middle,
  if_flat_mirror,
  form_mirrored_beam,
  cut_mirrored_beam,
  shade_mirrored_parts,
  if_flat_glass,
  form_refracted_beam,
  cut_refracted_beam,
  shade_refracted_parts,
  if_curved_or_glass,
  form_middle_ray,
  follow_middle_ray,
  add_part,
  // Cone tracing's.
  cone_for_each_pixel,
  form_cone,
  find_cover,
  shade_cone,
  cone_put_final_shade,
  cone_for_each_part,
  form_shadow_cone,
  find_uncovered,
  cone_shade_middle,
  cone_if_reflective,
  form_reflected_cone,
  find_reflected_cover,
  shade_reflected_cone,
  cone_if_transparent,
  form_refracted_cone,
  find_refracted_cover,
  shade_refracted_cone,
  add_share,
  // Pencil tracing's.
  pencil_for_each_pixel,
  form_pencil,
  find_axis_intersection,
  pencil_if_intersect_something,
  shade_pencil,
  pencil_put_final_shade,
  transfer_pencil,
  pencil_form_shadow_ray,
  pencil_find_intersection,
  pencil_if_reflective,
  form_reflected_axis,
  reflect_pencil,
  find_reflected_axis_intersect,
  shade_reflected_pencil,
  pencil_if_transparent,
  form_refracted_axis,
  refract_pencil,
  find_refracted_axis_intersect,
  shade_refracted_pencil,
  pencil_compute_rtnshade,
};

struct PseudocodeLine {
  Line line;
  std::string_view id;  ///< of its translation: the text "line.ID"
  Procedure procedure;
  int indent;
  std::string_view text;
};

inline constexpr int line_count = 17;
inline constexpr std::array<PseudocodeLine, line_count> pseudocode{{
    {Line::for_each_pixel, "for_each_pixel", Procedure::main_algorithm, 0, "For each pixel"},
    {Line::form_primary_ray, "form_primary_ray", Procedure::main_algorithm, 1, "Form primary ray"},
    {Line::find_closest_intersection, "find_closest_intersection", Procedure::main_algorithm, 1,
     "Find closest intersection"},
    {Line::if_intersect_something, "if_intersect_something", Procedure::main_algorithm, 1, "If intersect something"},
    {Line::shade_final, "shade_final", Procedure::main_algorithm, 2, "Shade (DEPTH+1, final)"},
    {Line::put_final_shade, "put_final_shade", Procedure::main_algorithm, 1, "Put final shade in pixel"},
    {Line::form_shadow_ray, "form_shadow_ray", Procedure::shade, 0, "Form shadow ray"},
    {Line::find_intersection, "find_intersection", Procedure::shade, 0, "Find intersection"},
    {Line::if_reflective, "if_reflective", Procedure::shade, 0, "If reflective"},
    {Line::form_reflect_ray, "form_reflect_ray", Procedure::shade, 1, "Form reflect ray"},
    {Line::find_reflect_intersect, "find_reflect_intersect", Procedure::shade, 1, "Find closest intersect"},
    {Line::shade_reflect, "shade_reflect", Procedure::shade, 1, "Shade (DEPTH+1, REFLSHADE)"},
    {Line::if_transparent, "if_transparent", Procedure::shade, 0, "If transparent"},
    {Line::form_refract_ray, "form_refract_ray", Procedure::shade, 1, "Form refract ray"},
    {Line::find_refract_intersect, "find_refract_intersect", Procedure::shade, 1, "Find closest intersect"},
    {Line::shade_refract, "shade_refract", Procedure::shade, 1, "Shade (DEPTH+1, REFRSHADE)"},
    {Line::compute_rtnshade, "compute_rtnshade", Procedure::shade, 0, "Compute rtnshade"},
}};

inline constexpr int path_line_count = 15;
inline constexpr std::array<PseudocodeLine, path_line_count> path_pseudocode{{
    {Line::path_for_each_pixel, "for_each_pixel", Procedure::path_tracing, 0, "For each pixel"},
    {Line::path_form_primary_ray, "form_primary_ray", Procedure::path_tracing, 1, "Form primary ray"},
    {Line::follow_path, "follow_path", Procedure::path_tracing, 1, "Follow path (final)"},
    {Line::path_put_final_shade, "put_final_shade", Procedure::path_tracing, 1, "Put final shade in pixel"},
    {Line::while_ray, "while_ray", Procedure::follow_path, 0, "While there is a ray"},
    {Line::path_find_closest_intersection, "find_closest_intersection", Procedure::follow_path, 1,
     "Find closest intersection"},
    {Line::if_intersect_nothing, "if_intersect_nothing", Procedure::follow_path, 1, "If intersect nothing"},
    {Line::add_background, "add_background", Procedure::follow_path, 2, "Add background and end"},
    {Line::add_emission, "add_emission", Procedure::follow_path, 1, "Add emission, weighted"},
    {Line::path_form_shadow_ray, "form_shadow_ray", Procedure::follow_path, 1, "Form shadow ray"},
    {Line::path_find_intersection, "find_intersection", Procedure::follow_path, 1, "Find intersection"},
    {Line::add_light, "add_light", Procedure::follow_path, 1, "Add light, weighted"},
    {Line::choose_direction, "choose_direction", Procedure::follow_path, 1, "Choose direction"},
    {Line::if_path_survives, "if_path_survives", Procedure::follow_path, 1, "If path survives"},
    {Line::form_next_ray, "form_next_ray", Procedure::follow_path, 2, "Form next ray"},
}};

inline constexpr int photon_line_count = 27;
inline constexpr std::array<PseudocodeLine, photon_line_count> photon_pseudocode{{
    {Line::for_each_photon, "for_each_photon", Procedure::photon_mapping, 0, "For each photon"},
    {Line::emit_photon, "emit_photon", Procedure::photon_mapping, 1, "Emit photon"},
    {Line::follow_photon, "follow_photon", Procedure::photon_mapping, 1, "Follow photon (POWER)"},
    {Line::photon_for_each_pixel, "for_each_pixel", Procedure::photon_mapping, 0, "For each pixel"},
    {Line::photon_form_primary_ray, "form_primary_ray", Procedure::photon_mapping, 1, "Form primary ray"},
    {Line::gather_light, "gather_light", Procedure::photon_mapping, 1, "Gather light (final)"},
    {Line::photon_put_final_shade, "put_final_shade", Procedure::photon_mapping, 1, "Put final shade in pixel"},
    {Line::while_photon, "while_photon", Procedure::follow_photon, 0, "While there is a photon"},
    {Line::photon_find_closest_intersection, "find_closest_intersection", Procedure::follow_photon, 1,
     "Find closest intersection"},
    {Line::if_diffuse, "if_diffuse", Procedure::follow_photon, 1, "If diffuse"},
    {Line::store_photon, "store_photon", Procedure::follow_photon, 2, "Store photon"},
    {Line::photon_choose_direction, "choose_direction", Procedure::follow_photon, 1, "Choose direction"},
    {Line::if_photon_survives, "if_photon_survives", Procedure::follow_photon, 1, "If photon survives"},
    {Line::photon_form_next_ray, "form_next_ray", Procedure::follow_photon, 2, "Form next ray"},
    {Line::gather_while_ray, "while_ray", Procedure::gather_light, 0, "While there is a ray"},
    {Line::gather_find_closest_intersection, "find_closest_intersection", Procedure::gather_light, 1,
     "Find closest intersection"},
    {Line::gather_if_intersect_nothing, "if_intersect_nothing", Procedure::gather_light, 1, "If intersect nothing"},
    {Line::gather_add_background, "add_background", Procedure::gather_light, 2, "Add background and end"},
    {Line::gather_add_emission, "add_whole_emission", Procedure::gather_light, 1, "Add emission"},
    {Line::gather_form_shadow_ray, "form_shadow_ray", Procedure::gather_light, 1, "Form shadow ray"},
    {Line::gather_find_intersection, "find_intersection", Procedure::gather_light, 1, "Find intersection"},
    {Line::gather_add_light, "add_whole_light", Procedure::gather_light, 1, "Add light"},
    {Line::find_nearest_photons, "find_nearest_photons", Procedure::gather_light, 1, "Find nearest photons"},
    {Line::add_light_of_photons, "add_light_of_photons", Procedure::gather_light, 1, "Add light of photons"},
    {Line::gather_choose_direction, "choose_direction", Procedure::gather_light, 1, "Choose direction"},
    {Line::gather_if_path_survives, "if_path_survives", Procedure::gather_light, 1, "If path survives"},
    {Line::gather_form_next_ray, "form_next_ray", Procedure::gather_light, 2, "Form next ray"},
}};

inline constexpr int radiosity_line_count = 14;
inline constexpr std::array<PseudocodeLine, radiosity_line_count> radiosity_pseudocode{{
    {Line::cut_patches, "cut_patches", Procedure::radiosity, 0, "Cut surfaces into patches"},
    {Line::light_patches, "light_patches", Procedure::radiosity, 0, "Give patches their own light"},
    {Line::while_unshot_light, "while_unshot_light", Procedure::radiosity, 0, "While there is unshot light"},
    {Line::take_patch, "take_patch", Procedure::radiosity, 1, "Take patch with most of it"},
    {Line::shoot_light, "shoot_light", Procedure::radiosity, 1, "Shoot light (PATCH)"},
    {Line::radiosity_for_each_pixel, "for_each_pixel", Procedure::radiosity, 0, "For each pixel"},
    {Line::radiosity_form_primary_ray, "form_primary_ray", Procedure::radiosity, 1, "Form primary ray"},
    {Line::radiosity_find_closest_intersection, "find_closest_intersection", Procedure::radiosity, 1,
     "Find closest intersection"},
    {Line::look_up_light, "look_up_light", Procedure::radiosity, 1, "Look up light of patches"},
    {Line::radiosity_put_final_shade, "put_final_shade", Procedure::radiosity, 1, "Put final shade in pixel"},
    {Line::for_each_patch, "for_each_patch", Procedure::shoot_light, 0, "For each patch in front"},
    {Line::compute_form_factor, "compute_form_factor", Procedure::shoot_light, 1, "Compute form factor"},
    {Line::add_what_arrives, "add_what_arrives", Procedure::shoot_light, 1, "Add what arrives"},
    {Line::forget_unshot_light, "forget_unshot_light", Procedure::shoot_light, 0, "Forget unshot light"},
}};

inline constexpr int beam_line_count = 21;
inline constexpr std::array<PseudocodeLine, beam_line_count> beam_pseudocode{{
    {Line::beam_for_each_pixel, "for_each_pixel", Procedure::beam_tracing, 0, "For each pixel"},
    {Line::form_beam, "form_beam", Procedure::beam_tracing, 1, "Form beam of the pixel"},
    {Line::cut_beam, "cut_beam", Procedure::beam_tracing, 1, "Cut beam by outlines and shadows"},
    {Line::shade_parts, "shade_parts", Procedure::beam_tracing, 1, "Shade parts (DEPTH+1, final)"},
    {Line::beam_put_final_shade, "put_final_shade", Procedure::beam_tracing, 1, "Put final shade in pixel"},
    {Line::for_each_part, "for_each_part", Procedure::shade_parts, 0, "For each part"},
    {Line::beam_form_shadow_ray, "form_shadow_ray", Procedure::shade_parts, 1, "Form shadow ray"},
    {Line::beam_find_intersection, "find_intersection", Procedure::shade_parts, 1, "Find intersection"},
    {Line::shade_middle, "shade_middle", Procedure::shade_parts, 1, "Shade its middle"},
    {Line::if_flat_mirror, "if_flat_mirror", Procedure::shade_parts, 1, "If flat mirror"},
    {Line::form_mirrored_beam, "form_mirrored_beam", Procedure::shade_parts, 2, "Form mirrored beam"},
    {Line::cut_mirrored_beam, "cut_mirrored_beam", Procedure::shade_parts, 2, "Cut it by outlines and shadows"},
    {Line::shade_mirrored_parts, "shade_mirrored_parts", Procedure::shade_parts, 2, "Shade parts (DEPTH+1, REFLSHADE)"},
    {Line::if_flat_glass, "if_flat_glass", Procedure::shade_parts, 1, "If flat glass"},
    {Line::form_refracted_beam, "form_refracted_beam", Procedure::shade_parts, 2, "Form refracted beam"},
    {Line::cut_refracted_beam, "cut_refracted_beam", Procedure::shade_parts, 2, "Cut it by outlines and shadows"},
    {Line::shade_refracted_parts, "shade_refracted_parts", Procedure::shade_parts, 2,
     "Shade parts (DEPTH+1, REFRSHADE)"},
    {Line::if_curved_or_glass, "if_curved_or_glass", Procedure::shade_parts, 1, "If curved mirror or glass"},
    {Line::form_middle_ray, "form_middle_ray", Procedure::shade_parts, 2, "Form ray from its middle"},
    {Line::follow_middle_ray, "follow_middle_ray", Procedure::shade_parts, 2, "Follow it as a ray"},
    {Line::add_part, "add_part", Procedure::shade_parts, 1, "Add shade, times coverage"},
}};

inline constexpr int cone_line_count = 18;
inline constexpr std::array<PseudocodeLine, cone_line_count> cone_pseudocode{{
    {Line::cone_for_each_pixel, "for_each_pixel", Procedure::cone_tracing, 0, "For each pixel"},
    {Line::form_cone, "form_cone", Procedure::cone_tracing, 1, "Form cone of the pixel"},
    {Line::find_cover, "find_cover", Procedure::cone_tracing, 1, "Find what covers it, and how much"},
    {Line::shade_cone, "shade_cone", Procedure::cone_tracing, 1, "Shade cone (DEPTH+1, final)"},
    {Line::cone_put_final_shade, "put_final_shade", Procedure::cone_tracing, 1, "Put final shade in pixel"},
    {Line::cone_for_each_part, "for_each_cover", Procedure::shade_cone, 0, "For each part, front to back"},
    {Line::form_shadow_cone, "form_shadow_cone", Procedure::shade_cone, 1, "Form shadow cone"},
    {Line::find_uncovered, "find_uncovered", Procedure::shade_cone, 1, "Find how much is uncovered"},
    {Line::cone_shade_middle, "shade_middle", Procedure::shade_cone, 1, "Shade its middle"},
    {Line::cone_if_reflective, "if_reflective", Procedure::shade_cone, 1, "If reflective"},
    {Line::form_reflected_cone, "form_reflected_cone", Procedure::shade_cone, 2, "Form reflected cone"},
    {Line::find_reflected_cover, "find_reflected_cover", Procedure::shade_cone, 2, "Find what covers it"},
    {Line::shade_reflected_cone, "shade_reflected_cone", Procedure::shade_cone, 2, "Shade cone (DEPTH+1, REFLSHADE)"},
    {Line::cone_if_transparent, "if_transparent", Procedure::shade_cone, 1, "If transparent"},
    {Line::form_refracted_cone, "form_refracted_cone", Procedure::shade_cone, 2, "Form refracted cone"},
    {Line::find_refracted_cover, "find_refracted_cover", Procedure::shade_cone, 2, "Find what covers it"},
    {Line::shade_refracted_cone, "shade_refracted_cone", Procedure::shade_cone, 2, "Shade cone (DEPTH+1, REFRSHADE)"},
    {Line::add_share, "add_share", Procedure::shade_cone, 1, "Add shade, times its share"},
}};

inline constexpr int pencil_line_count = 20;
inline constexpr std::array<PseudocodeLine, pencil_line_count> pencil_pseudocode{{
    {Line::pencil_for_each_pixel, "for_each_pixel", Procedure::pencil_tracing, 0, "For each pixel"},
    {Line::form_pencil, "form_pencil", Procedure::pencil_tracing, 1, "Form pencil of the pixel: M = 1"},
    {Line::find_axis_intersection, "find_axis", Procedure::pencil_tracing, 1, "Find intersection of its axis"},
    {Line::pencil_if_intersect_something, "if_intersect_something", Procedure::pencil_tracing, 1,
     "If intersect something"},
    {Line::shade_pencil, "shade_pencil", Procedure::pencil_tracing, 2, "Shade pencil (DEPTH+1, final)"},
    {Line::pencil_put_final_shade, "put_final_shade", Procedure::pencil_tracing, 1, "Put final shade in pixel"},
    {Line::transfer_pencil, "transfer_pencil", Procedure::shade_pencil, 0, "Transfer: M = T M"},
    {Line::pencil_form_shadow_ray, "form_shadow_ray", Procedure::shade_pencil, 0, "Form shadow ray"},
    {Line::pencil_find_intersection, "find_intersection", Procedure::shade_pencil, 0, "Find intersection"},
    {Line::pencil_if_reflective, "if_reflective", Procedure::shade_pencil, 0, "If reflective"},
    {Line::form_reflected_axis, "form_reflected_axis", Procedure::shade_pencil, 1, "Form reflected axis"},
    {Line::reflect_pencil, "reflect_pencil", Procedure::shade_pencil, 1, "Reflect: M = R M"},
    {Line::find_reflected_axis_intersect, "find_axis", Procedure::shade_pencil, 1, "Find intersection of its axis"},
    {Line::shade_reflected_pencil, "shade_reflected_pencil", Procedure::shade_pencil, 1,
     "Shade pencil (DEPTH+1, REFLSHADE)"},
    {Line::pencil_if_transparent, "if_transparent", Procedure::shade_pencil, 0, "If transparent"},
    {Line::form_refracted_axis, "form_refracted_axis", Procedure::shade_pencil, 1, "Form refracted axis"},
    {Line::refract_pencil, "refract_pencil", Procedure::shade_pencil, 1, "Refract: M = S M"},
    {Line::find_refracted_axis_intersect, "find_axis", Procedure::shade_pencil, 1, "Find intersection of its axis"},
    {Line::shade_refracted_pencil, "shade_refracted_pencil", Procedure::shade_pencil, 1,
     "Shade pencil (DEPTH+1, REFRSHADE)"},
    {Line::pencil_compute_rtnshade, "compute_rtnshade", Procedure::shade_pencil, 0, "Compute rtnshade"},
}};
/// Lines of the tracer, and those of pencil tracing that do the same with a pencil's axis.
inline constexpr std::pair<Line, Line> lines_with_pencils[] = {
    {Line::for_each_pixel, Line::pencil_for_each_pixel},
    {Line::form_primary_ray, Line::form_pencil},
    {Line::find_closest_intersection, Line::find_axis_intersection},
    {Line::if_intersect_something, Line::pencil_if_intersect_something},
    {Line::shade_final, Line::shade_pencil},
    {Line::put_final_shade, Line::pencil_put_final_shade},
    {Line::form_shadow_ray, Line::pencil_form_shadow_ray},
    {Line::find_intersection, Line::pencil_find_intersection},
    {Line::if_reflective, Line::pencil_if_reflective},
    {Line::form_reflect_ray, Line::form_reflected_axis},
    {Line::find_reflect_intersect, Line::find_reflected_axis_intersect},
    {Line::shade_reflect, Line::shade_reflected_pencil},
    {Line::if_transparent, Line::pencil_if_transparent},
    {Line::form_refract_ray, Line::form_refracted_axis},
    {Line::find_refract_intersect, Line::find_refracted_axis_intersect},
    {Line::shade_refract, Line::shade_refracted_pencil},
    {Line::compute_rtnshade, Line::pencil_compute_rtnshade}};
/// The one of pencil tracing that does what the tracer's does.
[[nodiscard]] constexpr Line with_pencil(Line line) {
  for (const auto& [of_tracer, of_pencils] : lines_with_pencils)
    if (line == of_tracer) return of_pencils;
  return line;
}
/// The tracer's that one of pencil tracing does; other lines stay.
[[nodiscard]] constexpr Line without_pencil(Line line) {
  for (const auto& [of_tracer, of_pencils] : lines_with_pencils)
    if (line == of_pencils) return of_tracer;
  return line;
}

/// The lines of several procedures: of the one that runs once for each pixel, and of those that it calls.
struct Pseudocode {
  std::span<const PseudocodeLine> lines;
  bool recursive;         ///< the second one calls itself, DEPTH deep
  Integrator integrator;  ///< whose it is; `automatic`: the tracer's
};
/// All pseudocodes, in the order of their lines.
inline constexpr std::array<Pseudocode, 7> pseudocodes{{{pseudocode, true, Integrator::automatic},
                                                        {path_pseudocode, false, Integrator::path},
                                                        {photon_pseudocode, false, Integrator::photons},
                                                        {radiosity_pseudocode, false, Integrator::radiosity},
                                                        {beam_pseudocode, true, Integrator::beams},
                                                        {cone_pseudocode, true, Integrator::cones},
                                                        {pencil_pseudocode, true, Integrator::pencils}}};
inline constexpr int all_lines_count = static_cast<int>(pseudocodes.back().lines.back().line) + 1;

/// The one that a line belongs to.
[[nodiscard]] constexpr const Pseudocode& pseudocode_with(Line line) {
  for (const Pseudocode& each : pseudocodes)
    if (line <= each.lines.back().line) return each;
  return pseudocodes.back();
}
[[nodiscard]] constexpr const PseudocodeLine& pseudocode_of(Line line) {
  const Pseudocode& code = pseudocode_with(line);
  return code.lines[static_cast<std::size_t>(line) - static_cast<std::size_t>(code.lines.front().line)];
}

/// Whether a line of beam tracing is of the plan only: beams of the picture follow all glass by rays.
[[nodiscard]] constexpr bool is_of_plan(Line line) {
  return line >= Line::if_flat_glass && line <= Line::shade_refracted_parts;
}

/// Of the translation of its title: the text "procedure.ID".
[[nodiscard]] constexpr std::string_view procedure_id(Procedure procedure) {
  switch (procedure) {
    case Procedure::main_algorithm:
      return "main_algorithm";
    case Procedure::shade:
      return "shade";
    case Procedure::path_tracing:
      return "path_tracing";
    case Procedure::follow_path:
      return "follow_path";
    case Procedure::photon_mapping:
      return "photon_mapping";
    case Procedure::follow_photon:
      return "follow_photon";
    case Procedure::gather_light:
      return "gather_light";
    case Procedure::radiosity:
      return "radiosity";
    case Procedure::shoot_light:
      return "shoot_light";
    case Procedure::beam_tracing:
      return "beam_tracing";
    case Procedure::shade_parts:
      return "shade_parts";
    case Procedure::cone_tracing:
      return "cone_tracing";
    case Procedure::shade_cone:
      return "shade_cone";
    case Procedure::pencil_tracing:
      return "pencil_tracing";
    case Procedure::shade_pencil:
      return "shade_pencil";
  }
  return "";
}

}  // namespace raywalk
