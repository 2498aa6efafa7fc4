#pragma once

#include <array>
#include <string_view>

namespace raywalk {

enum class PathProcedure { path_tracing, follow_path };

/// The lines of path tracing's two procedures, in their order. As with trace/pseudocode.h, each text is also the
/// comment that heads its statement, in trace/path.h, and a test holds the two together.
enum class PathLine {
  for_each_pixel,
  form_primary_ray,
  follow_path,
  put_final_shade,
  while_ray,
  find_closest_intersection,
  if_intersect_nothing,
  add_background,
  add_emission,
  form_shadow_ray,
  find_intersection,
  add_light,
  choose_direction,
  if_path_survives,
  form_next_ray,
};

struct PathPseudocodeLine {
  PathLine line;
  PathProcedure procedure;
  int indent;
  std::string_view text;
};

inline constexpr int path_line_count = 15;
inline constexpr std::array<PathPseudocodeLine, path_line_count> path_pseudocode{{
    {PathLine::for_each_pixel, PathProcedure::path_tracing, 0, "For each pixel"},
    {PathLine::form_primary_ray, PathProcedure::path_tracing, 1, "Form primary ray"},
    {PathLine::follow_path, PathProcedure::path_tracing, 1, "Follow path (final)"},
    {PathLine::put_final_shade, PathProcedure::path_tracing, 1, "Put final shade in pixel"},
    {PathLine::while_ray, PathProcedure::follow_path, 0, "While there is a ray"},
    {PathLine::find_closest_intersection, PathProcedure::follow_path, 1, "Find closest intersection"},
    {PathLine::if_intersect_nothing, PathProcedure::follow_path, 1, "If intersect nothing"},
    {PathLine::add_background, PathProcedure::follow_path, 2, "Add background and end"},
    {PathLine::add_emission, PathProcedure::follow_path, 1, "Add emission, weighted"},
    {PathLine::form_shadow_ray, PathProcedure::follow_path, 1, "Form shadow ray"},
    {PathLine::find_intersection, PathProcedure::follow_path, 1, "Find intersection"},
    {PathLine::add_light, PathProcedure::follow_path, 1, "Add light, weighted"},
    {PathLine::choose_direction, PathProcedure::follow_path, 1, "Choose direction"},
    {PathLine::if_path_survives, PathProcedure::follow_path, 1, "If path survives"},
    {PathLine::form_next_ray, PathProcedure::follow_path, 2, "Form next ray"},
}};

[[nodiscard]] constexpr const PathPseudocodeLine& pseudocode_of(PathLine line) {
  return path_pseudocode[static_cast<std::size_t>(line)];
}

[[nodiscard]] constexpr std::string_view procedure_title(PathProcedure procedure) {
  switch (procedure) {
    case PathProcedure::path_tracing:
      return "PATH TRACING";
    case PathProcedure::follow_path:
      return "FOLLOW PATH (RTNSHADE)";
  }
  return "";
}

}  // namespace raywalk
