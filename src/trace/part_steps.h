#pragma once
// What beams and cones do alike with a part, which is shaded in one place for all of it. Included by them alone.

#include "trace/event.h"
#include "trace/optics.h"
#include "trace/surface_vertex.h"
#include "trace/world.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace raywalk::detail {

/// By object: the first of its primitives; -1 for none.
template <class T>
[[nodiscard]] std::vector<int> first_primitives(const World<T>& world) {
  std::vector<int> first;
  const auto add = [&](int id) {
    const auto object = static_cast<std::size_t>(world.object(id));
    if (object >= first.size()) first.resize(object + 1, -1);
    if (first[object] < 0) first[object] = id;
  };
  if (world.leaves.empty())
    for (int id = 0; id < world.accelerator.primitives().size(); ++id) add(id);
  for (const auto& leaf : world.leaves)
    if (leaf.first < world.accelerator.primitives().size()) add(leaf.first);  // the last may be an empty mesh
  return first;
}

/// The ray in the middle of a part, as `prepare_vertex` takes it.
template <class T>
struct MiddleOfPart {
  Ray<T> ray;
  int number;
  const typename World<T>::Medium* medium;
  int length = 1;
  Rgb<T> throughput{1};
};

/// The limit that keeps what is as wide as a part, or a ray from its middle, from being followed.
template <class T>
[[nodiscard]] std::optional<Ending> why_not_followed(const World<T>& world, int depth, const Rgb<T>& throughput) {
  if (depth + 1 > world.depth) return Ending::depth;
  if (max_component(throughput) < world.threshold) return Ending::threshold;
  return std::nullopt;
}

template <class T>
struct PartLight {
  Rgb<T> diffuse{0}, specular{0};
};

/// What a light brings to the middle of a part, whose ray is `ray`. `to_light`: not of unit length; `arriving`: how
/// much of the light is not held up on its way.
template <class T, bool with_maps>
[[nodiscard]] PartLight<T> light_on(const SurfaceVertex<T, true, with_maps>& at, const Ray<T>& ray,
                                    const typename World<T>::Light& light, const Vec3<T>& to_light,
                                    const Rgb<T>& arriving) {
  const T distance = light.distance(to_light);
  const Vec3<T> l = to_light / distance, h = l - ray.direction;
  const Rgb<T> radiance = arriving * light.strength * (light.falloff(l) / light.attenuation(distance));
  const T cos = std::max(dot(at.bsdf.shading_normal, l), T(0));
  PartLight<T> brought{radiance * at.bsdf.diffuse * cos};
  if (at.bsdf.matt != nullptr) brought.diffuse = radiance * at.bsdf.diffuse_answer(l, cos);
  if (!is_black(at.specular))
    brought.specular =
        radiance * at.specular * power_of_cosine(dot(at.bsdf.shading_normal, h), dot(h, h), at.values().shininess);
  return brought;
}

/// Of a light as it is seen along `l`, of unit length: of a disc of its area, in a flat world half its width; 0 of a
/// point.
template <class T>
[[nodiscard]] double radius_of_light(const typename World<T>::Light& light, const Vec3d& l, bool flat) {
  if (const auto* sphere = std::get_if<SphereLight::Prepared<T>>(&light.kind))
    return static_cast<double>(sphere->radius);
  const auto* rectangle = std::get_if<RectangleLight::Prepared<T>>(&light.kind);
  if (rectangle == nullptr) return 0;
  const Vec3d u(rectangle->u), v(rectangle->v);
  if (flat) return (std::abs(cross(plan(u), plan(l))) + std::abs(cross(plan(v), plan(l)))) / 2;
  return std::sqrt(std::abs(dot(cross(u, v), l)) / std::numbers::pi);
}

}  // namespace raywalk::detail
