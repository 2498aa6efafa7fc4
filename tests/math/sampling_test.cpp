// Each map of the unit square against its density: the density integrates to 1 and the drawn directions follow it cell
// by cell (chi-square); then the limits: radius 0, the narrowest cones, the farthest lights.

#include "math/sampling.h"

#include "math/sampler.h"

#include <array>
#include <functional>
#include <utility>
#include <vector>

#include "support/catch.h"

using namespace raywalk;

namespace {

Vec2d drawn(std::uint32_t sample, Sampler sampler = Sampler::random) {
  RandomKey key{};
  key.seed = 17;
  key.sample = sample;
  return draw_pair<double>(sampler, key, Strata(1u << 20));
}

using Draw = std::function<Vec3d(const Vec2d&)>;
using Density = std::function<double(const Vec3d&)>;

constexpr int rings = 16, sectors = 12;

// Cells of equal solid angle between 1 - cos = 0 and `reach`: `rings` bands by `sectors`; -1 outside.
int cell_of(const Vec3d& direction, double reach) {
  // 1 - z of a unit vector, without cancellation near the axis.
  const double down =
      direction.z > 0 ? (direction.x * direction.x + direction.y * direction.y) / (1 + direction.z) : 1 - direction.z;
  const int ring = static_cast<int>(down / reach * rings);
  if (ring >= rings) return -1;
  const double turn = std::atan2(direction.y, direction.x) / (2 * pi_v<double>)+0.5;
  return ring * sectors + std::min(static_cast<int>(turn * sectors), sectors - 1);
}

// Shares of the density in each cell, by the midpoint rule.
std::vector<double> shares(const Density& density, double reach) {
  std::vector<double> share(rings * sectors);
  constexpr int fine = 40;
  for (int ring = 0; ring < rings * fine; ++ring)
    for (int sector = 0; sector < sectors * fine; ++sector) {
      const double down = (ring + 0.5) / (rings * fine) * reach;
      const double turn = ((sector + 0.5) / (sectors * fine) - 0.5) * 2 * pi_v<double>;
      const double sin = std::sqrt(down * (2 - down));
      const Vec3d direction(sin * std::cos(turn), sin * std::sin(turn), 1 - down);
      share[static_cast<std::size_t>(ring / fine * sectors + sector / fine)] +=
          density(direction) * 2 * pi_v<double> * reach / (rings * fine * sectors * fine);
    }
  return share;
}

void follows(const Draw& draw, const Density& density, double reach = 2) {
  const std::vector<double> share = shares(density, reach);
  double sum = 0;
  for (const double s : share) sum += s;
  CHECK(sum == Approx(1).epsilon(0.003));
  constexpr int n = 100000;
  std::vector<int> held(share.size());
  int outside = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec3d direction = draw(drawn(i));
    if (std::abs(dot(direction, direction) - 1) > 1e-12) FAIL("length^2 " << dot(direction, direction));
    const int cell = cell_of(direction, reach);
    cell < 0 ? ++outside : ++held[static_cast<std::size_t>(cell)];
  }
  CHECK(outside == 0);
  double chi = 0, freedom = 0, expected_rest = 0, held_rest = 0;
  for (std::size_t i = 0; i < share.size(); ++i) {
    const double expected = share[i] * n;
    if (expected < 10) {  // too few to judge alone
      expected_rest += expected, held_rest += held[i];
      continue;
    }
    chi += (held[i] - expected) * (held[i] - expected) / expected;
    ++freedom;
  }
  REQUIRE(freedom >= sectors);
  CHECK(chi < freedom + 5 * std::sqrt(2 * freedom));
  CHECK(chi > freedom - 5 * std::sqrt(2 * freedom));
  CHECK(std::abs(held_rest - expected_rest) < 5 * std::sqrt(expected_rest) + 5);
}

}  // namespace

