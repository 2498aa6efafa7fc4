#include "shape/shape.h"

#include "shape/numbers.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

TEST_CASE("a shape answers as what it holds") {
  const Sphere<double> sphere{{1, 2, 3}, 2};
  const Plane<double> plane{{0, 0, 1}, {0, 0, 2}};
  const Prism<double> prism{{{0, 0}, {2, 0}, {0, 2}}, 2};
  const Ray<double> ray{{0.5, 0.5, 9}, {0.01, 0.02, -1}};
  const auto compare = [&](const auto& held) {
    const Shape<double> shape = held;
    const auto expected = intersect(held, ray, 100.0);
    const auto got = intersect(shape, ray, 100.0);
    REQUIRE(expected);
    REQUIRE(got);
    CHECK(got->t == expected->t);
    CHECK(got->part == expected->part);
    CHECK(surface_at(shape, ray, *got).position == surface_at(held, ray, *expected).position);
    CHECK(surface_at(shape, ray, *got).normal == surface_at(held, ray, *expected).normal);
    const auto point = surface_at(held, ray, *expected);
    CHECK(uv_at(shape, point, got->part) == uv_at(held, point, expected->part));
    CHECK(bounds(shape).min == bounds(held).min);
    CHECK(bounds(shape).max == bounds(held).max);
  };
  compare(sphere);
  compare(plane);
  compare(prism);
}

TEST_CASE("a shape in another scalar has each number rounded once") {
  const double third = 1.0 / 3;
  const float rounded = static_cast<float>(third);
  const auto sphere = std::get<Sphere<float>>(shape_cast<float>(Shape<double>(Sphere<double>{{third, 1, 2}, third})));
  CHECK(sphere == Sphere<float>{{rounded, 1, 2}, rounded});
  const auto plane =
      std::get<Plane<float>>(shape_cast<float>(Shape<double>(Plane<double>{{third, 0, 0}, {0, third, 0}})));
  CHECK(plane == Plane<float>{{rounded, 0, 0}, {0, rounded, 0}});
  const auto prism =
      std::get<Prism<float>>(shape_cast<float>(Shape<double>(Prism<double>{{{0, third}, {1, 0}, {1, 1}}, third})));
  CHECK(prism == Prism<float>{{{0, rounded}, {1, 0}, {1, 1}}, rounded});
  // To itself: nothing changes.
  const Shape<double> same = Prism<double>{{{0, third}, {1, 0}, {1, 1}}, third};
  CHECK(shape_cast<double>(same) == same);
}
