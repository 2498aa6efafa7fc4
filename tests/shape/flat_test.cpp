// Triangle, polygon and disk.

#include "shape/disk.h"
#include "shape/polygon.h"
#include "shape/triangle.h"
#include "support/catch.h"

#include <array>
#include <random>

using namespace raywalk;

namespace {

/// A closed mesh: an icosahedron's 20 faces, each cut into 16, moved and scaled.
template <class T>
std::vector<Triangle<T>> ball(const Vec3<T>& centre, T radius) {
  const T g = (1 + std::sqrt(T(5))) / 2;
  const std::array<Vec3<T>, 12> v{{{-1, g, 0},
                                   {1, g, 0},
                                   {-1, -g, 0},
                                   {1, -g, 0},
                                   {0, -1, g},
                                   {0, 1, g},
                                   {0, -1, -g},
                                   {0, 1, -g},
                                   {g, 0, -1},
                                   {g, 0, 1},
                                   {-g, 0, -1},
                                   {-g, 0, 1}}};
  const int f[20][3] = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                        {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                        {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  std::vector<Triangle<T>> mesh;
  for (const auto& face : f)
    mesh.push_back({v[static_cast<std::size_t>(face[0])], v[static_cast<std::size_t>(face[1])],
                    v[static_cast<std::size_t>(face[2])]});
  for (int round = 0; round < 2; ++round) {
    std::vector<Triangle<T>> finer;
    for (const auto& [a, b, c] : mesh) {
      // The middle of an edge must be the same bits from both sides: addition commutes.
      const Vec3<T> ab = (a + b) / T(2), bc = (b + c) / T(2), ca = (c + a) / T(2);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh = finer;
  }
  for (auto& t : mesh)
    for (Vec3<T>* corner : {&t.a, &t.b, &t.c}) *corner = centre + radius * normalize(*corner);
  return mesh;
}

}  // namespace

TEMPLATE_TEST_CASE("a closed mesh has no gaps and each edge is crossed once", "[shape]", float, double) {
  using T = TestType;
  std::mt19937 engine(3);
  const auto unit = [&] { return static_cast<T>(engine() >> 8) / static_cast<T>(1 << 24); };
  for (const T scale : {T(1), T(1e-3), T(1e4)}) {
    const Vec3<T> centre = scale * Vec3<T>(T(0.3), T(-7.1), T(2.9));
    const auto mesh = ball<T>(centre, scale);
    int leaks = 0, odd = 0;
    for (int i = 0; i < 3000; ++i) {
      const Triangle<T>& aimed = mesh[engine() % mesh.size()];
      const T s = unit();
      const Vec3<T> target = i % 2 ? aimed.a : aimed.a + s * (aimed.b - aimed.a);
      const T x = unit();
      const T y = unit();
      const T z = unit();
      // From inside: exactly one crossing ahead. From outside through the same point: an even number.
      const Vec3<T> within = centre + T(0.4) * scale * (Vec3<T>(x, y, z) - T(0.5));
      const auto count = [&](const Ray<T>& ray) {
        int crossings = 0;
        for (const auto& triangle : mesh) crossings += intersect(triangle, ray, infinity<T>).has_value();
        return crossings;
      };
      if (count({within, target - within}) != 1) ++leaks;
      const Vec3<T> outside = centre + T(3) * scale * normalize(Vec3<T>(x, y, z) + T(0.01));
      if (count({outside, target - outside}) % 2 != 0) ++odd;
    }
    CHECK(leaks == 0);
    CHECK(odd == 0);
  }
}

TEST_CASE("a triangle is hit from both sides, never along its plane, never without area", "[shape]") {
  const Triangle<double> t{{0, 1, 0}, {-1, 0, 0}, {1, 0, 0}};
  CHECK(intersect(t, Ray<double>{{0, 0.5, -2}, {0, 0, 1}}, infinity<double>)->t == 2);
  CHECK(intersect(t, Ray<double>{{0, 0.5, 2}, {0, 0, -0.5}}, infinity<double>)->t == 4);
  CHECK_FALSE(intersect(t, Ray<double>{{0, 0.5, -2}, {0, 0, -1}}, infinity<double>));
  CHECK_FALSE(intersect(t, Ray<double>{{0, -1, -2}, {0, 1, 0}}, infinity<double>));
  CHECK_FALSE(intersect(t, Ray<double>{{0, -1, 0}, {0, 1, 0}}, infinity<double>));
  CHECK_FALSE(intersect(t, Ray<double>{{0, 0.5, -2}, {0, 0, 1}}, infinity<double>, 0));
  CHECK_FALSE(intersect(Triangle<double>{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, Ray<double>{{1, 0, -2}, {0, 0, 1}},
                        infinity<double>));
  // A sliver is no reason to miss: only an area of exactly 0 is.
  const Triangle<double> sliver{{-1, 0, 0}, {1, 0, 0}, {0, 1e-200, 0}};
  CHECK(intersect(sliver, Ray<double>{{0, 5e-201, -2}, {0, 0, 1}}, infinity<double>));
  const Vec2d weights = barycentric(t, Vec3d(0.25, 0.25, 0));
  CHECK(weights.x == Approx(0.25));
  CHECK(weights.y == Approx(0.5));
}

TEST_CASE("a polygon may be concave and have holes", "[shape]") {
  const Polygon<double> u{{{0, 0, 1}, {3, 0, 1}, {3, 3, 1}, {2, 3, 1}, {2, 1, 1}, {1, 1, 1}, {1, 3, 1}, {0, 3, 1}},
                          {{{0.25, 0.25, 1}, {0.75, 0.25, 1}, {0.75, 0.75, 1}, {0.25, 0.75, 1}}}};
  const auto hits = [&](double x, double y) {
    return intersect(u, Ray<double>{{x, y, 5}, {0, 0, -2}}, infinity<double>).has_value();
  };
  CHECK(intersect(u, Ray<double>{{0.1, 0.1, 5}, {0, 0, -2}}, infinity<double>)->t == 2);
  CHECK(hits(2.5, 2.5));
  CHECK(hits(0.5, 2));
  CHECK_FALSE(hits(1.5, 2));    // between the arms
  CHECK_FALSE(hits(0.5, 0.5));  // in the hole
  CHECK_FALSE(hits(-0.5, 1));   // level with two corners, outside
  CHECK(hits(2.5, 1));          // level with two corners, inside
  CHECK_FALSE(intersect(u, Ray<double>{{-1, 1, 1}, {1, 0, 0}}, infinity<double>));
  const auto hit = intersect(u, Ray<double>{{0.1, 0.1, 5}, {0, 0, -2}}, infinity<double>);
  CHECK(surface_at(u, Ray<double>{{0.1, 0.1, 5}, {0, 0, -2}}, *hit).normal == Vec3d(0, 0, 1));
}

TEST_CASE("a polygon is solid where an odd number of outline and holes go around a point", "[shape]") {
  const auto square = [](double low, double high) {
    return std::vector<Vec3d>{{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}};
  };
  const auto hits = [](const Polygon<double>& polygon, double x, double y) {
    return intersect(polygon, Ray<double>{{x, y, 5}, {0, 0, -1}}, infinity<double>).has_value();
  };
  const Polygon<double> island{square(0, 9), {square(2, 7), square(4, 5)}};
  CHECK(hits(island, 1, 1.5));
  CHECK_FALSE(hits(island, 3, 3.5));
  CHECK(hits(island, 4.5, 4.25));
  const Polygon<double> outside{square(0, 1), {square(2, 3)}};
  CHECK(hits(outside, 2.75, 2.25));
  CHECK_FALSE(hits(outside, 1.5, 1.25));
  const Polygon<double> overlapping{square(0, 9), {square(1, 5), square(3, 7)}};
  CHECK_FALSE(hits(overlapping, 2, 1.5));
  CHECK(hits(overlapping, 4, 3.5));
  CHECK_FALSE(hits(overlapping, 6, 6.5));
}

TEST_CASE("a disk ends at its rim", "[shape]") {
  const Disk<double> disk{{1, 2, 3}, {0, 0, -4}, 2};
  CHECK(intersect(disk, Ray<double>{{1, 2, 0}, {0, 0, 1}}, infinity<double>)->t == 3);
  CHECK(intersect(disk, Ray<double>{{3, 2, 0}, {0, 0, 1}}, infinity<double>));
  CHECK_FALSE(intersect(disk, Ray<double>{{3.0000001, 2, 0}, {0, 0, 1}}, infinity<double>));
  const Bounds<double> box = bounds(Disk<double>{{0, 0, 0}, {1, 0, 1}, 1});
  CHECK(box.max.x == Approx(std::sqrt(0.5)));
  CHECK(box.max.y == Approx(1));
}

TEMPLATE_TEST_CASE("the bounds of a disk hold it however little it is tilted", "[shape]", float, double) {
  using T = TestType;
  for (const T tilt : {std::sqrt(std::numeric_limits<T>::epsilon()), T(1e-4), std::numeric_limits<T>::epsilon()}) {
    const Bounds<T> box = bounds(Disk<T>{{0, 0, 0}, {-tilt / 4, 0, 1}, 100});
    CHECK(box.max.z == Approx(25 * tilt));
    CHECK(box.min.z == -box.max.z);
    CHECK(box.max.x == Approx(100));
  }
}

TEMPLATE_TEST_CASE("flat shapes of any size have unit normals and weights that give the point", "[shape]", float,
                   double) {
  using T = TestType;
  for (int exponent = -90; exponent <= 60; exponent += 10) {
    const T size = std::ldexp(T(1), sizeof(T) == 4 ? exponent : 3 * exponent);
    CAPTURE(size);
    const Triangle<T> triangle{size * Vec3<T>(1, 1, 1), size * Vec3<T>(2, 1, 3), size * Vec3<T>(1, 3, 1)};
    const Ray<T> ray{size * Vec3<T>(T(1.25), T(1.5), 4), {0, 0, -size}};
    const auto met = intersect(triangle, ray, infinity<T>);
    REQUIRE(met);
    const Vec3<T> normal = surface_at(triangle, ray, *met).normal;
    CHECK(normal.x == Approx(-2 / std::sqrt(5)));
    CHECK(normal.z == Approx(1 / std::sqrt(5)));
    const Vec2<T> weights = barycentric(triangle, ray.at(met->t));
    CHECK(weights.x == Approx(0.25));
    CHECK(weights.y == Approx(0.25));
    if (exponent < -60) continue;  // an area vector has to be in range
    const Polygon<T> polygon{{triangle.a, triangle.b, triangle.c}, {}};
    CHECK(surface_at(polygon, ray, *met).normal.x == Approx(-2 / std::sqrt(5)));
  }
}

TEST_CASE("a triangle has no normal only where its area is exactly 0", "[shape]") {
  const Triangle<double> line{{0, 0, 0}, {1, 3, 0}, {2, 6, 0}};
  CHECK(normal_of(line) == Vec3d(0.0));
  // An area of -1e-18, which a rounded cross product takes for 0.
  const Triangle<double> sliver{{0.23662438918608703, 0.9550225344814793, 0},
                                {0.18496803226808425, 0.656151175036132, 0},
                                {0.0946466741707001, 0.13357334159802928, 0}};
  REQUIRE(cross(sliver.b - sliver.a, sliver.c - sliver.a) == Vec3d(0.0));
  CHECK(std::abs(normal_of(sliver).z) == 1);
  const Vec2d weights = barycentric(sliver, 0.5 * (sliver.a + sliver.c));
  CHECK(weights.x + weights.y == Approx(0.5));
}

TEST_CASE("t is right to a few ulps in a sliver, too") {
  // From the full count of the hard-case suite: the weights of its corners have few digits right there.
  const Triangle<double> sliver{{-1.4723052402458738, 2.0689060161589761, 0.36194471267697759},
                                {1.7594399588687271, -2.3312528003055539, 3.0667789428583645},
                                {-1.4720718053985393, 2.0685111720365121, 0.36216419671880645}};
  const Ray<double> ray{{14.222997930832719, 18.593289406435797, -1.3026684463247231},
                        {-13.464052281712048, -19.562345563102877, 3.532081857646983}};
  const auto intersection = intersect(sliver, ray, infinity<double>);
  REQUIRE(intersection);
  CHECK(std::abs(intersection->t - 0.99999999999999967) < 64 * 0x1p-53);  // it was 10,000 half ulps off
}