TEMPLATE_TEST_CASE("the disk's sine and cosine are within two units in the last place", "", float, double) {
  using T = TestType;
  for (int i = -10'000; i <= 10'000; ++i) {
    const T angle = pi_v<T> / 4 * (static_cast<T>(i) / 10'000);
    const auto [sin, cos] = detail::sin_cos_of_octant(angle);
    const T two = 2 * std::numeric_limits<T>::epsilon();
    REQUIRE(std::abs(sin - portable::sin(angle)) <= two * std::abs(sin));
    REQUIRE(std::abs(cos - portable::cos(angle)) <= two * cos);
  }
}

TEST_CASE("regular points of a sphere have its mean and its mean squares") {
  for (int grid = 2; grid <= 20; ++grid) {
    Vec3d mean(0.0);
    std::array<Vec3d, 3> squares{Vec3d(0.0), Vec3d(0.0), Vec3d(0.0)};
    for (int point = 0; point < grid * grid; ++point) {
      const Vec3d at = regular_on_sphere<double>(point, grid);
      CHECK(dot(at, at) == Approx(1).epsilon(1e-14));
      mean += at;
      for (int axis = 0; axis < 3; ++axis) squares[static_cast<std::size_t>(axis)] += at[axis] * at;
    }
    CAPTURE(grid);
    CHECK(length(mean) < 1e-12 * grid * grid);
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column)
        CHECK(squares[static_cast<std::size_t>(row)][column] / (grid * grid) ==
              Approx(row == column ? 1.0 / 3 : 0.0).margin(1e-13));
  }
}

TEST_CASE("a basis is orthonormal and right-handed about any unit vector") {
  for (std::uint32_t i = 0; i < 5000; ++i) {
    const Vec3d n = i == 0   ? Vec3d(0, 0, 1)
                    : i == 1 ? Vec3d(0, 0, -1)
                    : i == 2 ? Vec3d(1, 0, -0.0)
                             : sample_uniform_sphere(drawn(i));
    const Basis<double> basis(n);
    const Vec3d wrong = cross(basis.s, basis.t) - basis.n;
    if (!(std::abs(dot(basis.s, basis.t)) < 1e-14 && std::abs(dot(basis.s, n)) < 1e-14 && length(wrong) < 1e-14 &&
          std::abs(length(basis.s) - 1) < 1e-14))
      FAIL("about " << n.x << ' ' << n.y << ' ' << n.z);
    CHECK(basis.to_world({0, 0, 1}) == n);
  }
}

TEST_CASE("the disk is filled evenly, and square rings become circles") {
  constexpr int n = 60000;
  std::vector<int> held(10 * 12);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec2d p = sample_concentric_disk(drawn(i));
    const double r2 = dot(p, p);
    if (!(r2 <= 1 + 1e-15)) FAIL("outside: " << r2);
    const double turn = std::atan2(p.y, p.x) / (2 * pi_v<double>)+0.5;
    ++held[static_cast<std::size_t>(std::min(r2 * 10, 9.999)) * 12 +
           static_cast<std::size_t>(std::min(turn * 12, 11.99))];
  }
  double chi = 0;
  for (const int h : held) chi += (h - n / 120.0) * (h - n / 120.0) / (n / 120.0);
  CHECK(std::abs(chi - 119) < 5 * std::sqrt(2 * 119.0));
  CHECK(sample_concentric_disk(Vec2d(0.5, 0.5)) == Vec2d(0, 0));
  for (const double along : {0.0, 0.2, 0.5, 0.9})
    for (const Vec2d& u : {Vec2d(0.25, 0.25 + along / 2), Vec2d(0.75, 0.25 + along / 2), Vec2d(0.25 + along / 2, 0.25)})
      CHECK(length(sample_concentric_disk(u)) == Approx(0.5).epsilon(1e-14));
  // In order: right of the centre is right, above it above.
  CHECK(sample_concentric_disk(Vec2d(0.9, 0.5)).x == Approx(0.8));
  CHECK(sample_concentric_disk(Vec2d(0.5, 0.9)).y == Approx(0.8));
}

TEST_CASE("directions follow their densities") {
  SECTION("whole sphere") {
    follows([](const Vec2d& u) { return sample_uniform_sphere(u); },
            [](const Vec3d&) { return 1 / (4 * pi_v<double>); });
  }
  SECTION("cosine") {
    follows([](const Vec2d& u) { return sample_cosine_hemisphere(u); },
            [](const Vec3d& d) { return cosine_hemisphere_pdf(d.z); });
  }
  for (const double exponent : {0.0, 0.5, 1.0, 7.0, 60.0}) {
    DYNAMIC_SECTION("cosine to the power " << exponent) {
      const double reach = exponent > 20 ? 0.4 : 1;
      follows([exponent](const Vec2d& u) { return sample_power_cosine(u, exponent); },
              [exponent](const Vec3d& d) { return power_cosine_pdf(d.z, exponent); }, 2 * reach);
    }
  }
  for (const double angle : {3.0, 1.2, 0.1, 1e-3, 1e-9}) {
    DYNAMIC_SECTION("cone of half angle " << angle) {
      const double down = one_minus_cos_of(angle);
      follows([down](const Vec2d& u) { return sample_uniform_cone(u, down); },
              [down](const Vec3d&) { return uniform_cone_pdf(down); }, down * (1 + 1e-9));
    }
  }
}

