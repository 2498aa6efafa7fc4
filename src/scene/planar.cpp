#include "scene/scene.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace raywalk {

namespace {

/// A sphere crosses the plan with horizontal normals only if its centre lies in it.
std::string why_not_planar(const Sphere<double>& sphere) {
  const bool off_centre = sphere.centre.z != 0 && std::abs(sphere.centre.z) <= sphere.radius;
  return off_centre ? "is cut by z = 0, but not through its centre" : "";
}

/// A plane must be vertical, or horizontal and off the plan.
std::string why_not_planar(const Plane<double>& plane) {
  if (plane.normal.z == 0) return "";
  const bool level = plane.normal.x == 0 && plane.normal.y == 0;
  if (!level) return "meets z = 0 aslant";
  return plane.point.z == 0 ? "lies in z = 0" : "";
}

template <class S>
bool meets_plan(const S& shape) {
  const Bounds<double> box = bounds(shape);
  return box.min.z <= 0 && 0 <= box.max.z;
}

/// A shape of which nothing else is said below is planar when its box stays clear of the plan.
template <class S>
std::string why_not_planar(const S& shape) {
  return meets_plan(shape) ? "meets z = 0" : "";
}

/// A box that the plan cuts between its faces has vertical sides there.
std::string why_not_planar(const Box<double>& box) {
  return box.min.z == 0 || box.max.z == 0 ? "has a face in z = 0" : "";
}

/// A quadric that is its own mirror image in z = 0 crosses it at a right angle, unless clipped there. A cone meets it
/// in its apex, which has no normal.
template <QuadricKind Kind>
std::string why_not_planar(const Quadric<double, Kind>& quadric) {
  if (!meets_plan(quadric)) return "";
  if (quadric.z_min == 0 || quadric.z_max == 0) return "is cut off in z = 0";
  if (Kind == QuadricKind::cone) return "has its apex in z = 0";
  if (Kind == QuadricKind::elliptic_paraboloid) return "meets z = 0 aslant";
  return "";
}

/// Flat shapes: rounding may tilt even a vertical one, so only those clear of the plan count.
template <class Flat>
std::string why_not_planar_flat(const Flat& flat) {
  return meets_plan(flat) ? "is flat and meets z = 0" : "";
}
std::string why_not_planar(const Disk<double>& disk) { return why_not_planar_flat(disk); }
std::string why_not_planar(const Polygon<double>& polygon) { return why_not_planar_flat(polygon); }
std::string why_not_planar(const Triangle<double>& triangle) { return why_not_planar_flat(triangle); }

/// A prism is centred on the plan with vertical sides; its caps are off the plan.
std::string why_not_planar(const Prism<double>& prism) { return prism.height > 0 ? "" : "is flat and lies in z = 0"; }

/// A mesh's triangles are flat shapes.
std::string why_not_planar(const MeshShape& mesh) {
  return meets_plan(mesh) ? "is made of flat triangles and meets z = 0" : "";
}

std::string why_not_planar(const Object& object, const Affine<double>& outer);

/// By a map of its own, or of its mesh file.
bool has_bent_normals(const Object& object) {
  if (std::holds_alternative<Instance>(object.shape)) return false;
  const auto* mesh = std::get_if<MeshShape>(&object.shape);
  return object.material.has_bent_normals() ||
         (mesh && mesh->file_materials && mesh->materials &&
          std::any_of(mesh->materials->begin(), mesh->materials->end(),
                      [](const Material& material) { return material.has_bent_normals(); }));
}

std::string why_not_planar(const Instance& instance, const Affine<double>& map) {
  if (!instance.content) return "";
  for (const Object& object : instance.content->group.objects) {
    const std::string why = why_not_planar(object, map);
    if (!why.empty()) return "holds " + object.name + ", which " + why;
  }
  return "";
}

/// A map that preserves z = 0 and vertical directions keeps a planar shape planar. Under any other map the shape has to
/// stay clear of the plan.
std::string why_not_planar(const Object& object, const Affine<double>& outer) {
  const Affine<double> map = outer * affine_of(object.transform);
  const auto meets_plan_anywhere = [&] {
    Bounds<double> box = image_of(map, bounds(object.shape)), swept = box;
    for (const MotionKey& key : object.motion) swept.include({box.min + key.offset, box.max + key.offset});
    return swept.min.z <= 0 && 0 <= swept.max.z;
  };
  const auto along_plan = [](const MotionKey& key) { return key.offset.z == 0; };
  const bool keeps_plan = map.x.z == 0 && map.y.z == 0 && map.z.x == 0 && map.z.y == 0 && map.move.z == 0 &&
                          std::all_of(object.motion.begin(), object.motion.end(), along_plan);
  if (has_bent_normals(object) && (keeps_plan ? meets_plan(object.shape) : meets_plan_anywhere()))
    return "has a relief of normals and meets z = 0";
  if (const auto* instance = std::get_if<Instance>(&object.shape); instance && keeps_plan)
    return why_not_planar(*instance, map);
  if (keeps_plan)
    return std::visit(
        [](const auto& shape) -> std::string {
          if constexpr (std::is_same_v<std::decay_t<decltype(shape)>, Instance>)
            return "";
          else
            return why_not_planar(shape);
        },
        object.shape);
  return meets_plan_anywhere() ? "is moved out of z = 0 and still meets it" : "";
}

}  // namespace

std::string why_not_planar(const Scene& scene) {
  if (scene.camera.eye.z != 0) return "the eye does not lie in z = 0";
  if (scene.camera.look_at.z != 0) return "the camera does not look along z = 0";
  if (scene.camera.up.x != 0 || scene.camera.up.y != 0 || !(scene.camera.up.z > 0)) return "up is not +z";
  for (const Light& light : scene.lights) {
    if (const auto middle = middle_of(light); middle && middle->z != 0) return light.name + " does not lie in z = 0";
    if (const auto axis = axis_of(light); axis && axis->z != 0) return light.name + " does not shine along z = 0";
  }
  for (const Object& object : scene.objects) {
    const std::string why = why_not_planar(object, Affine<double>{});
    if (!why.empty()) return object.name + " " + why;
  }
  return {};
}

}  // namespace raywalk
