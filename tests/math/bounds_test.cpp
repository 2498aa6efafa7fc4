#include "math/bounds.h"

#include "support/catch.h"

using namespace raywalk;

TEMPLATE_TEST_CASE("bounds start empty and grow by what they include", "", float, double) {
  using V = Vec3<TestType>;
  Bounds<TestType> box;
  CHECK(box.empty());
  box.include(V(1, -2, 3));
  CHECK_FALSE(box.empty());
  CHECK(box.min == V(1, -2, 3));
  CHECK(box.max == V(1, -2, 3));
  box.include(V(-1, 5, 3));
  CHECK(box.min == V(-1, -2, 3));
  CHECK(box.max == V(1, 5, 3));
  CHECK(box.bounded());
}

TEMPLATE_TEST_CASE("bounds include other bounds", "", float, double) {
  using V = Vec3<TestType>;
  Bounds<TestType> box{V(0), V(1)};
  box.include(Bounds<TestType>{V(-1, 0.5, 0.5), V(0.5, 2, 0.5)});
  CHECK(box.min == V(-1, 0, 0));
  CHECK(box.max == V(1, 2, 1));

  SECTION("nothing adds nothing") {
    box.include(Bounds<TestType>{});
    CHECK(box.min == V(-1, 0, 0));
    CHECK(box.max == V(1, 2, 1));
    Bounds<TestType> none;
    none.include(Bounds<TestType>{});
    CHECK(none.empty());
  }
  SECTION("what has no end stays without one") {
    box.include(Bounds<TestType>{V(-infinity<TestType>), V(infinity<TestType>)});
    CHECK_FALSE(box.bounded());
    CHECK_FALSE(box.empty());
  }
}

TEMPLATE_TEST_CASE("points on a ray are counted in multiples of its direction", "", float, double) {
  using V = Vec3<TestType>;
  const Ray<TestType> ray{V(1, 2, 3), V(0, -2, 4)};
  CHECK(ray.at(TestType(0.5)) == V(1, 1, 5));
  CHECK(ray.departure == Departure{-1, 0});
}