TEST_CASE("densities are 0 behind the surface") {
  for (const double cos : {0.0, -0.0, -0.3, -1.0}) {
    CHECK(cosine_hemisphere_pdf(cos) == 0);
    CHECK(power_cosine_pdf(cos, 5.0) == 0);
    CHECK(power_cosine_pdf(cos, 0.0) == 0);
  }
}

TEST_CASE("the power lobe stays a lobe at its limits") {
  for (const double u : {0.0, 0.3, 0.5, 0.999999})
    for (const double v : {0.0, 0.5, 0.9}) {
      // Exponent 1 is the cosine itself.
      const Vec3d difference = sample_power_cosine(Vec2d(u, v), 1.0) - sample_cosine_hemisphere(Vec2d(u, v));
      CHECK(length(difference) < 3e-4);  // at the rim; elsewhere 1e-7
      if (dot(sample_concentric_disk(Vec2d(u, v)), sample_concentric_disk(Vec2d(u, v))) < 0.99)
        CHECK(length(difference) < 1e-7);
      // A mirror: the angle goes with 1 / sqrt(exponent), and does not vanish in rounding.
      const Vec3d sharp = sample_power_cosine(Vec2d(u, v), 1e17);
      CHECK(sharp.z == Approx(1));
      const Vec2d disk = sample_concentric_disk(Vec2d(u, v));
      const double share = std::min(dot(disk, disk), 1 - 0x1p-24);
      CHECK(std::hypot(sharp.x, sharp.y) ==
            Approx(std::sqrt(-2 * std::log1p(-share) / 1e17)).margin(1e-30).epsilon(1e-6));
      CHECK(is_finite(sample_power_cosine(Vec2<float>(static_cast<float>(u), static_cast<float>(v)), 1e8f)));
    }
}

TEST_CASE("points of a triangle: even by area") {
  constexpr int n = 60000, grid = 8;
  // The small congruent triangles of a regular subdivision hold equally many.
  std::vector<int> held(2 * grid * grid);
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec2d w = sample_uniform_triangle(drawn(i));
    if (!(w.x >= 0 && w.y >= 0 && w.x + w.y <= 1 + 1e-15)) FAIL("outside: " << w.x << ' ' << w.y);
    const double x = w.x * grid, y = w.y * grid;
    const auto column = static_cast<std::size_t>(std::min(x, grid - 0.001));
    const auto row = static_cast<std::size_t>(std::min(y, grid - 0.001));
    const bool upper = x - std::floor(x) + y - std::floor(y) > 1;
    ++held[2 * (column * grid + row) + (upper ? 1 : 0)];
  }
  double chi = 0;
  int cells = 0;
  for (std::size_t column = 0; column < grid; ++column)
    for (std::size_t row = 0; column + row < grid; ++row)
      for (const std::size_t upper : {0u, 1u}) {
        if (upper == 1 && column + row == grid - 1) continue;
        const double expected = n / static_cast<double>(grid * grid), h = held[2 * (column * grid + row) + upper];
        chi += (h - expected) * (h - expected) / expected;
        ++cells;
      }
  CHECK(cells == grid * grid);
  CHECK(std::abs(chi - (cells - 1)) < 5 * std::sqrt(2.0 * cells));
}

TEST_CASE("area to solid angle: the tables' polygon formula comes out") {
  // A square of edge 2 at height 1 seen from below its middle fills a sixth of all directions.
  double sum = 0;
  constexpr int n = 1 << 14;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Vec2d u = drawn(i, Sampler::sobol);
    const Vec3d way(2 * u.x - 1, 2 * u.y - 1, 1);
    sum += 1 / solid_angle_pdf(0.25, way, Vec3d(0, 0, -1)) / n;
  }
  CHECK(sum == Approx(4 * pi_v<double> / 6).epsilon(1e-5));
  CHECK(solid_angle_pdf(1.0, Vec3d(1, 2, 0), Vec3d(0, 0, 1)) == std::numeric_limits<double>::infinity());
}

