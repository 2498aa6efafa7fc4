#include "trace/outlines.h"

#include "math/overloaded.h"

#include <algorithm>

namespace raywalk {

namespace {

bool crosses_plan(const Bounds<double>& box) { return box.min.z <= 0 && 0 <= box.max.z; }

Bounds<double> box_of(const Object& object) {
  Bounds<double> box = image_of(affine_of(object.transform), bounds(object.shape));
  const Bounds<double> at_rest = box;
  for (const MotionKey& key : object.motion) box.include({at_rest.min + key.offset, at_rest.max + key.offset});
  return box;
}

/// Nothing: its outline is known.
std::string why_no_outline(const Object& object) {
  if (!crosses_plan(box_of(object))) return "";
  if (!object.motion.empty()) return "moves";
  if (!object.transform.empty()) return "is transformed";
  if (object.material.normal == ShadingNormal::fixed) return "has a fixed normal";
  return std::visit(Overloaded{
                        [](const Sphere<double>&) { return ""; },
                        [](const Plane<double>&) { return ""; },
                        [](const Prism<double>&) { return ""; },
                        [](const Box<double>&) { return ""; },
                        [](const auto&) { return "is neither a sphere, a polygon, a box nor a plane"; },
                    },
                    static_cast<const ObjectShape::Kinds&>(object.shape));
}

}  // namespace

std::string why_no_beams(const Scene& scene) {
  if (const std::string why = why_not_planar(scene); !why.empty()) return why;
  for (const Object& object : scene.objects)
    if (const std::string why = why_no_outline(object); !why.empty()) return object.name + " " + why;
  return {};
}

std::string object_against_beams(const Scene& scene) {
  const std::string why = why_no_beams(scene);
  std::string told;  // an object's name may begin with that of another
  for (const Object& object : scene.objects)
    if (object.name.size() > told.size() && why.starts_with(object.name + " ")) told = object.name;
  return told;
}

std::vector<Outline> outlines_of(const Scene& scene) {
  std::vector<Outline> outlines;
  for (int index = 0; index < static_cast<int>(scene.objects.size()); ++index) {
    const Object& object = scene.objects[static_cast<std::size_t>(index)];
    if (!crosses_plan(box_of(object))) continue;
    const auto add = [&](const auto& shape, int part = 0) { outlines.push_back({shape, index, part}); };
    std::visit(Overloaded{
                   [&](const Sphere<double>& sphere) { add(OutlineCircle{plan(sphere.centre), sphere.radius}); },
                   [&](const Plane<double>& plane) {
                     if (!is_level(plane)) add(OutlineWall{plan(plane.point), plan(plane.normal)});
                   },
                   [&](const Prism<double>& prism) {
                     for (int side = 0; side < prism.sides(); ++side)
                       add(OutlineSide{prism.corner(side), prism.corner_after(side)}, side);
                   },
                   [&](const Box<double>& box) {
                     const Vec2d low = plan(box.min), high = plan(box.max);
                     const Vec2d corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
                     constexpr int faces[] = {2, 1, 3, 0};  // low y, high x, high y, low x
                     for (std::size_t side = 0; side < 4; ++side)
                       add(OutlineSide{corners[side], corners[(side + 1) % 4]}, faces[side]);
                   },
                   [](const auto&) {},
               },
               static_cast<const ObjectShape::Kinds&>(object.shape));
  }
  return outlines;
}

}  // namespace raywalk
