#pragma once
// Objects as cones meet them, and which of them a cone may meet.

#include "trace/ray_cone.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace raywalk {

struct ConeBall {
  Vec3d centre;
  double radius;
};
struct ConeWall {
  Vec3d point, normal;  ///< of unit length
};
/// In a flat world one loop of two corners.
struct ConeFace {
  std::vector<std::vector<Vec3d>> loops;  ///< the outline, and holes
  Vec3d normal;                           ///< of unit length, outward
  int part;                               ///< of the shape's intersections
  std::optional<ConeBall> disc{};         ///< what the outline stands for: its centre and radius
};
struct ConeFaces {
  std::vector<ConeFace> faces;
  bool closed;  ///< of a convex solid
};
/// An object as a cone meets it.
struct ConeBody {
  std::variant<ConeBall, ConeWall, ConeFaces> shape;
  int object;  ///< index in Scene::objects
};

/// Bodies in a tree of balls around balls, so that a cone asks only those that it comes near.
class ConeBodies {
 public:
  ConeBodies() = default;
  explicit ConeBodies(std::vector<ConeBody> all);

  [[nodiscard]] std::size_t size() const { return all_.size(); }
  [[nodiscard]] const ConeBody& operator[](int body) const { return all_[static_cast<std::size_t>(body)]; }
  [[nodiscard]] auto begin() const { return all_.begin(); }
  [[nodiscard]] auto end() const { return all_.end(); }

  /// All that a cone may meet as far as `depth` along its axis, and perhaps others: their indices, ascending.
  [[nodiscard]] std::vector<int> near(const RayCone& cone, double depth) const;

 private:
  /// Around the balls below: the next node and the one at `second`; or, where that is 0, around the body `first`.
  struct Node {
    ConeBall ball;
    int first = 0, second = 0;
  };
  void build(std::vector<std::pair<ConeBall, int>>& waiting, std::size_t begin, std::size_t end);
  [[nodiscard]] static bool may_meet(const RayCone& cone, const ConeBall& ball, double depth);

  std::vector<ConeBody> all_;
  std::vector<int> endless_;
  std::vector<Node> nodes_;  ///< the root is the first
};

}  // namespace raywalk
