// Every row of the tables of hits and normals: all shapes, under all transforms.

#include <algorithm>
#include <map>
#include <sstream>

#include "accel/primitives.h"
#include "support/catch.h"
#include "support/table.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// "translate 1 2 3; rotate 0 1 0 90; scale 2 2 2": the last step acts on the object first.
Affine<double> transform_of(const std::string& text) {
  Affine<double> all;
  std::istringstream steps(text);
  for (std::string step; std::getline(steps, step, ';');) {
    std::istringstream in(step);
    std::string name;
    Vec3d v{0.0};
    double degrees = 0;
    in >> name >> v.x >> v.y >> v.z;
    if (name == "rotate") in >> degrees;
    if (!in) FAIL("malformed transform: " << step);
    all = all * (name == "translate" ? translation(v) : name == "scale" ? scaling(v) : rotation(v, degrees));
  }
  return all;
}

// "a=0 1 0; ymin=-inf"
std::map<std::string, std::vector<double>> parameters_of(const std::string& text) {
  std::map<std::string, std::vector<double>> parameters;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ';');) {
    part.erase(0, part.find_first_not_of(' '));
    const std::size_t equals = part.find('=');
    std::istringstream in(part.substr(equals + 1));
    for (std::string word; in >> word;)
      parameters[part.substr(0, equals)].push_back(std::strtod(word.c_str(), nullptr));
  }
  return parameters;
}

// The row's shape as primitive 0. The table's cylinder stands along y, ours along z.
Primitives<double> primitive_of(const Row& row) {
  const Affine<double> map = transform_of(row.text("transform"));
  auto parameters = parameters_of(row.text("params"));
  const auto point = [&](const std::string& name) {
    const std::vector<double>& p = parameters[name];
    return Vec3d(p.at(0), p.at(1), p.at(2));
  };
  const std::string& name = row.text("shape");
  Primitives<double> primitives;
  if (name == "sphere") {
    primitives.add(Sphere<double>{{0, 0, 0}, 1}, *object_transform<double>(map));
  } else if (name == "plane") {
    primitives.add(Plane<double>{{0, 0, 0}, {0, 1, 0}}, *object_transform<double>(map));
  } else if (name == "cube") {
    primitives.add(Box<double>{{-1, -1, -1}, {1, 1, 1}}, *object_transform<double>(map));
  } else if (name == "cylinder") {
    const Affine<double> upright{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}, Vec3d(0.0)};
    Cylinder<double> cylinder;
    cylinder.radii = Vec3d(1.0);
    cylinder.z_min = parameters["ymin"].at(0);
    cylinder.z_max = parameters["ymax"].at(0);
    cylinder.capped = parameters["closed"].at(0) != 0;
    primitives.add(cylinder, *object_transform<double>(map * upright));
  } else if (name == "triangle") {
    primitives.add(Triangle<double>{point("a"), point("b"), point("c")}, *object_transform<double>(map));
  } else if (name == "triangle_smooth") {
    Mesh mesh;
    mesh.positions = {point("a"), point("b"), point("c")};
    mesh.normals = {point("na"), point("nb"), point("nc")};
    mesh.triangles = {{0, 1, 2}};
    primitives.add(mesh, map, true);
  } else {
    FAIL("unknown shape: " << name);
  }
  return primitives;
}

// Every crossing of the whole line, ascending: forwards, leaving each surface in turn, then backwards.
std::vector<double> all_crossings(const Primitives<double>& primitives, const Ray<double>& ray) {
  std::vector<double> crossings;
  for (const double sense : {1.0, -1.0}) {
    Ray<double> rest{ray.origin, sense * ray.direction};
    double travelled = 0;
    while (const auto intersection = primitives.intersect(0, rest, infinity<double>)) {
      travelled += intersection->t;
      crossings.push_back(sense * travelled);
      rest.origin = primitives.surface_at(0, rest, *intersection).position;
      rest.departure = {0, intersection->part};
    }
  }
  std::sort(crossings.begin(), crossings.end());
  return crossings;
}

}  // namespace

TEST_CASE("every row of the table of hits holds, under its transform", "[accel]") {
  int rows = 0;
  for (const Row& row : read_table("ray_shape.tsv")) {
    ++rows;
    INFO(row.text("id") << " " << row.text("shape") << " " << row.text("class"));
    const Primitives<double> primitives = primitive_of(row);
    Ray<double> ray{row.vector("ray_origin"), row.vector("ray_direction")};
    if (row.text("direction_mode") == "normalise") ray.direction = normalize(ray.direction);
    const double tolerance = row.number("tol");
    const auto first = primitives.intersect(0, ray, infinity<double>);
    CHECK(first.has_value() == !row.text("t_first").empty());
    if (first && !row.text("t_first").empty()) CHECK(std::abs(first->t - row.number("t_first")) <= tolerance);
    std::vector<double> expected = row.numbers("t_all");
    // A double root is one point, and one crossing to us.
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    const std::vector<double> crossings = all_crossings(primitives, ray);
    CHECK(crossings.size() == expected.size());
    for (std::size_t i = 0; i < std::min(crossings.size(), expected.size()); ++i)
      CHECK(std::abs(crossings[i] - expected[i]) <= tolerance);
  }
  CHECK(rows >= 46);
}

TEST_CASE("every row of the table of normals holds, smooth ones too", "[accel]") {
  int rows = 0;
  for (const Row& row : read_table("shape_normal.tsv")) {
    ++rows;
    INFO(row.text("id") << " " << row.text("shape") << " " << row.text("class"));
    const Primitives<double> primitives = primitive_of(row);
    const Vec3d normal = row.vector("normal");
    Vec3d point = row.vector("point");
    const double tolerance = row.number("tol");
    if (row.text("shape") == "triangle_smooth") {
      // Given by its weights; the point of the row is where they say, or the corner itself.
      const std::vector<double> uv = row.numbers("uv");
      const Vec3d a(1, 0, 0), b(0, 2, 0), c(0, 0, 3);
      point = a + uv.at(0) * (b - a) + uv.at(1) * (c - a);
      CHECK(length(point - row.vector("point")) <= tolerance);
      const auto smooth = primitives.smooth_normal(0, {point, normalize(cross(b - a, c - a))});
      REQUIRE(smooth);
      CHECK(length(*smooth - normal) <= tolerance);
      continue;
    }
    // A ray that meets the surface at the point, from outside; at a corner of the cube it comes in aslant.
    const Vec3d from = point + 2.0 * normal + (row.text("class") == "tie" ? Vec3d(0, 0.5, 0.5) : Vec3d(0.0));
    const Ray<double> ray{from, point - from};
    const auto intersection = primitives.intersect(0, ray, infinity<double>);
    REQUIRE(intersection);
    CHECK(intersection->t == Approx(1));
    const SurfacePoint<double> got = primitives.surface_at(0, ray, *intersection);
    if (row.text("class") == "tie") {
      // Any of the corner's faces is right.
      CHECK(std::max({std::abs(got.normal.x), std::abs(got.normal.y), std::abs(got.normal.z)}) == Approx(1));
    } else {
      CHECK(length(got.normal - normal) <= tolerance);
    }
    CHECK(length(got.position - point) <= tolerance);
  }
  CHECK(rows >= 21);
}
