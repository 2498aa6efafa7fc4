#pragma once
// The list of shapes, and what is asked of any. CONTRIBUTING.md, How to add a shape.

#include "shape/box.h"
#include "shape/disk.h"
#include "shape/exactly.h"
#include "shape/plane.h"
#include "shape/polygon.h"
#include "shape/prism.h"
#include "shape/quadric.h"
#include "shape/sphere.h"
#include "shape/triangle.h"

#include <string_view>
#include <variant>

namespace raywalk {

template <class T>
using Shape =
    std::variant<Sphere<T>, Plane<T>, Prism<T>, Box<T>, Ellipsoid<T>, EllipticParaboloid<T>, Cone<T>, Cylinder<T>,
                 HyperboloidOneSheet<T>, HyperboloidTwoSheets<T>, Disk<T>, Polygon<T>, Triangle<T>>;

/// The name of each shape, in scene files and for people.
template <class T>
constexpr std::string_view shape_name(const Sphere<T>& /*shape*/) {
  return "sphere";
}
template <class T>
constexpr std::string_view shape_name(const Plane<T>& /*shape*/) {
  return "plane";
}
template <class T>
constexpr std::string_view shape_name(const Prism<T>& /*shape*/) {
  return "polygon";
}
template <class T>
constexpr std::string_view shape_name(const Box<T>& /*shape*/) {
  return "box";
}
template <class T, QuadricKind Kind>
constexpr std::string_view shape_name(const Quadric<T, Kind>& /*shape*/) {
  switch (Kind) {
    case QuadricKind::ellipsoid:
      return "ellipsoid";
    case QuadricKind::elliptic_paraboloid:
      return "paraboloid";
    case QuadricKind::cone:
      return "cone";
    case QuadricKind::cylinder:
      return "cylinder";
    case QuadricKind::hyperboloid_one_sheet:
      return "hyperboloid_one_sheet";
    case QuadricKind::hyperboloid_two_sheets:
      return "hyperboloid_two_sheets";
  }
  return "";
}
template <class T>
constexpr std::string_view shape_name(const Disk<T>& /*shape*/) {
  return "disk";
}
template <class T>
constexpr std::string_view shape_name(const Polygon<T>& /*shape*/) {
  return "flat_polygon";
}
template <class T>
constexpr std::string_view shape_name(const Triangle<T>& /*shape*/) {
  return "triangle";
}
template <class T>
[[nodiscard]] constexpr std::string_view shape_name(const Shape<T>& shape) {
  return std::visit([](const auto& s) { return shape_name(s); }, shape);
}

template <class T, class Explain = NoExplanation>
[[nodiscard]] std::optional<Intersection<T>> intersect(const Shape<T>& shape, const Ray<T>& ray, T t_max,
                                                       int departed_part = no_part, Explain&& explain = {}) {
  return std::visit([&](const auto& s) { return intersect(s, ray, t_max, departed_part, explain); }, shape);
}

/// The point of `shape` at an intersection that its `intersect` returned for this very ray.
template <class T>
[[nodiscard]] SurfacePoint<T> surface_at(const Shape<T>& shape, const Ray<T>& ray,
                                         const Intersection<T>& intersection) {
  return std::visit([&](const auto& s) { return surface_at(s, ray, intersection); }, shape);
}

/// Coordinates of a point of part `part`: lengths along the surface in scene units, from an origin and along axes fixed
/// to the shape.
template <class T>
[[nodiscard]] Vec2<T> uv_at(const Shape<T>& shape, const SurfacePoint<T>& point, int part) {
  return std::visit([&](const auto& s) { return uv_at(s, point, part); }, shape);
}

/// How fast the unit outward normal turns where a point of part `part` moves along the surface: its derivative where
/// `along` is the point's. 0 where the surface is flat.
template <class T>
[[nodiscard]] Vec3<T> normal_derivative(const Shape<T>& shape, const SurfacePoint<T>& point, int part,
                                        const Vec3<T>& along) {
  return std::visit([&](const auto& s) { return normal_derivative(s, point, part, along); }, shape);
}

/// The same of `uv_at`. Not finite at poles and on axes, where this has no derivative.
template <class T>
[[nodiscard]] Vec2<T> uv_derivative(const Shape<T>& shape, const SurfacePoint<T>& point, int part,
                                    const Vec3<T>& along) {
  return std::visit([&](const auto& s) { return uv_derivative(s, point, part, along); }, shape);
}

template <class T>
[[nodiscard]] Bounds<T> bounds(const Shape<T>& shape) {
  return std::visit([](const auto& s) { return bounds(s); }, shape);
}

/// Whether it is closed.
template <class T>
[[nodiscard]] bool has_inside(const Shape<T>& shape) {
  return std::visit([](const auto& s) { return has_inside(s); }, shape);
}

/// Cuts it into flat pieces, for radiosity and beams: `to` is a Cutter of trace/patch_cutter.cpp, which says what it
/// can.
template <class Cutter>
void cut(Cutter& to, const Shape<double>& shape) {
  std::visit([&](const auto& s) { cut(to, s); }, shape);
}

/// The same shape in another scalar type: each number rounded once.
template <class To, class From>
[[nodiscard]] Shape<To> shape_cast(const Shape<From>& shape);

namespace detail {

template <class To, class From>
Shape<To> cast_shape(const Sphere<From>& s) {
  return Sphere<To>{Vec3<To>(s.centre), static_cast<To>(s.radius)};
}
template <class To, class From>
Shape<To> cast_shape(const Plane<From>& p) {
  return Plane<To>{Vec3<To>(p.point), Vec3<To>(p.normal)};
}
template <class To, class From>
Shape<To> cast_shape(const Prism<From>& p) {
  Prism<To> prism;
  for (const auto& corner : p.corners) prism.corners.emplace_back(corner);
  prism.height = static_cast<To>(p.height);
  return prism;
}

template <class To, class From>
Shape<To> cast_shape(const Box<From>& b) {
  return Box<To>{Vec3<To>(b.min), Vec3<To>(b.max)};
}
template <class To, class From, QuadricKind Kind>
Shape<To> cast_shape(const Quadric<From, Kind>& q) {
  return Quadric<To, Kind>{Vec3<To>(q.radii), static_cast<To>(q.z_min), static_cast<To>(q.z_max), q.capped};
}
template <class To, class From>
Shape<To> cast_shape(const Disk<From>& d) {
  return Disk<To>{Vec3<To>(d.centre), Vec3<To>(d.normal), static_cast<To>(d.radius)};
}
template <class To, class From>
Shape<To> cast_shape(const Polygon<From>& p) {
  const auto cast = [](const std::vector<Vec3<From>>& loop) {
    std::vector<Vec3<To>> corners;
    for (const auto& corner : loop) corners.emplace_back(corner);
    return corners;
  };
  Polygon<To> polygon{cast(p.outline), {}};
  for (const auto& hole : p.holes) polygon.holes.push_back(cast(hole));
  return polygon;
}
template <class To, class From>
Shape<To> cast_shape(const Triangle<From>& t) {
  return Triangle<To>{Vec3<To>(t.a), Vec3<To>(t.b), Vec3<To>(t.c)};
}

}  // namespace detail

template <class To, class From>
Shape<To> shape_cast(const Shape<From>& shape) {
  return std::visit([](const auto& s) { return detail::cast_shape<To>(s); }, shape);
}

}  // namespace raywalk
