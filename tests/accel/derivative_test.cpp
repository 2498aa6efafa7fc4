// How fast a normal turns and (u, v) grow where a place moves along a surface, against differences of both between
// places nearby, of every shape and under a map.

#include "accel/primitives.h"
#include "support/catch.h"
#include "support/one_of_each.h"

#include <cmath>
#include <optional>

using namespace raywalk;
using namespace raywalk::test;

namespace {

struct Place {
  SurfacePoint<double> point;
  int part;
  Vec3d normal;
  Vec2d uv;
};

std::optional<Place> met(const Primitives<double>& all, const Ray<double>& ray) {
  const auto hit = all.intersect(0, ray, infinity<double>);
  if (!hit) return std::nullopt;
  const SurfacePoint<double> point = all.surface_at(0, ray, *hit);
  return Place{point, hit->part, all.smooth_normal(0, point).value_or(point.normal), all.uv_at(0, point, hit->part)};
}

// Of each place that a grid of rays from all around meets: the derivatives along the way to where the ray beside it
// meets the same part, against the difference between the rays on both sides.
int checked(const Primitives<double>& all) {
  int count = 0;
  constexpr double apart = 1e-5;
  for (int i = 0; i < 400; ++i) {
    // Evenly about the sphere, by the golden angle.
    const double z = 1 - (2 * i + 1) / 400.0, turn = 2.399963229728653 * i, level = std::sqrt(1 - z * z);
    const Vec3d from = 4.0 * Vec3d(level * std::cos(turn), level * std::sin(turn), z);
    const Vec3d to(0.3 * std::sin(3.0 * i), 0.3 * std::sin(5.0 * i), 0.3 * std::sin(7.0 * i));
    const Vec3d beside = normalize(cross(to - from, Vec3d(std::sin(11.0 * i), std::cos(13.0 * i), 0.4)));
    const auto ray = [&](double by) { return Ray<double>{from + by * beside, normalize(to - from)}; };
    const auto here = met(all, ray(0)), left = met(all, ray(-apart)), right = met(all, ray(apart));
    if (!here || !left || !right || left->part != here->part || right->part != here->part) continue;
    if (std::abs(dot(here->point.normal, normalize(to - from))) < 0.2) continue;
    const Vec3d along = (right->point.position - left->point.position) / (2 * apart);
    const Vec3d turned = all.normal_derivative(0, here->point, here->part, 0.0, along);
    const Vec2d grown = all.uv_derivative(0, here->point, here->part, 0.0, along);
    const Vec2d difference = (right->uv - left->uv) / (2 * apart);
    if (length(difference) > 1e3) continue;  // across the seam of u
    CHECK(length(turned - (right->normal - left->normal) / (2 * apart)) < 1e-6 * (1 + 10 * length(turned)));
    CHECK(length(grown - difference) < 1e-6 * (1 + 10 * length(grown)));
    ++count;
  }
  return count;
}

}  // namespace

TEST_CASE("normals turn and places on a pattern grow as differences say") {
  const auto map = object_transform<double>(translation(Vec3d(0.2, -0.1, 0.1)) * rotation(Vec3d(1, -2, 2), 50.0) *
                                            scaling(Vec3d(1.2, 0.7, -0.9)));
  REQUIRE(map);
  for (const Shape<double>& shape : one_of_each()) {
    CAPTURE(shape_name(shape));
    Primitives<double> plain, mapped;
    plain.add(shape);
    mapped.add(shape, *map);
    CHECK(checked(plain) > 20);
    CHECK(checked(mapped) > 20);
  }
}

TEST_CASE("so do those between the corners of a triangle of a mesh") {
  Mesh mesh;
  mesh.positions = {{-0.8, -0.6, 0.1}, {0.9, -0.4, -0.2}, {0.1, 0.8, 0.3}};
  mesh.normals = {{-0.3, 0, 1}, {0.5, -0.2, 1}, {0, 0.5, 2}};
  mesh.uv = {{0.2, 0.3}, {2, 0.1}, {0.4, 3}};
  mesh.triangles = {{0, 1, 2}};
  for (const bool smooth : {false, true}) {
    Primitives<double> all;
    all.add(mesh, scaling(Vec3d(1.1, 0.8, 1)), smooth);
    CHECK(checked(all) > 20);
    const auto place = met(all, {{0.05, 0, 3}, {0, 0, -1}});
    REQUIRE(place);
    const Vec3d turned = all.normal_derivative(0, place->point, 0, 0.0, {1, 0, 0});
    CHECK((length(turned) > 0.1) == smooth);
  }
}

TEST_CASE("a sphere's normal turns by the inverse of its radius, and a flat one's not") {
  const Sphere<double> ball{{1, 2, 3}, 4};
  CHECK(normal_derivative(ball, {{5, 2, 3}, {1, 0, 0}}, 0, {0, 2, 0}) == Vec3d(0, 0.5, 0));
  CHECK(uv_derivative(ball, {{5, 2, 3}, {1, 0, 0}}, 0, {0, 2, 3}) == Vec2d(2, 3));
  CHECK(normal_derivative(Plane<double>{}, {{0, 0, 0}, {0, 0, 1}}, 0, {1, 1, 0}) == Vec3d(0.0));
}
