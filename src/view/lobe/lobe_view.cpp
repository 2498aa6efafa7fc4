#include "inspect/scattering.h"
#include "view/plan/painter.h"
#include "view/plan/plan_view.h"
#include "view/state.h"
#include "view/text/text.h"
#include "view/walk/fault.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

namespace raywalk {

namespace {

/// The ray at whose hit the walk is: the current one, or the one that it was formed by; -1 where there is none.
int ray_at_hit(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const int position = state.walk.position;
  for (int i = timeline.current_ray(position); i >= 0;) {
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(i)];
    if (ray.formed && ray.kind != RayKind::shadow && ray.object >= 0 && ray.found_at <= position) return i;
    i = ray.parent;
  }
  return -1;
}

/// Directions about the normal, up to `reach` on both sides, closest together about the peaks: where small facets send
/// light, by the tangent of the angle to the normal's half vector. `normal`, `peaks`: angles in the plan.
std::vector<double> angles(double normal, double reach, const std::vector<double>& peaks, double roughness) {
  constexpr int even = 90, about_the_peak = 60;
  std::vector<double> all;
  for (int i = 0; i <= even; ++i) all.push_back(normal + reach * (2.0 * i / even - 1));
  for (const double peak : peaks)
    for (int i = 0; i <= about_the_peak; ++i) {
      const double slope = 6 * roughness * (2.0 * i / about_the_peak - 1);
      all.push_back(peak + 2 * std::atan(slope));
    }
  all.erase(std::remove_if(all.begin(), all.end(), [&](double at) { return std::abs(at - normal) > reach; }),
            all.end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

void LobeRoom::follow(State& state, const Before& /*before*/) {
  LobeRoom& room = state.lobe;
  const std::shared_ptr<const Timeline>& timeline = state.walk.timeline;
  // While the scene is changed there are new rays all the time, and no lobes.
  const int at_hit = timeline == nullptr || state.walk.mode == Mode::move ? -1 : ray_at_hit(state);
  const bool is_known = room.of == timeline && room.ray == at_hit;
  room.of = timeline, room.position = state.walk.position, room.ray = at_hit;
  if (is_known) return;
  room.seen.reset(), room.world.reset();
  if (room.ray < 0) return;
  const RayRecord& ray = timeline->rays()[static_cast<std::size_t>(room.ray)];
  const Material& material = state.scene().objects[static_cast<std::size_t>(ray.object)].material;
  if (!material.is_rough() && !material.is_rough_diffuse() && !material.is_mapped()) return;
  const auto walked = walked_scene(state);
  if (!effects_of(*walked, walked->render.samples).used(Effect::microfacets)) return;
  const auto world = state.document.worlds->of<double>(*walked, AcceleratorKind::automatic, fault_at_work(state));
  const auto found = scattering_at(*world, *walked, *timeline, room.ray);
  if (!found || (!found->bsdf.by_facets() && found->bsdf.matt == nullptr)) return;
  room.world = world;
  room.seen = std::make_shared<const Scattering>(*found);
}

void LobeRoom::draw_in_plan(Painter& painter) {
  const State& state = painter.state;
  const LobeRoom& room = state.lobe;
  if (room.seen == nullptr || room.of != state.walk.timeline || room.position != state.walk.position) return;
  const RayRecord& ray = room.of->rays()[static_cast<std::size_t>(room.ray)];
  const auto walked = walked_scene(state);
  const Bsdf<double>& bsdf = room.seen->bsdf;
  const Vec3d& normal = bsdf.shading_normal;
  constexpr double upright = 0.2;  // what lies nearly in the plan's plane is hardly cut by it
  if (std::hypot(normal.x, normal.y) < upright) return;
  const double middle = std::atan2(normal.y, normal.x);
  // Without random numbers glass sends on one ray each way only: the lobe is that of the lights' highlights.
  const bool is_sampled = draws_random(integrator_of(*walked, walked->render.samples));
  constexpr double half_turn = pi_v<double>;
  std::vector<double> peaks;
  const auto add_peak = [&](const Vec3d& at) {
    peaks.push_back(middle + std::remainder(std::atan2(at.y, at.x) - middle, 2 * half_turn));
  };
  if (bsdf.by_facets()) add_peak(reflect(bsdf.incident, normal));
  if (room.seen->refracted) add_peak(*room.seen->refracted);
  struct Sent {
    Vec2d along;
    double much;
  };
  std::vector<Sent> curve;
  Sent most{Vec2d(0.0), 0};
  const double reach_of_turn = bsdf.glass != nullptr && is_sampled ? half_turn : half_turn / 2;
  for (const double angle : angles(middle, reach_of_turn, peaks, room.seen->roughness)) {
    const Vec2d along(std::cos(angle), std::sin(angle));
    curve.push_back({along, max_component(bsdf.evaluate(Vec3d(along, 0)).value)});
    if (curve.back().much > most.much) most = curve.back();
  }
  if (!(most.much > 0)) return;
  const Vec2d hit = painter.pixels(Vec2d(ray.end.x, ray.end.y));
  // Within the ring or the pane, and small rather than cut.
  constexpr double of_the_room = 0.8, least = 12;
  double reach = 70 * painter.sizes.unit;
  for (const Sent& one : curve)
    reach = std::min(reach, of_the_room * painter.room_along(hit, Vec2d(one.along.x, -one.along.y)) * most.much /
                                std::max(one.much, 1e-9 * most.much));
  if (reach < least * painter.sizes.unit) return;
  const auto place = [&](const Sent& one) {
    const double far = one.much / most.much * reach;
    return Vec2d(hit.x + far * one.along.x, hit.y - far * one.along.y);
  };
  PolygonItem shape{{hit}, painter.colours.normal.with_alpha(48), painter.stroke(painter.colours.normal, 1.3)};
  PixelRect box{hit, hit};
  for (const Sent& one : curve) {
    const Vec2d at = place(one);
    shape.points.push_back(at);
    box = {{std::min(box.min.x, at.x), std::min(box.min.y, at.y)},
           {std::max(box.max.x, at.x), std::max(box.max.y, at.y)}};
  }
  painter.add(std::move(shape));
  painter.kept_free.push_back(box);
  const Vec2d out(most.along.x, -most.along.y);
  for (const std::string_view id : {is_sampled ? "plan.lobe" : "plan.lobe_highlight", "plan.lobe_short"})
    if (painter.note_beside(place(most), out, std::string(text(id, state.appearance.language)), box)) break;
}

}  // namespace raywalk
