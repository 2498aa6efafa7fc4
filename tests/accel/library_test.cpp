#include "accel/library.h"

#include "accel/accelerator.h"
#include "support/catch.h"
#include "support/effort.h"

#include <algorithm>
#include <random>
#include <string>

using namespace raywalk;
using namespace raywalk::test;
using namespace raywalk::accel;

namespace {

template <class T>
struct Buffers {
  std::vector<T> positions;
  std::vector<std::uint32_t> indices;
};

// A closed surface of 2 n n triangles, a bent torus, whose corners are shared.
template <class T>
Buffers<T> torus(int n) {
  Buffers<T> soup;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double a = 6.283185307179586 * i / n, b = 6.283185307179586 * j / n;
      const double r = 2 + std::cos(b);
      for (const double x : {r * std::cos(a), r * std::sin(a), std::sin(b) + 0.3 * std::sin(2 * a)})
        soup.positions.push_back(static_cast<T>(x));
    }
  const auto at = [n](int i, int j) { return static_cast<std::uint32_t>(i % n * n + j % n); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (const auto corner : {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)})
        soup.indices.push_back(corner);
  return soup;
}

template <class T>
TriangleSet<T> built(const Buffers<T>& soup) {
  return std::get<TriangleSet<T>>(TriangleSet<T>::build(soup.positions, soup.indices));
}

template <class T>
BuildFailure failure(const Buffers<T>& soup) {
  const auto result = TriangleSet<T>::build(soup.positions, soup.indices);
  REQUIRE(std::holds_alternative<BuildFailure>(result));
  return std::get<BuildFailure>(result);
}

}  // namespace

TEMPLATE_TEST_CASE("the library meets the triangles that are there, one at a time and in batches", "[accel]", float,
                   double) {
  using T = TestType;
  const Buffers<T> soup = torus<T>(24);
  const TriangleSet<T> triangles = built(soup);
  REQUIRE(triangles.size() == 24 * 24 * 2);
  CHECK(triangles.bytes() > 0);
  // Every triangle by itself.
  std::vector<TriangleSet<T>> single;
  for (std::size_t i = 0; i < soup.indices.size(); i += 3)
    single.push_back(
        std::get<TriangleSet<T>>(TriangleSet<T>::build(soup.positions, std::span(soup.indices).subspan(i, 3))));
  std::mt19937 engine(5);
  const auto next = [&] { return static_cast<T>(static_cast<double>(engine()) / 2147483648.0 - 1); };
  std::vector<RayQuery<T>> rays;
  for (int i = 0; i < rounds(600); ++i) {
    RayQuery<T> ray{{4 * next(), 4 * next(), 4 * next()}, {next(), next(), next()}};
    if (i % 3 == 0) {  // exactly through a corner
      const std::size_t corner = 3 * (engine() % (soup.positions.size() / 3));
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = static_cast<T>(engine() % 9) - 4;
        ray.direction[axis] = soup.positions[corner + axis] - ray.origin[axis];
      }
    }
    rays.push_back(ray);
  }
  std::vector<std::optional<TriangleHit<T>>> hits(rays.size());
  triangles.closest(rays, hits);
  const auto met = std::make_unique<bool[]>(rays.size());
  triangles.any(rays, {met.get(), rays.size()});
  int found = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    std::optional<TriangleHit<T>> expected;
    for (std::size_t k = 0; k < single.size(); ++k)
      if (const auto hit = single[k].closest(rays[i]); hit && (!expected || hit->t < expected->t))
        expected = {hit->t, static_cast<std::uint32_t>(k), hit->u, hit->v};
    const auto hit = triangles.closest(rays[i]);
    REQUIRE(hit.has_value() == expected.has_value());
    REQUIRE(hits[i].has_value() == hit.has_value());
    REQUIRE(met[i] == hit.has_value());
    REQUIRE(triangles.any(rays[i]) == hit.has_value());
    if (!hit) continue;
    ++found;
    REQUIRE(hit->t == expected->t);
    REQUIRE(hit->triangle == expected->triangle);
    REQUIRE(hits[i]->t == hit->t);
    REQUIRE(hits[i]->triangle == hit->triangle);
    REQUIRE(hit->u == expected->u);
    REQUIRE(hit->v == expected->v);
    // The weights give the point.
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto corner = [&](std::size_t c) { return soup.positions[3 * soup.indices[3 * hit->triangle + c] + axis]; };
      const T point = (1 - hit->u - hit->v) * corner(0) + hit->u * corner(1) + hit->v * corner(2);
      REQUIRE(std::abs(point - (rays[i].origin[axis] + hit->t * rays[i].direction[axis])) < T(1e-4));
    }
    // What ends there meets nothing; what ends just beyond does.
    RayQuery<T> shorter = rays[i];
    shorter.t_max = hit->t;
    REQUIRE_FALSE(triangles.any(shorter));
    shorter.t_max = std::nextafter(hit->t, std::numeric_limits<T>::infinity());
    REQUIRE(triangles.any(shorter));
    // From the surface outwards and back, along the same line: an even number of crossings in all.
    int crossings = 1;
    RayQuery<T> onward = rays[i];
    for (auto at = hit; at && crossings < 20; ++crossings) {
      for (std::size_t axis = 0; axis < 3; ++axis) onward.origin[axis] += at->t * onward.direction[axis];
      onward.leaves = at->triangle;
      at = triangles.closest(onward);
    }
    REQUIRE(crossings < 20);
  }
  CHECK(found > rounds(100));
}

