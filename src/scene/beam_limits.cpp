#include "scene/beam_limits.h"

#include <cmath>
#include <type_traits>
#include <variant>

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
  const bool flat =
      std::holds_alternative<Plane<double>>(object.shape) || std::holds_alternative<Polygon<double>>(object.shape) ||
      std::holds_alternative<Triangle<double>>(object.shape) || std::holds_alternative<Box<double>>(object.shape) ||
      std::holds_alternative<Prism<double>>(object.shape) || std::holds_alternative<Disk<double>>(object.shape);
  return flat ? 6 : faces_of_round;
}

std::string why_not(const std::vector<Object>& objects) {
  for (const Object& object : objects) {
    if (!object.motion.empty()) return object.name + " moves";
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
  if (faces_of(scene.objects) > most_faces) return "the scene has more than 200,000 faces";
  return {};
}

}  // namespace raywalk
