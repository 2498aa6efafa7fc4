#include "shape/sphere.h"

#include <array>
#include <cstdint>
#include <vector>

#include "shape/meet.h"
#include "shape/numbers.h"
#include "shape/quad.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

__extension__ using Wide = __int128;

namespace {

struct Explanation {
  static constexpr bool wanted = true;
  double a = 0, b = 0, c = 0, discriminant = 0, t0 = 0, t1 = 0;
  void quadratic(double a_, double b_, double c_, double discriminant_, double t0_, double t1_) {
    a = a_, b = b_, c = c_, discriminant = discriminant_, t0 = t0_, t1 = t1_;
  }
};

// Integer vectors of integer length: radii along which a tangent point is exact.
constexpr std::array<std::array<int, 4>, 6> quadruples{
    {{1, 2, 2, 3}, {2, 3, 6, 7}, {1, 4, 8, 9}, {4, 4, 7, 9}, {2, 6, 9, 11}, {0, 3, 4, 5}}};

struct IntegerRay {
  std::array<std::int64_t, 3> origin, direction;  // seen from the centre
  std::int64_t radius;
  std::int64_t t;  // of the tangent point
};

// A ray that touches the sphere exactly, by integers alone: the tangent point is k (a, b, c), the direction is
// perpendicular to it, and the origin lies t steps before it.
IntegerRay tangent_ray(Numbers& next, int largest_step, int largest_t) {
  for (;;) {
    const auto& [a, b, c, d] = quadruples[static_cast<std::size_t>(next.integer(0, 5))];
    const std::int64_t k = next.integer(1, largest_step);
    const std::array<std::int64_t, 3> point{k * a, (next.integer(0, 1) * 2 - 1) * k * b, k * c};
    const std::int64_t x = next.integer(-largest_step, largest_step), y = next.integer(-largest_step, largest_step),
                       z = next.integer(-largest_step, largest_step);
    const std::array<std::int64_t, 3> along{point[1] / k * z - point[2] / k * y, point[2] / k * x - point[0] / k * z,
                                            point[0] / k * y - point[1] / k * x};
    if (along[0] == 0 && along[1] == 0 && along[2] == 0) continue;
    const std::int64_t t = next.integer(1, largest_t);
    return {{point[0] - t * along[0], point[1] - t * along[1], point[2] - t * along[2]}, along, k * d, t};
  }
}

// Sign of the discriminant in integers.
int exact_sign(const IntegerRay& ray) {
  Wide a = 0, b = 0, c = -static_cast<Wide>(ray.radius) * ray.radius;
  for (std::size_t i = 0; i < 3; ++i) {
    a += static_cast<Wide>(ray.direction[i]) * ray.direction[i];
    b += static_cast<Wide>(ray.direction[i]) * ray.origin[i];
    c += static_cast<Wide>(ray.origin[i]) * ray.origin[i];
  }
  const Wide discriminant = b * b - a * c;
  return discriminant > 0 ? 1 : discriminant < 0 ? -1 : 0;
}

template <class T>
Ray<T> ray_of(const IntegerRay& ray) {
  const auto vector = [](const std::array<std::int64_t, 3>& v) {
    return Vec3<T>(static_cast<T>(v[0]), static_cast<T>(v[1]), static_cast<T>(v[2]));
  };
  return {vector(ray.origin), vector(ray.direction)};
}

}  // namespace

TEMPLATE_TEST_CASE("a ray meets a sphere in front, from inside, behind, or not at all", "", float, double) {
  using V = Vec3<TestType>;
  const Sphere<TestType> sphere{V(1, 2, 3), 2};
  CHECK(meet(sphere, {V(1, 2, -3), V(0, 0, 1)})->t == 4);
  CHECK(meet(sphere, {V(1, 2, -3), V(0, 0, 4)})->t == 1);  // t counts multiples of the direction
  CHECK(meet(sphere, {V(1, 2, 3), V(0, -1, 0)})->t == 2);
  CHECK(meet(sphere, {V(1, 1, 3), V(0, -1, 0)})->t == 1);
  CHECK(meet(sphere, {V(1, 4, -3), V(0, 0, 1)})->t == 6);  // tangent
  CHECK_FALSE(meet(sphere, {V(1, 2, 9), V(0, 0, 1)}));
  CHECK_FALSE(meet(sphere, {V(1, 5, -3), V(0, 0, 1)}));
  CHECK(meet(sphere, {V(1, 2, -3), V(0, 0, 1)})->part == 0);
}