TEMPLATE_TEST_CASE("the library has no gaps and right weights at any length and size", "[accel]", float, double) {
  using T = TestType;
  // A pyramid of four triangles, seen from above: rays through the tip and through an edge.
  const std::vector<T> pyramid{0, 0, 1, 2, 0, 0, 0, 2, 0, -2, 0, 0, 0, -2, 0};
  const std::vector<std::uint32_t> indices{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1};
  constexpr bool wide = sizeof(T) == sizeof(double);
  for (const int size : wide ? std::vector{-200, 0, 40} : std::vector{-60, -40, 0, 35, 45}) {
    std::vector<T> positions = pyramid;
    for (T& x : positions) x = std::ldexp(x, size);
    const auto triangles = std::get<TriangleSet<T>>(TriangleSet<T>::build(positions, indices));
    for (const int length : wide ? std::vector{-1050, -1000, -300, 0, 300, 1000, 1020} : std::vector{-100, 0, 100}) {
      CAPTURE(size, length);
      std::vector<RayQuery<T>> rays;
      for (const T x : {T(0), T(0.5)})
        rays.push_back({{std::ldexp(x, size), 0, std::ldexp(T(5), size)}, {0, 0, -std::ldexp(T(1), length)}});
      std::vector<std::optional<TriangleHit<T>>> hits(2);
      triangles.closest(rays, hits);
      const T t = std::ldexp(T(4), size - length);
      if (!std::isfinite(t) || t < std::numeric_limits<T>::min()) continue;
      REQUIRE((hits[0] && hits[1]));
      CHECK(hits[0]->t == t);
      CHECK(hits[0]->u == 0);
      CHECK(hits[0]->v == 0);
      CHECK(hits[1]->t == Approx(std::ldexp(T(4.25), size - length)));
      CHECK(hits[1]->u + hits[1]->v == Approx(0.25));
      for (std::size_t i = 0; i < 2; ++i) {
        CHECK(triangles.closest(rays[i])->t == hits[i]->t);
        CHECK(triangles.any(rays[i]));
        rays[i].t_max = hits[i]->t;
        CHECK_FALSE(triangles.any(rays[i]));
      }
    }
  }
}

