#include "view/drawing/display_list.h"

#include <limits>
#include <numbers>

#include "support/catch.h"

using namespace raywalk;

namespace {

LineItem dashed(double from, double to, double phase, std::array<double, 4> lengths, int count) {
  return {{from, 0}, {to, 0}, {{}, 1, {lengths, count}, phase}};
}

double drawn(const std::vector<std::array<Vec2d, 2>>& pieces) {
  double sum = 0;
  for (const auto& piece : pieces) sum += length(piece[1] - piece[0]);
  return sum;
}

}  // namespace

TEST_CASE("a solid line is one piece") {
  const auto pieces = dashes(dashed(0, 50, 0, {}, 0));
  REQUIRE(pieces.size() == 1);
  CHECK(pieces[0][1] == Vec2d(50, 0));
}

TEST_CASE("dashes and gaps alternate from the line's start") {
  const auto pieces = dashes(dashed(0, 25, 0, {6, 4}, 2));
  REQUIRE(pieces.size() == 3);
  CHECK(pieces[0][0].x == 0);
  CHECK(pieces[0][1].x == 6);
  CHECK(pieces[1][0].x == 10);
  CHECK(pieces[1][1].x == 16);
  CHECK(pieces[2][1].x == 25);
}

TEST_CASE("dash and dot have four parts") {
  const auto pieces = dashes(dashed(0, 42, 0, {11, 4, 2, 4}, 4));
  REQUIRE(pieces.size() == 4);
  CHECK(pieces[1][0].x == 15);
  CHECK(pieces[1][1].x == 17);
  CHECK(pieces[2][0].x == 21);
}

TEST_CASE("a line cut off at its start keeps its dashes where they were") {
  const auto whole = dashes(dashed(0, 100, 0, {7, 3}, 2));
  for (const double cut : {1.0, 6.9, 8.0, 23.5, 70.0}) {
    const auto rest = dashes(dashed(cut, 100, cut, {7, 3}, 2));
    // Every point of the rest is drawn exactly where the whole is.
    for (double x = cut + 0.25; x < 100; x += 0.5) {
      const auto covers = [x](const auto& pieces) {
        for (const auto& piece : pieces)
          if (piece[0].x <= x && x <= piece[1].x) return true;
        return false;
      };
      INFO("cut at " << cut << ", at " << x);
      CHECK(covers(rest) == covers(whole));
    }
  }
}

TEST_CASE("dashes cover their share, and too many become one line") {
  CHECK(drawn(dashes(dashed(0, 1000, 0, {5, 5}, 2))) == Approx(500));
  CHECK(dashes(dashed(0, 1e9, 0, {5, 5}, 2)).size() == 1);
  CHECK(dashes(dashed(3, 3, 0, {5, 5}, 2)).size() == 1);
}

TEST_CASE("an arrowhead points along its line") {
  LineItem line{{0, 0}, {10, 0}, {}, 4, 0.5};
  const auto head = arrowhead(line);
  REQUIRE(head);
  CHECK((*head)[0] == Vec2d(5, 0));
  CHECK((*head)[1].x == Approx(1));
  CHECK((*head)[1].y == Approx(-(*head)[2].y));
  line.arrow = 0;
  CHECK_FALSE(arrowhead(line));
  CHECK_FALSE(arrowhead({{1, 1}, {1, 1}, {}, 4, 1}));
}

TEST_CASE("distances to what is drawn") {
  const Colour grey{128, 128, 128};
  CHECK(distance_to({LineItem{{0, 0}, {10, 0}, {}}}, {5, 3}) == Approx(3));
  CHECK(distance_to({LineItem{{0, 0}, {10, 0}, {}}}, {13, 4}) == Approx(5));
  CHECK(distance_to({LineItem{{2, 2}, {2, 2}, {}}}, {2, 5}) == Approx(3));
  CHECK(distance_to({PolylineItem{{{0, 0}, {10, 0}, {10, 10}}, {}}}, {12, 5}) == Approx(2));
  // An open polyline has no side back to its start.
  CHECK(distance_to({PolylineItem{{{0, 0}, {10, 0}, {10, 10}}, {}}}, {3, 7}) == Approx(7));
  const std::vector<Vec2d> notched{{0, 0}, {10, 0}, {10, 10}, {5, 2}, {0, 10}};
  CHECK(distance_to({PolygonItem{notched, grey, {}}}, {2, 3}) == 0);
  CHECK(distance_to({PolygonItem{notched, grey, {}}}, {5, 8}) > 1);
  CHECK(distance_to({PolygonItem{notched, std::nullopt, Stroke{}}}, {5, 1}) == Approx(1));
  CHECK(distance_to({CircleItem{{0, 0}, 5, grey, {}}}, {3, 0}) == 0);
  CHECK(distance_to({CircleItem{{0, 0}, 5, std::nullopt, Stroke{}}}, {3, 0}) == Approx(2));
  CHECK(distance_to({CircleItem{{0, 0}, 5, grey, {}}}, {9, 0}) == Approx(4));
  const ArcItem quarter{{0, 0}, 5, 0, std::numbers::pi / 2, {}};
  CHECK(distance_to({quarter}, {0, 7}) == Approx(2));
  CHECK(distance_to({quarter}, {0, -5}) == Approx(std::sqrt(50)));
  CHECK(distance_to({TextItem{{0, 0}, "words", 10, grey, TextAnchor::middle}}, {3, 2}) == 0);
  CHECK(distance_to({TextItem{{0, 0}, "words", 10, grey, TextAnchor::start}}, {-4, 0}) == Approx(4));
  CHECK(distance_to({TextItem{{0, 0}, "words", 10, grey, TextAnchor::end}}, {0, 9}) == Approx(4));
}

TEST_CASE("what covers a place is at distance 0 from it, on its corners and edges too") {
  const Colour grey{128, 128, 128};
  const std::vector<Vec2d> notched{{0, 0}, {10, 0}, {10, 10}, {5, 2}, {0, 10}};
  const DisplayItem items[] = {{PolygonItem{notched, grey, {}}},
                               {PolygonItem{notched, std::nullopt, Stroke{}}},
                               {CircleItem{{5, 5}, 5, grey, {}}},
                               {LineItem{{0, 0}, {10, 10}, {}}}};
  int covered = 0;
  for (const DisplayItem& item : items)
    for (int x = -4; x <= 44; ++x)
      for (int y = -4; y <= 44; ++y) {
        const Vec2d at(x / 4.0, y / 4.0);
        CHECK(covers(item, at) == (distance_to(item, at) == 0));
        covered += covers(item, at);
      }
  CHECK(covered > 1000);
}

TEST_CASE("text counts letters, not bytes") { CHECK(text_width("né", 10) == text_width("ne", 10)); }

TEST_CASE("a list with one number that is none is found out") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Vec2d bad(1, nan);
  CHECK(is_finite(DisplayList{{LineItem{{0, 0}, {1, 1}, {}}}}));
  for (const Shape2d& shape : {Shape2d(LineItem{bad, {0, 0}, {}}), Shape2d(PolylineItem{{bad}, {}}),
                               Shape2d(PolygonItem{{bad}, {}, {}}), Shape2d(CircleItem{{0, 0}, nan, {}, {}}),
                               Shape2d(ArcItem{{0, 0}, 1, 0, nan, {}}), Shape2d(TextItem{bad, "", 1, {}})})
    CHECK_FALSE(is_finite(DisplayList{{shape}}));
}
