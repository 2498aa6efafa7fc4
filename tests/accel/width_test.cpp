// Every width that this machine has gives the same bits and meets the same nodes, and all give what testing every
// primitive gives: on random rays, and on rays aimed at corners and edges, where rounding decides.

#include "accel/width.h"

#include <limits>
#include <memory>

#include "accel/accelerator.h"
#include "hostile.h"
#include "meshes.h"
#include "shape/numbers.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// A ball, slivers, degenerate triangles, doubles in one place, one that moves, a few shapes among them.
template <class T>
Primitives<T> mixture(double scale, const Vec3d& at, bool moving) {
  const Affine<double> place = translation(at) * scaling(Vec3d(scale));
  Primitives<T> all;
  all.add(Sphere<T>{Vec3<T>(place.point({0.9, 0.9, 0})), static_cast<T>(0.2 * scale)});
  all.add(Box<T>{Vec3<T>(place.point({-1.2, 0.4, -0.3})), Vec3<T>(place.point({-0.9, 0.8, 0.1}))});
  add_hostile_meshes(all, place, scale, moving);
  return all;
}

}  // namespace

TEST_CASE("a width can be forced for a while", "[accel]") {
  REQUIRE_FALSE(lane_widths().empty());
  CHECK(lane_widths().front() == LaneWidth::four);
  const LaneWidth widest = lane_widths().back();
  CHECK(lane_width() == widest);
  {
    const ForcedWidth narrow(LaneWidth::four);
    CHECK(lane_width() == LaneWidth::four);
    const ForcedWidth wide(widest);
    CHECK(lane_width() == widest);
  }
  CHECK(lane_width() == widest);
}

TEMPLATE_TEST_CASE("every width and quality answers as brute force does, and widths meet the same nodes", "[accel]",
                   float, double) {
  using T = TestType;
  const double scale = GENERATE(1.0, 1e-20, 3e-5, 1e6, 1e17);
  const double shift = GENERATE(0.0, 30.0, 1e5);
  const bool moving = GENERATE(false, true);
  const BuildQuality quality = GENERATE(BuildQuality::fast, BuildQuality::good, BuildQuality::best);
  CAPTURE(scale, shift, moving, name_of(quality));
  const Vec3d middle = scale * shift * Vec3d(1, -2, 0.5);
  const Primitives<T> all = mixture<T>(scale, middle, moving);
  const Accelerator<T> list(all, AcceleratorKind::none), tree(all, AcceleratorKind::bvh, {.quality = quality});
  std::vector<ShadowRole> roles(static_cast<std::size_t>(all.size()), ShadowRole::filters);
  for (std::size_t i = 0; i < roles.size(); i += 5) roles[i] = i % 2 ? ShadowRole::stops : ShadowRole::ignored;
  const Comparison found = compare(list, tree, hostile(all, scale, middle, rounds(250)), roles, roles);
  CHECK(found.differing == 0);
  CHECK(static_cast<int>(found.hit_ids.size()) > rounds(80));
  CHECK(found.exact > rounds(8));
}

TEMPLATE_TEST_CASE("what certainly blocks a shadow ray is never what it departs from, nor its neighbour", "[accel]",
                   float, double) {
  using T = TestType;
  const double scale = GENERATE(1.0, 1e-6, 1e6), shift = GENERATE(0.0, 100.0);
  CAPTURE(scale, shift);
  Primitives<T> all;
  all.add(icosphere(3), translation(scale * shift * Vec3d(1, -2, 0.5)) * scaling(Vec3d(scale)), false);
  const Accelerator<T> list(all, AcceleratorKind::none), tree(all, AcceleratorKind::bvh);
  Numbers next(31);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < rounds(3000); ++i) {
    const int from = next.integer(0, all.size() - 1), to = i % 4 ? next.integer(0, all.size() - 1) : from;
    const Triangle<T> left = all.triangles()[from], met = all.triangles()[to];
    // From a corner, an edge or within, over the plane of the triangle or into the ball.
    const T a = i % 3 ? static_cast<T>(next.real(0, 1)) : T(0), b = i % 3 == 2 ? static_cast<T>(next.real(0, 1)) : T(0);
    const Vec3<T> eye = left.a + a * (left.b - left.a) + b * (1 - a) * (left.c - left.a);
    Vec3<T> way = to == from ? left.b - left.a : met.a - eye;
    if (i % 2) way += static_cast<T>(next.real(-1e-3, 1e-3) * scale) * next.unit<T>();
    if (way == Vec3<T>(0)) continue;
    rays.push_back({eye, way, {from, 0}});
    // Said to depart from what it is aimed at from afar.
    const Vec3<T> afar = eye + static_cast<T>(scale) * next.unit<T>();
    if (i % 5 == 0) rays.push_back({afar, (left.a + left.b + left.c) / T(3) - afar, {from, 0}});
  }
  const Comparison found = compare(list, tree, rays, {}, {});
  CHECK(found.differing == 0);
  CHECK(static_cast<int>(found.hit_ids.size()) > rounds(1000));
}

