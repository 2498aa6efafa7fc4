#include "inspect/scattering.h"

#include "inspect/retraced_ray.h"
#include "trace/pattern_filter.h"

#include <vector>

namespace raywalk {

namespace {

using Vertex = SurfaceVertex<double>;

/// A ray on the way from EYE, as `prepare_vertex` takes it.
struct WayRay {
  Ray<double> ray;
  const World<double>::Medium* medium = nullptr;
  int number = 0, length = 1;
  Rgbd throughput{1.0};
};

/// Where no direction is drawn, facets are left out of what is prepared: lights have highlights by them all the same.
void take_undrawn_facets(Vertex& at, const World<double>& world) {
  if (const SurfaceMaps<double>* maps = world.maps(*at.surface); maps != nullptr) return take_facets(at, true, *maps);
  const auto& material = at.values();
  if (at.surface->transmits)
    if (const auto* glass = world.rough_dielectric(*at.surface, at.refraction.n1, at.refraction.n2))
      at.bsdf.take_glass(*glass, at.refraction.n1, at.refraction.cos_in, material.reflection + material.transmission);
  if (const auto* own = world.microsurface(*at.surface); own != nullptr && own->facets) {
    at.bsdf.facets = own;
    at.bsdf.mirror = material.reflection;
  }
}

}  // namespace

std::optional<Scattering> scattering_at(const World<double>& world, const Scene& scene, const Timeline& timeline,
                                        int ray) {
  const auto record = [&](int number) -> const RayRecord& { return timeline.rays()[static_cast<std::size_t>(number)]; };
  if (timeline.has_width()) return std::nullopt;
  const std::vector<int> way = way_of(timeline, ray);
  if (record(way.front()).kind != RayKind::primary) return std::nullopt;
  const RayGenerator<double> camera = camera_of<double>(scene, timeline);
  const PixelRecord& pixel = timeline.pixels()[static_cast<std::size_t>(record(ray).pixel)];
  Statistics uncounted;
  NestedMedia<double> nested(world);
  NoDifferential<double> none;
  WayRay next{camera.primary_ray({pixel.column, pixel.row, pixel.sample}, uncounted)};
  next.ray.direction = normalize(record(way.front()).direction);
  if (nested.any_around_eye()) next.medium = nested.at_eye(next.ray, uncounted.tests);
  for (std::size_t i = 0; i < way.size(); ++i) {
    if (record(way[i]).ending == Ending::scattered) return std::nullopt;
    const auto hit = world.accelerator.closest(next.ray, infinity<double>, uncounted.tests);
    if (!hit || world.object(hit->primitive) != record(way[i]).object) return std::nullopt;
    Vertex at = prepare_vertex<Policy<double>>(world, nested, next, *hit, uncounted, none);
    if (i + 1 == way.size()) {
      if (!world.draws) take_undrawn_facets(at, world);
      const Material& material = scene.objects[static_cast<std::size_t>(record(ray).object)].material;
      Scattering found{at.bsdf, at.mapped ? at.mapped->roughness : material.roughness, std::nullopt};
      if (at.bsdf.glass != nullptr) found.refracted = refract(at.bsdf.incident, at.bsdf.shading_normal, at.refraction);
      found.bsdf.prepare(Rgbd(1.0));
      return found;
    }
    const RayRecord& further = record(way[i + 1]);
    next.medium = further.kind == RayKind::refract ? at.behind : at.medium;
    next.ray = spawn_ray<Ray<double>>(world, at.position, at.outward_normal, at.departure, normalize(further.direction),
                                      next.ray.time);
  }
  return std::nullopt;
}

}  // namespace raywalk
