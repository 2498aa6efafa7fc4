// Laws that hold for every closed shape, and the quadrics' own: a ray walked through all of its crossings goes in and
// out in turn, each crossing lies on the surface, and the normal points out.

#include "shape/box.h"
#include "shape/kinds.h"
#include "shape/prism.h"
#include "shape/quadric.h"
#include "shape/sphere.h"
#include "support/catch.h"

#include <random>

using namespace raywalk;
using namespace raywalk::test;

namespace {

template <class T>
struct Random {
  std::mt19937 engine{11};
  T operator()(T low = -1, T high = 1) {
    return low + (high - low) * static_cast<T>(engine() >> 8) / static_cast<T>(1 << 24);
  }
  Vec3<T> point(T size) {
    const T x = (*this)(-size, size);
    const T y = (*this)(-size, size);
    const T z = (*this)(-size, size);
    return {x, y, z};
  }
};

/// The quadric's left side minus its right one, written down again from the definitions.
template <class T, QuadricKind Kind>
long double implicit(const Quadric<T, Kind>& q, const Vec3<T>& p) {
  const long double x = p.x / static_cast<long double>(q.radii.x), y = p.y / static_cast<long double>(q.radii.y);
  const long double z = p.z, zr = z / q.radii.z;
  switch (Kind) {
    case QuadricKind::ellipsoid:
      return x * x + y * y + zr * zr - 1;
    case QuadricKind::elliptic_paraboloid:
      return x * x + y * y - z;
    case QuadricKind::cone:
      return x * x + y * y - z * z;
    case QuadricKind::cylinder:
      return x * x + y * y - 1;
    case QuadricKind::hyperboloid_one_sheet:
      return x * x + y * y - zr * zr - 1;
    case QuadricKind::hyperboloid_two_sheets:
      return x * x + y * y - zr * zr + 1;
  }
  return 0;
}

template <class T, QuadricKind Kind>
bool inside(const Quadric<T, Kind>& q, const Vec3<T>& p) {
  return implicit(q, p) < 0 && q.z_min < p.z && p.z < q.z_max;
}
template <class T>
bool inside(const Box<T>& b, const Vec3<T>& p) {
  return b.min.x < p.x && p.x < b.max.x && b.min.y < p.y && p.y < b.max.y && b.min.z < p.z && p.z < b.max.z;
}
template <class T>
bool inside(const Sphere<T>& s, const Vec3<T>& p) {
  return length(p - s.centre) < s.radius;
}

/// Walks each ray from crossing to crossing, departing from the part just met.
template <class T, class Solid>
void walk(const Solid& solid, int rays, Random<T>& random) {
  int wrong_turns = 0, off_surface = 0, inwards = 0, crossings = 0, out_of_bounds = 0, endless = 0;
  const Bounds<T> box = bounds(solid);
  for (int i = 0; i < rays; ++i) {
    Ray<T> ray{random.point(4), Vec3<T>(0)};
    ray.direction = random.point(T(1.25)) - ray.origin;
    if (i % 4 == 0) ray.direction[i / 4 % 3] = 0;
    if (ray.direction == Vec3<T>(0)) continue;
    ray.direction = normalize(ray.direction);
    bool was_inside = inside(solid, ray.origin);
    int departed = no_part, steps = 0;
    while (const auto intersection = intersect(solid, ray, infinity<T>, departed)) {
      if (++steps > 8) {
        ++endless;
        break;
      }
      ++crossings;
      // Between two crossings the ray stays on one side. Points within rounding of a surface tell nothing.
      if (intersection->t > T(1e-3) && inside(solid, ray.at(intersection->t / 2)) != was_inside) ++wrong_turns;
      const SurfacePoint<T> point = surface_at(solid, ray, *intersection);
      if (length(point.position - ray.at(intersection->t)) > T(sizeof(T) == 4 ? 2e-3 : 1e-9)) ++off_surface;
      if (std::abs(dot(point.normal, ray.direction)) > T(1e-2) && (dot(point.normal, ray.direction) < 0) == was_inside)
        ++inwards;
      for (int axis = 0; axis < 3; ++axis) {
        const T slack = T(sizeof(T) == 4 ? 1e-4 : 1e-9);
        if (point.position[axis] < box.min[axis] - slack || point.position[axis] > box.max[axis] + slack)
          ++out_of_bounds;
      }
      ray.origin = point.position;
      departed = intersection->part;
      was_inside = !was_inside;
    }
    if (inside(solid, ray.at(T(20)))) ++wrong_turns;  // beyond the last crossing
  }
  CHECK(crossings > rays / 20);
  CHECK(wrong_turns == 0);
  CHECK(off_surface == 0);
  CHECK(inwards == 0);
  CHECK(out_of_bounds == 0);
  CHECK(endless == 0);
}

}  // namespace

