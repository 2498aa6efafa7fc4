#pragma once
// The bodies of a world that light goes through, where rays may be inside of more than one, or start inside of one.

#include "scene/camera.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace raywalk {

template <class T>
struct World;

struct Bodies {
  struct Body {
    std::int32_t surface;  ///< in World::surfaces
    double priority;
    bool endless;  ///< has no bounds: a ray may be inside and never come out
  };

  std::vector<Body> list;
  std::vector<std::int32_t> of;          ///< by primitive: its body's place in the list, or -1
  std::vector<std::int32_t> around_eye;  ///< those that may hold the eye, outer ones first
  /// By primitive: those of other bodies that are its equals in the same place, where searches find it alone.
  std::unordered_map<int, std::vector<int>> doubles;

  [[nodiscard]] bool empty() const { return list.empty(); }
  [[nodiscard]] std::int32_t of_primitive(int id) const { return of[static_cast<std::size_t>(id)]; }
  [[nodiscard]] const Body& operator[](std::int32_t body) const { return list[static_cast<std::size_t>(body)]; }
};

/// A shape, or the triangles of a mesh that share a material, is a body. What is flat encloses nothing by itself: all
/// flat shapes of the same glass are the skin of one body. Empty where no two bodies can touch and none can hold the
/// eye: by their boxes, so that some are found that need not be.
template <class T>
[[nodiscard]] Bodies bodies_that_nest(const World<T>& world, const Camera& camera);

}  // namespace raywalk
