#pragma once
// A flat world: the outlines of a planar scene's objects in the plan, where everything is endless along z.

#include "scene/scene.h"

#include <string>
#include <variant>
#include <vector>

namespace raywalk {

/// A side of a polygon or a box, from one corner to the next.
struct OutlineSide {
  Vec2d from, to;
};
/// A wall without ends; `normal`: of any length but 0.
struct OutlineWall {
  Vec2d point, normal;
};
struct OutlineCircle {
  Vec2d centre;
  double radius;
};

/// A piece of the plan's outlines that light is met by.
struct Outline {
  std::variant<OutlineSide, OutlineWall, OutlineCircle> shape;
  int object;    ///< index in Scene::objects
  int part = 0;  ///< of the shape's intersections
  [[nodiscard]] bool is_straight() const { return !std::holds_alternative<OutlineCircle>(shape); }
};

/// Why beams cannot be followed through the scene's plan, naming the object; empty where they can.
[[nodiscard]] std::string why_no_beams(const Scene& scene);

/// The object that has this reason; empty: it is none of them.
[[nodiscard]] std::string object_against_beams(const Scene& scene);

/// In the order of the objects. Objects above and below the plan have none. The scene has no reason against beams.
[[nodiscard]] std::vector<Outline> outlines_of(const Scene& scene);

}  // namespace raywalk
