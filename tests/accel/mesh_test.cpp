// Meshes: watertight, the same to every accelerator, shaded as their normals say, and moving.

#include "answers.h"
#include "meshes.h"
#include "shape/numbers.h"
#include "support/catch.h"
#include "support/effort.h"

#include <numbers>

using namespace raywalk;
using namespace raywalk::test;

namespace {

// A corner, or a point of an edge, of some triangle of the mesh.
Vec3d edge_point(const Mesh& mesh, const Affine<double>& map, Numbers& next, bool corner) {
  const auto& corners =
      mesh.triangles[static_cast<std::size_t>(next.integer(0, static_cast<int>(mesh.triangles.size()) - 1))];
  const Vec3d a = map.point(mesh.positions[static_cast<std::size_t>(corners[0])]);
  const Vec3d b = map.point(mesh.positions[static_cast<std::size_t>(corners[1])]);
  return corner ? a : a + next.real(0, 1) * (b - a);
}

}  // namespace

TEMPLATE_TEST_CASE("a closed mesh has no leaks at its corners and edges", "[mesh]", float, double) {
  using T = TestType;
  const double scale = GENERATE(1e-3, 1.0, 1e6), shift = GENERATE(0.0, 100.0);
  CAPTURE(scale, shift);
  const Mesh mesh = icosphere(2);
  const Affine<double> map = translation(scale * shift * Vec3d(1, -2, 0.5)) * scaling(Vec3d(scale));
  Primitives<T> primitives;
  primitives.add(mesh, map, false);
  const std::vector all(static_cast<std::size_t>(primitives.size()), ShadowRole::filters);
  const Accelerator<T> list(primitives, AcceleratorKind::none), tree(primitives, AcceleratorKind::bvh);
  Numbers next(3);
  TestCounts counts;
  std::vector<int> crossed;
  int inside_misses = 0, odd = 0, differing = 0;
  const Vec3<T> centre(map.point(Vec3d(0.0)));
  for (int i = 0; i < rounds(4000); ++i) {
    const Vec3<T> target(edge_point(mesh, map, next, i % 2 == 0));
    // From inside, something is hit; a line from outside crosses the surface an even number of times.
    const Vec3<T> within = centre + static_cast<T>(0.5 * scale) * next.unit<T>();
    if (!tree.closest({within, target - within}, infinity<T>, counts)) ++inside_misses;
    const Vec3<T> outside = centre + static_cast<T>(i % 3 == 0 ? 1000 * scale : 3 * scale) * next.unit<T>();
    const Ray<T> ray{outside, target - outside};
    bool stopped = list.occluded_or_filtered(ray, infinity<T>, counts, all, crossed);
    odd += crossed.size() % 2 != 0;
    const std::vector<int> expected = crossed;
    stopped = tree.occluded_or_filtered(ray, infinity<T>, counts, all, crossed) || stopped;
    differing += crossed != expected || stopped;
  }
  CHECK(inside_misses == 0);
  CHECK(odd == 0);
  CHECK(differing == 0);
}

TEMPLATE_TEST_CASE("a corner that is on a neighbour's edge but for rounding leaves no gap", "[mesh]", float, double) {
  using T = TestType;
  Numbers next(17);
  TestCounts counts;
  int thin = 0, lost = 0, bent = 0;
  for (int i = 0; i < rounds(1000); ++i) {
    // A square with the diagonal ab; on one side c halves it, and abc, of hardly any width, fills what is between.
    const auto corner = [&] { return Vec3<T>(plan(next.in_box<T>()), 0); };
    const Vec3<T> a = corner(), b = corner(), c = a + static_cast<T>(next.real(0.1, 0.9)) * (b - a),
                  across(a.y - b.y, b.x - a.x, 0);
    auto mesh = std::make_shared<Mesh>();
    for (const Vec3<T>& at : {a, b, c, a + across, a - across}) mesh->positions.push_back(wide(at));
    mesh->triangles = {{0, 1, 3}, {0, 2, 1}, {0, 4, 2}, {2, 4, 1}};
    Primitives<T> stored, copied;
    stored.add(*mesh, {}, false);
    copied.add_copy(mesh, {}, false);
    const Ray<T> ray{c + Vec3<T>(0, 0, 1), {0, 0, -1}};
    for (const Primitives<T>& primitives : {stored, copied})
      for (const AcceleratorKind kind : {AcceleratorKind::none, AcceleratorKind::bvh}) {
        const auto hit = Accelerator<T>(primitives, kind).closest(ray, infinity<T>, counts);
        lost += !hit;
        if (!hit) continue;
        thin += hit->primitive == 1;
        const SurfacePoint<T> point = primitives.surface_at(hit->primitive, ray, {hit->t, hit->part});
        const Vec2<T> weights = barycentric(primitives.triangles()[hit->primitive], point.position);
        bent += std::abs(point.normal.z) != 1 ||
                !(weights.x > T(-0.1) && weights.y > T(-0.1) && weights.x + weights.y < T(1.1));
      }
  }
  CHECK(thin > 0);
  CHECK(lost == 0);
  CHECK(bent == 0);
}

