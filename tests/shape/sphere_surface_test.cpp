// Points of a sphere's surface: where they lie, their normals and their longitude and latitude.

#include "shape/meet.h"
#include "shape/numbers.h"
#include "shape/sphere.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

TEMPLATE_TEST_CASE("points on a sphere lie on it and their normals point outwards", "", float, double) {
  using T = TestType;
  const T eps = std::numeric_limits<T>::epsilon();
  Numbers next(7);
  for (int i = 0; i < 2000; ++i) {
    const Sphere<T> sphere{next.in_box<T>(), static_cast<T>(next.real(0.5, 2))};
    const Ray<T> ray{next.in_box<T>(5), normalize(sphere.centre + next.in_box<T>(0.2) - next.in_box<T>(5))};
    const auto hit = meet(sphere, ray);
    if (!hit) continue;
    const SurfacePoint<T> point = surface_at(sphere, ray, *hit);
    const Vec3<T> expected = (ray.at(hit->t) - sphere.centre) / sphere.radius;
    if (std::abs(length(point.normal) - 1) > 4 * eps) FAIL("normal's length at " << i);
    if (length(point.normal - expected) > 100 * eps) FAIL("normal at " << i);
    if (std::abs(length(point.position - sphere.centre) - sphere.radius) > 8 * eps) FAIL("position at " << i);
  }
}

TEMPLATE_TEST_CASE("a normal is of unit length, its point on the sphere, from however far both are seen", "", float,
                   double) {
  using T = TestType;
  const T eps = std::numeric_limits<T>::epsilon();
  Numbers next(9);
  for (int digits = 0; digits <= std::numeric_limits<T>::digits10; ++digits)
    for (int i = 0; i < 200; ++i) {
      const T way = static_cast<T>(std::pow(10.0, digits));
      const Sphere<T> sphere{next.in_box<T>(), static_cast<T>(next.real(0.5, 2))};
      const Vec3<T> from = sphere.centre + (way + 2) * next.unit<T>();
      const Ray<T> ray{from, normalize(sphere.centre + next.in_box<T>(0.2) - from)};
      const auto hit = meet(sphere, ray);
      if (!hit) continue;
      const SurfacePoint<T> point = surface_at(sphere, ray, *hit);
      if (std::abs(length(point.normal) - 1) > 4 * eps) FAIL("normal's length from " << way);
      if (std::abs(length(point.position - sphere.centre) - sphere.radius) > 8 * eps) FAIL("position from " << way);
    }
}

TEST_CASE("normals keep their digits far from the origin") {
  // The scene is moved by 1e9: a point holds 7 digits of what is left behind the point, a normal must not.
  Numbers next(8);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d shift(1e9, -1e9, 7e8);
    const Vec3d unit = next.unit<double>();
    // Multiples of 1/1024, so that moving changes no bit of the difference.
    const Vec3d from(std::floor(5120 * unit.x) / 1024, std::floor(5120 * unit.y) / 1024,
                     std::floor(5120 * unit.z) / 1024);
    const Ray<double> ray{shift + from, normalize(next.in_box<double>(0.3) - from)};
    const Sphere<double> here{Vec3d(0), 1}, there{shift, 1};
    const auto near = meet(here, {from, ray.direction}), far = meet(there, ray);
    REQUIRE(near);
    REQUIRE(far);
    CHECK(far->t == near->t);
    const Vec3d expected = surface_at(here, {from, ray.direction}, *near).normal;
    if (length(surface_at(there, ray, *far).normal - expected) > 1e-15) FAIL("at " << i);
  }
}

TEMPLATE_TEST_CASE("a sphere too small to see from far still has a unit normal", "", float, double) {
  using T = TestType;
  // The hit point is the centre, as far as the numbers can tell.
  const Sphere<T> speck{Vec3<T>(5, 0, 0), std::numeric_limits<T>::epsilon()};
  const Ray<T> ray{Vec3<T>(0), Vec3<T>(1, 0, 0)};
  const auto hit = meet(speck, ray);
  REQUIRE(hit);
  const SurfacePoint<T> point = surface_at(speck, ray, *hit);
  CHECK(is_finite(point.position));
  CHECK(length(point.normal) == Approx(1));
  CHECK(dot(point.normal, ray.direction) < 0);
}

TEST_CASE("longitude and latitude are lengths along the sphere") {
  const Sphere<double> sphere{Vec3d(1, 1, 1), 2};
  const double pi = 3.14159265358979323846;
  const auto uv = [&](const Vec3d& normal) { return uv_at(sphere, SurfacePoint<double>{Vec3d(0), normal}, 0); };
  CHECK(uv({1, 0, 0}) == Vec2d(0, 0));
  CHECK(uv({0, 1, 0}).x == Approx(pi));
  CHECK(uv({0, -1, 0}).x == Approx(-pi));
  CHECK(uv({0, 0, 1}).y == Approx(pi));
  CHECK(uv({0, 0, -1}).y == Approx(-pi));
  CHECK(uv(normalize(Vec3d(1, 1, 0))).x == Approx(pi / 2));
}
