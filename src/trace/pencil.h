#pragma once
// Pencils of rays: M. Shinya, T. Takahashi and S. Naito, "Principles and Applications of Pencil Tracing", SIGGRAPH
// 1987. Rays near one ray, the axis, are followed by a system matrix, as in the optics of lens designers (paraxial rays
// about any ray, not about an axis of symmetry). In a plane along the axis a ray is its distance from the axis and its
// slope against it, and what happens to both is a 2 x 2 matrix; in space there are two such planes, and the matrix is
// 4 x 4. They do not mix while the axis stays in a plane and surfaces are upright to it or round: in the plan.
//
// Lengths are those of the world, slopes those of small angles: exact to first order. A matrix from a medium of index
// n1 to one of n2 has the determinant n1 / n2 (up to the sign by which a mirror turns the plan over), for light is
// neither lost nor gained between rays.

#include "trace/optics.h"
#include "trace/ray_cone.h"

#include <array>
#include <cmath>
#include <optional>
#include <utility>

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
  [[nodiscard]] PencilMatrix operator+(const PencilMatrix& more) const {
    return {a + more.a, b + more.b, c + more.c, d + more.d};
  }
  [[nodiscard]] bool operator==(const PencilMatrix&) const = default;
};
inline constexpr PencilMatrix no_pencil{0, 0, 0, 0};

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

/// The 4 x 4 matrix of space, by its four blocks. Of rays to the left of the axis and above it (`sides_of`): `plan`
/// makes from left left, `across` from up up, and the others one from the other.
struct PencilSystem {
  PencilMatrix plan{}, across{}, left_from_up = no_pencil, up_from_left = no_pencil;

  /// First `before`, then this.
  [[nodiscard]] PencilSystem operator*(const PencilSystem& before) const {
    return {plan * before.plan + left_from_up * before.up_from_left,
            up_from_left * before.left_from_up + across * before.across,
            plan * before.left_from_up + left_from_up * before.across,
            up_from_left * before.plan + across * before.up_from_left};
  }
  /// Whether left and up stay apart, as in the plan.
  [[nodiscard]] bool is_unmixed() const { return left_from_up == no_pencil && up_from_left == no_pencil; }
};
[[nodiscard]] inline PencilSystem transferred(double distance) {
  return {pencil_transfer(distance), pencil_transfer(distance)};
}

/// The sides of a pencil: of unit length, across its axis and each other.
struct PencilSides {
  Vec3d left, up;
};
/// Those that lie level and point up, about an axis of unit length: in the plan the plan's left, and z.
[[nodiscard]] inline PencilSides sides_of(const Vec3d& axis) {
  const Vec3d level(-axis.y, axis.x, 0);
  const Vec3d left = length(level) > 0 ? normalize(level) : Vec3d(0, 1, 0);
  return {left, cross(axis, left)};
}

/// A surface where an axis meets it. Curvatures are of the surface towards the ray: > 0 where it bulges that way. They
/// are those of the plane of incidence and of the one across it, and what the normal turns by in one on the way along
/// the other.
struct PencilSurface {
  Vec3d axis, normal;  ///< of unit length; the normal is towards the ray
  Vec3d across;        ///< of unit length, across the plane of incidence; in the plan it points up or down
  double cos_in;       ///< of the ray's angle to the normal
  double curvature, upright, twist;  ///< in the plane of incidence; across it; from one to the other
};

namespace detail {

/// From level sides to those of the plane of incidence, `across` and at its left.
[[nodiscard]] inline PencilSystem turned_to(const Vec3d& across, const Vec3d& axis) {
  const PencilSides sides = sides_of(axis);
  const double cos = dot(across, sides.up), sin = -dot(across, sides.left);
  return {{cos, 0, 0, cos}, {cos, 0, 0, cos}, {sin, 0, 0, sin}, {-sin, 0, 0, -sin}};
}
/// And back from them.
[[nodiscard]] inline PencilSystem turned_from(const Vec3d& across, const Vec3d& axis) {
  PencilSystem turn = turned_to(across, axis);
  std::swap(turn.left_from_up, turn.up_from_left);
  return turn;
}

}  // namespace detail

