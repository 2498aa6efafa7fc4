// Where a place of a surface lies on what is drawn on it: (u, v) by value, of every shape that its own test leaves out,
// and of all of them under a map. Each place is met by a ray, so that the part which the ray names counts too.

#include "math/transform.h"
#include "shape/kinds.h"
#include "shape/object_transform.h"
#include "support/catch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;

namespace {

/// A place with its part, and its coordinates.
template <class T>
struct Met {
  int part;
  Vec2<T> uv;
};

template <class T>
Met<T> meet_head_on(const Shape<T>& shape, const Vec3d& origin, const Vec3d& direction) {
  const Ray<T> ray{Vec3<T>(origin), Vec3<T>(direction)};
  const auto intersection = intersect(shape, ray, infinity<T>);
  REQUIRE(intersection);
  return {intersection->part, uv_at(shape, surface_at(shape, ray, *intersection), intersection->part)};
}

/// Through the place straight from the front: `normal` points to where the ray comes from.
template <class T>
Vec2<T> uv_seen(const Shape<T>& shape, const Vec3d& place, const Vec3d& normal) {
  return meet_head_on(shape, place + 2.0 * normal, -normal).uv;
}

template <class T>
void expect(const Vec2<T>& uv, double u, double v) {
  const double rounding = 100 * static_cast<double>(std::numeric_limits<T>::epsilon());
  CHECK(static_cast<double>(uv.x) == Approx(u).epsilon(rounding).margin(rounding));
  CHECK(static_cast<double>(uv.y) == Approx(v).epsilon(rounding).margin(rounding));
}

/// A plane's normal, of any length, and two steps along its own directions, with their lengths.
struct Leaning {
  Vec3d normal, u, v;
  double u_length, v_length;
};

const double root2 = std::sqrt(2.0);
// Up to 60 degrees from level u is x, as nearly as the plane lets it; from there on u is level and v climbs.
const std::array<Leaning, 10> leanings{{{{0, 0, 3}, {1, 0, 0}, {0, 1, 0}, 1, 1},
                                        {{0, -3, 4}, {2, 0, 0}, {0, 4, 3}, 2, 5},
                                        {{3, 0, 4}, {4, 0, -3}, {0, 2, 0}, 5, 2},
                                        {{1, 2, 2}, {4, -1, -1}, {0, 1, -1}, 3 * root2, root2},
                                        {{0, -2, 0}, {3, 0, 0}, {0, 0, 1}, 3, 1},
                                        {{1, 0, 0}, {0, 3, 0}, {0, 0, 1}, 3, 1},
                                        {{3, -4, 0}, {4, 3, 0}, {0, 0, 2}, 5, 2},
                                        {{0, -12, 5}, {2, 0, 0}, {0, 5, 12}, 2, 13},
                                        {{12, 0, 5}, {0, 2, 0}, {-5, 0, 12}, 2, 13},
                                        {{2, -2, 1}, {1, 1, 0}, {-1, 1, 4}, root2, 3 * root2}}};

/// Takes each plane, from both sides, to each of its quarters: `body(plane, place, u, v, right, up)`, where u and v are
/// the coordinates expected `place` away from where they start, and the quarter lies along `right` and `up`.
template <class Body>
void for_each_quarter(Body body) {
  for (const Leaning& plane : leanings)
    for (const double front : {1.0, -1.0})
      for (const double right : {1.0, -1.0})
        for (const double up : {1.0, -1.0}) {
          CAPTURE(plane.normal.x, plane.normal.y, plane.normal.z, front, right, up);
          // Not the same share of both, so that one is not taken for the other.
          body(front * plane.normal, right * plane.u + up * 0.5 * plane.v, right * plane.u_length,
               up * 0.5 * plane.v_length, right * plane.u, up * plane.v);
        }
}

/// How many times rx and ry the wall is wide at height z, and at which height just once, from the definitions.
double width(QuadricKind kind, double rz, double z) {
  const double share = z * z / (rz * rz);
  switch (kind) {
    case QuadricKind::ellipsoid:
      return std::sqrt(1 - share);
    case QuadricKind::elliptic_paraboloid:
      return std::sqrt(z);
    case QuadricKind::cone:
      return std::abs(z);
    case QuadricKind::cylinder:
      return 1;
    case QuadricKind::hyperboloid_one_sheet:
      return std::sqrt(1 + share);
    case QuadricKind::hyperboloid_two_sheets:
      return std::sqrt(share - 1);
  }
  return 0;
}
double height_of_its_radii(QuadricKind kind, double rz) {
  if (kind == QuadricKind::elliptic_paraboloid || kind == QuadricKind::cone) return 1;
  return kind == QuadricKind::hyperboloid_two_sheets ? std::sqrt(2.0) * rz : 0;
}

}  // namespace