TEMPLATE_TEST_CASE("rays that leave from an edge meet neither of its triangles", "[mesh]", float, double) {
  using T = TestType;
  const double scale = GENERATE(1e-3, 1.0, 1e6), shift = GENERATE(0.0, 100.0);
  CAPTURE(scale, shift);
  const Mesh mesh = icosphere(1);
  const Affine<double> map = translation(scale * shift * Vec3d(1, -2, 0.5)) * scaling(Vec3d(scale));
  Primitives<T> primitives;
  primitives.add(mesh, map, false);
  const Accelerator<T> tree(primitives, AcceleratorKind::bvh);
  Numbers next(11);
  TestCounts counts;
  int departed = 0, self_hits = 0, lost = 0;
  for (int i = 0; i < rounds(6000); ++i) {
    const Vec3<T> target(edge_point(mesh, map, next, i % 5 == 0));
    const Vec3<T> eye = Vec3<T>(map.point(Vec3d(0.0))) + static_cast<T>(3 * scale) * next.unit<T>();
    const Ray<T> ray{eye, target - eye};
    const auto hit = tree.closest(ray, infinity<T>, counts);
    if (!hit) continue;
    const SurfacePoint<T> point = primitives.surface_at(hit->primitive, ray, Intersection<T>{hit->t, hit->part});
    // Away from all triangles at this place: on a ball, into the half space of its radius or nearly so.
    const Vec3<T> out = normalize(point.position - Vec3<T>(map.point(Vec3d(0.0))));
    Vec3<T> direction = next.unit<T>();
    if (dot(direction, out) < 0) direction = -direction;
    direction = normalize(direction + T(0.9) * out);
    const Departure departure{hit->primitive, hit->part};
    ++departed;
    self_hits += tree.closest({point.position, direction, departure}, infinity<T>, counts).has_value();
    self_hits += tree.occluded({point.position, direction, departure}, infinity<T>, counts);
    // Inwards, the far side is met.
    const auto through = tree.closest({point.position, -direction, departure}, infinity<T>, counts);
    lost += !through || through->t < static_cast<T>(0.1 * scale);
  }
  CHECK(departed > rounds(1000));
  CHECK(self_hits == 0);
  CHECK(lost == 0);
}

TEST_CASE("a kd-tree of triangles that all meet in one corner lists few of them often", "[mesh]") {
  Mesh fan;  // a regular polygon, cut from its first corner: long thin triangles, whose boxes mostly overlap
  constexpr int corners = 500;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    fan.positions.push_back({std::cos(angle), std::sin(angle), 0.1 * std::cos(3 * angle)});
  }
  for (int i = 1; i + 1 < corners; ++i) fan.triangles.push_back({0, i, i + 1});
  Primitives<double> primitives;
  primitives.add(fan, {}, false);
  const Accelerator<double> tree(primitives, AcceleratorKind::kdtree), list(primitives, AcceleratorKind::none);
  const AcceleratorStatistics statistics = tree.statistics();
  CHECK(statistics.references > fan.triangles.size());
  CHECK(statistics.references <= 32 * fan.triangles.size());  // 14 million without a bound
  Numbers next(5);
  TestCounts counts;
  int differing = 0;
  for (int i = 0; i < rounds(2000); ++i) {
    const Vec3d eye(next.real(-2, 2), next.real(-2, 2), next.real(1, 2));
    const Ray<double> ray{eye, Vec3d(next.real(-1, 1), next.real(-1, 1), 0) - eye};
    differing += !same(tree.closest(ray, infinity<double>, counts), list.closest(ray, infinity<double>, counts));
  }
  CHECK(differing == 0);
}