TEMPLATE_TEST_CASE("weights are right where triangles are small for their distance", "[accel]", float, double) {
  using T = TestType;
  const double distance = sizeof(T) == sizeof(float) ? 1e4 : 1e9, size = distance * 1e-7;
  std::mt19937 engine(11);
  const auto next = [&] { return static_cast<double>(engine()) / 2147483648.0 - 1; };
  int met = 0;
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    std::vector<T> corners;
    for (int k = 0; k < 3; ++k)
      for (const double along : {0.0, 0.0, distance}) corners.push_back(static_cast<T>(along + size * next()));
    const RayQuery<T> ray{{static_cast<T>(size * next()), static_cast<T>(size * next()), 0},
                          {static_cast<T>(size * next() / distance), static_cast<T>(size * next() / distance), 1}};
    const auto hit =
        std::get<TriangleSet<T>>(TriangleSet<T>::build(corners, std::vector<std::uint32_t>{0, 1, 2})).closest(ray);
    if (!hit) continue;
    ++met;
    REQUIRE(hit->u >= 0);
    REQUIRE(hit->v >= 0);
    REQUIRE(hit->u + hit->v <= 1 + std::numeric_limits<T>::epsilon());
    // d . (p - o) x (q - o) of each edge, by long doubles.
    using Wide = long double;
    std::array<Wide, 3> volumes;
    for (std::size_t k = 0; k < 3; ++k) {
      std::array<Wide, 3> p, q, d;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        p[axis] = static_cast<Wide>(corners[3 * ((k + 1) % 3) + axis]) - ray.origin[axis];
        q[axis] = static_cast<Wide>(corners[3 * ((k + 2) % 3) + axis]) - ray.origin[axis];
        d[axis] = ray.direction[axis];
      }
      for (std::size_t axis = 0; axis < 2; ++axis)  // sheared, so that few digits cancel
        p[axis] -= d[axis] / d[2] * p[2], q[axis] -= d[axis] / d[2] * q[2];
      volumes[k] = p[0] * q[1] - p[1] * q[0];
    }
    const Wide sum = volumes[0] + volumes[1] + volumes[2];
    worst = std::max({worst, static_cast<double>(std::abs(volumes[1] / sum - hit->u)),
                      static_cast<double>(std::abs(volumes[2] / sum - hit->v))});
  }
  CHECK(met > 1000);
  CHECK(worst < 1e-3);  // of a triangle's width; of the rounded point up to 1 and more
}