TEST_CASE("a sphere seen from outside: every drawn ray meets it, and none is missing") {
  const Vec3d point(1, -2, 0.5), centre(3, 1, -1);
  const double distance = length(centre - point);
  for (const double radius : {0.999999 * distance, 0.5 * distance, 0.1, 1e-4, 1e-9, 1e-15}) {
    CAPTURE(radius);
    const SubtendedCone<double> seen = subtended_cone(point, centre, radius);
    CHECK_FALSE(seen.from_inside);
    // 1 - cos = sin^2 / (1 + cos), to its last digits also where the cone is narrow.
    const long double sin2 =
        static_cast<long double>(radius) * radius / (static_cast<long double>(distance) * distance);
    CHECK(seen.one_minus_cos == Approx(static_cast<double>(sin2 / (1 + std::sqrt(1 - sin2)))).epsilon(1e-9));
    double nearest = 1e300, farthest = 0;
    for (std::uint32_t i = 0; i < 3000; ++i) {
      const Vec3d direction = sample_subtended_cone(drawn(i), point, centre, seen);
      // How far from the centre the ray passes.
      const double passes = length(cross(centre - point, direction));
      nearest = std::min(nearest, passes), farthest = std::max(farthest, passes);
      if (!(dot(direction, centre - point) > 0)) FAIL("away from the sphere");
    }
    // The ways' own rounding: some ulps of the distance.
    CHECK(farthest <= radius * (1 + 1e-6) + 4e-15);
    CHECK(farthest >= 0.98 * radius - 4e-15);
    CHECK(nearest <= 0.1 * radius + 4e-15);
  }
}

TEST_CASE("a sphere of radius 0 is its centre, from inside a sphere is all around") {
  const Vec3d point(0.3, 0.2, 0.1), centre(5, 4, 3);
  const SubtendedCone<double> seen = subtended_cone(point, centre, 0.0);
  CHECK_FALSE(seen.from_inside);
  CHECK(seen.one_minus_cos == 0);
  for (std::uint32_t i = 0; i < 20; ++i)
    CHECK(sample_subtended_cone(drawn(i), point, centre, seen) == normalize(centre - point));
  CHECK(subtended_cone(centre, centre, 1.0).from_inside);
  CHECK(subtended_cone(Vec3d(1, 0, 0), Vec3d(0, 0, 0), 1.0).from_inside);
  CHECK(subtended_cone(centre, centre, 0.0).from_inside);  // no direction leads there
}

TEST_CASE("a spot fades smoothly from its inner to its outer cone") {
  const double inner = std::cos(0.3), outer = std::cos(0.7);
  CHECK(spot_falloff(1.0, inner, outer) == 1);
  CHECK(spot_falloff(inner, inner, outer) == 1);
  CHECK(spot_falloff(outer, inner, outer) == 0);
  CHECK(spot_falloff(-1.0, inner, outer) == 0);
  CHECK(spot_falloff((inner + outer) / 2, inner, outer) == Approx(0.5));
  CHECK(spot_falloff(outer + (inner - outer) / 4, inner, outer) == Approx(5.0 / 32));
  double before = 0;
  for (int i = 0; i <= 1000; ++i) {
    const double left = spot_falloff(outer + (inner - outer) * i / 1000, inner, outer);
    CHECK(left >= before);
    before = left;
  }
  // Equal cones: a sharp edge.
  CHECK(spot_falloff(0.8, 0.8, 0.8) == 1);
  CHECK(spot_falloff(std::nextafter(0.8, 0.0), 0.8, 0.8) == 0);
}