TEMPLATE_TEST_CASE("a sphere is met only before t_max", "", float, double) {
  using V = Vec3<TestType>;
  const Sphere<TestType> sphere{V(0), 1};
  const Ray<TestType> ray{V(0, 0, -5), V(0, 0, 1)};
  CHECK_FALSE(intersect(sphere, ray, TestType(4)));
  CHECK(intersect(sphere, ray, std::nextafter(TestType(4), TestType(5)))->t == 4);
  // The far side is not offered instead of a near one beyond t_max.
  CHECK_FALSE(intersect(sphere, ray, TestType(3)));
}

TEMPLATE_TEST_CASE("rays at random spheres are right about hit and t", "", float, double) {
  using T = TestType;
  Numbers next(1);
  int wrong = 0, hits = 0;
  double worst = 0;
  for (int i = 0; i < rounds(200000); ++i) {
    const Sphere<T> sphere{next.in_box<T>(10), static_cast<T>(std::exp(next.real(-3, 2)))};
    const Vec3<T> origin = next.in_box<T>(20), target = sphere.centre + T(2) * sphere.radius * next.in_box<T>();
    const Ray<T> ray{origin, static_cast<T>(next.real(0.1, 2)) * (target - origin)};
    const auto expected = sphere_roots(sphere, ray);
    const auto got = meet(sphere, ray);
    const bool hit = expected && expected->second > 0;
    if (hit != got.has_value()) {
      ++wrong;
    } else if (hit) {
      ++hits;
      const Quad t = expected->first > 0 ? expected->first : expected->second;
      // How much t moves when origin, centre and radius move: over the cosine to the normal, against t itself.
      const double speed = std::sqrt(static_cast<double>(dot(ray.direction, ray.direction)));
      const double reach = static_cast<double>(length(ray.origin - sphere.centre) + sphere.radius);
      const double cosine =
          static_cast<double>(expected->second - expected->first) * speed / 2 / static_cast<double>(sphere.radius);
      const double condition = 1 + reach / (static_cast<double>(t) * speed) / cosine;
      worst = std::max(worst, std::abs(static_cast<double>((got->t - t) / t)) / condition);
    }
  }
  CHECK(wrong == 0);
  CHECK(hits > rounds(20000));
  CHECK(worst / std::numeric_limits<T>::epsilon() <= 4);
}

TEST_CASE("rays near a tangent are right about hit or miss") {
  // Offsets of 2^-k of the radius, k up to 50, on both sides of the tangent; quadruple precision decides.
  Numbers next(2);
  int wrong = 0, hits = 0, misses = 0;
  for (int i = 0; i < rounds(200000); ++i) {
    const Vec3d side = next.unit<double>(), along = normalize(cross(side, next.unit<double>()));
    const double radius = std::exp(next.real(-10, 10)), distance = radius * std::exp(next.real(0, 20));
    const double off = radius * (1 + std::ldexp(next.real(), -next.integer(1, 50)));
    const Vec3d centre = next.in_box<double>(10 * radius);
    const Ray<double> ray{centre + off * side - distance * along, along};
    const Sphere<double> sphere{centre, radius};
    const auto expected = sphere_roots(sphere, ray);
    const auto got = meet(sphere, ray);
    expected ? ++hits : ++misses;
    wrong += got.has_value() != (expected && expected->second > 0);
  }
  CHECK(wrong == 0);
  CHECK(hits > rounds(50000));
  CHECK(misses > rounds(50000));
}

