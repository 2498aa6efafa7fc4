#include "math/transform.h"
#include "support/catch.h"

using namespace raywalk;

TEST_CASE("the step written last acts first", "[math]") {
  const Affine<double> m = translation<double>({1, 0, 0}) * scaling<double>({2, 2, 2});
  CHECK(m.point({1, 1, 1}) == Vec3d(3, 2, 2));
  CHECK(m.direction({1, 1, 1}) == Vec3d(2, 2, 2));
}

TEST_CASE("rotations are right-handed and quarter turns exact", "[math]") {
  CHECK(rotation<double>({0, 0, 5}, 90).point({1, 0, 0}) == Vec3d(0, 1, 0));
  CHECK(rotation<double>({0, 0, 1}, -270).point({1, 0, 0}) == Vec3d(0, 1, 0));
  CHECK(rotation<double>({1, 0, 0}, 180).point({0, 1, 0}) == Vec3d(0, -1, 0));
  CHECK(rotation<double>({0, 1, 0}, 360).point({1, 2, 3}) == Vec3d(1, 2, 3));
  const Vec3d turned = rotation<double>({1, 1, 1}, 120).point({1, 0, 0});
  CHECK(turned.y == Approx(1));
}

TEST_CASE("an inverse undoes, and a singular map has none", "[math]") {
  const Affine<double> m = rotation<double>({1, 2, 3}, 40) * translation<double>({3, -2, 1}) *
                           Affine<double>{{1, 0, 0}, {0.5, 2, 0}, {0, -0.25, -3}, {0, 0, 7}};
  const auto back = inverse(m);
  REQUIRE(back);
  const Vec3d p = back->point(m.point({0.3, -4, 5}));
  CHECK(p.x == Approx(0.3));
  CHECK(p.y == Approx(-4));
  CHECK(p.z == Approx(5));
  CHECK_FALSE(inverse(scaling<double>({1, 0, 1})));
  CHECK_FALSE(inverse(Affine<double>{{1, 2, 3}, {2, 4, 6}, {0, 0, 1}, {0, 0, 0}}));
}

TEST_CASE("a normal stays upright on its surface, and outside stays outside under a mirror", "[math]") {
  const Affine<double> shear{{1, 0, 0}, {1, 1, 0}, {0, 0, 1}, {5, 5, 5}};
  CHECK(dot(shear.normal({0, 1, 0}), shear.direction({1, 0, 0})) == 0);
  CHECK(dot(shear.normal({1, 0, 0}), shear.direction({0, 1, 0})) == 0);
  const Affine<double> mirror = scaling<double>({-2, 1, 1});
  CHECK(normalize(mirror.normal({1, 0, 0})) == Vec3d(-1, 0, 0));
  CHECK(normalize(mirror.normal({0, 1, 0})) == Vec3d(0, 1, 0));
}
