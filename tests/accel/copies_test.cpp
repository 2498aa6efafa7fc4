// Copies of a mesh share one tree, and answer as if each were stored: to the bit, wherever and however they are placed.

#include "accel/mesh_copies.h"

#include <algorithm>

#include "accel/accelerator.h"
#include "accel/watched.h"
#include "hostile.h"
#include "meshes.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// Turned, stretched by up to `stretch` along an axis of no importance, mirrored now and then.
Affine<double> somewhere(Numbers& next, double stretch) {
  const Affine<double> turn = rotation(next.unit<double>(), next.real(0, 360));
  const Vec3d size(next.real(0.5, 1), next.real(0.5, 1) * (next.integer(0, 2) ? 1 : -1), next.real(0.5, 1) / stretch);
  return translation(next.in_box<double>(2)) * turn * scaling(size) * rotation(next.unit<double>(), next.real(0, 360));
}

struct Placed {
  std::shared_ptr<const Mesh> mesh;
  Affine<double> at;
};

// Balls and slivers in many places, two of them twice in the same one, and boxes side by side that share their walls.
std::vector<Placed> placements(double scale, const Vec3d& middle, double stretch) {
  const auto ball = std::make_shared<const Mesh>(icosphere(2, Vec3d(0.3, 0, 0), 0.4));
  const auto fence = std::make_shared<const Mesh>(slivers());
  auto brick = std::make_shared<Mesh>();
  for (int i = 0; i < 8; ++i) brick->positions.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
  for (const auto& [a, b, c, d] :
       {std::array{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}})
    brick->triangles.push_back({a, b, c}), brick->triangles.push_back({a, c, d});
  brick->triangles.push_back({0, 0, 1}), brick->triangles.push_back({0, 3, 3});  // of no area: never hit
  const Affine<double> place = translation(middle) * scaling(Vec3d(scale));
  Numbers next(5);
  std::vector<Placed> all;
  for (int i = 0; i < 12; ++i) all.push_back({i % 3 ? ball : fence, place * somewhere(next, stretch)});
  all.push_back(all[1]), all.push_back(all[0]);
  for (int i = 0; i < 4; ++i)
    all.push_back({brick, place * translation(Vec3d(0.25 * i - 1, -1.5, 0)) * scaling(Vec3d(0.25))});
  return all;
}

template <class T>
Primitives<T> shapes(double scale, const Vec3d& middle) {
  const Affine<double> place = translation(middle) * scaling(Vec3d(scale));
  Primitives<T> all;
  all.add(Sphere<T>{Vec3<T>(place.point({0.9, 0.9, 0})), static_cast<T>(0.2 * scale)});
  all.add(Plane<T>{Vec3<T>(place.point({0, 0, -2})), {0, 0, 1}});
  return all;
}

// The same primitives, the meshes stored and as copies.
template <class T>
struct BothWays {
  Primitives<T> stored, copied;
};
template <class T>
BothWays<T> both_ways(double scale, const Vec3d& middle, double stretch) {
  BothWays<T> both{shapes<T>(scale, middle), shapes<T>(scale, middle)};
  for (const Placed& each : placements(scale, middle, stretch)) {
    both.stored.add(*each.mesh, each.at, false);
    both.copied.add_copy(each.mesh, each.at, false);
  }
  return both;
}

}  // namespace

TEMPLATE_TEST_CASE("copies answer as if they were stored", "[accel]", float, double) {
  using T = TestType;
  const double scale = GENERATE(1.0, 1e-20, 3e-5, 1e6, 1e17);
  const double shift = GENERATE(0.0, 30.0, 1e5);
  const double stretch = GENERATE(1.0, 1e3, 1e9);
  const BuildQuality quality = GENERATE(BuildQuality::good, BuildQuality::best);
  CAPTURE(scale, shift, stretch, name_of(quality));
  const Vec3d middle = scale * shift * Vec3d(1, -2, 0.5);
  const auto [stored, copied] = both_ways<T>(scale, middle, stretch);
  REQUIRE(stored.size() == copied.size());
  REQUIRE(copied.own_size() == 2);
  const Accelerator<T> list(stored, AcceleratorKind::none),
      tree(copied, AcceleratorKind::automatic, {.quality = quality});
  REQUIRE(tree.kind() == AcceleratorKind::bvh);
  const std::vector<ShadowRole> roles{ShadowRole::filters, ShadowRole::ignored};
  std::vector<ShadowRole> all_roles = roles;
  all_roles.resize(static_cast<std::size_t>(stored.size()), ShadowRole::stops);
  const Comparison found = compare(list, tree, hostile(stored, scale, middle, rounds(150)), all_roles, roles);
  const auto of_copies = std::count_if(found.hit_ids.begin(), found.hit_ids.end(), [](int id) { return id >= 2; });
  CHECK(found.differing == 0);
  CHECK(static_cast<int>(found.hit_ids.size()) > rounds(50));
  CHECK(of_copies > rounds(20));
  CHECK(found.exact > 0);
}

TEMPLATE_TEST_CASE("structures that know nothing of copies list their triangles", "[accel]", float, double) {
  using T = TestType;
  const auto [stored, copied] = both_ways<T>(1, Vec3d(0.0), 1);
  const AcceleratorKind kind = GENERATE(AcceleratorKind::none, AcceleratorKind::boxes, AcceleratorKind::grid,
                                        AcceleratorKind::octree, AcceleratorKind::kdtree);
  const Accelerator<T> list(stored, AcceleratorKind::none), other(copied, kind);
  int differing = 0;
  TestCounts counts;
  for (const Ray<T>& ray : hostile(stored, 1, Vec3d(0.0), rounds(200)))
    differing += !same(list.closest(ray, infinity<T>, counts), other.closest(ray, infinity<T>, counts));
  CHECK(differing == 0);
}