TEMPLATE_TEST_CASE("a ray that leaves a mesh of mixed turns is not let through", "[accel]", float, double) {
  using T = TestType;
  // Every way to turn the faces of a tetrahedron that lies far from 0; rays from the middle of the first one inwards.
  for (const auto& [corner, edge] : {std::pair(1000.0, 0.002), std::pair(1e5, 0.01), std::pair(1e6, 1.0)}) {
    const T A = static_cast<T>(corner), far = static_cast<T>(corner + edge);
    const std::vector<T> positions{A, A, A, far, A, A, A, far, A, A, A, far};
    for (unsigned turned = 0; turned < 16; ++turned) {
      std::vector<std::uint32_t> indices{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
      for (unsigned face = 0; face < 4; ++face)
        if ((turned >> face & 1U) != 0) std::swap(indices[3 * face], indices[3 * face + 1]);
      const auto triangles = std::get<TriangleSet<T>>(TriangleSet<T>::build(positions, indices));
      CAPTURE(corner, turned);
      RayQuery<T> ray{{A + (far - A) / 4, A + (far - A) / 4, A}, {T(0.1), T(0.2), 1}};
      ray.leaves = 0;
      CHECK(triangles.closest(ray));
      CHECK(triangles.any(ray));
      ray.direction = {T(0.1), T(0.2), -1};
      CHECK_FALSE(triangles.any(ray));
    }
  }
}

TEST_CASE("numbers nearer to 0 than the least coordinate leave no gaps", "[accel]") {
  // An octahedron with such numbers where it has zeros: rays from inside through its corners and edges.
  for (const double tiny : {std::numeric_limits<double>::denorm_min(), 1e-310, 1e-200, 1e-160, 1e-155, 1e-150, 1e-100,
                            0x1p-250, 0x1p-249}) {
    const double D = tiny;
    const std::vector<double> corners{0, 0, 1, 1, D, -D, -D, 1, 0, -1, -D, -D, -D, -1, D, D, D, -1};
    const std::vector<std::uint32_t> faces{0, 1, 2, 0, 2, 3, 0, 3, 4, 0, 4, 1, 5, 2, 1, 5, 3, 2, 5, 4, 3, 5, 1, 4};
    const auto ball = std::get<TriangleSet<double>>(TriangleSet<double>::build(corners, faces));
    std::mt19937 engine(7);
    const auto near = [&] { return static_cast<double>(static_cast<int>(engine() % 5) - 2) / 8; };
    for (int i = 0; i < 2000; ++i) {
      RayQuery<double> ray{{near(), near(), near()}, {0, 0, 0}};
      for (double& x : ray.origin) x = x == 0 ? (engine() % 2 == 0 ? D : -D) : x;
      const std::size_t from = 3 * (engine() % 6), to = i % 2 == 0 ? from : 3 * (engine() % 6);
      for (std::size_t axis = 0; axis < 3; ++axis)
        ray.direction[axis] = (corners[from + axis] + corners[to + axis]) / 2 - ray.origin[axis];
      const auto is_tiny = [](double x) { return std::abs(x) < 1e-300; };
      if (std::all_of(ray.direction.begin(), ray.direction.end(), is_tiny)) continue;  // no double holds their t
      CAPTURE(tiny, i);
      CHECK(ball.closest(ray));
    }
  }
  // Nor do triangles as small as that, and directions with them.
  const std::vector<double> small{0, 0, 0x1p-240, 0x1p-240, 0, 0x1p-240, 0, 0x1p-240, 0x1p-240};
  const auto one =
      std::get<TriangleSet<double>>(TriangleSet<double>::build(small, std::vector<std::uint32_t>{0, 1, 2}));
  const auto hit = one.closest({{0x1p-242, 0x1p-243, 0}, {0, 0, 0x1p-300}});
  REQUIRE(hit);
  CHECK(hit->t == 0x1p60);
  CHECK(hit->u == 0.25);
  CHECK(hit->v == 0.125);
}

TEMPLATE_TEST_CASE("the library says what it cannot build from, and where", "[accel]", float, double) {
  using T = TestType;
  const Buffers<T> good = torus<T>(4);
  const auto problem = [&](auto change) {
    Buffers<T> soup = good;
    change(soup);
    const BuildFailure why = failure(soup);
    CHECK(std::string(words_for(why.problem)).size() > 10);
    return std::pair(why.problem, why.at);
  };
  using enum BuildProblem;
  CHECK(problem([](Buffers<T>& s) { s.indices.clear(); }) == std::pair(no_triangles, std::size_t{0}));
  CHECK(problem([](Buffers<T>& s) { s = {}; }).first == no_triangles);
  CHECK(problem([](Buffers<T>& s) { s.positions.pop_back(); }).first == incomplete_vertex);
  CHECK(problem([](Buffers<T>& s) { s.indices.pop_back(); }).first == incomplete_triangle);
  CHECK(problem([](Buffers<T>& s) { s.indices[7] = 16; }) == std::pair(bad_index, std::size_t{7}));
  CHECK(problem([](Buffers<T>& s) { s.indices[8] = no_triangle; }) == std::pair(bad_index, std::size_t{8}));
  for (const T bad : {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(), T(-2e15)})
    CHECK(problem([&](Buffers<T>& s) { s.positions[11] = bad; }) == std::pair(bad_position, std::size_t{11}));
  const std::vector<std::uint32_t> many(3 * (max_triangles + 1));
  const auto result = TriangleSet<T>::build(good.positions, many);
  REQUIRE(std::holds_alternative<BuildFailure>(result));
  CHECK(std::get<BuildFailure>(result).problem == too_many);
}

TEMPLATE_TEST_CASE("the library's queries that mean nothing meet nothing", "[accel]", float, double) {
  using T = TestType;
  const TriangleSet<T> triangles = built(torus<T>(8));
  const RayQuery<T> good{{0, 2, -5}, {0, 0, 1}};
  REQUIRE(triangles.closest(good));
  const T nan = std::numeric_limits<T>::quiet_NaN(), infinite = std::numeric_limits<T>::infinity();
  std::vector<RayQuery<T>> bad(6, good);
  bad[0].origin[1] = nan;
  bad[1].direction[2] = nan;
  bad[2].direction = {0, 0, 0};
  bad[3].origin[2] = -infinite;
  bad[4].direction[2] = infinite;
  bad[5].t_max = nan;
  for (const RayQuery<T>& ray : bad) {
    CHECK_FALSE(triangles.closest(ray));
    CHECK_FALSE(triangles.any(ray));
  }
  RayQuery<T> odd = good;
  odd.leaves = 4000;  // no triangle of this set: as if it left none
  CHECK(triangles.closest(odd));
  // A set of nothing but triangles without an area.
  const std::vector<T> line{0, 0, 0, 1, 1, 1, 2, 2, 2};
  const std::vector<std::uint32_t> corners{0, 1, 2, 0, 0, 0};
  const auto flat = TriangleSet<T>::build(line, corners);
  CHECK_FALSE(std::get<TriangleSet<T>>(flat).closest({{1, 1, -5}, {0, 0, 1}}));
}