TEMPLATE_TEST_CASE("the coordinates of each face of a box run along its axes from its lower left corner", "", float,
                   double) {
  using T = TestType;
  const Box<T> box{Vec3<T>(-1, 2, 3), Vec3<T>(3, 7, 12)};  // 4 by 5 by 9
  struct Look {
    Vec3d from, along;
    int part;
    double u, v;
  };
  // All through (0, 3, 8), which is (1, 1, 5) from the low corner and (3, 4, 4) from the high one.
  const std::array<Look, 6> looks{{{{-9, 3, 8}, {1, 0, 0}, 0, 4, 5},
                                   {{9, 3, 8}, {-1, 0, 0}, 1, 1, 5},
                                   {{0, -9, 8}, {0, 1, 0}, 2, 1, 5},
                                   {{0, 19, 8}, {0, -1, 0}, 3, 3, 5},
                                   {{0, 3, -9}, {0, 0, 1}, 4, 3, 1},
                                   {{0, 3, 19}, {0, 0, -1}, 5, 1, 1}}};
  for (const Look& look : looks) {
    CAPTURE(look.part);
    const Met<T> met = meet_head_on<T>(box, look.from, look.along);
    CHECK(met.part == look.part);
    CHECK(met.uv == Vec2<T>(Vec2d(look.u, look.v)));
  }
}

TEMPLATE_TEST_CASE("the coordinates of a plane are steps along its own two directions", "", float, double) {
  using T = TestType;
  const Vec3d point(1, -2, 3);
  for_each_quarter([&](const Vec3d& normal, const Vec3d& place, double u, double v, const Vec3d&, const Vec3d&) {
    const Plane<T> plane{Vec3<T>(point), Vec3<T>(normal)};
    expect(uv_seen<T>(plane, point + place, normal), u, v);
    expect(uv_seen<T>(plane, point + place, -normal), u, v);
  });
}

TEMPLATE_TEST_CASE("the coordinates of a disk are steps along its plane's directions from the centre", "", float,
                   double) {
  using T = TestType;
  const Vec3d centre(1, -2, 3);
  for_each_quarter([&](const Vec3d& normal, const Vec3d& place, double u, double v, const Vec3d&, const Vec3d&) {
    for (const double radius : {20.0, 40.0}) {  // which is no unit
      const Disk<T> disk{Vec3<T>(centre), Vec3<T>(normal), static_cast<T>(radius)};
      expect(uv_seen<T>(disk, centre + place, normal), u, v);
    }
  });
}

