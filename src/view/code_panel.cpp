#include "view/panels.h"

namespace raywalk {

namespace {

CodeRow row_of(const State& state, const PseudocodeLine& line) {
  CodeRow row{line.line, line.indent, std::string(line.text)};
  const Event* just_run = state.timeline->just_run(state.position);
  const Event* next = state.timeline->next(state.position);
  row.just_run = just_run != nullptr && just_run->line == line.line;
  row.next = next != nullptr && next->line == line.line;
  row.hovered = state.hovered_line == line.line;
  if (state.hovered_ray >= 0)
    row.hovered =
        row.hovered || concerns(line.line, state.timeline->rays()[static_cast<std::size_t>(state.hovered_ray)].kind);
  return row;
}

}  // namespace

/// The lines that form a ray, find its end and shade it.
bool concerns(Line line, RayKind kind) {
  switch (kind) {
    case RayKind::primary:
      return line == Line::form_primary_ray || line == Line::find_closest_intersection || line == Line::shade_final;
    case RayKind::shadow:
      return line == Line::form_shadow_ray || line == Line::find_intersection;
    case RayKind::reflect:
      return line == Line::form_reflect_ray || line == Line::find_reflect_intersect || line == Line::shade_reflect;
    case RayKind::refract:
      return line == Line::form_refract_ray || line == Line::find_refract_intersect || line == Line::shade_refract;
  }
  return false;
}

bool is_lit(const State& state, int ray) {
  const Timeline& timeline = *state.timeline;
  if (ray < 0 || ray >= static_cast<int>(timeline.rays_at(state.position).size())) return false;
  if (ray == state.hovered_ray) return true;
  const RayRecord& record = timeline.rays()[static_cast<std::size_t>(ray)];
  return state.hovered_line && record.pixel == timeline.current_pixel(state.position) &&
         concerns(*state.hovered_line, record.kind);
}

CodePanel code_panel(const State& state) {
  CodePanel panel;
  const Event* just_run = state.timeline->just_run(state.position);
  for (const Procedure procedure : {Procedure::main_algorithm, Procedure::shade}) {
    CodeBox& box = panel.boxes[static_cast<std::size_t>(procedure)];
    box.procedure = procedure;
    box.title = procedure_title(procedure);
    if (just_run != nullptr && pseudocode_of(just_run->line).procedure == procedure) box.depth = just_run->depth;
    for (const PseudocodeLine& line : pseudocode)
      if (line.procedure == procedure) box.rows.push_back(row_of(state, line));
  }
  return panel;
}

}  // namespace raywalk
