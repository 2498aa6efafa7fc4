#include <algorithm>
#include <limits>

#include "shape/prism.h"
#include "support/catch.h"

using namespace raywalk;
using raywalk::test::contains;

TEST_CASE("polygons that are fine, in both windings and from every first corner") {
  const std::vector<std::vector<Vec2d>> fine{
      {{0, 0}, {1, 0}, {0, 1}},
      {{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}},                  // collinear corners
      {{0, 0}, {4, 0}, {4, 3}, {3, 3}, {3, 1}, {1, 1}, {1, 3}, {0, 3}},  // U
      {{0, 0}, {1e-9, 0}, {0, 1e-9}},                                    // tiny
      {{1e9, 1e9}, {1e9 + 1, 1e9}, {1e9, 1e9 + 1}},                      // far away
      {{0, 0}, {4, 0}, {4, 4}, {2, 0x1p-50}, {0, 4}},                    // nearly touching
  };
  for (std::vector<Vec2d> corners : fine)
    for (int winding = 0; winding < 2; ++winding) {
      for (std::size_t first = 0; first < corners.size(); ++first) {
        CHECK(why_not_polygon(corners) == "");
        std::rotate(corners.begin(), corners.begin() + 1, corners.end());
      }
      std::reverse(corners.begin(), corners.end());
    }
}

TEST_CASE("polygons that are none are refused, with the reason") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  CHECK_THAT(why_not_polygon({}), contains("at least 3 corners, this one has 0"));
  CHECK_THAT(why_not_polygon({{0, 0}, {1, 0}}), contains("at least 3 corners, this one has 2"));
  CHECK_THAT(why_not_polygon({{0, 0}, {1, nan}, {0, 1}}), contains("corner 2 is not a finite point"));
  CHECK_THAT(why_not_polygon({{0, 0}, {1, 0}, {-inf, 1}}), contains("corner 3 is not a finite point"));
  CHECK_THAT(why_not_polygon({{0, 0}, {1, 0}, {1, 0}, {0, 1}}), contains("corners 2 and 3 are the same point"));
  CHECK_THAT(why_not_polygon({{0, 0}, {1, 0}, {0, 1}, {0, 0}}), contains("corners 4 and 1 are the same point"));
  // A bow tie: the second edge crosses the fourth.
  CHECK_THAT(why_not_polygon({{0, 0}, {2, 0}, {0, 2}, {2, 2}}),
             contains("after corner 2 crosses the edge after corner 4"));
  // A corner that touches another edge, a corner twice, an edge on an edge.
  CHECK(why_not_polygon({{0, 0}, {4, 0}, {4, 4}, {2, 0}, {0, 4}}) != "");
  CHECK(why_not_polygon({{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 1}}) != "");
  CHECK(why_not_polygon({{0, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 0}, {1, 0}, {1, 2}, {0, 2}}) != "");
  CHECK_THAT(why_not_polygon({{0, 0}, {2, 0}, {1, 0}, {1, 3}}), contains("corner 2 fold back"));
  // All on one line.
  CHECK(why_not_polygon({{0, 0}, {1, 1}, {2, 2}}) != "");
  CHECK(why_not_polygon({{0, 0}, {1, 1}, {3, 3}, {2, 2}}) != "");
  // One that double arithmetic alone calls collinear or not, at random: the fourth corner lies just beyond the edge.
  CHECK(why_not_polygon({{0, 0}, {4, 0}, {4, 4}, {2, -0x1p-50}, {0, 4}}) != "");
}

TEST_CASE("edges out of range of exact products are still judged") {
  CHECK(why_not_polygon({{0, 0}, {1e200, 0}, {0, 1e200}}) == "");
  CHECK(why_not_polygon({{0, 0}, {1e-200, 0}, {0, 1e-200}}) == "");
  CHECK(why_not_polygon({{0, 0}, {2e200, 0}, {0, 2e200}, {2e200, 2e200}}) != "");
  CHECK(why_not_polygon({{0, 0}, {2e-200, 0}, {0, 2e-200}, {2e-200, 2e-200}}) != "");
}
