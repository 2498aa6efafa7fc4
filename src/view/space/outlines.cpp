#include "view/space/outlines.h"

#include "view/space/mesh_lines.h"

#include "scene/transform_step.h"
#include "shape/intersection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>

namespace raywalk {

namespace {

constexpr int round_pieces = 48;

/// An ellipse about `centre` with half axes `u` and `v`.
Polyline circle(const Vec3d& centre, const Vec3d& u, const Vec3d& v) {
  static const std::vector<Vec2d> unit_circle = [] {  // every frame draws thousands of them
    std::vector<Vec2d> points;
    for (int i = 0; i <= round_pieces; ++i) {
      const double angle = 2 * std::numbers::pi * i / round_pieces;
      points.emplace_back(std::cos(angle), std::sin(angle));
    }
    return points;
  }();
  Polyline curve;
  curve.reserve(unit_circle.size());
  for (const Vec2d& at : unit_circle) curve.push_back(centre + at.x * u + at.y * v);
  return curve;
}

/// Curves of a shape, where its object is.
std::vector<Polyline> placed(std::vector<Polyline> curves, const std::vector<TransformStep>& transform) {
  if (transform.empty()) return curves;
  const Affine<double> place = affine_of(transform);
  for (Polyline& curve : curves)
    for (Vec3d& point : curve) point = place.point(point);
  return curves;
}

Polyline closed(std::vector<Vec3d> corners) {
  if (!corners.empty()) corners.push_back(corners.front());
  return corners;
}

double reach_of(const Bounds<double>& room) { return length(room.max - room.min) / 2; }
Vec3d middle_of(const Bounds<double>& room) { return room.min + (room.max - room.min) / 2.0; }

/// The twelve edges of a box; also used for shapes without an outline of their own.
std::vector<Polyline> edges_of(const Bounds<double>& box) {
  const auto corner = [&](int i) {
    return Vec3d((i & 1) != 0 ? box.max.x : box.min.x, (i & 2) != 0 ? box.max.y : box.min.y,
                 (i & 4) != 0 ? box.max.z : box.min.z);
  };
  std::vector<Polyline> curves;
  for (int i = 0; i < 8; ++i)
    for (const int bit : {1, 2, 4})
      if ((i & bit) == 0) curves.push_back({corner(i), corner(i | bit)});
  return curves;
}

template <class Other>
std::vector<Polyline> outline(const Other& shape, const Bounds<double>& room) {
  const Bounds<double> box = bounds(shape);
  return box.bounded() ? edges_of(box) : edges_of(room);
}

std::vector<Polyline> outline(const Sphere<double>& sphere, const Bounds<double>& /*room*/) {
  const double r = sphere.radius;
  const Vec3d x(r, 0, 0), y(0, r, 0), z(0, 0, r);
  return {circle(sphere.centre, x, y), circle(sphere.centre, y, z), circle(sphere.centre, z, x)};
}

std::vector<Polyline> outline(const Plane<double>& plane, const Bounds<double>& room) {
  const Vec3d normal = normalize(plane.normal);
  const PlaneAxes<double> frame = plane_axes(normal);
  const Vec3d middle = middle_of(room);
  const Vec3d centre = middle - dot(middle - plane.point, normal) * normal;
  const double reach = 1.2 * reach_of(room);
  constexpr int lines = 4;  // on either side of the middle
  std::vector<Polyline> curves;
  for (int i = -lines; i <= lines; ++i) {
    const double at = reach * i / lines;
    curves.push_back({centre + at * frame.u - reach * frame.v, centre + at * frame.u + reach * frame.v});
    curves.push_back({centre + at * frame.v - reach * frame.u, centre + at * frame.v + reach * frame.u});
  }
  return curves;
}

std::vector<Polyline> outline(const Prism<double>& prism, const Bounds<double>& /*room*/) {
  std::vector<Vec3d> low, high;
  std::vector<Polyline> curves;
  for (const Vec2d& corner : prism.corners) {
    low.emplace_back(corner, -prism.height / 2);
    high.emplace_back(corner, prism.height / 2);
    curves.push_back({low.back(), high.back()});
  }
  curves.push_back(closed(std::move(low)));
  curves.push_back(closed(std::move(high)));
  return curves;
}

template <QuadricKind Kind>
std::vector<Polyline> outline(const Quadric<double, Kind>& quadric, const Bounds<double>& room) {
  const detail::QuadricEquation equation = detail::equation_of(quadric);
  const Bounds<double> box = bounds(quadric);
  const double reach = 2 * reach_of(room);
  const double low = std::max(box.min.z, -reach), high = std::min(box.max.z, reach);
  if (!(low < high)) return {};
  // At height z the surface is an ellipse with half axes rx s and ry s; s^2 negative: none.
  const auto square = [&](double z) { return -(equation.zz * z * z + equation.linear * z + equation.constant); };
  const auto radius = [&](double z) { return std::sqrt(std::max(square(z), 0.0)); };
  constexpr int levels = 6, steps = 32, meridians = 8;
  std::vector<Polyline> curves;
  for (int i = 0; i <= levels; ++i) {
    const double z = low + (high - low) * i / levels, s = radius(z);
    if (square(z) > 1e-9) curves.push_back(circle({0, 0, z}, {quadric.radii.x * s, 0, 0}, {0, quadric.radii.y * s, 0}));
  }
  for (int m = 0; m < meridians; ++m) {
    const double angle = 2 * std::numbers::pi * m / meridians;
    Polyline curve;
    for (int i = 0; i <= steps; ++i) {
      // Denser towards the ends, where an ellipsoid is round.
      const double z = low + (high - low) * (1 - std::cos(std::numbers::pi * i / steps)) / 2;
      if (square(z) < -1e-9) {
        if (curve.size() > 1) curves.push_back(curve);
        curve.clear();
        continue;
      }
      const double s = radius(z);
      curve.emplace_back(quadric.radii.x * s * std::cos(angle), quadric.radii.y * s * std::sin(angle), z);
    }
    if (curve.size() > 1) curves.push_back(std::move(curve));
  }
  return curves;
}

std::vector<Polyline> outline(const Disk<double>& disk, const Bounds<double>& /*room*/) {
  const PlaneAxes<double> frame = plane_axes(normalize(disk.normal));
  const Vec3d u = disk.radius * frame.u, v = disk.radius * frame.v;
  return {circle(disk.centre, u, v), {disk.centre - u, disk.centre + u}, {disk.centre - v, disk.centre + v}};
}

std::vector<Polyline> outline(const Polygon<double>& polygon, const Bounds<double>& /*room*/) {
  std::vector<Polyline> curves{closed(polygon.outline)};
  for (const auto& hole : polygon.holes) curves.push_back(closed(hole));
  return curves;
}

std::vector<Polyline> outline(const MeshShape& shape, const Bounds<double>& /*room*/) {
  return shape.mesh ? *mesh_lines(shape.mesh) : std::vector<Polyline>();
}

/// What a group is drawn as where its objects are too many: the largest of them, in few points.
std::vector<Polyline> outline_of_largest(const Instance& instance, const Bounds<double>& room) {
  const Object* largest = nullptr;
  double most = 0;
  for (const Object& object : instance.content->group.objects) {
    const Bounds<double> own = bounds(object.shape);
    if (own.empty() || !own.bounded()) continue;
    const Bounds<double> box = image_of(affine_of(object.transform), own);
    if (const double size = length(box.max - box.min); size > most) largest = &object, most = size;
  }
  if (largest == nullptr) return {};
  const auto* nested = std::get_if<Instance>(&largest->shape);
  std::vector<Polyline> curves = nested != nullptr && nested->content
                                     ? placed(outline_of_largest(*nested, room), largest->transform)
                                     : outline_of(*largest, room);
  constexpr std::size_t every = 3;
  for (Polyline& curve : curves) {
    if (curve.size() <= round_pieces) continue;
    Polyline few;
    for (std::size_t i = 0; i + 1 < curve.size(); i += every) few.push_back(curve[i]);
    few.push_back(curve.back());
    curve = std::move(few);
  }
  return curves;
}

/// Adds the objects of a group, and those of groups in it down to `depth`. False if that is too much to be told apart,
/// and to be drawn in every frame.
bool add_contents(const Instance& instance, int depth, const Bounds<double>& room, std::size_t& points,
                  std::vector<Polyline>& curves) {
  constexpr std::size_t max_points = 6000;
  for (const Object& object : instance.content->group.objects) {
    const auto* nested = std::get_if<Instance>(&object.shape);
    std::vector<Polyline> own;
    if (nested == nullptr || !nested->content) {
      own = outline_of(object, room);
    } else if (depth == 0) {
      own = placed(outline_of_largest(*nested, room), object.transform);
    } else {
      if (!add_contents(*nested, depth - 1, room, points, own)) return false;
      own = placed(std::move(own), object.transform);
      curves.insert(curves.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
      continue;
    }
    for (const Polyline& curve : own) points += curve.size();
    if (points > max_points) return false;
    curves.insert(curves.end(), std::make_move_iterator(own.begin()), std::make_move_iterator(own.end()));
  }
  return true;
}

/// Its objects, as far down as there are few enough of them; else a box.
std::vector<Polyline> outline(const Instance& instance, const Bounds<double>& room) {
  if (!instance.content) return {};
  constexpr int deepest = 3;
  for (int depth = deepest; depth >= 0; --depth) {
    std::vector<Polyline> curves;
    std::size_t points = 0;
    if (add_contents(instance, depth, room, points, curves)) return curves;
  }
  return edges_of(bounds(instance));
}

std::vector<Polyline> outline(const Triangle<double>& triangle, const Bounds<double>& /*room*/) {
  return {closed({triangle.a, triangle.b, triangle.c})};
}

}  // namespace

std::vector<Polyline> outline_of(const Object& object, const Bounds<double>& room) {
  return placed(std::visit([&](const auto& shape) { return outline(shape, room); }, object.shape), object.transform);
}

}  // namespace raywalk