TEMPLATE_TEST_CASE("accelerators agree over meshes, mapped shapes and what moves", "[mesh]", float, double) {
  using T = TestType;
  const double far = GENERATE(3.0, 300.0);
  CAPTURE(far);
  Numbers next(11);
  const Motion motion{{0, {0, 0, 0}}, {0.5, {0.4, 0.1, 0}}, {1, {0, 0.3, -0.6}}};
  Primitives<T> primitives;
  const Affine<double> map =
      translation(Vec3d(0.3, 0, 0)) * rotation(Vec3d(1, 2, 3), 50.0) * scaling(Vec3d(-1, 0.5, 1));
  for (int i = 0; i < 60; ++i) {
    const Vec3<T> at = next.in_box<T>(1.5);
    if (i % 3 == 0) {
      primitives.add(Sphere<T>{at, T(0.15)});
    } else if (i % 3 == 1) {
      primitives.add(Box<T>{at, at + Vec3<T>(T(0.2))}, *object_transform<T>(map));
    } else {
      primitives.add(Ellipsoid<T>{Vec3<T>(T(0.1), T(0.2), T(0.15))},
                     *object_transform<T>(translation(Vec3d(at)) * map));
    }
    if (i % 4 == 0) primitives.move(primitives.size() - 1, primitives.size(), motion);
  }
  const int shapes = primitives.size();
  const Mesh ball = icosphere(2, {0.8, 0, 0}, 0.5);
  primitives.add(ball, Affine<double>{}, true);
  primitives.add(ball, map, false);
  const int still = primitives.size();
  primitives.add(ball, translation(Vec3d(-1.5, 0, 0)), false);
  primitives.move(still, primitives.size(), motion);
  const Accelerator<T> list(primitives, AcceleratorKind::none);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < rounds(4000); ++i) {
    const Vec3<T> eye = static_cast<T>(far) * next.unit<T>();
    const Vec3<T> target =
        i % 2 ? Vec3<T>(edge_point(ball, i % 3 ? map : Affine<double>{}, next, i % 4 == 1)) : next.in_box<T>(1.5);
    Ray<T> ray{eye, target - eye};
    ray.time = static_cast<T>(next.real(0, 1));
    rays.push_back(ray);
  }
  for (const AcceleratorKind kind : structures) {
    INFO(name_of(kind));
    const Accelerator<T> structure(primitives, kind);
    TestCounts counts;
    int differing = 0, on_shapes = 0, on_meshes = 0, moving = 0;
    for (const Ray<T>& ray : rays) {
      const auto expected = list.closest(ray, infinity<T>, counts);
      differing += !same(expected, structure.closest(ray, infinity<T>, counts));
      differing += structure.occluded(ray, infinity<T>, counts) != expected.has_value();
      if (expected) ++(expected->primitive < shapes ? on_shapes : expected->primitive < still ? on_meshes : moving);
    }
    CHECK(differing == 0);
    CHECK(on_shapes > rounds(300));
    CHECK(on_meshes > rounds(300));
    CHECK(moving > rounds(100));
  }
}

