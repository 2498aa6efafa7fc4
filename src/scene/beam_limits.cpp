#include "scene/beam_limits.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <variant>
#include <vector>

namespace raywalk {

namespace {

/// Of as many faces no scene is made that beams are followed through (trace/beam_faces.h).
constexpr double most_faces = 200000;
/// What stands for something round.
constexpr double faces_of_round = 2048;

bool is_endless(const Object& object) {
  if (std::holds_alternative<Plane<double>>(object.shape)) return false;  // it is one face
  const Bounds<double> box = bounds(object.shape);
  return !box.empty() && !box.bounded();
}

/// Into how many trapezoids a flat outline with holes is cut: between each two neighbouring heights of its corners, one
/// for every two sides that pass there (trace/patch_cutter.cpp). Of a star of n corners they may be n^2.
template <class Loops, class Height>
double trapezoids_of(const Loops& loops, const Height& height) {
  std::vector<double> heights;
  for (const auto& loop : loops)
    for (const auto& corner : loop) heights.push_back(height(corner));
  std::sort(heights.begin(), heights.end());
  heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
  const auto place_of = [&](const auto& corner) {
    return static_cast<double>(std::lower_bound(heights.begin(), heights.end(), height(corner)) - heights.begin());
  };
  double passed = 0;
  for (const auto& loop : loops)
    for (std::size_t i = 0; i < loop.size(); ++i)
      passed += std::abs(place_of(loop[i]) - place_of(loop[i + 1 == loop.size() ? 0 : i + 1]));
  return passed / 2;
}
double faces_of(const Polygon<double>& polygon) {
  std::vector<std::vector<Vec3d>> loops{polygon.outline};
  loops.insert(loops.end(), polygon.holes.begin(), polygon.holes.end());
  const Vec3d up = cross(polygon.area_vector(), polygon.outline[1] - polygon.outline[0]);
  return trapezoids_of(loops, [&](const Vec3d& corner) { return dot(corner - polygon.outline[0], up); });
}
double faces_of(const Prism<double>& prism) {
  const std::vector<std::vector<Vec2d>> loops{prism.corners};
  return prism.sides() + trapezoids_of(loops, [](const Vec2d& corner) { return corner.y; }) +
         trapezoids_of(loops, [](const Vec2d& corner) { return corner.x; });
}

double faces_of(const Object& object);

double faces_of(const std::vector<Object>& objects) {
  double sum = 0;
  for (const Object& object : objects) sum += faces_of(object);
  return sum;
}

double faces_of(const Object& object) {
  if (const auto* mesh = std::get_if<MeshShape>(&object.shape))
    return mesh->mesh ? static_cast<double>(mesh->mesh->triangles.size()) : 0;
  if (const auto* instance = std::get_if<Instance>(&object.shape))
    return instance->content ? faces_of(instance->content->group.objects) : 0;
  if (const auto* polygon = std::get_if<Polygon<double>>(&object.shape)) return faces_of(*polygon);
  if (const auto* prism = std::get_if<Prism<double>>(&object.shape)) return faces_of(*prism);
  if (std::holds_alternative<Box<double>>(object.shape)) return 6;
  const bool flat = std::holds_alternative<Plane<double>>(object.shape) ||
                    std::holds_alternative<Triangle<double>>(object.shape) ||
                    std::holds_alternative<Disk<double>>(object.shape);
  return flat ? 1 : faces_of_round;
}

std::string why_not(const std::vector<Object>& objects) {
  for (const Object& object : objects) {
    if (!object.motion.empty()) return object.name + " moves";
    if (object.material.normal == ShadingNormal::fixed) return object.name + " has a fixed normal";
    if (is_endless(object)) return object.name + " is endless";
    if (const auto* instance = std::get_if<Instance>(&object.shape); instance != nullptr && instance->content)
      if (std::string why = why_not(instance->content->group.objects); !why.empty())
        return object.name + " holds something that cannot be cut: " + why;
  }
  return {};
}

}  // namespace

std::string why_no_space_beams(const Scene& scene) {
  if (std::string why = why_not(scene.objects); !why.empty()) return why;
  double sum = 0, most = 0;
  const Object* largest = nullptr;
  for (const Object& object : scene.objects) {
    const double faces = faces_of(object);
    sum += faces;
    if (faces > most) most = faces, largest = &object;
  }
  if (!(sum > most_faces)) return {};
  return "the scene has more than 200,000 faces, and " + largest->name + " the most of them";
}

}  // namespace raywalk
