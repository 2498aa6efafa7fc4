// The oracle itself: the filter never lies, and both arithmetics know what is known.

#include "check/ball.h"
#include "check/judge.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::check;

namespace {

/// |ball - exact| <= radius, told by rationals.
bool holds(const Ball& ball, const Rational& exact) {
  if (std::isinf(ball.radius)) return true;
  const Rational middle = Rational(ball.middle.hi) + Rational(ball.middle.lo);
  return abs(Rational(middle - exact)) <= Rational(ball.radius);
}

template <class T>
Truth<Rational> crossings(const Sphere<T>& sphere, const Ray<T>& ray) {
  return truth<Rational>(sphere, ray);
}

}  // namespace

TEST_CASE("a ball holds the exact value of what was computed") {
  int wrong = 0, undecided = 0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    Random random(1, 2, i);
    const int spread = i % 3 == 0 ? 400 : 30;
    const auto number = [&] { return std::ldexp(random.real(), random.whole(-spread, spread)); };
    const double a = number(), b = number(), c = number(), d = i % 5 == 0 ? a : number();
    const Ball x = Ball(a) * Ball(b) - Ball(c) * Ball(d), y = x * x + Ball(a) * x - Ball(d) * Ball(a);
    const Rational rx = Rational(a) * b - Rational(c) * d, ry = rx * rx + a * rx - Rational(d) * a;
    wrong += !holds(x, rx) + !holds(y, ry);
    try {
      wrong += sign(y) != sign(ry);
      wrong += !holds(x / y, Rational(rx / ry));
      // Of a root only the square is rational.
      if (sign(y) > 0) wrong += !holds(root(y) * root(y), ry);
    } catch (const Undecided&) {
      ++undecided;
    }
  }
  CHECK(wrong == 0);
  CHECK(undecided > 0);
  CHECK(undecided < 1500);
}

TEST_CASE("a ball around zero has no sign") {
  CHECK(sign(Ball(0.0)) == 0);
  CHECK(sign(Ball(0x1p-300)) == 1);
  const Ball third = Ball(1.0) / Ball(3.0);
  CHECK_THROWS_AS(sign(third + third + third - Ball(1.0)), Undecided);
  CHECK_THROWS_AS(third / (third - third), Undecided);
}

TEST_CASE("the truth of spheres is told to the last bit") {
  const Sphere<double> unit{{0, 0, 0}, 1};
  // Exactly tangent counts; one step beside it does not.
  CHECK(crossings(unit, Ray<double>{{-5, 1, 0}, {1, 0, 0}}).crossings.size() == 1);
  CHECK(crossings(unit, Ray<double>{{-5, std::nextafter(1.0, 2.0), 0}, {1, 0, 0}}).crossings.empty());
  CHECK(crossings(unit, Ray<double>{{-5, std::nextafter(1.0, 0.0), 0}, {1, 0, 0}}).crossings.size() == 2);
  // On the surface, outwards and inwards; inside; and the whole sphere behind.
  CHECK(crossings(unit, Ray<double>{{1, 0, 0}, {1, 1, 0}}).crossings.empty());
  REQUIRE(crossings(unit, Ray<double>{{1, 0, 0}, {-1, 0, 0}}).crossings.size() == 1);
  CHECK(crossings(unit, Ray<double>{{1, 0, 0}, {-1, 0, 0}}).crossings[0].t == 2);
  CHECK(crossings(unit, Ray<double>{{0, 0, 0}, {0, 3, 4}}).crossings[0].t == Rational(1, 5));
  CHECK(crossings(unit, Ray<double>{{5, 0, 0}, {1, 0, 0}}).crossings.empty());
}

TEST_CASE("the judge tells a right answer from a missed and a false one") {
  const Sphere<double> unit{{0, 0, 0}, 1};
  const Ray<double> hits{{-5, 0, 0}, {1, 0, 0}}, passes{{-5, 2, 0}, {1, 0, 0}};
  const auto truly = truth<Rational>(unit, hits);
  CHECK(judge(truly, std::optional(Intersection<double>{4})).verdict == HitVerdict::right);
  CHECK(judge(truly, std::optional(Intersection<double>{4})).ulps == 0);
  CHECK(judge(truly, std::optional(Intersection<double>{std::nextafter(4.0, 5.0)})).ulps == 1);
  CHECK(judge(truly, std::optional<Intersection<double>>()).verdict == HitVerdict::missed);
  CHECK(judge(truly, std::optional(Intersection<double>{NAN})).verdict == HitVerdict::false_hit);
  CHECK(judge(truly, std::optional(Intersection<double>{6})).verdict == HitVerdict::missed);  // the way out
  CHECK(judge(truth<Rational>(unit, passes), std::optional(Intersection<double>{5})).verdict == HitVerdict::false_hit);
  CHECK(judge(truth<Rational>(unit, passes), std::optional<Intersection<double>>()).verdict == HitVerdict::right);
}

TEST_CASE("the judge tells the part that was hit from the others") {
  const Box<double> cube{{-1, -1, -1}, {1, 1, 1}};
  const auto verdict = [&](const Ray<double>& ray, int part) {
    return judge(truth<Rational>(cube, ray), std::optional(Intersection<double>{4, part})).verdict;
  };
  const Ray<double> at_face{{-5, 0, 0}, {1, 0, 0}}, at_edge{{-5, -5, 0}, {1, 1, 0}};
  CHECK(verdict(at_face, 0) == HitVerdict::right);
  CHECK(verdict(at_face, 1) == HitVerdict::false_hit);
  CHECK(verdict(at_edge, 0) == HitVerdict::right);
  CHECK(verdict(at_edge, 2) == HitVerdict::right);
}

TEST_CASE("quadratics know on which side of each root a number lies") {
  for (const double sense : {1.0, -1.0}) {
    const Quadratic<Rational> two(sense, -3 * sense, 8 * sense);  // roots 2 and 4
    REQUIRE(two.count() == 2);
    const auto place = [](const Quadratic<Rational>& q, double s) {
      return std::pair(q.place(s).below, q.place(s).at);
    };
    CHECK(place(two, 1) == std::pair(0, 0));
    CHECK(place(two, 2) == std::pair(0, 1));
    CHECK(place(two, 3) == std::pair(1, 0));
    CHECK(place(two, 4) == std::pair(1, 1));
    CHECK(place(two, 5) == std::pair(2, 0));
    CHECK(two.root_at(0) == 2);
    CHECK(two.root_at(1) == 4);
    CHECK(two.sign_at(3) == -sense);
    const Quadratic<Rational> twice(sense, -3 * sense, 9 * sense);
    CHECK(twice.count() == 1);
    CHECK(place(twice, 3) == std::pair(0, 1));
    CHECK(place(twice, 4) == std::pair(1, 0));
    const Quadratic<Rational> straight(Rational(0), sense, -6 * sense);
    CHECK(straight.count() == 1);
    CHECK(straight.root_at(0) == 3);
    CHECK(place(straight, 2) == std::pair(0, 0));
    CHECK(place(straight, 4) == std::pair(1, 0));
    CHECK(Quadratic<Rational>(sense, 0, sense).count() == 0);
  }
}