TEMPLATE_TEST_CASE("accelerators miss nothing that is computed far away from where it stands", "[mesh]", float,
                   double) {
  using T = TestType;
  // There, all that is known of a ball is within one of its own radii.
  const double away = 0.5 / static_cast<double>(std::numeric_limits<T>::epsilon());
  Primitives<T> primitives;
  for (int i = 0; i < 4; ++i) {
    primitives.add(Sphere<T>{Vec3<T>(Vec3d(away, 2 * i, 0)), T(0.4)},
                   *object_transform<T>(translation(Vec3d(-away, -3, 0))));
    primitives.add(Sphere<T>{Vec3<T>(Vec3d(2 * i - 3, away, 0)), T(0.4)});
    primitives.move(2 * i + 1, 2 * i + 2, {{0, {0, -away, 0}}, {1, {0, 1 - away, 0}}});
  }
  const Accelerator<T> list(primitives, AcceleratorKind::none);
  Numbers next(23);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < rounds(3000); ++i) {
    const Vec3<T> eye = T(8) * next.unit<T>();
    rays.push_back({eye, next.in_box<T>(4) - eye, {}, static_cast<T>(next.real(0, 1))});
  }
  for (const AcceleratorKind kind : structures) {
    INFO(name_of(kind));
    const Accelerator<T> structure(primitives, kind);
    TestCounts counts;
    int differing = 0, hits = 0;
    for (const Ray<T>& ray : rays) {
      const auto expected = list.closest(ray, infinity<T>, counts);
      hits += expected.has_value();
      differing += !same(expected, structure.closest(ray, infinity<T>, counts));
    }
    CHECK(differing == 0);
    CHECK(hits > rounds(100));
  }
}

TEST_CASE("trees miss nothing that a map's rounding moves rays from afar to", "[mesh]") {
  Numbers next(29);
  Primitives<float> primitives;
  for (int i = 0; i < 200; ++i) {
    const Affine<double> turn = rotation(next.unit<double>(), next.real(0, 360));
    primitives.add(Ellipsoid<float>{}, *object_transform<float>(translation(next.in_box<double>()) * turn *
                                                                scaling(next.real(0.02, 0.05) * Vec3d(1, 0.5, 0.7))));
  }
  const Accelerator<float> list(primitives, AcceleratorKind::none), tree(primitives, AcceleratorKind::kdtree);
  TestCounts counts;
  int differing = 0;
  for (int i = 0; i < rounds(8000); ++i) {
    const Vec3<float> d = next.unit<float>();
    const Ray<float> ray{next.in_box<float>() - 1e7F * d, d};
    differing += !same(list.closest(ray, infinity<float>, counts), tree.closest(ray, infinity<float>, counts));
  }
  CHECK(differing == 0);
}

TEMPLATE_TEST_CASE("what moves is met where it is at the ray's time", "[mesh]", float, double) {
  using T = TestType;
  const Motion motion{{1, {2, 0, 0}}, {3, {4, 0, -8}}};
  Primitives<T> primitives;
  primitives.add(Sphere<T>{{0, 0, 0}, 1});
  primitives.add(Sphere<T>{{0, 0, 0}, 1}, *object_transform<T>(translation(Vec3d(0, 5, 0))));
  Mesh square;
  square.positions = {{-1, -1, -20}, {1, -1, -20}, {1, 1, -20}, {-1, 1, -20}};
  square.triangles = {{0, 1, 2}, {0, 2, 3}};
  primitives.add(square, Affine<double>{}, false);
  primitives.move(0, 4, motion);
  primitives.set_shutter(0, 4);
  const Accelerator<T> moving(primitives, AcceleratorKind::bvh);
  TestCounts counts;
  struct At {
    T time, x, z;
  };
  // At rest before the first key and after the last; half way at half the time.
  for (const At at : {At{0, 2, 0}, At{1, 2, 0}, At{2, 3, -4}, At{T(2.5), T(3.5), -6}, At{3, 4, -8}, At{4, 4, -8}}) {
    CAPTURE(at.time);
    const Ray<T> down{{at.x, 0, 50}, {0, 0, -1}, {}, at.time};
    const auto hit = moving.closest(down, infinity<T>, counts);
    REQUIRE(hit);
    CHECK(hit->primitive == 0);
    CHECK(hit->t == 49 - at.z);
    const SurfacePoint<T> top = moving.primitives().surface_at(0, down, Intersection<T>{hit->t, 0});
    CHECK(top.position == Vec3<T>(at.x, 0, at.z + 1));
    CHECK(top.normal == Vec3<T>(0, 0, 1));
    // A ray that leaves it does not meet it again, and meets what lies below at the same time.
    const Ray<T> away{{at.x, 0, at.z - 1}, {0, 0, -1}, {0, 0}, at.time};
    const auto floor = moving.closest(away, infinity<T>, counts);
    REQUIRE(floor);
    CHECK(floor->primitive >= 2);
    CHECK(floor->t == 19);
    const Ray<T> mapped{{at.x, 5, 50}, {0, 0, -1}, {}, at.time};
    CHECK(moving.closest(mapped, infinity<T>, counts)->primitive == 1);
    CHECK_FALSE(moving.occluded({{at.x, 5, at.z}, {0, 1, 0}, {1, 0}, at.time}, T(0.5), counts));
  }
}