TEMPLATE_TEST_CASE("the coordinates of a polygon are steps along its plane's directions from the first corner", "",
                   float, double) {
  using T = TestType;
  const Vec3d corner(1, -2, 3);
  for_each_quarter(
      [&](const Vec3d& normal, const Vec3d& place, double u, double v, const Vec3d& right, const Vec3d& up) {
        // In either turn, and with a hole beside the place, whose corners count for nothing.
        Polygon<T> polygon;
        for (const Vec3d& away : {Vec3d(0.0), 2.0 * right, 2.0 * (right + up), 2.0 * up})
          polygon.outline.emplace_back(corner + away);
        const Vec3d beside = corner + 1.5 * (right + up);
        polygon.holes = {{Vec3<T>(beside), Vec3<T>(beside + 0.25 * right), Vec3<T>(beside + 0.25 * up)}};
        expect(uv_seen<T>(polygon, corner + place, normal), u, v);
        std::swap(polygon.outline[1], polygon.outline[3]);
        expect(uv_seen<T>(polygon, corner + place, normal), u, v);
        // From another first corner the way is another.
        std::rotate(polygon.outline.begin(), polygon.outline.begin() + 2, polygon.outline.end());
        const double u_length = std::abs(u), v_length = 2 * std::abs(v);
        expect(uv_seen<T>(polygon, corner + place, normal), u - std::copysign(2 * u_length, u),
               v - std::copysign(2 * v_length, v));
      });
}

TEMPLATE_TEST_CASE("the coordinates of a triangle are lengths along its first edge and across it", "", float, double) {
  using T = TestType;
  using V = Vec3<T>;
  // Three directions at right angles, each 7 long: the first is that of the edge, the third is the normal.
  const Vec3d edge(2, 3, 6), across(3, -6, 2), normal(6, 2, -3), a(1, 2, 3);
  const auto at = [&](double u, double v) { return a + u / 7 * edge + v / 7 * across; };
  // c lies 35 across, before a or behind b: v is across whatever way c leans.
  for (const double c_along : {-7.0, 7.0, 28.0}) {
    CAPTURE(c_along);
    const Triangle<T> triangle{V(a), V(at(21, 0)), V(at(c_along, 35))};
    for (const Vec2d& uv : {Vec2d(7, 3.5), Vec2d(10, 7), Vec2d(14, 1)}) {
      expect(uv_seen<T>(triangle, at(uv.x, uv.y), normal), uv.x, uv.y);
      expect(uv_seen<T>(triangle, at(uv.x, uv.y), -normal), uv.x, uv.y);
    }
    // The other turn: its front is behind, and v still grows from the edge to c.
    const Triangle<T> turned{V(a), V(at(21, 0)), V(at(c_along, -35))};
    expect(uv_seen<T>(turned, at(10, -7), normal), 10, 7);
  }
}

TEMPLATE_TEST_CASE("the coordinates of a quadric's wall are the angle from +x times rx, and z", "", float, double) {
  using T = TestType;
  for_each_kind([](auto kind) {
    // Each wall reaches the heights tried; closed, so that a ray cannot look past it.
    const double rz = kind.value == QuadricKind::hyperboloid_two_sheets ? 0.5 : 2;
    const Quadric<T, kind.value> quadric{Vec3<T>(3, T(0.5), static_cast<T>(rz)), T(-1.5), T(1.5), true};
    for (const double z : {-1.0, -0.75, 0.75, 1.0}) {
      if (kind.value == QuadricKind::elliptic_paraboloid && z < 0) continue;
      // The angle is a circle's that is drawn out into the ellipse; all four quarters, both sides of the seam at -x.
      for (const double angle : {0.0, 0.5, 1.25, 2.0, 3.1, -0.25, -1.0, -2.0, -3.1}) {
        CAPTURE(static_cast<int>(kind.value), z, angle);
        const double size = width(kind.value, rz, z);
        const Vec3d out(3 * size * std::cos(angle), 0.5 * size * std::sin(angle), 0);
        const Met<T> met = meet_head_on<T>(quadric, 3.0 * out + Vec3d(0, 0, z), -out);
        CHECK(met.part == 0);
        expect(met.uv, 3 * angle, z);
      }
    }
  });
}

