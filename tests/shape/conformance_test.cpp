// The rows of tests/conformance for what our shapes can express: spheres under translation, rotation and uniform scale,
// planes under translation and rotation, and the cube as a prism (the table's y is then the prism's z).

#include "shape/shape.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>

#include "support/catch.h"
#include "support/table.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Columns and offset of an affine map.
struct Transform {
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, offset{0.0};
  [[nodiscard]] Vec3d direction(const Vec3d& v) const { return v.x * x + v.y * y + v.z * z; }
  [[nodiscard]] Vec3d point(const Vec3d& p) const { return direction(p) + offset; }
  // The scale of all lengths; 0 where there is no such number.
  [[nodiscard]] double uniform_scale() const {
    const double scale = length(x);
    const bool same = std::abs(length(y) - scale) < 1e-12 && std::abs(length(z) - scale) < 1e-12;
    return same && std::abs(dot(x, y)) + std::abs(dot(y, z)) + std::abs(dot(z, x)) < 1e-12 ? scale : 0;
  }
};

Transform after(const Transform& outer, const Transform& inner) {
  return {outer.direction(inner.x), outer.direction(inner.y), outer.direction(inner.z), outer.point(inner.offset)};
}

Vec3d rotated(const Vec3d& v, const Vec3d& axis, double degrees) {
  const double angle = degrees * 3.14159265358979323846 / 180;
  return std::cos(angle) * v + std::sin(angle) * cross(axis, v) + (1 - std::cos(angle)) * dot(axis, v) * axis;
}

// "translate 1 2 3; rotate 0 1 0 90; scale 2 2 2": the last step acts on the object first.
Transform parse_transform(const std::string& text) {
  Transform all;
  std::istringstream steps(text);
  for (std::string step; std::getline(steps, step, ';');) {
    std::istringstream in(step);
    std::string name;
    Vec3d v{0.0};
    in >> name >> v.x >> v.y >> v.z;
    Transform one;
    if (name == "translate") {
      one.offset = v;
    } else if (name == "scale") {
      one.x *= v.x, one.y *= v.y, one.z *= v.z;
    } else if (name == "rotate") {
      double degrees = 0;
      in >> degrees;
      const Vec3d axis = normalize(v);
      one = {rotated(one.x, axis, degrees), rotated(one.y, axis, degrees), rotated(one.z, axis, degrees), Vec3d(0.0)};
    } else {
      FAIL("unknown transform: " << step);
    }
    if (!in) FAIL("malformed transform: " << step);
    all = after(all, one);
  }
  return all;
}

// The table's axes (x, y, z) as ours (z, x, y), for the cube: its upright axis is y.
Vec3d turned(const Vec3d& v) { return {v.z, v.x, v.y}; }
Vec3d turned_back(const Vec3d& v) { return {v.y, v.z, v.x}; }

// The shape of a row in world space, or nothing where we have no such shape.
std::optional<Shape<double>> shape_of(const Row& row, bool& axes_turned) {
  const Transform to_world = parse_transform(row.text("transform"));
  const std::string& name = row.text("shape");
  axes_turned = false;
  if (name == "sphere" && to_world.uniform_scale() > 0)
    return Sphere<double>{to_world.offset, to_world.uniform_scale()};
  if (name == "plane" && to_world.uniform_scale() > 0)
    return Plane<double>{to_world.offset, to_world.direction({0, 1, 0})};
  const bool upright = length(cross(to_world.y, Vec3d(0, 1, 0))) == 0 && to_world.x.y == 0 && to_world.z.y == 0;
  if (name == "cube" && upright && to_world.offset.y == 0) {
    Prism<double> prism;
    for (const Vec2d& corner : {Vec2d(-1, -1), Vec2d(1, -1), Vec2d(1, 1), Vec2d(-1, 1)})
      prism.corners.push_back(plan(turned(to_world.point({corner.x, 0, corner.y}))));
    prism.height = 2 * to_world.y.y;
    axes_turned = true;
    return prism;
  }
  return std::nullopt;
}