TEST_CASE("what a point sees of a rectangle: its solid angle, and points even by it") {
  struct Case {
    Vec3d point, corner, u, v;
    double solid_angle;  // 0: by sums over the area
  };
  const std::vector<Case> cases{{{0, 0, 0}, {-1, -1, 1}, {2, 0, 0}, {0, 2, 0}, 4 * pi_v<double> / 6},
                                {{0, 0, 0}, {-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 4 * pi_v<double> / 6},
                                {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, 4 * pi_v<double> / 24},
                                {{1, 2, 3}, {2, 2.5, 3.3}, {0.6, 0.8, 0}, {-1.6, 1.2, 0}, 0},
                                {{0, 0, 0}, {-0.5, 3, 0.01}, {1, 0, 0}, {0, 4, 0}, 0},
                                {{0, 0, 0}, {50, 40, 30}, {0, 1, 0}, {0, 0, 2}, 0}};
  for (const Case& c : cases) {
    const Vec3d normal = normalize(cross(c.u, c.v));
    const double area = length(cross(c.u, c.v));
    const SphericalRectangle seen(c.point, c.corner, {c.u, c.v});
    constexpr int n = 1 << 16, grid = 6;
    double sum = 0;
    std::vector<double> expected(grid * grid);
    for (int i = 0; i < 600; ++i)
      for (int j = 0; j < 600; ++j) {
        const double x = (i + 0.5) / 600, y = (j + 0.5) / 600;
        const Vec3d way = c.corner + x * c.u + y * c.v - c.point;
        const double part = 1 / solid_angle_pdf(600 * 600 / area, way, normal);
        sum += part;
        expected[static_cast<std::size_t>(i / 100 * grid + j / 100)] += part;
      }
    CHECK(seen.solid_angle() == Approx(sum).epsilon(2e-4));
    if (c.solid_angle != 0) CHECK(seen.solid_angle() == Approx(c.solid_angle).epsilon(1e-13));
    CHECK(seen.usable());
    std::vector<int> held(grid * grid);
    for (std::uint32_t i = 0; i < n; ++i) {
      const Vec2d p = seen.point_at(drawn(i));
      if (!(p.x >= 0 && p.x <= 1 && p.y >= 0 && p.y <= 1)) FAIL("off the rectangle: " << p.x << ' ' << p.y);
      ++held[static_cast<std::size_t>(std::min(p.x * grid, grid - 0.001)) * grid +
             static_cast<std::size_t>(std::min(p.y * grid, grid - 0.001))];
    }
    double chi = 0, freedom = -1, few = 0, few_expected = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const double e = expected[i] / sum * n;
      if (e < 10) {
        few += held[i], few_expected += e;
        continue;
      }
      chi += (held[i] - e) * (held[i] - e) / e;
      ++freedom;
    }
    CHECK(freedom > 4);
    CHECK(chi < freedom + 5 * std::sqrt(2 * freedom));
    CHECK(std::abs(few - few_expected) <= 5 * std::sqrt(few_expected) + 5);
  }
}

TEST_CASE("what is seen of a rectangle does not depend on the unit of length, nor ends as one comes near") {
  const auto seen_from = [](double height, double unit) {
    return SphericalRectangle({0, 0, unit * height}, {-unit, -unit, 0}, {{2 * unit, 0, 0}, {0, 3 * unit, 0}});
  };
  for (const double unit : {1e-30, 1e-9, 1.0, 1e9, 1e30}) {
    INFO(unit);
    for (const double height : {1e-12, 1e-6, 0.01, 1.0, 20.0}) {
      const SphericalRectangle seen = seen_from(height, unit), same = seen_from(height, 1);
      CHECK(seen.solid_angle() == Approx(same.solid_angle()).epsilon(1e-12));
      for (const Vec2d& drawn : {Vec2d(0.01, 0.99), Vec2d(0.3, 0.6), Vec2d(1, 0)})
        CHECK(length(seen.point_at(drawn) - same.point_at(drawn)) < 1e-9);
    }
  }
  // Straight below, the plane of the rectangle fills the half of what is seen: all but what lies beyond its edges.
  for (const double height : {1e-12, 1e-9, 1e-6}) {
    const double beyond = height * (std::sqrt(5.0) + 2 * std::sqrt(2.0));  // at each corner distance / (x y)
    CHECK(2 * pi_v<double> - seen_from(height, 1).solid_angle() == Approx(beyond).epsilon(1e-3));
  }
}

TEST_CASE("a rectangle too small or seen edge on is drawn by area instead") {
  CHECK_FALSE(SphericalRectangle({0, 0, 0}, {1000, 0, 0}, {{0, 1, 0}, {0, 0, 1}}).usable());
  CHECK_FALSE(SphericalRectangle({0, 0, 0}, {1, 0, 0}, {{1, 0, 0}, {0, 1, 0}}).usable());
  CHECK(SphericalRectangle({0, 0, 0}, {1, 0, 0}, {{1, 0, 0}, {0, 1, 0}}).solid_angle() == 0);
  // Where it is just usable, its digits hold.
  const double edge = 0.004;
  const SphericalRectangle seen({0, 0, 0}, {-edge / 2, -edge / 2, 1}, {{edge, 0, 0}, {0, edge, 0}});
  CHECK(seen.usable());
  CHECK(seen.solid_angle() == Approx(4 * std::asin(edge * edge / 4 / (1 + edge * edge / 4))).epsilon(1e-9));
}
