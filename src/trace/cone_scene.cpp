#include "trace/cone_scene.h"

#include "math/elementary.h"
#include "math/overloaded.h"

#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace raywalk {

namespace {

ConeFace face_of(std::vector<Vec3d> corners, const Vec3d& normal, int part) {
  return {{std::move(corners)}, normalize(normal), part};
}

ConeFaces faces_of(const Box<double>& box, bool flat) {
  ConeFaces faces{{}, true};
  for (int axis = 0; axis < (flat ? 2 : 3); ++axis) {
    const int next = (axis + 1) % 3, other = (axis + 2) % 3;
    for (const bool high : {false, true}) {
      Vec3d normal{0.0};
      normal[axis] = high ? 1 : -1;
      const auto corner = [&](bool a, bool b) {
        Vec3d at;
        at[axis] = high ? box.max[axis] : box.min[axis];
        at[next] = a ? box.max[next] : box.min[next];
        at[other] = b ? box.max[other] : box.min[other];
        if (flat) at.z = 0;
        return at;
      };
      std::vector<Vec3d> corners{corner(false, false), corner(true, false), corner(true, true), corner(false, true)};
      if (flat) corners = axis == 0 ? std::vector{corners[0], corners[1]} : std::vector{corners[0], corners[3]};
      faces.faces.push_back(face_of(std::move(corners), normal, 2 * axis + (high ? 1 : 0)));
    }
  }
  return faces;
}

ConeFaces faces_of(const Prism<double>& prism, bool flat) {
  ConeFaces faces{{}, true};
  const double half = prism.height / 2, turn = prism.twice_signed_area() < 0 ? -1 : 1;
  std::vector<Vec3d> top, bottom;
  for (int side = 0; side < prism.sides(); ++side) {
    const Vec2d from = prism.corner(side), to = prism.corner_after(side), edge = to - from;
    const Vec3d normal = turn * Vec3d(edge.y, -edge.x, 0);
    if (flat)
      faces.faces.push_back(face_of({Vec3d(from, 0), Vec3d(to, 0)}, normal, side));
    else
      faces.faces.push_back(
          face_of({Vec3d(from, -half), Vec3d(to, -half), Vec3d(to, half), Vec3d(from, half)}, normal, side));
    top.push_back({from, half});
    bottom.push_back({from, -half});
  }
  if (flat) return faces;
  faces.faces.push_back(face_of(std::move(top), {0, 0, 1}, prism.top()));
  faces.faces.push_back(face_of(std::move(bottom), {0, 0, -1}, prism.bottom()));
  return faces;
}

ConeFaces faces_of(const Polygon<double>& polygon) {
  ConeFace face = face_of(polygon.outline, polygon.area_vector(), 0);
  for (const auto& hole : polygon.holes) face.loops.push_back(hole);
  return {{std::move(face)}, false};
}

ConeFaces faces_of(const Triangle<double>& triangle) {
  return {{face_of({triangle.a, triangle.b, triangle.c}, cross(triangle.b - triangle.a, triangle.c - triangle.a), 0)},
          false};
}

ConeFaces faces_of(const Disk<double>& disk) {
  constexpr int corners = 64;
  const Vec3d normal = normalize(disk.normal);
  const RayCone about = cone_about(disk.centre, normal, 1, 0, false);
  const double step = 2 * std::numbers::pi / corners;
  const double radius = disk.radius * std::sqrt(step / portable::sin(step));
  std::vector<Vec3d> outline;
  for (int i = 0; i < corners; ++i) {
    const auto [sin, cos] = portable::sin_cos(i * step);
    outline.push_back(disk.centre + radius * about.across({cos, sin}));
  }
  ConeFace face = face_of(std::move(outline), normal, 0);
  face.disc = ConeBall{disk.centre, disk.radius};
  return {{std::move(face)}, false};
}

}  // namespace

ConeBodies cone_bodies_of(const Scene& scene, bool flat) {
  std::vector<ConeBody> bodies;
  for (int index = 0; index < static_cast<int>(scene.objects.size()); ++index) {
    const Object& object = scene.objects[static_cast<std::size_t>(index)];
    const Bounds<double> box = bounds(object.shape);
    if (flat && !(box.min.z <= 0 && 0 <= box.max.z)) continue;
    const auto add = [&](auto shape) { bodies.push_back({std::move(shape), index}); };
    std::visit(Overloaded{
                   [&](const Sphere<double>& sphere) { add(ConeBall{sphere.centre, sphere.radius}); },
                   [&](const Plane<double>& plane) {
                     if (!flat || !is_level(plane)) add(ConeWall{plane.point, normalize(plane.normal)});
                   },
                   [&](const Box<double>& its) { add(faces_of(its, flat)); },
                   [&](const Prism<double>& prism) { add(faces_of(prism, flat)); },
                   [&](const Polygon<double>& polygon) { add(faces_of(polygon)); },
                   [&](const Triangle<double>& triangle) { add(faces_of(triangle)); },
                   [&](const Disk<double>& disk) { add(faces_of(disk)); },
                   [](const auto&) {},
               },
               static_cast<const ObjectShape::Kinds&>(object.shape));
  }
  return ConeBodies(std::move(bodies));
}

}  // namespace raywalk
