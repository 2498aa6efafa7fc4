#include "trace/form_factor.h"
#include "support/catch.h"

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

using namespace raywalk;

namespace {

using FourCorners = std::vector<Vec3d>;
constexpr double sharp = 1e-12;

/// The six faces of a box, seen from inside.
std::vector<FourCorners> inside_of(const Vec3d& size) {
  const double x = size.x, y = size.y, z = size.z;
  return {{{0, 0, 0}, {x, 0, 0}, {x, y, 0}, {0, y, 0}}, {{0, 0, z}, {0, y, z}, {x, y, z}, {x, 0, z}},
          {{0, 0, 0}, {0, 0, z}, {x, 0, z}, {x, 0, 0}}, {{0, y, 0}, {x, y, 0}, {x, y, z}, {0, y, z}},
          {{0, 0, 0}, {0, y, 0}, {0, y, z}, {0, 0, z}}, {{x, 0, 0}, {x, 0, z}, {x, y, z}, {x, y, 0}}};
}

double area_of(const FourCorners& face) { return length(area_vector_of(face)); }

/// Of the row of each face.
double worst_row(const std::vector<FourCorners>& room) {
  double worst = 0;
  for (const FourCorners& face : room) {
    double row = 0;
    for (const FourCorners& other : room)
      if (&other != &face) row += exchange_area(face, other, sharp) / area_of(face);
    worst = std::max(worst, std::abs(row - 1));
  }
  return worst;
}

}  // namespace

TEST_CASE("form factors between the faces of a cube are those in closed form") {
  const std::vector<FourCorners> cube = inside_of({1, 1, 1});
  const double root2 = std::sqrt(2.0), pi = std::numbers::pi;
  // J. Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", C-11 and C-14.
  const double opposite = 2 / pi * (0.5 * std::log(4.0 / 3) + 2 * root2 * std::atan(1 / root2) - 2 * std::atan(1.0));
  const double adjacent = (1 - opposite) / 4;
  CHECK(std::abs(opposite - 0.1998249) < 5e-8);
  CHECK(std::abs(adjacent - 0.2000438) < 5e-8);
  CHECK(std::abs(exchange_area(cube[0], cube[1], sharp) - opposite) < 1e-12);
  CHECK(std::abs(exchange_area(cube[0], cube[2], sharp) - adjacent) < 1e-12);
  CHECK(std::abs(exchange_area(cube[4], cube[1], sharp) - adjacent) < 1e-12);
}

TEST_CASE("every row of a closed convex room sums to 1") {
  CHECK(worst_row(inside_of({1, 1, 1})) < 1e-12);
  CHECK(worst_row(inside_of({3, 0.5, 7})) < 1e-12);
  // A tetrahedron and an octagonal prism: edges at any angle.
  const Vec3d a{0, 0, 0}, b{2, 0.3, 0}, c{0.4, 1.5, 0.2}, d{0.7, 0.6, 1.9};
  CHECK(worst_row({{a, b, c}, {a, d, b}, {b, d, c}, {c, d, a}}) < 1e-12);
  std::vector<Vec3d> low, high;
  for (int i = 0; i < 8; ++i) {
    const double angle = i * std::numbers::pi / 4;
    low.push_back({std::cos(angle), std::sin(angle), 0});
    high.push_back({std::cos(angle), std::sin(angle), 1.3});
  }
  std::vector<FourCorners> room{low, {high.rbegin(), high.rend()}};
  for (std::size_t i = 0; i < 8; ++i) room.push_back({low[(i + 1) % 8], low[i], high[i], high[(i + 1) % 8]});
  CHECK(worst_row(room) < 1e-12);
}

TEST_CASE("form factors do not depend on which side is asked, and add up over parts") {
  const FourCorners floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const FourCorners slanted{{0.2, 0.1, 0.4}, {0.3, 0.9, 0.5}, {0.9, 1.2, 1.1}, {0.8, 0.4, 1.0}};
  REQUIRE(std::abs(dot(slanted[3] - slanted[0], cross(slanted[1] - slanted[0], slanted[2] - slanted[0]))) < 1e-12);
  const double whole = exchange_area(floor, slanted, sharp);
  CHECK(whole > 0.01);
  CHECK(std::abs(exchange_area(slanted, floor, sharp) - whole) < 1e-13);
  const FourCorners left{floor[0], {0.4, 0, 0}, {0.4, 1, 0}, floor[3]},
      right{{0.4, 0, 0}, floor[1], floor[2], {0.4, 1, 0}};
  CHECK(std::abs(exchange_area(left, slanted, sharp) + exchange_area(right, slanted, sharp) - whole) < 1e-13);
  // The tolerance is the error, of the factor.
  CHECK(std::abs(exchange_area(floor, slanted, 1e-6) - whole) < 1e-6);
}

