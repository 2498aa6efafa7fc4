// Meshes and groups as lines in space.

#include "view/space/outlines.h"

#include <cmath>

#include "support/catch.h"

using namespace raywalk;

namespace {

/// A cube's twelve triangles.
std::shared_ptr<const Mesh> cube() {
  auto mesh = std::make_shared<Mesh>();
  for (int i = 0; i < 8; ++i) mesh->positions.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
  mesh->triangles = {{0, 1, 3}, {0, 3, 2}, {4, 6, 7}, {4, 7, 5}, {0, 4, 5}, {0, 5, 1},
                     {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 5, 7}, {1, 7, 3}};
  return mesh;
}

/// A sphere of many triangles, closed and nowhere sharp.
std::shared_ptr<const Mesh> ball(int rings, int pieces) {
  auto mesh = std::make_shared<Mesh>();
  const double pi = 3.14159265358979323846;
  for (int i = 0; i <= rings; ++i)
    for (int k = 0; k < pieces; ++k) {
      const double up = pi * i / rings, around = 2 * pi * k / pieces;
      mesh->positions.emplace_back(std::sin(up) * std::cos(around), std::sin(up) * std::sin(around), std::cos(up));
    }
  for (int i = 0; i < rings; ++i)
    for (int k = 0; k < pieces; ++k) {
      const int next = (k + 1) % pieces, a = i * pieces + k, b = i * pieces + next;
      mesh->triangles.push_back({a, a + pieces, b});
      mesh->triangles.push_back({b, a + pieces, b + pieces});
    }
  return mesh;
}

Object object_of(std::shared_ptr<const Mesh> mesh) {
  MeshShape shape;
  shape.mesh = std::move(mesh);
  return {"Mesh", shape, {}};
}

const Bounds<double> room{{-9, -9, -9}, {9, 9, 9}};

}  // namespace

TEST_CASE("a small mesh shows each of its edges once") {
  const auto lines = outline_of(object_of(cube()), room);
  CHECK(lines.size() == 18);  // twelve of the cube, and a diagonal on each face
  double total = 0;
  for (const Polyline& line : lines) {
    REQUIRE(line.size() == 2);
    total += length(line[1] - line[0]);
  }
  CHECK(total == Approx(12 + 6 * std::sqrt(2.0)));
}

TEST_CASE("a large mesh shows sections, which lie on it") {
  const auto lines = outline_of(object_of(ball(60, 80)), room);
  CHECK(lines.size() > 500);
  CHECK(lines.size() < 16000);
  double off = 0;
  for (const Polyline& line : lines)
    for (const Vec3d& point : line) off = std::max(off, std::abs(length(point) - 1));
  CHECK(off < 0.002);  // the triangles' own distance from the sphere
}

TEST_CASE("instances show what is in their group, where they stand") {
  const auto inner = std::make_shared<const GroupContent>(
      Group{"inner", {object_of(cube()), {"Point", Sphere<double>{{5, 0, 0}, 1}, {}}}});
  Object instance{"Instance", Instance{"inner", inner}, {}};
  instance.transform = {TransformStep{Translate{{0, 0, 7}}}};
  const auto lines = outline_of(instance, room);
  CHECK(lines.size() == 18 + 3);
  const auto twice = std::make_shared<const GroupContent>(Group{"outer", {instance, instance}});
  CHECK(outline_of({"Both", Instance{"outer", twice}, {}}, room).size() == 2 * lines.size());
  for (const Polyline& line : lines)
    for (const Vec3d& point : line) CHECK(point.z >= 6);
  std::vector<Object> many(200, instance);
  const auto crowd = std::make_shared<const GroupContent>(Group{"crowd", many});
  CHECK(outline_of({"Crowd", Instance{"crowd", crowd}, {}}, room).size() == 12);  // a box
  CHECK(outline_of({"None", Instance{"missing", nullptr}, {}}, room).empty());
}

TEST_CASE("of groups in groups that are too many, the largest body of each is drawn, in its place") {
  // A ball with three a third as large around it, each of them such a group again: 9,841 balls in the end.
  auto content = std::make_shared<const GroupContent>(Group{"0", {{"Ball", Sphere<double>{{0, 0, 0}, 1}, {}}}});
  for (int level = 1; level <= 8; ++level) {
    std::vector<Object> objects{{"Ball", Sphere<double>{{0, 0, 0}, 1}, {}}};
    for (int i = 0; i < 3; ++i) {
      Object instance{"Smaller", Instance{std::to_string(level - 1), content}, {}};
      instance.transform = {TransformStep{Scale{Vec3d(1.0 / 3)}}, TransformStep{Translate{{4.0 / 3, 0, 0}}},
                            TransformStep{Rotate{{0, 0, 1}, 120.0 * i}}};
      objects.push_back(instance);
    }
    content = std::make_shared<const GroupContent>(Group{std::to_string(level), std::move(objects)});
  }
  const auto lines = outline_of({"Flake", Instance{"8", content}, {}}, room);
  std::size_t points = 0;
  for (const Polyline& line : lines) points += line.size();
  CHECK(points <= 6000);
  CHECK(lines.size() > 12);
  CHECK(lines.size() % 3 == 0);  // balls alone, no box
  // Each circle is one of a ball of radius 1, 1/3, 1/9...
  for (const Polyline& line : lines) {
    Bounds<double> box;
    for (const Vec3d& point : line) box.include(point);
    const Vec3d size = box.max - box.min;
    const double radius = std::max({size.x, size.y, size.z}) / 2, level = -std::log(radius) / std::log(3.0);
    INFO(radius);
    CHECK(level == Approx(std::round(level)).margin(0.02));
  }
}