TEMPLATE_TEST_CASE("a ray goes in and out of a closed solid in turn", "[shape]", float, double) {
  using T = TestType;
  Random<T> random;
  walk<T>(Sphere<T>{{T(0.25), T(-0.5), 1}, T(1.5)}, 3000, random);
  walk<T>(Box<T>{{T(-1.5), -1, T(-0.5)}, {1, T(1.25), 2}}, 3000, random);
  for_each_kind([&](auto kind) {
    using Solid = Quadric<T, kind.value>;
    INFO(static_cast<int>(kind.value));
    walk<T>(Solid{{T(1.25), T(0.75), T(0.5)}, T(-1.5), T(1.75), true}, 3000, random);
    const T rz = kind.value == QuadricKind::hyperboloid_two_sheets ? T(0.5) : T(1.5);
    walk<T>(Solid{{T(1.25), T(0.75), rz}, T(0.25), T(1.75), true}, 3000, random);
  });
}

TEST_CASE("the bounds of a quadric hold its cap next to a pole", "[shape]") {
  Random<double> random;
  for (int i = 0; i < 100; ++i) {
    const double rz = 2 + random.point(1).x, inside = std::nextafter(rz, 0.0), outside = std::nextafter(rz, 9.0);
    const auto reach = [&](double z) { return std::sqrt(std::abs(rz - z) * (rz + z)) / rz; };
    CHECK(bounds(Ellipsoid<double>{{1, 1, rz}, inside, rz, true}).max.x == Approx(reach(inside)));
    CHECK(bounds(HyperboloidTwoSheets<double>{{1, 1, rz}, rz, outside, true}).max.x == Approx(reach(outside)));
  }
}

TEST_CASE("an open quadric is its wall alone, limits excluded", "[shape]") {
  for_each_kind([&](auto kind) {
    using Solid = Quadric<double, kind.value>;
    const Solid open{Vec3d(1), -1.5, 1.5, false}, closed{Vec3d(1), -1.5, 1.5, true};
    Random<double> random;
    int cap_hits = 0;
    for (int i = 0; i < 2000; ++i) {
      const Ray<double> ray{random.point(3), random.point(1)};
      const auto hit = intersect(open, ray, infinity<double>);
      if (hit) CHECK(hit->part == Solid::wall);
      const auto solid = intersect(closed, ray, infinity<double>);
      if (solid && solid->part != Solid::wall) ++cap_hits;
      // The caps can only bring the first crossing nearer.
      if (hit) CHECK((solid && solid->t <= hit->t));
    }
    if (kind.value != QuadricKind::ellipsoid) CHECK(cap_hits > 0);
  });
  // Exactly at the height of the rim.
  const Cylinder<double> tube{Vec3d(1), 1, 2, false};
  CHECK_FALSE(intersect(tube, Ray<double>{{-3, 0, 2}, {1, 0, 0}}, infinity<double>));
  CHECK(intersect(tube, Ray<double>{{-3, 0, std::nextafter(2.0, 0.0)}, {1, 0, 0}}, infinity<double>)->t == 2);
}

TEST_CASE("tangents and parallels of quadrics", "[shape]") {
  const Cylinder<double> tube{Vec3d(1)};
  CHECK(intersect(tube, Ray<double>{{1, -5, 0}, {0, 1, 0}}, infinity<double>)->t == 5);
  CHECK_FALSE(intersect(tube, Ray<double>{{1 + 1e-15, -5, 0}, {0, 1, 0}}, infinity<double>));
  CHECK_FALSE(intersect(tube, Ray<double>{{0, 0, 0}, {0, 0, 1}}, infinity<double>));
  // Parallel to a cone's side: one crossing, of the other side.
  const Cone<double> cone{Vec3d(1)};
  const auto across = intersect(cone, Ray<double>{{2, 0, 0}, {-1, 0, 1}}, infinity<double>);
  REQUIRE(across);
  CHECK(across->t == 1);
  // Through the apex, and along the axis.
  CHECK(intersect(cone, Ray<double>{{2, 0, 0}, {-1, 0, 0}}, infinity<double>)->t == 2);
  CHECK(intersect(cone, Ray<double>{{0, 0, -3}, {0, 0, 1}}, infinity<double>)->t == 3);
  // From a point of the wall, straight on: the other wall, whatever the size of the world.
  for (const double size : {1e-6, 1.0, 1e9}) {
    const Ellipsoid<double> bowl{Vec3d(size)};
    const auto far = intersect(bowl, Ray<double>{{size, 0, 0}, {-1, 0, 0}}, infinity<double>, 0);
    REQUIRE(far);
    CHECK(far->t == 2 * size);
    CHECK_FALSE(intersect(bowl, Ray<double>{{size, 0, 0}, {1, 0, 0}}, infinity<double>, 0));
  }
}

TEST_CASE("the box keeps its edges and knows a ray in a face's plane", "[shape]") {
  const Box<double> box{};
  CHECK(intersect(box, Ray<double>{{-3, 1, 1}, {1, 0, 0}}, infinity<double>)->t == 2);
  CHECK(intersect(box, Ray<double>{{-3, 1, 1}, {1, -0.0, 0.0}}, infinity<double>)->t == 2);
  CHECK_FALSE(intersect(box, Ray<double>{{-3, 1 + 1e-15, 0}, {1, 0, 0}}, infinity<double>));
  CHECK(intersect(box, Ray<double>{{-2, -2, -2}, {1, 1, 1}}, infinity<double>)->t == 1);
  const Box<double> flat{{-1, -1, 0}, {1, 1, 0}};
  CHECK(intersect(flat, Ray<double>{{0.5, 0.5, 3}, {0, 0, -1}}, infinity<double>)->t == 3);
}
