#pragma once
// The transmitting bodies of a world, where rays may be inside more than one, or start inside one (nested dielectrics).

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
    bool endless;  ///< unbounded: a ray may be inside and never leave
  };

  std::vector<Body> list;
  std::vector<std::int32_t> of;          ///< by primitive: the index of its body in the list, or -1; without copies
  std::vector<std::int32_t> around_eye;  ///< bodies that may contain the eye, outer ones first
  /// By primitive: equal primitives of other bodies in the same place, of which searches find only this one.
  std::unordered_map<int, std::vector<int>> doubles;

  [[nodiscard]] bool empty() const { return list.empty(); }
  [[nodiscard]] std::int32_t of_primitive(int id) const {
    const auto at = static_cast<std::size_t>(id);
    return at < of.size() ? of[at] : -1;
  }
  [[nodiscard]] const Body& operator[](std::int32_t body) const { return list[static_cast<std::size_t>(body)]; }
};

/// A shape, or the triangles of a mesh that share a material, is a body. A flat shape encloses nothing by itself: all
/// flat shapes of the same glass are the surface of one body. Empty where no two bodies can touch and none can contain
/// the eye; conservative, as only boxes are compared.
template <class T>
[[nodiscard]] Bodies bodies_that_nest(const World<T>& world, const Camera& camera);

}  // namespace raywalk
