// Naive crossings: where nothing is close they are the robust ones, up to rounding; and where the textbook fails, they
// fail, or there were nothing to show.
#include "shape/naive.h"

#include <string>
#include <vector>

#include "shape/numbers.h"
#include "support/catch.h"
#include "support/one_of_each.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

struct Agreement {
  int hits = 0, decided_otherwise = 0, other_parts = 0;
  double worst = 0;  // relative, of t
};

template <class T>
Agreement agreement_on(const Shape<T>& shape, int rays) {
  Agreement found;
  Numbers numbers(7);
  for (int i = 0; i < rays; ++i) {
    const Ray<T> ray{numbers.in_box<T>(2), numbers.unit<T>()};
    const auto expected = intersect(shape, ray, infinity<T>), got = intersect(shape, NaiveRay<T>{ray}, infinity<T>);
    found.hits += expected.has_value();
    found.decided_otherwise += expected.has_value() != got.has_value();
    if (!expected || !got) continue;
    found.other_parts += got->part != expected->part;
    if (got->part == expected->part)
      found.worst = std::max(found.worst, static_cast<double>(std::abs(got->t - expected->t) / expected->t));
  }
  return found;
}

struct Explained {
  double a = 0, b = 0, c = 0, discriminant = 0, near = 0, far = 0, numerator = 0, denominator = 0;
  static constexpr bool wanted = true;
  void quadratic(double a_, double b_, double c_, double discriminant_, double near_, double far_) {
    a = a_, b = b_, c = c_, discriminant = discriminant_, near = near_, far = far_;
  }
  void plane(double numerator_, double denominator_) { numerator = numerator_, denominator = denominator_; }
};

}  // namespace

TEST_CASE("where nothing is close, naive crossings are the robust ones up to rounding") {
  for (const Shape<double>& shape : one_of_each()) {
    INFO(shape_name(shape));
    constexpr int rays = 20000;
    const Agreement wide = agreement_on(shape, rays), narrow = agreement_on(shape_cast<float>(shape), rays);
    CHECK(wide.hits > 300);
    CHECK(wide.decided_otherwise == 0);
    CHECK(wide.other_parts == 0);
    CHECK(wide.worst < 1e-8);
    CHECK(narrow.decided_otherwise <= 3);  // of 20,000 random rays, those that touch an edge
    CHECK(narrow.other_parts <= 3);
    CHECK(narrow.worst < 0.05);  // a float's t where two roots nearly meet
    CHECK(narrow.worst > wide.worst);
  }
}

TEST_CASE("naive crossings end at t_max, and hand out the numbers that they computed") {
  const NaiveRay<double> ray{{{-3, 0, 0}, {1, 0, 0}}};
  const Sphere<double> sphere{{0, 0, 0}, 1};
  CHECK(intersect(sphere, ray, 2.5).value().t == 2);
  CHECK_FALSE(intersect(sphere, ray, 2.0));
  Explained numbers;
  static_cast<void>(intersect(sphere, ray, infinity<double>, no_part, numbers));
  CHECK(numbers.a == 1);
  CHECK(numbers.b == -6);
  CHECK(numbers.c == 8);
  CHECK(numbers.discriminant == 4);
  CHECK(numbers.near == 2);
  CHECK(numbers.far == 4);
  for (const Shape<double>& shape : one_of_each()) {
    INFO(shape_name(shape));
    Numbers any(5);
    NaiveRay<double> ray_that_hits(Ray<double>{});
    Explained of_shape;
    std::optional<Intersection<double>> intersection;
    while (!intersection) {
      ray_that_hits = NaiveRay<double>{{any.in_box<double>(2), any.unit<double>()}};
      of_shape = {};
      intersection = intersect(shape, ray_that_hits, infinity<double>, no_part, of_shape);
    }
    CHECK((of_shape.a != 0 || std::abs(of_shape.numerator / of_shape.denominator - intersection->t) < 1e-12));
    CHECK_FALSE(intersect(shape, ray_that_hits, intersection->t));
  }
}

namespace {

/// Whether a shape's intersections can be asked for with a ray.
template <class S, class AnyRay>
concept Intersects = requires(const S& shape, const AnyRay& ray) { intersect(shape, ray, infinity<double>); };

/// A shape that has no naive form yet.
struct OnlyRobust {};
[[maybe_unused]] std::optional<Intersection<double>> intersect(const OnlyRobust&, const Ray<double>&, double,
                                                               int = no_part) {
  return std::nullopt;
}

template <class AnyShape>
struct AllIntersect;
template <class... S>
struct AllIntersect<std::variant<S...>>
    : std::bool_constant<((Intersects<S, Ray<double>> && Intersects<S, NaiveRay<double>>) && ...)> {};

static_assert(AllIntersect<Shape<double>>::value);
static_assert(Intersects<OnlyRobust, Ray<double>>);
static_assert(!Intersects<OnlyRobust, NaiveRay<double>>, "a robust intersection must not answer for a naive one");

}  // namespace

TEST_CASE("the textbook's failures are there to be shown") {
  // A ball that is touched, from 2^30 radii away: the discriminant drowns.
  const Sphere<double> ball{{0, 0, 0}, 1};
  int missed = 0, invented = 0;
  Numbers numbers(3);
  for (int i = 0; i < 1000; ++i) {
    const double x = -std::ldexp(1 + numbers.real(0, 1), 30), d = std::ldexp(numbers.real(0.5, 1), -40);
    const Ray<double> inside{{x, 1 - d, 0}, {1, 0, 0}}, outside{{x, 1 + d, 0}, {1, 0, 0}};
    REQUIRE(intersect(ball, inside, infinity<double>));
    REQUIRE_FALSE(intersect(ball, outside, infinity<double>));
    missed += !intersect(ball, NaiveRay<double>{inside}, infinity<double>);
    invented += intersect(ball, NaiveRay<double>{outside}, infinity<double>).has_value();
  }
  CHECK(missed + invented > 300);
  // Small triangles fall below the epsilon of their determinant.
  const Triangle<double> small{{0, 0, 0}, {0.0009, 0, 0}, {0, 0.0009, 0}};
  const Ray<double> down{{0.0002, 0.0002, 1}, {0, 0, -1}};
  CHECK(intersect(small, down, infinity<double>));
  CHECK_FALSE(intersect(small, NaiveRay<double>{down}, infinity<double>));
  // Rays that start on a ball meet it again at once, half of them or so.
  int again = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vec3d n = numbers.unit<double>(), out = numbers.unit<double>();
    const Ray<double> ray{n, dot(n, out) < 0 ? -out : out, Departure{0, 0}};
    REQUIRE_FALSE(intersect(ball, ray, infinity<double>, 0));
    again += intersect(ball, NaiveRay<double>{ray}, infinity<double>, 0).has_value();
  }
  CHECK(again > 200);
  CHECK(again < 800);
}
