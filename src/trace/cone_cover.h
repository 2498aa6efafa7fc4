#pragma once
// What covers a cone, front to back: how much of it each object does. J. Amanatides, "Ray Tracing with Cones", SIGGRAPH
// 1984. The cone's rays are the points of a unit disc (trace/ray_cone.h); in it a sphere is taken as a disc, and a
// plane or polygon has straight edges, so that the covered areas have closed forms.
//
// Only how much is known, not which rays: what is behind gets its share of what those before have left, as if each
// covered rays at random. That is exact for one object before another that fills the cone. Where two share an edge it
// is not: of two halves that meet in the middle of a cone, the first gets 1/2, the second 1/4, and 1/4 sees through.
// The faces of one convex solid never hide each other; their shares are added. A sphere seen aslant is an ellipse, and
// is taken as the disc that has its extent in the direction away from the axis: too large, by up to 0.002 of a cone of
// a spread of 0.2. A disc square to the axis is exact, another one has 64 sides.

#include "accel/query.h"
#include "trace/cone_bodies.h"
#include "trace/ray_cone.h"

#include <vector>

namespace raywalk {

/// A part of a cone, covered by one object, or by one face of it.
struct ConePart {
  int body = -1;        ///< index; -1: nothing covers it
  int part = 0;         ///< of its shape's intersections
  bool inside = false;  ///< the cone starts inside of it
  double cover = 1;     ///< share of the cone that it covers by itself
  double share = 1;     ///< share of the cone that sees it
  Vec2d place{0};       ///< of a ray in the middle of what it covers
  double size = 1;      ///< of the cone about it that is as large as what it covers: its share of the cone's width
  double t = 0;         ///< along that ray, in lengths of RayCone::direction, to the object
};

/// Where a cone starts: on part `part` of this object, which it cannot meet at once.
struct ConeLeaves {
  int object = -1, part = 0;
};

/// What covers a cone, each object by itself and in their order, as far as `depth` along the axis: only `cover` is
/// known, and not what hides what. The faces of one object follow each other. Counts those asked.
[[nodiscard]] std::vector<ConePart> meet_cone(const ConeBodies& bodies, const RayCone& cone, const ConeLeaves& leaves,
                                              double depth, TestCounts& counts);

/// The parts of a cone, front to back; their shares and what is left add up to 1. What is left is the last part, if
/// there is any.
[[nodiscard]] std::vector<ConePart> cover_cone(const ConeBodies& bodies, const RayCone& cone, const ConeLeaves& leaves,
                                               TestCounts& counts);

}  // namespace raywalk