TEST_CASE("exactly tangent rays hit, one step off they do not") {
  Numbers next(3);
  // The last gives distances of up to 1e9 radii.
  const auto [step, largest_t] = GENERATE(table<int, int>({{3, 10}, {100, 1000}, {3000, 100000}, {2, 30000000}}));
  int tangent_missed = 0, t_wrong = 0, wrong = 0, decided[3] = {0, 0, 0};
  for (int i = 0; i < rounds(20000); ++i) {
    IntegerRay ray = tangent_ray(next, step, largest_t);
    REQUIRE(exact_sign(ray) == 0);
    const auto tangent = meet(Sphere<double>{Vec3d(0), static_cast<double>(ray.radius)}, ray_of<double>(ray));
    if (!tangent)
      ++tangent_missed;
    else
      t_wrong += tangent->t != static_cast<double>(ray.t);
    // One unit sideways: near the tangent, but not on it.
    ray.origin[static_cast<std::size_t>(i % 3)] += i % 2 ? 1 : -1;
    const int sign = exact_sign(ray);
    ++decided[sign + 1];
    const auto got = meet(Sphere<double>{Vec3d(0), static_cast<double>(ray.radius)}, ray_of<double>(ray));
    wrong += got.has_value() != (sign >= 0);
  }
  CHECK(tangent_missed == 0);
  CHECK(t_wrong == 0);
  CHECK(wrong == 0);
  CHECK(decided[0] > rounds(1000));
  CHECK(decided[2] > rounds(1000));
}

TEST_CASE("exactly tangent rays hit in float too") {
  Numbers next(4);
  int missed = 0, wrong = 0;
  for (int i = 0; i < rounds(20000); ++i) {
    IntegerRay ray = tangent_ray(next, 20, 500);  // all below 2^24
    const Sphere<float> sphere{Vec3<float>(0), static_cast<float>(ray.radius)};
    const auto got = meet(sphere, ray_of<float>(ray));
    missed += !got || got->t != static_cast<float>(ray.t);
    ray.origin[1] += i % 2 ? 1 : -1;
    wrong += meet(sphere, ray_of<float>(ray)).has_value() != (exact_sign(ray) >= 0);
  }
  CHECK(missed == 0);
  CHECK(wrong == 0);
}

TEST_CASE("a root too small for float does not hide the other one") {
  // In double the near root is 1e-60; as a float it is 0, which is no crossing.
  const Sphere<float> sphere{Vec3<float>(0, 0, 1e-30f), 1e-30f};
  const Ray<float> ray{Vec3<float>(0, 0, -1e-45f), Vec3<float>(0, 0, 1e20f)};
  const auto got = meet(sphere, ray);
  if (got) CHECK(got->t > 0);
  const Ray<float> slow{Vec3<float>(0, 0, -1e-45f), Vec3<float>(0, 0, 1e6f)};
  REQUIRE(meet(sphere, slow));
  CHECK(meet(sphere, slow)->t == Approx(2e-36).epsilon(1e-3));
}

TEMPLATE_TEST_CASE("scaling by powers of two and mirroring keep every bit", "", float, double) {
  using T = TestType;
  Numbers next(5);
  int compared = 0;
  for (int i = 0; i < rounds(20000); ++i) {
    const Sphere<T> sphere{next.in_box<T>(3), static_cast<T>(next.real(0.1, 2))};
    const Vec3<T> origin = next.in_box<T>(6);
    const Ray<T> ray{origin, sphere.centre + next.in_box<T>(2) - origin};
    const auto plain = meet(sphere, ray);
    const T scale = std::ldexp(T(1), next.integer(-12, 12));
    const auto scaled =
        meet(Sphere<T>{scale * sphere.centre, scale * sphere.radius}, {scale * ray.origin, ray.direction});
    const Vec3<T> mirror(i % 2 ? -1 : 1, i % 3 ? 1 : -1, i % 5 ? 1 : -1);
    const auto mirrored =
        meet(Sphere<T>{mirror * sphere.centre, sphere.radius}, {mirror * ray.origin, mirror * ray.direction});
    if (plain.has_value() != scaled.has_value() || (plain && scaled->t != scale * plain->t)) FAIL("scaled, ray " << i);
    if (plain.has_value() != mirrored.has_value() || (plain && mirrored->t != plain->t)) FAIL("mirrored, ray " << i);
    compared += plain.has_value();
  }
  CHECK(compared > rounds(1000));
}

