// Draws the rays that depth and threshold cut off.

#include "view/plan/painter.h"
#include "view/text/text.h"
#include "view/walk/ghosts.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace raywalk {

void draw_ghosts(Painter& painter) {
  const State& state = painter.state;
  if (!state.walk.ghosts) return;
  const double unit = painter.sizes.unit;
  const auto& rays = state.walk.timeline->rays();
  Rgbd cut_off{0.0};
  for (const GhostRay& ghost : state.walk.ghosts->rays) {
    // A ghost appears with its stub.
    if (ghost.stub >= static_cast<int>(rays.size()) ||
        rays[static_cast<std::size_t>(ghost.stub)].formed_at > state.walk.position || !ghost.record.formed)
      continue;
    const RayRecord& ray = ghost.record;
    const std::optional<RayWay> way = ray_way(painter, ray, true);
    if (!way) continue;
    const auto& [from, to, along, open] = *way;
    // Dotted, in the kind's colour: formed rays are never dotted.
    const bool light = ray.kind == RayKind::shadow;
    const DashPattern dots{{1.5 * unit, 5 * unit}, 2};
    Stroke stroke{ray_style(state.appearance.theme, ray.kind).colour.with_alpha(light ? 110 : 235),
                  (light ? 1.2 : 2.2) * unit, dots};
    painter.add_clipped({from, to, stroke, light ? 0 : 8 * unit, 0.55});
    if (ghost.record.parent >= 0 || light) continue;
    cut_off += ghost.contribution;
    const Vec2d across(-along.y, along.x);
    std::vector<Vec2d> places;
    for (const double part : {0.5, 0.35, 0.65, 0.2, 0.8})
      for (const double side : {14.0, -14.0})
        places.push_back(painter.seen_middle(from + std::max(2 * part - 1, 0.0) * (to - from),
                                             to + std::min(2 * part - 1, 0.0) * (to - from)) +
                         side * unit * across);
    painter.note(places, percent_text(share_of(ghost.contribution, *state.walk.ghosts), state.appearance.language));
  }
  if (state.walk.ghosts->pixel < 0) return;
  const std::string total =
      fill("ghosts.total", state.appearance.language,
           {{"percent", percent_text(share_of(cut_off, *state.walk.ghosts), state.appearance.language)}});
  const double low = painter.viewport.height - 1.2 * painter.sizes.text;
  painter.note(std::vector<Vec2d>{{painter.viewport.width / 2, low},
                                  {painter.viewport.width * 0.35, low},
                                  {painter.viewport.width * 0.65, low},
                                  {painter.viewport.width / 2, 1.2 * painter.sizes.text}},
               state.walk.ghosts->rays.empty() ? std::string(text("ghosts.none", state.appearance.language)) : total);
}

}  // namespace raywalk