TEMPLATE_TEST_CASE("a ray that leaves a triangle does not hit its neighbour where only rounding put it beyond the edge",
                   "[accel]", float, double) {
  using T = TestType;
  const bool copied = GENERATE(false, true);
  const double size = GENERATE(1.0, 1024.0);
  CAPTURE(copied, size);
  const Affine<double> place = scaling(Vec3d(size));
  // Two sides of a valley along y: level to the left, rising to the right.
  Mesh valley;
  valley.positions = {{0, -1, 0}, {0, 1, 0}, {-1, 0, 0}, {1, 0, 0.5}};
  valley.triangles = {{0, 1, 2}, {0, 3, 1}};
  Primitives<T> all;
  if (copied)
    all.add_copy(std::make_shared<const Mesh>(valley), place, false);
  else
    all.add(valley, place, false);
  const T tiny = std::numeric_limits<T>::epsilon() / 4 * static_cast<T>(size), far = static_cast<T>(size / 1024);
  const auto hit = [&](T beyond_edge, int departed) {
    Ray<T> ray{{beyond_edge, 0, 0}, {T(0.125), 0, 1}};
    if (departed >= 0) ray.departure = {departed, 0};
    return all.intersect(1, ray, infinity<T>).has_value();
  };
  // Steeper than the right side, from a little below it.
  CHECK(hit(tiny, -1));
  CHECK_FALSE(hit(tiny, 0));
  CHECK(hit(far, 0));
}

TEMPLATE_TEST_CASE("packs rule out most triangles, and count them", "[accel]", float, double) {
  using T = TestType;
  Primitives<T> all;
  all.add(icosphere(4), {}, false);
  const Accelerator<T> tree(all, AcceleratorKind::bvh);
  Numbers next(3);
  TestCounts counts;
  int hits = 0;
  const int rays = rounds(2000);
  for (int i = 0; i < rays; ++i) {
    const Vec3<T> eye = T(3) * next.unit<T>();
    const Ray<T> ray{eye, next.in_box<T>(1) - eye};
    hits += tree.closest(ray, infinity<T>, counts).has_value();
  }
  CHECK(hits > rays / 2);
  // Far fewer than all 5120, and more than the one or two that are hit.
  CHECK(counts.primitives < static_cast<std::uint64_t>(60 * rays));
  CHECK(counts.primitives > static_cast<std::uint64_t>(3 * hits));
  CHECK(counts.nodes < static_cast<std::uint64_t>(20 * rays));
}

TEST_CASE(
    "in double, brute force's answers are given of a mesh that floats hold, and of one with a corner between floats",
    "[accel]") {
  const double scale = GENERATE(1.0, 1e-6, 1e6);
  const bool exact = GENERATE(false, true);
  CAPTURE(scale, exact);
  Mesh ball = icosphere(3, Vec3d(0.0), scale);
  for (Vec3d& at : ball.positions) at = Vec3d(Vec3<float>(at));
  // Where a float's corner in its place would be another triangle for most rays.
  if (!exact)
    for (std::size_t i = 0; i < ball.positions.size(); i += 7) ball.positions[i] *= 1 + 0x1p-26;
  Primitives<double> all;
  all.add(ball, {}, false);
  const Accelerator<double> list(all, AcceleratorKind::none), tree(all, AcceleratorKind::bvh);
  const Comparison found = compare(list, tree, hostile(all, scale, Vec3d(0.0), rounds(600)), {}, {});
  CHECK(found.differing == 0);
  CHECK(static_cast<int>(found.hit_ids.size()) > rounds(200));
}
