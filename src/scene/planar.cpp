#include "scene/scene.h"

#include <cmath>

namespace raywalk {

namespace {

/// A sphere meets the plan with level normals only if its centre lies there.
bool is_planar(const Sphere<double>& sphere) {
  return sphere.centre.z == 0 || std::abs(sphere.centre.z) > sphere.radius;
}

/// A plane must stand upright, or lie level and off the plan.
bool is_planar(const Plane<double>& plane) {
  const bool level = plane.normal.x == 0 && plane.normal.y == 0;
  return plane.normal.z == 0 || (level && plane.point.z != 0);
}

/// A prism is centred on the plan and its sides are upright; its caps lie off it.
bool is_planar(const Prism<double>& prism) { return prism.height > 0; }

}  // namespace

std::string why_not_planar(const Scene& scene) {
  if (scene.camera.eye.z != 0) return "the eye does not lie in z = 0";
  if (scene.camera.look_at.z != 0) return "the camera does not look along z = 0";
  if (scene.camera.up.x != 0 || scene.camera.up.y != 0 || !(scene.camera.up.z > 0)) return "up is not +z";
  for (const Light& light : scene.lights) {
    if (const auto* point = std::get_if<PointLight>(&light.kind); point && point->position.z != 0)
      return light.name + " does not lie in z = 0";
    if (const auto* sun = std::get_if<DirectionalLight>(&light.kind); sun && sun->direction.z != 0)
      return light.name + " does not shine along z = 0";
  }
  for (const Object& object : scene.objects)
    if (!std::visit([](const auto& shape) { return is_planar(shape); }, object.shape))
      return object.name + " meets z = 0 with a slanted surface";
  return {};
}

}  // namespace raywalk