TEST_CASE("equal keys and keys outside the time change nothing", "[mesh]") {
  CHECK(is_at_rest({}));
  CHECK(is_at_rest({{0, {1, 2, 3}}}));
  CHECK(is_at_rest({{0, {1, 2, 3}}, {1, {1, 2, 3}}}));
  CHECK_FALSE(is_at_rest({{0, {1, 2, 3}}, {1, {1, 2, 4}}}));
  const Motion late{{2, {0, 0, 0}}, {3, {1, 0, 0}}, {4, {0, 0, 0}}};
  CHECK_FALSE(moves_between(late, 0, 2));
  CHECK(moves_between(late, 0, 2.5));
  CHECK(moves_between(late, 1, 5));  // there and back
  CHECK_FALSE(moves_between(late, 2.5, 2.5));
  CHECK(offset_at({}, 7) == Vec3d(0.0));
  CHECK(offset_at({{0, {1, 0, 0}}, {2, {5, 0, 4}}}, 0.5) == Vec3d(2, 0, 1));
  // Inside something turned by a quarter about z that itself moves along z.
  const Motion both =
      moved_within({{0, {0, 0, 0}}, {2, {2, 0, 0}}}, rotation(Vec3d(0, 0, 1), 90.0), {{1, {0, 0, 0}}, {3, {0, 0, 6}}});
  CHECK(both.size() == 4);
  CHECK(offset_at(both, 0.5) == Vec3d(0, 0.5, 0));
  CHECK(offset_at(both, 1.5) == Vec3d(0, 1.5, 1.5));
  CHECK(offset_at(both, 3) == Vec3d(0, 2, 6));
}

TEST_CASE("a smooth mesh is shaded by the normals of its corners", "[mesh]") {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
  mesh.normals = {{0, 0, 2}, {3, 0, 3}, {0, 0, 1}};
  mesh.uv = {{0, 0}, {10, 0}, {0, 20}};
  mesh.triangles = {{0, 1, 2}};
  Primitives<double> primitives;
  primitives.add(mesh, Affine<double>{}, true);
  primitives.add(mesh, Affine<double>{}, false);
  primitives.add(mesh, scaling(Vec3d(1, 1, -1)), true);
  const SurfacePoint<double> half{{2, 0, 0}, {0, 0, 1}};
  const Vec3d expected = normalize((Vec3d(0, 0, 1) + normalize(Vec3d(1, 0, 1))) / 2.0);
  CHECK(length(*primitives.smooth_normal(0, half) - expected) < 1e-15);
  CHECK_FALSE(primitives.smooth_normal(1, half));
  CHECK(primitives.uv_at(0, half, 0) == Vec2d(5, 0));
  CHECK(primitives.uv_at(0, {{1, 2, 0}, {0, 0, 1}}, 0) == Vec2d(2.5, 10));
  // Mirrored, the outside is below, and so are the normals.
  const Ray<double> up{{1, 1, -5}, {0, 0, 1}};
  const auto point = primitives.surface_at(2, up, *primitives.intersect(2, up, 100.0));
  CHECK(point.normal == Vec3d(0, 0, -1));
  CHECK(primitives.smooth_normal(2, point)->z < 0);
}

TEST_CASE("vertices in one place share a normal, weighted with the angles there", "[mesh]") {
  // A cube's corner: three faces, one of them in two triangles. Each face counts by its right angle.
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0},
                    {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, {0, 0, 1}, {1, 0, 0}};
  mesh.triangles = {{0, 2, 1}, {0, 3, 2}, {4, 6, 5}, {7, 9, 8}};
  const std::vector<Vec3d> normals = vertex_normals(mesh);
  CHECK(normals[0] == normals[4]);
  CHECK(length(normalize(normals[0]) - normalize(Vec3d(-1, -1, -1))) < 1e-15);
  CHECK(length(normalize(normals[2]) - Vec3d(0, 0, -1)) < 1e-15);
}
