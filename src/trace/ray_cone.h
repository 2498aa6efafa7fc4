#pragma once
// Cones of rays: J. Amanatides, "Ray Tracing with Cones", SIGGRAPH 1984. A cone is a centre line and a spread: how fast
// its radius grows along that line. Cut off where it starts, it has a radius there, too; the paper's virtual origin is
// where the radius would be 0, behind the start or, where the cone converges, before it.
//
// A ray of the cone is named by its place u in the unit disc: it starts at origin + radius u and goes along
// axis + spread u, so that at depth t along the axis it is radius + spread t away from it, times u. In a flat world u
// is a number from -1 to 1.
//
// What the approximation is: rays near the axis are followed exactly to first order. A cone stays round: where a curved
// surface spreads it in one way and not in the other, it takes the mean of both. A spread has a limit
// (`largest_spread`), which grazing cones reach.

#include "math/vec.h"

namespace raywalk {

/// 76 degrees to each side.
inline constexpr double largest_spread = 4;

struct RayCone {
  Vec3d origin;
  Vec3d axis;  ///< of unit length
  Vec3d right,
      up;         ///< the axes of u: of unit length, at right angles to `axis`; in a flat world `right` is in the plan
  double radius;  ///< where it starts, >= 0
  double spread;  ///< of the radius with the distance along the axis; < 0: it converges
  bool flat = false;  ///< in a flat world u.y is 0

  [[nodiscard]] double radius_at(double depth) const { return radius + spread * depth; }
  [[nodiscard]] Vec3d across(const Vec2d& u) const { return u.x * right + u.y * up; }
  [[nodiscard]] Vec3d start(const Vec2d& u) const { return origin + radius * across(u); }
  /// Not of unit length: to depth 1.
  [[nodiscard]] Vec3d direction(const Vec2d& u) const { return axis + spread * across(u); }
};

/// A cone about `axis`, of unit length.
[[nodiscard]] RayCone cone_about(const Vec3d& origin, const Vec3d& axis, double radius, double spread, bool flat);

/// The narrower cone of those rays that are not farther than `size` from u, about ray u. Exact to first order: in a
/// flat world its width, in space its area, for across an aslant ray they fill an ellipse.
[[nodiscard]] RayCone part_of_cone(const RayCone& cone, const Vec2d& u, double size);

/// How wide a cone is that arrives at a surface, or leaves it: radius and spread.
struct ConeWidth {
  double radius, spread;
};

/// The same cone, seen the other way round if its rays have crossed: with a radius >= 0 and a spread within limits.
[[nodiscard]] ConeWidth turned_out(ConeWidth width);

/// Of the two planes of a surface's curvature, that of incidence and the one across it (H. Coddington, "A Treatise on
/// the Reflexion and Refraction of Light", 1829): what mirror and refraction make of a width there. `curvature`: of the
/// surface, 1 / radius, > 0 where it bulges towards the ray. `cos_in`, `cos_out`: of the angles to the normal, > 0.
enum class ConePlane { of_incidence, across };
[[nodiscard]] ConeWidth mirrored(ConeWidth width, ConePlane plane, double curvature, double cos_in);
[[nodiscard]] ConeWidth refracted(ConeWidth width, ConePlane plane, double curvature, double n1, double n2,
                                  double cos_in, double cos_out);
/// Of a round cone: in a flat world that of the plane of incidence, else the mean of both.
[[nodiscard]] ConeWidth mirrored_cone(ConeWidth width, double curvature, double cos_in, bool flat);
[[nodiscard]] ConeWidth refracted_cone(ConeWidth width, double curvature, double n1, double n2, double cos_in,
                                       double cos_out, bool flat);
/// Of small facets, half of whose area is steeper than `slope`: the cone in whose inner half lies what the other half
/// sends on, each direction turned by as much as its facet makes it. A slope of 0 widens nothing.
[[nodiscard]] ConeWidth widened_by_mirrors(ConeWidth width, double slope, double cos_in, bool flat);
[[nodiscard]] ConeWidth widened_by_facets(ConeWidth width, double slope, double n1, double n2, double cos_in,
                                          double cos_out, bool flat);
/// Of a rough mirror or milky glass, which scatter evenly in a cone of their own. `one_minus_cos`: of its half angle.
[[nodiscard]] ConeWidth widened(ConeWidth width, double one_minus_cos);

// Shares of the unit disc, in 0..1.

/// Covered by a disc whose centre is `distance` >= 0 from its own; to 1e-10 of the share.
[[nodiscard]] double share_of_disc(double distance, double radius);
/// On the far side of a line; `distance`: of the line from the centre, < 0 where the centre is on the far side.
[[nodiscard]] double share_beyond(double distance);
/// Twice the signed area that the triangle of the centre and a side of a polygon has in common with the disc: over all
/// sides, turning counter-clockwise, they add up to that of the polygon.
[[nodiscard]] double twice_area_of_side(const Vec2d& from, const Vec2d& to);

}  // namespace raywalk