TEST_CASE("where a round wall is as wide as its radii, u is the length walked around it") {
  for_each_kind([](auto kind) {
    const double rz = 0.75, radius = 2.5, z = height_of_its_radii(kind.value, rz);
    CAPTURE(static_cast<int>(kind.value));
    const Quadric<double, kind.value> quadric{Vec3d(radius, radius, rz)};
    for (const double turn : {1.0, -1.0}) {
      Vec3d at(radius, 0, z);
      double walked = 0;
      for (int step = 1; step <= 3000; ++step) {
        const double angle = turn * step / 1000;
        const Vec3d next(radius * std::cos(angle), radius * std::sin(angle), z);
        walked += length(next - at);
        at = next;
        if (step % 500 != 0) continue;
        const Vec3d out(std::cos(angle), std::sin(angle), 0);
        CHECK(meet_head_on<double>(quadric, at + out, -out).uv.x == Approx(turn * walked).epsilon(1e-6));
      }
    }
  });
}

TEMPLATE_TEST_CASE("the coordinates of a quadric's caps are x and y, and -x of the lower one", "", float, double) {
  using T = TestType;
  for_each_kind([](auto kind) {
    CAPTURE(static_cast<int>(kind.value));
    const T rz = kind.value == QuadricKind::hyperboloid_two_sheets ? T(0.5) : T(2);
    const T low = kind.value == QuadricKind::elliptic_paraboloid ? T(0.5) : T(-1);
    const Quadric<T, kind.value> quadric{Vec3<T>(3, T(0.5), rz), low, 1, true};
    for (const Vec2d& xy : {Vec2d(0.5, 0.125), Vec2d(-0.25, 0.25), Vec2d(0.75, -0.125), Vec2d(-1, -0.0625)}) {
      const Met<T> bottom = meet_head_on<T>(quadric, {xy.x, xy.y, -4}, {0, 0, 1});
      CHECK(bottom.part == 1);
      CHECK(bottom.uv == Vec2<T>(Vec2d(-xy.x, xy.y)));
      const Met<T> top = meet_head_on<T>(quadric, {xy.x, xy.y, 4}, {0, 0, -1});
      CHECK(top.part == 2);
      CHECK(top.uv == Vec2<T>(xy));
    }
  });
}

TEST_CASE("a map moves, turns, stretches and mirrors what is drawn on a floor") {
  const Shape<double> floor = Plane<double>{{1, 2, 0}, {0, 0, 1}};
  const auto uv = [&](const Affine<double>& map, const Vec3d& world, const Vec3d& normal) {
    const auto place = object_transform<double>(map);
    REQUIRE(place);
    return uv_at(floor, *place, SurfacePoint<double>{world, normal}, 0);
  };
  const Vec3d up(0, 0, 1);
  CHECK(uv(translation(Vec3d(10, 20, 30)), {14, 27, 30}, up) == Vec2d(3, 5));
  CHECK(uv(rotation(up, 90.0), {-7, 4, 0}, up) == Vec2d(3, 5));                     // (4, 7) turned to the left
  CHECK(uv(scaling(Vec3d(2, 4, 8)), {8, 28, 0}, up) == Vec2d(3, 5));                // its own lengths, not the world's
  CHECK(uv(scaling(Vec3d(-1, 1, 1)), {-4, 7, 0}, up) == Vec2d(3, 5));               // seen in a mirror
  CHECK(uv(rotation(Vec3d(1, 0, 0), 90.0), {4, 0, 7}, {0, -1, 0}) == Vec2d(3, 5));  // stood up: a wall facing -y
}

