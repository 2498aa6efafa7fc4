// How often a ray crosses a sphere, told at once: what a filtered shadow ray asks.

#include "shape/numbers.h"
#include "shape/sphere.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

TEMPLATE_TEST_CASE("crossings are counted as a walk from one to the next finds them", "", float, double) {
  using T = TestType;
  Numbers next(17);
  int counted[3] = {0, 0, 0};
  for (int i = 0; i < rounds(20000); ++i) {
    const auto vector = [&](double size) {
      return Vec3<T>(static_cast<T>(next.real(-size, size)), static_cast<T>(next.real(-size, size)),
                     static_cast<T>(next.real(-size, size)));
    };
    const Sphere<T> sphere{vector(3), static_cast<T>(next.real(0.5, 3))};
    Ray<T> ray{vector(5), vector(1)};
    T reach = i % 3 == 0 ? infinity<T> : static_cast<T>(next.real(0.5, 12));
    int departed = no_part;
    if (i % 4 == 0) {  // from the sphere's own surface, in or out
      ray.origin = sphere.centre + sphere.radius * normalize(vector(1));
      departed = 0;
    }
    const int at_once = intersection_count(sphere, ray, reach, departed);
    int walked = 0;
    double last = 0;
    for (; walked < 10; ++walked) {
      const auto intersection = intersect(sphere, ray, reach, departed);
      if (!intersection) break;
      last = static_cast<double>(intersection->t);
      ray.origin = surface_at(sphere, ray, *intersection).position;
      reach -= intersection->t;
      departed = 0;
    }
    ++counted[at_once];
    // Where the second one lies by rounding on this or that side of the end, or both are nearly one, either is right.
    const bool close = std::abs(static_cast<double>(reach)) < 1e-4 || last < 1e-2;
    if (at_once != walked && !close) FAIL(at_once << " at once, " << walked << " on the way");
  }
  for (const int number : counted) CHECK(number > rounds(300));
}

TEST_CASE("a tangent ray crosses once, and a sphere that begins behind the light does not count") {
  const Sphere<double> sphere{{0, 0, 0}, 1};
  const Ray<double> through{{-3, 0, 0}, {1, 0, 0}}, tangent{{-3, 1, 0}, {1, 0, 0}}, past{{-3, 1.5, 0}, {1, 0, 0}};
  CHECK(intersection_count(sphere, through, infinity<double>) == 2);
  CHECK(intersection_count(sphere, through, 4.0) == 1);  // the second lies at the end, which is not within
  CHECK(intersection_count(sphere, through, 3.0) == 1);
  CHECK(intersection_count(sphere, through, 2.0) == 0);
  CHECK(intersection_count(sphere, Ray<double>{{0, 0, 0}, {1, 0, 0}}, infinity<double>) == 1);
  CHECK(intersection_count(sphere, Ray<double>{{3, 0, 0}, {1, 0, 0}}, infinity<double>) == 0);
  CHECK(intersection_count(sphere, tangent, infinity<double>) == 1);
  CHECK(intersection_count(sphere, past, infinity<double>) == 0);
}
