// The mean of a checker over a footprint, against many points and where it can be said.

#include "trace/checker_filter.h"
#include "support/catch.h"
#include "support/effort.h"
#include "trace/texture.h"

#include <cmath>
#include <limits>
#include <random>
#include <vector>

using namespace raywalk;
using namespace raywalk::test;

namespace {

double by_points(const Vec2d& place, const Footprint<double>& footprint, int edge) {
  int even = 0;
  for (int i = 0; i < edge; ++i)
    for (int k = 0; k < edge; ++k) {
      const Vec2d at = place + ((i + 0.5) / edge - 0.5) * footprint.x + ((k + 0.5) / edge - 0.5) * footprint.y;
      even += even_square(at, 1.0);
    }
  return static_cast<double>(even) / (edge * edge);
}

/// The convex polygon's part where the coordinate `axis` times `sign` is at least `least`.
std::vector<Vec2d> clipped(const std::vector<Vec2d>& polygon, int axis, double sign, double least) {
  std::vector<Vec2d> result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2d &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
    const double at_a = sign * a[axis] - least, at_b = sign * b[axis] - least;
    if (at_a >= 0) result.push_back(a);
    if ((at_a < 0) != (at_b < 0)) result.push_back(a + at_a / (at_a - at_b) * (b - a));
  }
  return result;
}

double area_of(const std::vector<Vec2d>& polygon) {
  double twice = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    twice += cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  return std::abs(twice) / 2;
}

/// By cutting the parallelogram at every line between squares.
double by_clipping(const Vec2d& place, const Footprint<double>& footprint) {
  const Vec2d p = 0.5 * footprint.x, q = 0.5 * footprint.y;
  const std::vector<Vec2d> whole{place - p - q, place + p - q, place + p + q, place - p + q};
  const Vec2d reach(std::abs(p.x) + std::abs(q.x), std::abs(p.y) + std::abs(q.y));
  double even = 0;
  for (double u = std::floor(place.x - reach.x); u <= place.x + reach.x; ++u) {
    const auto column = clipped(clipped(whole, 0, 1, u), 0, -1, -u - 1);
    for (double v = std::floor(place.y - reach.y); v <= place.y + reach.y; ++v)
      if (even_square(Vec2d(u + 0.5, v + 0.5), 1.0)) even += area_of(clipped(clipped(column, 1, 1, v), 1, -1, -v - 1));
  }
  return even / area_of(whole);
}

}  // namespace

TEST_CASE("the share of even squares is that of many points") {
  std::mt19937 bits(3);
  const auto number = [&] { return static_cast<double>(bits()) / 0x1p31 - 1; };
  for (int i = 0; i < rounds(400); ++i) {
    const double size = std::pow(2, 3 * number());
    const Vec2d place(10 * number(), 10 * number());
    const Footprint<double> footprint{size * Vec2d(number(), number()), size * Vec2d(number(), number())};
    CAPTURE(i, place.x, place.y, footprint.x.x, footprint.x.y, footprint.y.x, footprint.y.y);
    CHECK(even_share(place, 1.0, footprint) == Approx(by_points(place, footprint, 500)).epsilon(0).margin(0.006));
    // Scaled with the squares.
    CHECK(even_share(3.0 * place, 3.0, Footprint<double>{3.0 * footprint.x, 3.0 * footprint.y}) ==
          Approx(even_share(place, 1.0, footprint)).epsilon(0).margin(1e-9));
  }
}

TEST_CASE("a footprint without a breadth is filtered along the whole of its line") {
  // In squares 0.3 above a line, the diagonal: at its ends for a moment in odd ones.
  CHECK(even_share(Vec2d(0, 0.3), 1.0, Footprint<double>{{0.5, 0.5}, {0.5, 0.5}}) ==
        Approx(0.58).epsilon(0).margin(0.01));
  std::mt19937 bits(9);
  const auto number = [&] { return static_cast<double>(bits()) / 0x1p31 - 1; };
  for (int i = 0; i < 200; ++i) {
    const Vec2d place(number(), number()), side(2 * number(), 2 * number());
    const Footprint<double> line{side, number() * side};
    CHECK(even_share(place, 1.0, line) == Approx(by_points(place, line, 400)).epsilon(0).margin(0.03));
  }
}