TEST_CASE("a map turns, stretches and mirrors what is drawn on a ball") {
  const Shape<double> ball = Sphere<double>{{0, 0, 0}, 2};
  const auto uv = [&](const Affine<double>& map, const Vec3d& world, const Vec3d& normal) {
    const auto place = object_transform<double>(map);
    REQUIRE(place);
    return uv_at(ball, *place, SurfacePoint<double>{world, normal}, 0);
  };
  const double quarter = 3.14159265358979323846;  // of the way around, whose radius is 2
  expect(uv(rotation(Vec3d(0, 0, 1), 90.0), {-2, 0, 0}, {-1, 0, 0}), quarter, 0);
  expect(uv(rotation(Vec3d(1, 0, 0), 90.0), {0, 0, 2}, {0, 0, 1}), quarter, 0);
  expect(uv(scaling(Vec3d(-1, 1, 1)), {-2, 0, 0}, {-1, 0, 0}), 0, 0);
  expect(uv(scaling(Vec3d(1, -1, 1)), {0, -2, 0}, {0, -1, 0}), quarter, 0);
  CHECK(uv(scaling(Vec3d(1, 1, -1)), {0, 0, -2}, {0, 0, -1}).y == Approx(quarter));
  // An eighth of the way up, on a ball twice as wide: the normal is steeper than the way there.
  expect(uv(scaling(Vec3d(2, 2, 1)), {std::sqrt(8.0), 0, std::sqrt(2.0)}, normalize(Vec3d(1, 0, 2))), 0, quarter / 2);
}

TEMPLATE_TEST_CASE("a place keeps its coordinates under a map", "", float, double) {
  using T = TestType;
  /// A shape, a ray in its own space, and the coordinates of what that meets.
  struct Sight {
    std::string name;
    Shape<T> shape;
    Vec3d from, along;
    double u, v;
  };
  using V = Vec3<T>;
  const Vec3d out(std::cos(0.7) * std::cos(0.4), std::sin(0.7) * std::cos(0.4), std::sin(0.4)), lean(0, -3, 4);
  const Vec3d rim(2 * std::cos(2.0), std::sin(2.0), 0);
  const std::vector<Sight> sights{
      {"sphere", Sphere<T>{V(1, 0, 0), 2}, Vec3d(1, 0, 0) + 5.0 * out, -out, 1.4, 0.8},
      {"plane", Plane<T>{V(1, 2, 0), V(0, 0, 1)}, {4, 7, 3}, {0, 0, -1}, 3, 5},
      {"box", Box<T>{V(-1, 2, 3), V(3, 7, 12)}, {9, 3, 8}, {-1, 0, 0}, 1, 5},
      {"wall", Cylinder<T>{V(2, 1, 1), -1, 1, true}, 3.0 * rim + Vec3d(0, 0, 0.5), -rim, 4, 0.5},
      {"cap", Cylinder<T>{V(2, 1, 1), -1, 1, true}, {1, -0.25, 4}, {0, 0, -1}, 1, -0.25},
      {"disk", Disk<T>{V(1, 2, 3), V(lean), 9}, Vec3d(3, 6, 6) + lean, -lean, 2, 5},
      {"polygon", Polygon<T>{{V(0), V(9, 0, 0), V(9, 8, 6), V(0, 8, 6)}, {}}, Vec3d(2, 4, 3) + lean, -lean, 2, 5},
      {"triangle", Triangle<T>{V(1, 0, 0), V(1, 9, 0), V(1, 0, 9)}, {5, 2, 3}, {-1, 0, 0}, 2, 3},
      {"prism", Prism<T>{{{-1, -2}, {5, -2}, {0, 4}}, 2}, {1, -6, 0.25}, {0, 1, 0}, 2, 0.25}};
  const Affine<double> turn = rotation(Vec3d(1, 2, 3), 40.0), stretch = scaling(Vec3d(2, 3, 0.5));
  const std::array<Affine<double>, 7> maps{{translation(Vec3d(5, -6, 7)), turn, stretch, scaling(Vec3d(-1, 1, 1)),
                                            scaling(Vec3d(1, 1, -1)), translation(Vec3d(3, 2, 1)) * turn * stretch,
                                            scaling(Vec3d(1, -2, 1)) * turn * stretch * turn}};
  for (std::size_t i = 0; i < maps.size(); ++i) {
    const auto place = object_transform<T>(maps[i]);
    REQUIRE(place);
    for (const Sight& sight : sights) {
      CAPTURE(i, sight.name);
      const Ray<T> ray{V(maps[i].point(sight.from)), V(maps[i].direction(sight.along))};
      const auto intersection = intersect(sight.shape, into_object_space(*place, ray), infinity<T>);
      REQUIRE(intersection);
      const SurfacePoint<T> point = surface_at(sight.shape, *place, ray, *intersection);
      expect(uv_at(sight.shape, *place, point, intersection->part), sight.u, sight.v);
    }
  }
}