// Every crossing of the whole line, ascending: forwards, leaving each surface in turn, then backwards.
std::vector<double> all_crossings(const Shape<double>& shape, const Ray<double>& ray) {
  std::vector<double> crossings;
  for (const double sense : {1.0, -1.0}) {
    Ray<double> rest{ray.origin, sense * ray.direction};
    double travelled = 0;
    int part = no_part;
    while (const auto intersection = intersect(shape, rest, infinity<double>, part)) {
      travelled += intersection->t;
      crossings.push_back(sense * travelled);
      rest.origin = surface_at(shape, rest, *intersection).position;
      part = intersection->part;
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

TEST_CASE("rays meet shapes where ray_shape.tsv says") {
  std::map<std::string, int> rows;
  for (const Row& row : read_table("ray_shape.tsv")) {
    bool axes_turned = false;
    const auto shape = shape_of(row, axes_turned);
    if (!shape) continue;
    ++rows[row.text("shape")];
    INFO(row.text("id") << " " << row.text("shape") << " " << row.text("class"));
    const auto turn = [&](const Vec3d& v) { return axes_turned ? turned(v) : v; };
    Ray<double> ray{turn(row.vector("ray_origin")), turn(row.vector("ray_direction"))};
    if (row.text("direction_mode") == "normalise") ray.direction = normalize(ray.direction);
    const double tolerance = row.number("tol");
    const auto first = intersect(*shape, ray, infinity<double>);
    CHECK(first.has_value() == !row.text("t_first").empty());
    if (first && !row.text("t_first").empty())
      CHECK(first->t == Approx(row.number("t_first")).margin(tolerance).epsilon(0));
    std::vector<double> expected = row.numbers("t_all");
    // A double root is one point, and one crossing to us.
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    const std::vector<double> crossings = all_crossings(*shape, ray);
    REQUIRE(crossings.size() == expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i)
      CHECK(crossings[i] == Approx(expected[i]).margin(tolerance).epsilon(0));
  }
  CHECK(rows["sphere"] >= 9);
  CHECK(rows["plane"] >= 6);
  CHECK(rows["cube"] >= 9);
}

TEST_CASE("normals are what shape_normal.tsv says") {
  std::map<std::string, int> rows;
  for (const Row& row : read_table("shape_normal.tsv")) {
    bool axes_turned = false;
    const auto shape = shape_of(row, axes_turned);
    if (!shape) continue;
    ++rows[row.text("shape")];
    INFO(row.text("id") << " " << row.text("shape"));
    const Vec3d point = row.vector("point"), normal = row.vector("normal");
    // A ray that meets the surface at the point, from outside; at a corner of the cube it comes in aslant.
    const Vec3d from = point + 2.0 * normal + (row.text("class") == "tie" ? Vec3d(0, 0.5, 0.5) : Vec3d(0.0));
    const auto turn = [&](const Vec3d& v) { return axes_turned ? turned(v) : v; };
    const Ray<double> ray{turn(from), turn(point - from)};
    const auto intersection = intersect(*shape, ray, infinity<double>);
    REQUIRE(intersection);
    CHECK(intersection->t == Approx(1));
    const SurfacePoint<double> got = surface_at(*shape, ray, *intersection);
    const Vec3d got_normal = axes_turned ? turned_back(got.normal) : got.normal;
    if (row.text("class") == "tie") {
      // Any of the corner's faces is right.
      CHECK(std::max({got_normal.x, got_normal.y, got_normal.z}) == 1);
      CHECK(length(got_normal) == 1);
    } else {
      CHECK(length(got_normal - normal) <= row.number("tol"));
    }
    CHECK(length(got.position - turn(point)) <= row.number("tol"));
  }
  CHECK(rows["sphere"] >= 3);
  CHECK(rows["plane"] >= 2);
  CHECK(rows["cube"] >= 5);
}
