// The rays that a bug changed, beside those walked.

#include "view/bugs/bug_panel.h"
#include "view/plan/painter.h"

namespace raywalk {

void BugRoom::draw_in_plan(Painter& painter) {
  for (const RayRecord& ray : other_rays(painter.state)) {
    const std::optional<RayWay> way = ray_way(painter, ray, true);
    if (!way) continue;
    const RayStyle& style = ray_style(painter.state.appearance.theme, ray.kind);
    // Wide dots: a shadow ray's short dashes must not look like them.
    const Stroke stroke{style.colour, 3 * painter.sizes.unit, painter.scaled({{3, 6, 0, 0}, 2})};
    painter.add_clipped({way->from, way->to, stroke, 7 * painter.sizes.unit, 0.7});
    if (ray.ending == Ending::blocked) draw_blocked(painter, way->to, way->along, stroke);
  }
}

}  // namespace raywalk
