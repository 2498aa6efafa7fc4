#include "shape/plane.h"

#include "shape/meet.h"
#include "shape/numbers.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

struct Explanation {
  static constexpr bool wanted = true;
  double numerator = 0, denominator = 0;
  void plane(double numerator_, double denominator_) { numerator = numerator_, denominator = denominator_; }
};

}  // namespace

TEMPLATE_TEST_CASE("a ray meets a plane from either side, unless it runs along it", "", float, double) {
  using V = Vec3<TestType>;
  const Plane<TestType> floor{V(7, -3, 2), V(0, 0, 5)};  // the normal's length does not matter
  CHECK(meet(floor, {V(0, 0, 6), V(0, 0, -2)})->t == 2);
  CHECK(meet(floor, {V(0, 0, -2), V(1, 0, 1)})->t == 4);
  CHECK_FALSE(meet(floor, {V(0, 0, 6), V(0, 0, 1)}));
  CHECK_FALSE(meet(floor, {V(0, 0, 6), V(1, 0, 0)}));  // parallel
  CHECK_FALSE(meet(floor, {V(0, 0, 2), V(1, 1, 0)}));  // in the plane
  CHECK_FALSE(meet(floor, {V(0, 0, 2), V(0, 0, 1)}));  // starts on it: t = 0 is no crossing
  CHECK_FALSE(intersect(floor, {V(0, 0, 6), V(0, 0, -2)}, TestType(2)));
  CHECK(intersect(floor, {V(0, 0, 6), V(0, 0, -2)}, TestType(2.5)));
}

TEMPLATE_TEST_CASE("a ray that departs from a plane never meets it again", "", float, double) {
  using T = TestType;
  Numbers next(1);
  for (int i = 0; i < 2000; ++i) {
    const double scale = std::pow(10.0, next.integer(-6, 9));
    const Plane<T> plane{next.in_box<T>(scale), next.in_box<T>()};
    const Ray<T> ray{next.in_box<T>(scale), next.unit<T>()};
    const auto hit = meet(plane, ray);
    if (!hit) continue;
    const auto point = surface_at(plane, ray, *hit);
    if (intersect(plane, {point.position, next.unit<T>()}, infinity<T>, 0)) FAIL("met again at " << i);
    // The point lies on the plane, as far as numbers of its size can.
    const T off = dot(point.position - plane.point, point.normal);
    const T size = length(point.position) + length(plane.point);
    if (std::abs(off) > 8 * std::numeric_limits<T>::epsilon() * size) FAIL("off the plane by " << off);
    if (length(point.normal - normalize(plane.normal)) > 0) FAIL("another normal");
  }
}

TEST_CASE("the coordinates of a level plane are x and y from its point") {
  for (const double up : {1.0, -3.0}) {
    const Plane<double> floor{{1, 2, -1}, {0, 0, up}};
    const SurfacePoint<double> point{{4, 7, -1}, normalize(floor.normal)};
    CHECK(uv_at(floor, point, 0) == Vec2d(3, 5));
  }
}

TEST_CASE("the coordinates of any plane are lengths in two directions at right angles") {
  Numbers next(2);
  for (int i = 0; i < 1000; ++i) {
    Plane<double> plane{next.in_box<double>(5), next.unit<double>()};
    if (i % 3 == 0) plane.normal.z = 0;
    if (i % 6 == 0) plane.normal = {i % 12 ? -1.0 : 1.0, 0, 0};
    const Vec3d normal = normalize(plane.normal);
    // Three points of the plane: distances between their coordinates are distances in space.
    Vec3d p[2];
    Vec2d uv[2];
    for (int k = 0; k < 2; ++k) {
      const Vec3d loose = next.in_box<double>(5);
      p[k] = loose - dot(loose - plane.point, normal) * normal;
      uv[k] = uv_at(plane, SurfacePoint<double>{p[k], normal}, 0);
    }
    CHECK(length(uv[0] - uv[1]) == Approx(length(p[0] - p[1])));
    CHECK(length(uv[0]) == Approx(length(p[0] - plane.point)));
  }
}

TEST_CASE("v of an upright plane points up") {
  const Plane<double> wall{{0, 0, 0}, {0, -1, 0}};
  const Vec2d low = uv_at(wall, SurfacePoint<double>{{2, 0, 1}, {0, -1, 0}}, 0);
  const Vec2d high = uv_at(wall, SurfacePoint<double>{{2, 0, 4}, {0, -1, 0}}, 0);
  CHECK(high - low == Vec2d(0, 3));
}

TEST_CASE("the bounds of a plane are flat only along an axis") {
  const Bounds<double> level = bounds(Plane<double>{{1, 2, 3}, {0, 0, -2}});
  CHECK(level.min.z == 3);
  CHECK(level.max.z == 3);
  CHECK(level.min.x == -infinity<double>);
  CHECK_FALSE(level.bounded());
  const Bounds<double> slanted = bounds(Plane<double>{{1, 2, 3}, {0, 0.001, 1}});
  CHECK(slanted.max == Vec3d(infinity<double>));
  CHECK(slanted.min == Vec3d(-infinity<double>));
}

TEST_CASE("a plane is explained by a fraction") {
  Explanation numbers;
  const auto hit = intersect(Plane<double>{{0, 0, 2}, {0, 0, 1}}, Ray<double>{{0, 0, 6}, {1, 0, -2}}, infinity<double>,
                             no_part, numbers);
  REQUIRE(hit);
  CHECK(numbers.numerator == -4);
  CHECK(numbers.denominator == -2);
  CHECK(hit->t == numbers.numerator / numbers.denominator);
}