TEST_CASE("the share of even squares is that of the squares cut out of the footprint") {
  std::mt19937 bits(5);
  const auto number = [&] { return static_cast<double>(bits()) / 0x1p31 - 1; };
  // Sides of any slope, and such as are nearly or quite along the lines between squares, as those of a level camera.
  const auto side = [&](double size) {
    const double across = bits() % 3 == 0 ? std::pow(10, -8 - 9 * std::abs(number())) : number();
    const Vec2d along = size * Vec2d(number(), bits() % 5 == 0 ? 0 : across);
    return bits() % 2 == 0 ? along : Vec2d(along.y, along.x);
  };
  int checked = 0;
  for (int i = 0; i < 20000; ++i) {
    const Footprint<double> footprint{side(std::pow(2, 3 * number())), side(std::pow(2, 3 * number()))};
    if (std::abs(cross(footprint.x, footprint.y)) < 1e-3 * length(footprint.x) * length(footprint.y)) continue;
    const Vec2d place(10 * number(), 10 * number());
    CAPTURE(i, place.x, place.y, footprint.x.x, footprint.x.y, footprint.y.x, footprint.y.y);
    CHECK(std::abs(even_share(place, 1.0, footprint) - by_clipping(place, footprint)) < 1e-11);
    ++checked;
  }
  CHECK(checked > 10000);
}

TEST_CASE("the share of even squares is exact where it can be said") {
  const auto share = [](Vec2d place, Vec2d x, Vec2d y) { return even_share(place, 1.0, Footprint<double>{x, y}); };
  // Within one square, be it tiny: nothing is rounded.
  CHECK(share({0.5, 0.5}, {0.9, 0}, {0, 0.9}) == 1);
  CHECK(share({1.5, 0.5}, {0.9, 0}, {0, 0.9}) == 0);
  CHECK(share({-0.5, 0.5}, {0, 0}, {0, 0}) == 0);
  CHECK(share({-0.5, -0.5}, {0, 0}, {0, 0}) == 1);
  // Half of an even square and half of an odd one; a quarter of four; three quarters.
  CHECK(share({1, 0.5}, {0.5, 0}, {0, 0.5}) == Approx(0.5).epsilon(0).margin(1e-15));
  CHECK(share({1, 1}, {1, 0}, {0, 1}) == Approx(0.5).epsilon(0).margin(1e-15));
  CHECK(share({0.875, 0.5}, {0.5, 0}, {0, 0.5}) == Approx(0.75).epsilon(0).margin(1e-15));
  // Whole periods, whichever way the sides turn.
  for (const double sign : {1.0, -1.0})
    CHECK(share({0.3, 0.7}, {4, 0}, {0, sign * 6}) == Approx(0.5).epsilon(0).margin(1e-14));
  // A thin one along a diagonal, which stays on even squares; and a line of no width.
  CHECK(share({0.5, 0.5}, {12, 12}, {0.0001, -0.0001}) > 0.999);
  CHECK(share({0.5, 0.5}, {12, 12}, {0, 0}) == Approx(1).epsilon(0).margin(1e-12));
  CHECK(share({0.5, 0.5}, {2, 0}, {0, 0}) == Approx(0.5).epsilon(0).margin(1e-12));
  // From (0.3, 0.1) to (2.3, 1.1), or with u for v: even up to u = 1, and between u = 2 and v = 1.
  CHECK(share({1.3, 0.6}, {2, 1}, {0, 0}) == Approx(0.4).epsilon(0).margin(1e-12));
  CHECK(share({0.6, 1.3}, {1, 2}, {0, 0}) == Approx(0.4).epsilon(0).margin(1e-12));
  // Sides that lean by less than a division can say, from a line between squares.
  for (const double least : {4.9e-324, 1e-310, 1e-300})
    for (const double sign : {1.0, -1.0}) {
      CHECK(share({1, 2}, {sign * least, 4}, {2, 0}) == Approx(0.5).epsilon(0).margin(1e-14));
      CHECK(share({2, 1}, {4, sign * least}, {0, 2}) == Approx(0.5).epsilon(0).margin(1e-14));
      CHECK(share({0, 1.5}, {sign * least, 2}, {0, 0}) == Approx(0.5).epsilon(0).margin(1e-14));
    }
  // Beyond counting, and where nothing can be said.
  CHECK(share({0.5, 0.5}, {1e7, 3}, {2, 1e8}) == 0.5);
  CHECK(share({0.5, 0.5}, {std::nan(""), 0}, {0, 1}) == 0.5);
  CHECK(share({0.5, 0.5}, {std::numeric_limits<double>::infinity(), 0}, {0, 1}) == 0.5);
  CHECK(share({1e17, 0.5}, {0.1, 0}, {0, 0.1}) == 1);
}

TEST_CASE("the share of even squares has no jumps") {
  // Growing from a pixel close by to one at the horizon, along a way of small steps.
  double last = -1;
  for (int i = 0; i <= 200000; ++i) {
    const double size = 0.1 * std::exp(i * 5e-5);
    const double now =
        even_share(Vec2d(0.3, 0.4), 1.0, Footprint<double>{size * Vec2d(0.02, 0.015), size * Vec2d(0.4, 0.7)});
    if (last >= 0) REQUIRE(std::abs(now - last) < 2e-3);
    last = now;
  }
  CHECK(last == Approx(0.5).epsilon(0).margin(0.01));
}