[[nodiscard]] inline PencilSystem mirrored_by(const PencilSurface& at) {
  const PencilSystem mirror{pencil_mirror(ConePlane::of_incidence, at.curvature, at.cos_in),
                            pencil_mirror(ConePlane::across, at.upright, at.cos_in),
                            {0, 0, -2 * at.twist, 0},
                            {0, 0, 2 * at.twist, 0}};
  return detail::turned_from(at.across, reflect(at.axis, at.normal)) * mirror * detail::turned_to(at.across, at.axis);
}
[[nodiscard]] inline PencilSystem refracted_by(const PencilSurface& at, double n1, double n2, double cos_out) {
  const double turn = n1 * at.cos_in - n2 * cos_out;  // of the normal in Snell's law as vectors, which bends the axis
  const PencilSystem bend{pencil_refraction(ConePlane::of_incidence, at.curvature, n1, n2, at.cos_in, cos_out),
                          pencil_refraction(ConePlane::across, at.upright, n1, n2, at.cos_in, cos_out),
                          {0, 0, turn * at.twist / (n2 * cos_out), 0},
                          {0, 0, turn * at.twist / (n2 * at.cos_in), 0}};
  const Vec3d bent = normalize(n1 * at.axis + turn * at.normal);
  return detail::turned_from(at.across, bent) * bend * detail::turned_to(at.across, at.axis);
}
/// Where an axis of this direction, of unit length, meets a primitive at `point`, a SurfacePoint.
template <class Primitives, class Point, class T>
[[nodiscard]] PencilSurface pencil_surface(const Primitives& primitives, int primitive, int part, const Point& point,
                                           T time, const Vec3d& axis) {
  const Vec3d outward(point.normal);
  const double side = dot(outward, axis) <= 0 ? 1 : -1;
  const Vec3d normal = side * outward;
  Vec3d across = cross(axis, normal);
  across = length(across) > 0 ? normalize(across) : sides_of(axis).up;
  across = normalize(across - dot(across, axis) * axis);  // of rounding, where the ray comes along the normal
  const Vec3d along = cross(normal, across);
  const auto turn = [&](const Vec3d& way) {
    return side * Vec3d(primitives.normal_derivative(primitive, point, part, time, Vec3<T>(way)));
  };
  const Vec3d turned_across = turn(across);
  return {axis,
          normal,
          across,
          -dot(axis, normal),
          dot(turn(along), along),
          dot(turned_across, across),
          dot(turned_across, along)};
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
/// In space: how far along the axis the rays from one point meet on a line across it, and on another one at right
/// angles to the first (C. Sturm, "Memoire sur l'optique", 1838): in the plan what `focus_of_point` says of both
/// planes. The determinant of the offsets by slopes, B + t D, is 0 there; B D^-1 is symmetric, since light forms
/// fronts.
[[nodiscard]] inline std::array<std::optional<double>, 2> foci_of_point(const PencilSystem& system) {
  const PencilMatrix B{system.plan.b, system.left_from_up.b, system.up_from_left.b, system.across.b};
  const PencilMatrix D{system.plan.d, system.left_from_up.d, system.up_from_left.d, system.across.d};
  const PencilMatrix adjugate{D.d, -D.b, -D.c, D.a};
  const PencilMatrix front = B * adjugate;
  const double mean = (front.a + front.d) / 2, apart = length(Vec2d(front.a - front.d, front.b + front.c)) / 2;
  const double larger = mean < 0 ? mean - apart : mean + apart;
  std::array<std::optional<double>, 2> foci;
  if (D.determinant() != 0) foci[0] = -larger / D.determinant();
  if (larger != 0)
    foci[1] = -B.determinant() / larger;
  else
    foci[1] = foci[0];
  return foci;
}
/// Half the axes of the ellipse that a round bundle from one point fills, per its half angle; the longer first.
[[nodiscard]] inline Vec2d ellipse_from_point(const PencilSystem& system) {
  const PencilMatrix B{system.plan.b, system.left_from_up.b, system.up_from_left.b, system.across.b};
  const double turned = length(Vec2d(B.a + B.d, B.c - B.b)) / 2, flipped = length(Vec2d(B.a - B.d, B.b + B.c)) / 2;
  return {turned + flipped, std::abs(turned - flipped)};
}

}  // namespace raywalk