TEMPLATE_TEST_CASE("a ray that leaves a sphere never meets it where it left", "", float, double) {
  using T = TestType;
  const double scale = GENERATE(1e-6, 1e-3, 1.0, 1e3, 1e9);
  const double shift = GENERATE(0.0, 1.0, 1e9);
  // A sphere smaller than the steps between numbers at its centre has no surface to speak of.
  const bool resolved = scale > 1e4 * shift * std::numeric_limits<T>::epsilon();
  CAPTURE(scale, shift);
  Numbers next(6);
  int outward_hits = 0, inward_misses = 0, near_hits = 0, tried = 0;
  for (int i = 0; i < 3000; ++i) {
    const Sphere<T> sphere{next.in_box<T>(shift), static_cast<T>(scale * next.real(0.5, 2))};
    const Vec3<T> start = sphere.centre + static_cast<T>(3 * scale) * next.unit<T>();
    const Vec3<T> target = sphere.centre + static_cast<T>(0.4 * scale) * next.unit<T>();
    const Ray<T> ray{start, i % 2 ? normalize(target - start) : target - start};
    const auto hit = meet(sphere, ray);
    if (!hit) continue;
    ++tried;
    const SurfacePoint<T> point = surface_at(sphere, ray, *hit);
    Vec3<T> away = next.unit<T>();
    if (dot(away, point.normal) < 0) away = -away;
    const T cosine = dot(away, point.normal);
    if (resolved && cosine < T(1e-3)) continue;
    outward_hits += intersect(sphere, {point.position, away}, infinity<T>, 0).has_value();
    const auto through = intersect(sphere, {point.position, -away}, infinity<T>, 0);
    inward_misses += !through;
    near_hits += through && !(through->t > cosine * sphere.radius);
  }
  if (resolved) {
    CHECK(tried > 2000);
    CHECK(outward_hits == 0);
    CHECK(inward_misses == 0);
    CHECK(near_hits == 0);
  }
}

TEST_CASE("the bounds of a sphere hold every hit") {
  Numbers next(9);
  const Sphere<double> sphere{Vec3d(-3, 7, 0.5), 2.5};
  const Bounds<double> box = bounds(sphere);
  int hits = 0;
  for (int i = 0; i < rounds(20000); ++i) {
    const Vec3d origin = next.in_box<double>(12);
    const Ray<double> ray{origin, sphere.centre + next.in_box<double>(4) - origin};
    const auto hit = meet(sphere, ray);
    if (!hit) continue;
    ++hits;
    const Vec3d p = ray.at(hit->t);
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] < box.min[axis] - 1e-13 || p[axis] > box.max[axis] + 1e-13) FAIL("outside at " << i);
  }
  CHECK(hits > rounds(5000));
}

TEMPLATE_TEST_CASE("the explanation's numbers solve the quadratic and agree with the answer", "", float, double) {
  using T = TestType;
  Numbers next(10);
  int hits = 0, misses = 0;
  for (int i = 0; i < rounds(20000); ++i) {
    const Sphere<T> sphere{next.in_box<T>(), static_cast<T>(next.real(0.2, 1.5))};
    const Ray<T> ray{next.in_box<T>(3), next.unit<T>()};
    Explanation numbers;
    const auto explained = intersect(sphere, ray, infinity<T>, no_part, numbers);
    const auto plain = meet(sphere, ray);
    REQUIRE(explained.has_value() == plain.has_value());
    if (std::isnan(numbers.t0)) {
      ++misses;
      if (!(numbers.discriminant < 0) || plain) FAIL("no roots, but " << numbers.discriminant);
      continue;
    }
    if (!(numbers.discriminant >= 0)) FAIL("roots, but " << numbers.discriminant);
    if (plain && plain->t != explained->t) FAIL("another t");
    if (plain) {
      ++hits;
      const double t = numbers.t0 > 0 ? numbers.t0 : numbers.t1;
      if (static_cast<T>(t) != plain->t) FAIL("another root");
    }
    for (const double t : {numbers.t0, numbers.t1}) {
      const double size = std::abs(numbers.a * t * t) + std::abs(numbers.b * t) + std::abs(numbers.c);
      if (std::abs((numbers.a * t + numbers.b) * t + numbers.c) > 1e-6 * size) FAIL("no root: " << t);
    }
  }
  CHECK(hits > rounds(1000));
  CHECK(misses > rounds(1000));
}

TEST_CASE("an exactly tangent ray is explained by a discriminant of 0") {
  Numbers next(11);
  for (int i = 0; i < 1000; ++i) {
    const IntegerRay ray = tangent_ray(next, 3000, 100000);
    Explanation numbers;
    const Sphere<double> sphere{Vec3d(0), static_cast<double>(ray.radius)};
    REQUIRE(intersect(sphere, ray_of<double>(ray), infinity<double>, no_part, numbers));
    if (numbers.discriminant != 0 || numbers.t0 != numbers.t1) FAIL("discriminant " << numbers.discriminant);
  }
}
