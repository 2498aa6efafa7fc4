#pragma once
// Rays of a recording, retraced: a recording keeps the points that they leave, but not the primitives.

#include "timeline/timeline.h"
#include "trace/ray_generator.h"
#include "trace/spawn_ray.h"
#include "trace/statistics.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace raywalk {

/// A ray in robust and in naive numerics.
template <class T>
struct RayTwins {
  Ray<T> robust;
  NaiveRay<T> naive;
};

/// The generator of the primary rays of a recording of this scene.
template <class T>
[[nodiscard]] RayGenerator<T> camera_of(const Scene& scene, const Timeline& recorded) {
  const int samples = recorded.pixels().empty() ? 1 : recorded.pixels().back().sample + 1;
  return RayGenerator<T>(scene, recorded.image(), recorded.of_strip() ? scene.image : recorded.image(), {samples});
}

/// A hit, and its surface point.
template <class T>
struct SurfaceHit {
  Hit<T> hit;
  SurfacePoint<T> point;
};
template <class T, class AnyRay>
[[nodiscard]] std::optional<SurfaceHit<T>> find_surface(const World<T>& world, const AnyRay& ray) {
  TestCounts uncounted;
  const auto hit = world.accelerator.closest(ray, infinity<T>, uncounted);
  if (!hit) return std::nullopt;
  return SurfaceHit<T>{
      *hit, world.accelerator.primitives().surface_at(hit->primitive, ray, Intersection<T>{hit->t, hit->part})};
}

/// The numbers of the rays that led from EYE to a ray, first ray first, and its own.
[[nodiscard]] inline std::vector<int> way_of(const Timeline& timeline, int ray) {
  std::vector<int> way;
  for (int each = ray; each >= 0; each = timeline.rays()[static_cast<std::size_t>(each)].parent) way.push_back(each);
  std::reverse(way.begin(), way.end());
  return way;
}

/// Ray number `ray` of the recording, retraced from the eye through its ancestors; none if one of them misses, is a
/// beam or a cone, began at a light as a photon does, or was scattered inside a body.
template <class T>
[[nodiscard]] std::optional<RayTwins<T>> retraced_ray(const World<T>& world, const RayGenerator<T>& camera,
                                                      const Timeline& timeline, int ray) {
  const auto record = [&](int number) -> const RayRecord& { return timeline.rays()[static_cast<std::size_t>(number)]; };
  if (timeline.has_width()) return std::nullopt;
  const std::vector<int> way = way_of(timeline, ray);
  if (record(way.front()).kind != RayKind::primary) return std::nullopt;
  const PixelRecord& pixel = timeline.pixels()[static_cast<std::size_t>(record(ray).pixel)];
  Statistics uncounted;
  const Ray<T> primary = camera.primary_ray({pixel.column, pixel.row, pixel.sample}, uncounted);
  const bool is_naive = world.numerics == Numerics::naive;
  RayTwins<T> twins{primary, NaiveRay<T>(primary)};
  for (std::size_t i = 1; i < way.size(); ++i) {
    if (record(way[i - 1]).ending == Ending::scattered) return std::nullopt;
    const auto found = is_naive ? find_surface(world, twins.naive) : find_surface(world, twins.robust);
    if (!found) return std::nullopt;
    const Vec3<T> direction(record(way[i]).direction);
    if (is_naive) {
      const Ray<T> formed{Vec3<T>(record(way[i]).origin), direction, {}, primary.time};
      twins = {formed, NaiveRay<T>(formed)};
      continue;
    }
    const Departure from{found->hit.primitive, found->hit.part};
    const auto& [position, normal] = found->point;
    twins = {spawn_ray<Ray<T>>(world, position, normal, from, direction, primary.time),
             spawn_ray<NaiveRay<T>>(world, position, normal, from, direction, primary.time)};
  }
  return twins;
}

}  // namespace raywalk