TEST_CASE("what is drawn on a solid is read from left to right on each of its faces") {
  std::vector<std::pair<std::string, Shape<double>>> solids{
      {"sphere", Sphere<double>{{0, 0, 0}, 2}},
      {"box", Box<double>{{-1, -2, -1.5}, {3, 1, 2}}},
      {"prism", Prism<double>{{{-1, -2}, {5, -2}, {1, 1}, {0, 4}}, 2}},
      {"prism of clockwise corners", Prism<double>{{{0, 4}, {1, 1}, {5, -2}, {-1, -2}}, 2}}};
  for_each_kind([&](auto kind) {
    const double rz = kind.value == QuadricKind::hyperboloid_two_sheets ? 0.5 : 2;
    const double low = kind.value == QuadricKind::elliptic_paraboloid ? 0.25 : -1;
    solids.emplace_back("quadric " + std::to_string(static_cast<int>(kind.value)),
                        Quadric<double, kind.value>{Vec3d(3, 2, rz), low, 1, true});
  });
  for (const auto& [name, solid] : solids) {
    std::set<int> parts;
    for (int i = 0; i < 2000; ++i) {
      // From all sides, the low ones first, towards places near the middle.
      const double height = (i + 0.5) / 1000 - 1, round = std::sqrt(1 - height * height), turn = 2.4 * i;
      const Vec3d out(round * std::cos(turn), round * std::sin(turn), height);
      const Vec3d towards(0.3 * std::cos(1.7 * i), 0.3 * std::sin(1.3 * i), 0.3 * std::cos(0.9 * i));
      const Ray<double> ray{towards + 20.0 * out, -out};
      const auto met = intersect(solid, ray, infinity<double>);
      if (!met) continue;
      const SurfacePoint<double> point = surface_at(solid, ray, *met);
      const PlaneAxes<double> axes = plane_axes(point.normal);
      const Vec2d along_u = uv_derivative(solid, point, met->part, axes.u);
      const Vec2d along_v = uv_derivative(solid, point, met->part, axes.v);
      const double turned = dot(cross(axes.u, axes.v), point.normal);  // 1 or -1
      CAPTURE(name, met->part, i);
      CHECK(turned * (along_u.x * along_v.y - along_u.y * along_v.x) > 0);
      parts.insert(met->part);
    }
    CAPTURE(name);
    CHECK(parts.size() == (name == "sphere" ? 1 : name == "box" || name[0] == 'p' ? 6 : 3));
  }
}

TEST_CASE("rounding does not turn the frame of an upright surface") {
  for (int degrees = 0; degrees < 360; degrees += 15) {
    const double angle = degrees * 3.14159265358979323846 / 180;
    const Vec3d normal(std::cos(angle), std::sin(angle), 0);
    const PlaneAxes<double> frame = plane_axes(normal);
    for (const Vec3d& off : {Vec3d(0, 0, 1e-17), Vec3d(0, 0, -1e-17), Vec3d(1e-16, 0, 0), Vec3d(0, -1e-16, 0)})
      for (const double side : {1.0, -1.0}) {
        const PlaneAxes<double> other = plane_axes(side * (normal + off));
        CAPTURE(degrees, side, off.x, off.y, off.z);
        CHECK(dot(frame.u, other.u) > 0.999);
        CHECK(dot(frame.v, other.v) > 0.999);
      }
  }
}
