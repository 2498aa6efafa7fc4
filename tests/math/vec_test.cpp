#include "math/vec.h"

#include <limits>

#include "support/catch.h"

using namespace raywalk;

TEMPLATE_TEST_CASE("products of vectors follow the right hand", "", float, double) {
  using V = Vec3<TestType>;
  const V x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
  CHECK(cross(x, y) == z);
  CHECK(cross(y, z) == x);
  CHECK(cross(z, x) == y);
  CHECK(dot(V(1, 2, 3), V(4, -5, 6)) == 12);
  CHECK(cross(V(1, 2, 3), V(4, 5, 6)) == V(-3, 6, -3));
  CHECK(dot(Vec2<TestType>(3, 4), Vec2<TestType>(-2, 5)) == 14);
  CHECK(cross(Vec2<TestType>(1, 0), Vec2<TestType>(0, 1)) == 1);  // the second lies to the left of the first
  CHECK(cross(Vec2<TestType>(3, 4), Vec2<TestType>(6, 8)) == 0);
}

TEMPLATE_TEST_CASE("lengths and unit vectors", "", float, double) {
  using V = Vec3<TestType>;
  CHECK(length(V(2, 3, 6)) == 7);
  CHECK(length(Vec2<TestType>(3, -4)) == 5);
  const V unit = normalize(V(2, 3, 6));
  CHECK(std::abs(length(unit) - 1) <= 2 * std::numeric_limits<TestType>::epsilon());
  CHECK(unit.x == TestType(2) / 7);
  // What lies in the plan stays there exactly: the strip depends on it.
  CHECK(normalize(V(TestType(0.1), TestType(-0.7), 0)).z == 0);
}

TEMPLATE_TEST_CASE("one step brings a length of nearly 1 back to 1", "", float, double) {
  using T = TestType;
  const T eps = std::numeric_limits<T>::epsilon();
  for (int i = 1; i < 200; ++i) {
    const T angle = static_cast<T>(i) / 7;
    const Vec3<T> unit = normalize(Vec3<T>(std::cos(angle), std::sin(angle), std::sin(3 * angle)));
    for (const T off : {-64 * eps, -3 * eps, T(0), eps, 64 * eps})
      if (std::abs(length(renormalize((1 + off) * unit)) - 1) > 3 * eps) FAIL("at " << i << ", off by " << off);
  }
  CHECK(renormalize(Vec3<T>(0, 1, 0)) == Vec3<T>(0, 1, 0));
  CHECK(renormalize(Vec3<T>(T(0.3), T(0.2), 0)).z == 0);
}

TEMPLATE_TEST_CASE("components and tests of vectors", "", float, double) {
  using V = Vec3<TestType>;
  CHECK(max_component(V(1, 2, 3)) == 3);
  CHECK(max_component(V(1, 3, 2)) == 3);
  CHECK(max_component(V(3, 1, 2)) == 3);
  CHECK(max_component(V(-3, -1, -2)) == -1);
  CHECK(is_black(V(0)));
  CHECK(is_black(V(TestType(-0.0))));
  CHECK_FALSE(is_black(V(0, 0, std::numeric_limits<TestType>::denorm_min())));
  CHECK(plan(V(1, 2, 3)) == Vec2<TestType>(1, 2));
  const TestType nan = std::numeric_limits<TestType>::quiet_NaN();
  const TestType inf = std::numeric_limits<TestType>::infinity();
  CHECK(is_finite(V(1, 2, std::numeric_limits<TestType>::max())));
  CHECK_FALSE(is_finite(V(nan, 0, 0)));
  CHECK_FALSE(is_finite(V(0, inf, 0)));
  CHECK_FALSE(is_finite(V(0, 0, -inf)));
}
