#include "scene/cone_limits.h"

#include "math/overloaded.h"

#include <variant>

namespace raywalk {

namespace {

/// A cone sees the faces of a convex solid side by side: those in front never hide each other.
bool is_convex(const Prism<double>& prism) {
  int turns_left = 0, turns_right = 0;
  for (int i = 0; i < prism.sides(); ++i) {
    const double turn = cross(prism.edge(i), prism.edge(i + 1 == prism.sides() ? 0 : i + 1));
    if (turn > 0) ++turns_left;
    if (turn < 0) ++turns_right;
  }
  return turns_left == 0 || turns_right == 0;
}

std::string why_not_covered(const Object& object) {
  if (!object.motion.empty()) return "moves";
  if (!object.transform.empty()) return "is transformed";
  if (object.material.normal == ShadingNormal::fixed) return "has a fixed normal";
  return std::visit(
      Overloaded{
          [](const Sphere<double>&) { return ""; },
          [](const Plane<double>&) { return ""; },
          [](const Polygon<double>&) { return ""; },
          [](const Triangle<double>&) { return ""; },
          [](const Disk<double>&) { return ""; },
          [](const Box<double>&) { return ""; },
          [](const Prism<double>& prism) { return is_convex(prism) ? "" : "is not convex"; },
          [](const auto&) { return "is neither a sphere, a plane, a disc, a polygon, a prism nor a box"; },
      },
      static_cast<const ObjectShape::Kinds&>(object.shape));
}

const Object* first_against(const Scene& scene) {
  for (const Object& object : scene.objects)
    if (!why_not_covered(object).empty()) return &object;
  return nullptr;
}

}  // namespace

std::string object_against_cones(const Scene& scene) {
  const Object* object = first_against(scene);
  return object == nullptr ? std::string() : object->name;
}

std::string why_no_cones(const Scene& scene) {
  const Object* object = first_against(scene);
  return object == nullptr ? std::string() : object->name + " " + why_not_covered(*object);
}

}  // namespace raywalk
