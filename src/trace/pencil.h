#pragma once
// Pencils of rays: M. Shinya, T. Takahashi and S. Naito, "Principles and Applications of Pencil Tracing", SIGGRAPH
// 1987. Rays near one ray, the axis, are followed by a system matrix, as in the optics of lens designers (paraxial rays
// about any ray, not about an axis of symmetry). Across the axis lie two planes that do not mix where curvature is a
// sphere's or 0 and the axis stays in a plane: that of incidence, which is the plan, and the one across it. In each a
// ray is its distance from the axis and its slope against it, and what happens to both is a 2 x 2 matrix; the 4 x 4 one
// in space is both beside each other.
//
// Lengths are those of the world, slopes those of small angles: exact to first order. A matrix from a medium of index
// n1 to one of n2 has the determinant n1 / n2 (up to the sign by which a mirror turns the plan over), for light is
// neither lost nor gained between rays.

#include "trace/ray_cone.h"

#include <optional>

namespace raywalk {

/// A ray beside the axis: `offset` to the left of it, across; `slope` of its direction that way.
struct ParaxialRay {
  double offset, slope;
};

/// offset' = a offset + b slope, slope' = c offset + d slope.
struct PencilMatrix {
  double a = 1, b = 0, c = 0, d = 1;

  [[nodiscard]] double determinant() const { return a * d - b * c; }
  [[nodiscard]] ParaxialRay operator()(const ParaxialRay& ray) const {
    return {a * ray.offset + b * ray.slope, c * ray.offset + d * ray.slope};
  }
  /// First `before`, then this.
  [[nodiscard]] PencilMatrix operator*(const PencilMatrix& before) const {
    return {a * before.a + b * before.c, a * before.b + b * before.d, c * before.a + d * before.c,
            c * before.b + d * before.d};
  }
};

/// Over a distance along the axis.
[[nodiscard]] inline PencilMatrix pencil_transfer(double distance) { return {1, distance, 0, 1}; }

/// By a surface; arguments as of trace/ray_cone.h. In the plan a mirror exchanges left and right: both change sign.
[[nodiscard]] inline PencilMatrix pencil_mirror(ConePlane plane, double curvature, double cos_in) {
  const ConeWidth wide = mirrored({1, 0}, plane, curvature, cos_in), steep = mirrored({0, 1}, plane, curvature, cos_in);
  const double side = plane == ConePlane::of_incidence ? -1 : 1;
  return {side * wide.radius, side * steep.radius, side * wide.spread, side * steep.spread};
}
[[nodiscard]] inline PencilMatrix pencil_refraction(ConePlane plane, double curvature, double n1, double n2,
                                                    double cos_in, double cos_out) {
  const ConeWidth wide = refracted({1, 0}, plane, curvature, n1, n2, cos_in, cos_out);
  const ConeWidth steep = refracted({0, 1}, plane, curvature, n1, n2, cos_in, cos_out);
  return {wide.radius, steep.radius, wide.spread, steep.spread};
}

/// Both planes: that of the plan, and the one across it.
struct PencilSystem {
  PencilMatrix plan{}, across{};

  /// First `before`, then this.
  [[nodiscard]] PencilSystem operator*(const PencilSystem& before) const {
    return {plan * before.plan, across * before.across};
  }
};
[[nodiscard]] inline PencilSystem transferred(double distance) {
  return {pencil_transfer(distance), pencil_transfer(distance)};
}

/// A surface where an axis meets it. Curvatures are of the surface towards the ray: > 0 where it bulges that way.
struct PencilSurface {
  Vec3d normal;               ///< of unit length, towards the ray
  double cos_in;              ///< of the ray's angle to it
  double curvature, upright;  ///< in the plan; across it
};
[[nodiscard]] inline PencilSystem mirrored_by(const PencilSurface& at) {
  return {pencil_mirror(ConePlane::of_incidence, at.curvature, at.cos_in),
          pencil_mirror(ConePlane::across, at.upright, at.cos_in)};
}
[[nodiscard]] inline PencilSystem refracted_by(const PencilSurface& at, double n1, double n2, double cos_out) {
  return {pencil_refraction(ConePlane::of_incidence, at.curvature, n1, n2, at.cos_in, cos_out),
          pencil_refraction(ConePlane::across, at.upright, n1, n2, at.cos_in, cos_out)};
}
/// Where the axis, a ray of the plan of this direction, of unit length, meets a primitive at `point`, a SurfacePoint.
template <class Primitives, class Point, class T>
[[nodiscard]] PencilSurface pencil_surface(const Primitives& primitives, int primitive, int part, const Point& point,
                                           T time, const Vec3d& direction) {
  const Vec3d outward(point.normal);
  const double side = dot(outward, direction) <= 0 ? 1 : -1;
  const auto curvature = [&](const Vec3d& along) {
    return side * dot(Vec3d(primitives.normal_derivative(primitive, point, part, time, Vec3<T>(along))), along);
  };
  const Vec3d left(-outward.y, outward.x, 0), up(0, 0, 1);
  return {side * outward, -side * dot(direction, outward), curvature(left), curvature(up)};
}

/// How far along the axis the rays meet that come from one point (where the matrix begins), or from parallel ones:
/// there the pencil folds, and light that comes from a point is a caustic. Negative: behind, where they seem to come
/// from. None where they run in parallel.
[[nodiscard]] inline std::optional<double> focus_of_point(const PencilMatrix& system) {
  if (system.d == 0) return std::nullopt;
  return -system.b / system.d;
}
[[nodiscard]] inline std::optional<double> focus_of_parallel(const PencilMatrix& system) {
  if (system.c == 0) return std::nullopt;
  return -system.a / system.c;
}

}  // namespace raywalk
