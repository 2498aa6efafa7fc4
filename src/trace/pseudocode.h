#pragma once

#include <array>
#include <string_view>

namespace raywalk {

enum class Procedure { main_algorithm, shade };

/// The lines of the two procedures, in the order in which they stand on the screen. Each text is also the comment that
/// heads its statement in trace/tracer.h; a test holds the two together.
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
};

struct PseudocodeLine {
  Line line;
  Procedure procedure;
  int indent;
  std::string_view text;
};

inline constexpr int line_count = 17;
inline constexpr std::array<PseudocodeLine, line_count> pseudocode{{
    {Line::for_each_pixel, Procedure::main_algorithm, 0, "For each pixel"},
    {Line::form_primary_ray, Procedure::main_algorithm, 1, "Form primary ray"},
    {Line::find_closest_intersection, Procedure::main_algorithm, 1, "Find closest intersection"},
    {Line::if_intersect_something, Procedure::main_algorithm, 1, "If intersect something"},
    {Line::shade_final, Procedure::main_algorithm, 2, "Shade (DEPTH+1, final)"},
    {Line::put_final_shade, Procedure::main_algorithm, 1, "Put final shade in pixel"},
    {Line::form_shadow_ray, Procedure::shade, 0, "Form shadow ray"},
    {Line::find_intersection, Procedure::shade, 0, "Find intersection"},
    {Line::if_reflective, Procedure::shade, 0, "If reflective"},
    {Line::form_reflect_ray, Procedure::shade, 1, "Form reflect ray"},
    {Line::find_reflect_intersect, Procedure::shade, 1, "Find closest intersect"},
    {Line::shade_reflect, Procedure::shade, 1, "Shade (DEPTH+1, REFLSHADE)"},
    {Line::if_transparent, Procedure::shade, 0, "If transparent"},
    {Line::form_refract_ray, Procedure::shade, 1, "Form refract ray"},
    {Line::find_refract_intersect, Procedure::shade, 1, "Find closest intersect"},
    {Line::shade_refract, Procedure::shade, 1, "Shade (DEPTH+1, REFRSHADE)"},
    {Line::compute_rtnshade, Procedure::shade, 0, "Compute rtnshade"},
}};

[[nodiscard]] constexpr const PseudocodeLine& pseudocode_of(Line line) {
  return pseudocode[static_cast<std::size_t>(line)];
}

[[nodiscard]] constexpr std::string_view procedure_title(Procedure procedure) {
  switch (procedure) {
    case Procedure::main_algorithm:
      return "MAIN ALGORITHM";
    case Procedure::shade:
      return "SHADE (DEPTH, RTNSHADE)";
  }
  return "";
}

}  // namespace raywalk