TEST_CASE("only what lies in front exchanges light") {
  const FourCorners floor{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  const FourCorners below{{0, 0, -1}, {0, 1, -1}, {1, 1, -1}, {1, 0, -1}};
  CHECK(exchange_area(floor, below) == 0);
  // Seen from behind.
  const FourCorners lid{{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  CHECK(exchange_area(floor, lid) == 0);
  // In one plane.
  const FourCorners beside{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}};
  CHECK(exchange_area(floor, beside) == 0);
  // A wall that reaches below the floor counts as far as it rises above.
  const FourCorners wall{{1, 0, -1}, {1, 0, 1}, {1, 1, 1}, {1, 1, -1}},
      above{{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}};
  CHECK(std::abs(exchange_area(floor, wall, sharp) - exchange_area(floor, above, sharp)) < 1e-13);
  CHECK(std::abs(exchange_area(wall, floor, sharp) - exchange_area(floor, above, sharp)) < 1e-12);
}

TEST_CASE("crossed strings give the factors of the square in the plane") {
  const Edge bottom{{0, 0}, {1, 0}}, right{{1, 0}, {1, 1}}, top{{1, 1}, {0, 1}}, left{{0, 1}, {0, 0}};
  CHECK(std::abs(strings_between(bottom, top).exchange_length() - (std::sqrt(2.0) - 1)) < 1e-12);
  CHECK(std::abs(strings_between(bottom, top).exchange_length() - 0.4142136) < 5e-8);
  CHECK(std::abs(strings_between(bottom, right).exchange_length() - 0.2928932) < 5e-8);
  CHECK(std::abs(strings_between(bottom, left).exchange_length() - (1 - std::sqrt(2.0) / 2)) < 1e-12);
  CHECK(strings_between(bottom, {{1, -1}, {0, -1}}).exchange_length() == 0);
  CHECK(strings_between(bottom, {{2, 0}, {1, 0}}).exchange_length() == 0);
  // A room of seven edges: each row sums to 1.
  std::vector<Edge> room;
  for (int i = 0; i < 7; ++i) {
    const auto corner = [](int k) {
      const double angle = k * 2 * std::numbers::pi / 7;
      return Vec2d(3 * std::cos(angle), std::sin(angle));
    };
    room.push_back({corner(i), corner(i + 1)});
  }
  for (const Edge& edge : room) {
    double row = 0;
    for (const Edge& other : room)
      if (&other != &edge) row += strings_between(edge, other).exchange_length() / length(edge.b - edge.a);
    CHECK(std::abs(row - 1) < 1e-12);
  }
  // What reaches behind counts as far as it does not.
  CHECK(std::abs(strings_between(bottom, {{1, -5}, {1, 1}}).exchange_length() -
                 strings_between(bottom, right).exchange_length()) < 1e-12);
}

TEST_CASE("the factor from a point to a polygon is Lambert's, and its mean over a surface is the exchange") {
  const double pi = std::numbers::pi;
  // Under a corner of a rectangle, J. Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-3.
  const double a = 0.7, b = 1.9, c = 0.4;
  const double x = a / c, y = b / c, rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
  const double corner = (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * pi);
  const FourCorners above = {{0, 0, c}, {0, b, c}, {a, b, c}, {a, 0, c}};
  CHECK(point_factor({0, 0, 0}, {0, 0, 1}, above) == Approx(corner).epsilon(1e-13));
  // What lies behind the surface is cut off.
  const FourCorners wall = {{1, -1, -1}, {1, -1, 1}, {1, 1, 1}, {1, 1, -1}},
                    upper = {{1, -1, 0}, {1, -1, 1}, {1, 1, 1}, {1, 1, 0}};
  CHECK(point_factor({0, 0, 0}, {0, 0, 1}, wall) == Approx(point_factor({0, 0, 0}, {0, 0, 1}, upper)).epsilon(1e-13));
  CHECK(point_factor({0, 0, 0}, {-1, 0, 0}, wall) == 0);

  const std::vector<FourCorners> cube = inside_of({1, 1, 1});
  constexpr int points = 100;
  double mean = 0;
  for (int i = 0; i < points * points; ++i)
    mean += point_factor({(i % points + 0.5) / points, (i / points + 0.5) / points, 0}, {0, 0, 1}, cube[1]);
  CHECK(mean / (points * points) == Approx(exchange_area(cube[0], cube[1])).epsilon(1e-4));
}
