#pragma once
// How much of the light that leaves one surface arrives at another one: form factors between polygons that see each
// other whole.
//
// In space, Stokes's theorem makes of the double integral over two areas one around their edges (P. Moon, "The
// Scientific Basis of Illuminating Engineering", 1936; what P. Schröder and P. Hanrahan bring into closed form, "On the
// Form Factor between Two Polygons", SIGGRAPH 1993): A1 F12 = 1 / (2 pi) times the sum over pairs of edges of their
// cosine times the integral of ln r along both. The inner integral is elementary and taken in closed form. The outer
// one is taken by Gauss's rules of three and five points, and halved where they differ: so small and far polygons cost
// a few evaluations, and such as share an edge still become as exact as asked for. The dilogarithms of the closed form
// would need a branch for each way in which two edges can lie.
//
// In the plane a string does it (H. C. Hottel, "Radiant Heat Transmission", 1954).

#include "math/vec.h"

#include <span>
#include <vector>

namespace raywalk {

/// The share of a receiver's light: A1 F12, the area of the first times the factor to the second; the same the other
/// way round. `corners`: of convex, flat polygons, counter-clockwise seen from the side that gives off and receives
/// light. What lies behind the other one's plane is cut off. The error is about `tolerance` times the area of the
/// first.
[[nodiscard]] double exchange_area(std::span<const Vec3d> first, std::span<const Vec3d> second,
                                   double tolerance = 1e-6);

/// The factor from a point of a surface to a convex, flat polygon whose light it sees whole: in closed form, by the
/// angles that the edges subtend (J. H. Lambert, "Photometria", 1760). What lies behind the surface is cut off.
/// `normal`: of unit length.
[[nodiscard]] double point_factor(const Vec3d& point, const Vec3d& normal, std::span<const Vec3d> corners);

/// A straight edge of the plan. Light leaves it to the left of the way from `a` to `b`.
struct Edge {
  Vec2d a, b;
};
/// The strings between two edges, as far as they lie in front of each other.
struct Strings {
  Edge first, second;         ///< what is left of them
  double crossed, uncrossed;  ///< lengths of both strings together
  /// L1 F12, the length of the first times the factor to the second; 0 if nothing lies in front.
  [[nodiscard]] double exchange_length() const { return 0.5 * (crossed - uncrossed); }
};
[[nodiscard]] Strings strings_between(const Edge& first, const Edge& second);

/// The part of a convex polygon in front of a plane, in which it may lie.
[[nodiscard]] std::vector<Vec3d> clipped(std::span<const Vec3d> corners, const Vec3d& point, const Vec3d& normal);
/// Perpendicular to a flat polygon, towards the side from which its corners run counter-clockwise; as long as its area.
[[nodiscard]] Vec3d area_vector_of(std::span<const Vec3d> corners);

}  // namespace raywalk
