#include "accel/primitives.h"
#include "accel/accelerator.h"

#include "support/catch.h"

using namespace raywalk;

TEST_CASE("equal primitives are found, whatever stands between them", "[accel]") {
  const Sphere<double> ball{{1, 2, 3}, 1}, other{{1, 2, 3}, 1.5};
  const Prism<double> box{{{0, 1}, {2, 1}, {2, 3}, {0, 3}}, 8};  // not the ball, though its box touches the ball's
  const auto moved = object_transform<double>(translation(Vec3d(1, 2, 3)));
  REQUIRE(moved);
  Primitives<double> primitives;
  primitives.add(ball);
  primitives.add(other);
  primitives.add(ball);
  primitives.add(box);
  primitives.add(other);
  primitives.add(Sphere<double>{}, *moved);  // where the ball is, but under a map
  primitives.add(Plane<double>{});
  primitives.add(Sphere<double>{}, *moved);
  primitives.add(ball);
  primitives.add(Plane<double>{});
  CHECK(primitives.first_equal(2) == 2);  // not yet asked for
  primitives.find_equals(PrimitiveBounds<double>(primitives, true).boxes);
  const int expected[] = {0, 1, 0, 3, 1, 5, 6, 5, 0, 6};
  for (int id = 0; id < primitives.size(); ++id) CHECK(primitives.first_equal(id) == expected[id]);
}

TEST_CASE("what departs from a primitive departs from its equals", "[accel]") {
  for (const AcceleratorKind kind : {AcceleratorKind::none, AcceleratorKind::bvh}) {
    const Sphere<double> ball{{0.1, 0.2, 0.3}, 1.1};
    const Accelerator<double> accelerator(Primitives<double>({ball, ball, ball}), kind);
    TestCounts counts;
    int met = 0;
    for (int i = 0; i < 200; ++i) {
      const Vec3d direction = normalize(Vec3d(std::sin(i), std::cos(1.7 * i), std::sin(2.3 * i) + 0.1));
      Ray<double> ray{Vec3d(0.1, 0.2, 0.3) - 5.0 * direction + 0.1 * Vec3d(1, 0, 0), direction};
      const auto hit = accelerator.closest(ray, infinity<double>, counts);
      REQUIRE(hit);
      CHECK(hit->primitive == 0);
      const SurfacePoint<double> point = accelerator.primitives().surface_at(0, ray, {hit->t, hit->part});
      const Ray<double> away{point.position, point.normal, {hit->primitive, hit->part}};
      met += accelerator.occluded(away, infinity<double>, counts);
      const auto through =
          accelerator.closest({point.position, -point.normal, away.departure}, infinity<double>, counts);
      REQUIRE(through);
      CHECK(through->t == Approx(2.2));
    }
    CHECK(met == 0);
  }
}
