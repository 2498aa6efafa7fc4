#include "view/walk/lit.h"

namespace raywalk {

bool concerns(Line own, RayKind kind) {
  const Line line = without_pencil(own);
  switch (kind) {
    case RayKind::primary:
      return line == Line::form_primary_ray || line == Line::find_closest_intersection || line == Line::shade_final ||
             line == Line::path_form_primary_ray || line == Line::path_find_closest_intersection ||
             line == Line::follow_path || line == Line::photon_form_primary_ray || line == Line::gather_light ||
             line == Line::gather_find_closest_intersection || line == Line::radiosity_form_primary_ray ||
             line == Line::radiosity_find_closest_intersection;
    case RayKind::shadow:
      return line == Line::form_shadow_ray || line == Line::find_intersection || line == Line::path_form_shadow_ray ||
             line == Line::path_find_intersection || line == Line::gather_form_shadow_ray ||
             line == Line::gather_find_intersection || line == Line::beam_form_shadow_ray ||
             line == Line::beam_find_intersection || line == Line::form_shadow_cone || line == Line::find_uncovered;
    case RayKind::reflect:
      return line == Line::form_reflect_ray || line == Line::find_reflect_intersect || line == Line::shade_reflect ||
             line == Line::reflect_pencil || line == Line::form_next_ray ||
             line == Line::path_find_closest_intersection || line == Line::gather_form_next_ray ||
             line == Line::gather_find_closest_intersection || line == Line::form_middle_ray ||
             line == Line::follow_middle_ray;
    case RayKind::refract:
      return line == Line::form_refract_ray || line == Line::find_refract_intersect || line == Line::shade_refract ||
             line == Line::refract_pencil || line == Line::form_next_ray ||
             line == Line::path_find_closest_intersection || line == Line::gather_form_next_ray ||
             line == Line::gather_find_closest_intersection || line == Line::form_middle_ray ||
             line == Line::follow_middle_ray;
    case RayKind::photon:
      return line == Line::emit_photon || line == Line::photon_find_closest_intersection ||
             line == Line::follow_photon || line == Line::photon_form_next_ray;
    case RayKind::beam:
      return line == Line::form_beam || line == Line::cut_beam || line == Line::shade_parts ||
             line == Line::form_mirrored_beam || line == Line::cut_mirrored_beam ||
             line == Line::shade_mirrored_parts || line == Line::form_refracted_beam ||
             line == Line::cut_refracted_beam || line == Line::shade_refracted_parts || line == Line::form_cone ||
             line == Line::find_cover || line == Line::shade_cone || line == Line::form_reflected_cone ||
             line == Line::find_reflected_cover || line == Line::shade_reflected_cone ||
             line == Line::form_refracted_cone || line == Line::find_refracted_cover ||
             line == Line::shade_refracted_cone;
  }
  return false;
}

bool is_lit(const State& state, int ray) {
  const Timeline& timeline = *state.walk.timeline;
  if (ray < 0 || ray >= static_cast<int>(timeline.rays_at(state.walk.position).size())) return false;
  if (ray == state.plan.hovered_ray) return true;
  const RayRecord& record = timeline.rays()[static_cast<std::size_t>(ray)];
  return state.plan.hovered_line && record.pixel == timeline.current_pixel(state.walk.position) &&
         concerns(*state.plan.hovered_line, record.kind);
}

}  // namespace raywalk
