#include "trace/bsdf.h"
#include "view/plan/painter.h"
#include "view/plan/plan_view.h"
#include "view/state.h"
#include "view/text/text.h"
#include "view/walk/walk.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace raywalk {

namespace {

/// The ray at whose hit the walk is: the current one, or the one that it was formed by. Null where there is none.
const RayRecord* ray_at_hit(const State& state) {
  const Timeline& timeline = *state.walk.timeline;
  const int position = state.walk.position;
  for (int i = timeline.current_ray(position); i >= 0;) {
    const RayRecord& ray = timeline.rays()[static_cast<std::size_t>(i)];
    if (ray.formed && ray.kind != RayKind::shadow && ray.object >= 0 && ray.found_at <= position) return &ray;
    i = ray.parent;
  }
  return nullptr;
}

/// How the surface there scatters.
Bsdf<double> bsdf_at(const RayRecord& ray, const Material& material, const Microsurface<double>& mirrors) {
  Bsdf<double> bsdf;
  bsdf.incident = normalize(ray.direction);
  bsdf.shading_normal = dot(ray.normal, ray.direction) > 0 ? -ray.normal : ray.normal;
  bsdf.geometric_normal = bsdf.shading_normal;
  bsdf.diffuse = material.diffuse;
  bsdf.shininess = material.shininess;
  bsdf.highlight = highlight_scale(material.shininess) * material.specular;
  bsdf.mirror = material.reflection;
  bsdf.facets = &mirrors;
  bsdf.prepare(Rgbd(1.0));
  return bsdf;
}

/// Directions of the half plane in which the normal is, closest together about the mirrored ray, by the tangent of
/// the angle to the normal's half vector. `normal`, `mirrored`: angles in the plan.
std::vector<double> angles(double normal, double mirrored, double roughness) {
  constexpr int even = 90, about_the_peak = 60;
  constexpr double quarter = pi_v<double> / 2;
  std::vector<double> all;
  for (int i = 0; i <= even; ++i) all.push_back(normal + quarter * (2.0 * i / even - 1));
  for (int i = 0; i <= about_the_peak; ++i) {
    const double slope = 6 * roughness * (2.0 * i / about_the_peak - 1);
    all.push_back(mirrored + 2 * std::atan(slope));
  }
  all.erase(std::remove_if(all.begin(), all.end(), [&](double at) { return std::abs(at - normal) > quarter; }),
            all.end());
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

void LobeRoom::draw_in_plan(Painter& painter) {
  const State& state = painter.state;
  if (state.walk.mode == Mode::move) return;
  const RayRecord* ray = ray_at_hit(state);
  if (ray == nullptr) return;
  const Material& material = state.scene().objects[static_cast<std::size_t>(ray->object)].material;
  if (!material.is_rough()) return;
  const auto walked = walked_scene(state);
  if (!effects_of(*walked, walked->render.samples).used(Effect::microfacets)) return;
  const Microsurface<double> microsurface(material);
  const Bsdf<double> bsdf = bsdf_at(*ray, material, microsurface);
  const Vec3d& normal = bsdf.shading_normal;
  const Vec3d mirrored = reflect(bsdf.incident, normal);
  constexpr double upright = 0.2;  // what lies nearly in the plan's plane is hardly cut by it
  if (std::hypot(normal.x, normal.y) < upright) return;
  const double middle = std::atan2(normal.y, normal.x);
  const double peak = middle + std::remainder(std::atan2(mirrored.y, mirrored.x) - middle, 2 * pi_v<double>);
  struct Sent {
    Vec2d along;
    double much;
  };
  std::vector<Sent> curve;
  Sent most{Vec2d(0.0), 0};
  for (const double angle : angles(middle, peak, material.roughness)) {
    const Vec2d along(std::cos(angle), std::sin(angle));
    curve.push_back({along, max_component(bsdf.evaluate(Vec3d(along, 0)).value)});
    if (curve.back().much > most.much) most = curve.back();
  }
  if (!(most.much > 0)) return;
  const Vec2d hit = painter.pixels(Vec2d(ray->end.x, ray->end.y));
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
  // Without random numbers a mirror sends on one ray only: the lobe is that of the highlights.
  const bool is_sampled = draws_random(integrator_of(*walked, walked->render.samples));
  for (const std::string_view id : {is_sampled ? "plan.lobe" : "plan.lobe_highlight", "plan.lobe_short"})
    if (painter.note_beside(place(most), out, std::string(text(id, state.appearance.language)), {}, box)) break;
}

}  // namespace raywalk
