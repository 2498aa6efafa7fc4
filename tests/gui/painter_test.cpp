#include "gui/painter.h"

#include <cmath>

#include "gui/bench.h"
#include "support/catch.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

float twice_area(ImVec2 a, ImVec2 b, ImVec2 c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

// Twice the area that the triangles cover, if none of them overlaps another.
float covered(const std::vector<ImVec2>& corners) {
  float sum = 0;
  for (const auto& [a, b, c] : triangulate(corners)) {
    const auto at = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
    sum += std::abs(twice_area(at(a), at(b), at(c)));
  }
  return sum;
}

float polygon_area(const std::vector<ImVec2>& corners) {
  float sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += twice_area({0, 0}, corners[i], corners[(i + 1) % corners.size()]);
  return std::abs(sum);
}

// Paints one item alone and returns what it took: its vertices and the rectangle they span.
struct Painted {
  int vertices = 0;
  ImVec2 least{1e9f, 1e9f}, most{-1e9f, -1e9f};
};

Painted paint_alone(const DisplayList& list, const Rect& pane, float scale = 1) {
  Bench bench;
  Painted painted;
  ImGui::NewFrame();
  ImDrawList& draw = *ImGui::GetBackgroundDrawList();
  const int before = draw.VtxBuffer.Size;
  Fonts fonts;
  fonts.text = fonts.strong = fonts.small = fonts.title = fonts.code = fonts.code_strong = ImGui::GetFont();
  paint(draw, list, pane, scale, fonts);
  for (int i = before; i < draw.VtxBuffer.Size; ++i) {
    const ImVec2 at = draw.VtxBuffer[i].pos;
    ++painted.vertices;
    painted.least = {std::min(painted.least.x, at.x), std::min(painted.least.y, at.y)};
    painted.most = {std::max(painted.most.x, at.x), std::max(painted.most.y, at.y)};
  }
  ImGui::EndFrame();
  return painted;
}

constexpr Rect whole{0, 0, 1000, 700};
const Stroke thin{{255, 255, 255}, 2};

}  // namespace

TEST_CASE("triangles cover a polygon exactly, whatever its shape and turn") {
  const std::vector<std::vector<ImVec2>> polygons{
      {{0, 0}, {4, 0}, {0, 3}},
      {{0, 0}, {4, 0}, {4, 4}, {0, 4}},
      {{0, 0}, {4, 0}, {4, 4}, {2, 1}, {0, 4}},                          // a notch
      {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 4}, {4, 4}, {4, 2}, {0, 2}},  // a C
      {{0, 0}, {2, 0}, {4, 0}, {4, 4}, {0, 4}},                          // a corner on a straight edge
  };
  for (std::vector<ImVec2> corners : polygons) {
    CAPTURE(corners.size());
    CHECK(triangulate(corners).size() == corners.size() - 2);
    CHECK(covered(corners) == Approx(polygon_area(corners)));
    std::reverse(corners.begin(), corners.end());
    CHECK(covered(corners) == Approx(polygon_area(corners)));
  }
}

TEST_CASE("what is no polygon does not hang the painter") {
  CHECK(triangulate({}).empty());
  CHECK(triangulate({{1, 1}, {2, 2}}).empty());
  CHECK(triangulate({{0, 0}, {4, 4}, {4, 0}, {0, 4}}).size() <= 2);  // a bow tie
  CHECK(triangulate({{1, 1}, {1, 1}, {1, 1}, {1, 1}}).size() <= 2);
}

TEST_CASE("items are drawn where they say, moved into the pane and scaled") {
  const Rect pane{100, 50, 800, 600};
  const Painted line = paint_alone({{LineItem{{10, 20}, {60, 20}, thin}, {}}}, pane, 2);
  CHECK(line.least.x == Approx(120).margin(3));
  CHECK(line.most.x == Approx(220).margin(3));
  CHECK((line.least.y + line.most.y) / 2 == Approx(90).margin(0.6));
  const Painted circle = paint_alone({{CircleItem{{100, 100}, 30, Colour{1, 2, 3}, std::nullopt}, {}}}, pane);
  CHECK(circle.least.x == Approx(170).margin(1.5));
  CHECK(circle.most.y == Approx(180).margin(1.5));
  const Painted text = paint_alone({{TextItem{{200, 100}, "EYE", 15, {9, 9, 9}, TextAnchor::middle}, {}}}, pane);
  CHECK((text.least.x + text.most.x) / 2 == Approx(300).margin(3));
  CHECK((text.least.y + text.most.y) / 2 == Approx(150).margin(4));
}

TEST_CASE("a dashed line is drawn in pieces, and its arrowhead whole") {
  LineItem line{{0, 100}, {400, 100}, thin};
  const int solid = paint_alone({{line, {}}}, whole).vertices;
  line.stroke.dash = {{6, 4}, 2};
  const int dashed = paint_alone({{line, {}}}, whole).vertices;
  CHECK(dashed == 40 * solid);
  line.arrow = 12;
  CHECK(paint_alone({{line, {}}}, whole).vertices > dashed);
}

TEST_CASE("dashes run on across the corners of a polyline") {
  Stroke stroke = thin;
  stroke.dash = {{7, 3}, 2};
  // 100 pixels as one line, and as ten of ten: the same dashes, though some are bent.
  PolylineItem bent{{}, stroke};
  for (int i = 0; i <= 10; ++i) bent.points.emplace_back(10.0 * i, 50.0);
  const int straight = paint_alone({{LineItem{{0, 50}, {100, 50}, stroke}, {}}}, whole).vertices;
  CHECK(paint_alone({{bent, {}}}, whole).vertices == straight);
}

TEST_CASE("a full circle is as round as its size asks for") {
  const int small = paint_alone({{ArcItem{{100, 100}, 5, 0, 6.2831853, thin}, {}}}, whole).vertices;
  const int large = paint_alone({{ArcItem{{100, 100}, 300, 0, 6.2831853, thin}, {}}}, whole).vertices;
  CHECK(small < large);
  CHECK(large < 5000);
}

TEST_CASE("letters are drawn at the size of a face where one is near, else at their own") {
  Bench bench;
  Fonts fonts;
  fonts.text = fonts.small = fonts.title = ImGui::GetIO().Fonts->Fonts[0];
  const float face = line_height(fonts, *fonts.text);
  CHECK(lettering(fonts, face * 1.05f).size == face);
  CHECK(lettering(fonts, face * 3).size == face * 3);
}
