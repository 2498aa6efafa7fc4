#include "scene/scene.h"

#include <cmath>

namespace raywalk {

namespace {

/// A sphere meets the plan with level normals only if its centre lies there.
std::string why_not_planar(const Sphere<double>& sphere) {
  const bool off_centre = sphere.centre.z != 0 && std::abs(sphere.centre.z) <= sphere.radius;
  return off_centre ? "is cut by z = 0, but not through its centre" : "";
}

/// A plane must stand upright, or lie level and off the plan.
std::string why_not_planar(const Plane<double>& plane) {
  if (plane.normal.z == 0) return "";
  const bool level = plane.normal.x == 0 && plane.normal.y == 0;
  if (!level) return "meets z = 0 aslant";
  return plane.point.z == 0 ? "lies in z = 0" : "";
}

/// A prism is centred on the plan and its sides are upright; its caps lie off it.
std::string why_not_planar(const Prism<double>& prism) { return prism.height > 0 ? "" : "is flat and lies in z = 0"; }

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
  for (const Object& object : scene.objects) {
    const std::string why = std::visit([](const auto& shape) { return why_not_planar(shape); }, object.shape);
    if (!why.empty()) return object.name + " " + why;
  }
  return {};
}

}  // namespace raywalk