TEMPLATE_TEST_CASE("the triangle of a copy has the bits, normals and uv of a stored one", "[accel]", float, double) {
  using T = TestType;
  Mesh ball = icosphere(1);
  for (const Vec3d& at : ball.positions) ball.uv.push_back({at.x, at.y});
  Mesh bare = ball;
  bare.normals.clear(), bare.uv.clear();
  Triangles<T> stored, copied;
  Numbers next(11);
  for (int i = 0; i < 20; ++i) {
    const Mesh& mesh = i % 2 ? ball : bare;
    const Affine<double> at = somewhere(next, 3);
    stored.add(mesh, at, i % 3 > 0);
    copied.add_copy(std::make_shared<const Mesh>(mesh), at, i % 3 > 0);
  }
  REQUIRE(stored.size() == copied.size());
  CHECK(copied.own_size() == 0);
  for (int i = 0; i < stored.size(); i += 7) {
    const Triangle<T> triangle = stored[i];
    REQUIRE(copied[i] == triangle);
    const SurfacePoint<T> at{(triangle.a + triangle.b + T(2) * triangle.c) / T(4),
                             normalize(cross(triangle.b - triangle.a, triangle.c - triangle.a))};
    const Vec3<T> along = triangle.b - triangle.c;
    REQUIRE(copied.given_normal(i, at) == stored.given_normal(i, at));
    REQUIRE(copied.smooth_normal(i, at) == stored.smooth_normal(i, at));
    REQUIRE(copied.uv_at(i, at) == stored.uv_at(i, at));
    REQUIRE(copied.normal_derivative(i, at, along) == stored.normal_derivative(i, at, along));
    REQUIRE(copied.uv_derivative(i, at, along) == stored.uv_derivative(i, at, along));
  }
}

TEST_CASE("ten thousand copies take the memory of one, and a ray meets few of them", "[accel]") {
  const auto ball = std::make_shared<const Mesh>(icosphere(4));
  const auto bytes_of = [&](int side) {
    Primitives<float> all;
    for (int i = 0; i < side * side; ++i)
      all.add_copy(ball, translation(Vec3d(3.0 * (i % side), 3.0 * (i / side), 0)), true);
    const Accelerator<float> tree(all);
    TestCounts counts;
    Numbers next(3);
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
      const Vec3<float> from(next.in_box<double>(1.5 * side) + Vec3d(1.5 * side, 1.5 * side, 60));
      const Vec3<float> to(next.in_box<double>(1.5 * side) + Vec3d(1.5 * side, 1.5 * side, 0));
      hits += tree.closest(Ray<float>{from, to - from}, infinity<float>, counts).has_value();
    }
    CHECK(hits > 50);
    CHECK(counts.nodes < 60'000);
    CHECK(all.size() == side * side * 5120);
    return static_cast<double>(tree.statistics().bytes);
  };
  const double one = bytes_of(2), many = bytes_of(100);
  CHECK(many < one + 600.0 * 10'000);
}

TEST_CASE("a watched search of copies finds what the search does, in boxes of the scene", "[accel]") {
  const Primitives<double> copied = both_ways<double>(1, Vec3d(0.0), 2).copied;
  const Accelerator<double> tree(copied);
  const WatchedAccelerator<double> watched(tree.primitives(), AcceleratorKind::bvh, 1000);
  CHECK(watched.statistics().nodes == tree.statistics().nodes);
  int found = 0;
  for (const Ray<double>& ray : hostile(tree.primitives(), 1, Vec3d(0.0), 100)) {
    TestCounts counts, watched_counts;
    SearchRecord record(ray.origin, ray.direction, infinity<double>);
    const auto expected = tree.closest(ray, infinity<double>, counts);
    REQUIRE(same(expected, watched.closest(ray, infinity<double>, watched_counts, record)));
    CHECK(watched_counts.nodes == counts.nodes);
    CHECK(watched_counts.primitives == counts.primitives);
    if (!expected || expected->primitive < 2 || !(expected->t > 1e-6 && expected->t < 1e6)) continue;
    // The test that found it lies in the box that lists it.
    REQUIRE(record.nearest());
    const Bounds<double> box = record.nearest()->box;
    const Vec3d at = ray.at(expected->t);
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(at[axis] >= box.min[axis] - 1e-5);
      CHECK(at[axis] <= box.max[axis] + 1e-5);
    }
    ++found;
  }
  CHECK(found > 20);
}

TEMPLATE_TEST_CASE("naive rays find copies too, but for rounding", "[accel]", float, double) {
  using T = TestType;
  const auto [stored, copied] = both_ways<T>(1, Vec3d(0.0), 1);
  const Accelerator<T> list(stored, AcceleratorKind::none), tree(copied, AcceleratorKind::bvh);
  Numbers next(8);
  int differing = 0, hits = 0;
  TestCounts counts;
  for (int i = 0; i < 400; ++i) {
    const Vec3<T> eye = T(6) * next.unit<T>();
    const Triangle<T> aimed = stored.triangles()[next.integer(0, stored.triangles().size() - 1)];
    const NaiveRay<T> ray(Ray<T>{eye, (aimed.a + aimed.b + aimed.c) / T(3) - eye});
    const auto expected = list.closest(ray, infinity<T>, counts), found = tree.closest(ray, infinity<T>, counts);
    differing += !same(expected, found), hits += found && found->primitive >= 2;
  }
  CHECK(differing <= 2);
  CHECK(hits > 100);
}
