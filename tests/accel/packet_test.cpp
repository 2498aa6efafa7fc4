// Rays that are searched together have the answers that each has alone: coherent ones, aimed at corners and edges, and
// those that a packet cannot hold; at every width, which meet the same nodes. And each box that a ray's own test lets
// pass, its packet's test lets pass.

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <memory>
#include <span>

#include "accel/accelerator.h"
#include "accel/lanes_four.h"
#include "accel/library.h"
#include "accel/ray_packet.h"
#include "accel/width.h"
#include "hostile.h"
#include "meshes.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

// A ball, slivers twice, triangles without an area, one that moves, a few shapes, a plane that has no bounds, and a
// copy.
template <class T>
Primitives<T> mixture(double scale, const Vec3d& at) {
  const Affine<double> place = translation(at) * scaling(Vec3d(scale));
  Primitives<T> all;
  all.add(Sphere<T>{Vec3<T>(place.point({0.9, 0.9, 0})), static_cast<T>(0.2 * scale)});
  all.add(Plane<T>{Vec3<T>(place.point({0, -1.5, 0})), {0, 1, 0}});
  add_hostile_meshes(all, place, scale, true);
  all.add_copy(std::make_shared<const Mesh>(icosphere(1, {1, 0, 0.5}, 0.3)), place, false);
  return all;
}

template <class T>
struct Batch {
  std::vector<Ray<T>> rays;
  std::vector<T> t_max;
};

// Sixteen times sixteen rays that go nearly the same way, through corners and along edges where they can; here and
// there one that goes another way, has a slope of 0, or is nothing.
template <class T>
Batch<T> bundle(const Primitives<T>& all, double scale, const Vec3d& middle, Numbers& next) {
  Batch<T> batch;
  const auto triangle = [&] { return all.triangles()[next.integer(0, all.triangles().size() - 1)]; };
  const Vec3d eye = middle + scale * std::pow(10.0, next.integer(0, 2)) * next.unit<double>();
  const Vec3d target = wide(triangle().a);
  const double spread = scale * std::pow(10.0, -next.integer(0, 4));
  const bool parallel = next.integer(0, 3) == 0, strange = next.integer(0, 2) == 0;
  for (int i = 0; i < 256; ++i) {
    Vec3<T> from(parallel ? eye + spread * next.in_box<double>() : eye), to(target + spread * next.in_box<double>());
    const Triangle<T> near = triangle();
    if (i % 3 == 0 && length(wide(near.a) - target) < 4 * spread)
      to = near.a + (i % 2 ? T(0.5) : T(0)) * (near.b - near.a);
    Ray<T> ray{from, to - from};
    if (i % 5 == 0) ray.direction *= static_cast<T>(std::ldexp(1.0, next.integer(-3, 3)));
    ray.time = static_cast<T>(next.real(0, 1));
    if (i % 31 == 0) ray.departure = {all.shape_count() + next.integer(0, all.triangles().size() - 1), 0};
    if (strange && i % 7 == 0) {
      const int axis = next.integer(0, 2), kind = next.integer(0, 6);
      if (kind == 0) ray.direction[axis] = 0;
      if (kind == 1) ray.direction[axis] = -T(0);
      if (kind == 2) ray.direction[axis] = -ray.direction[axis];
      if (kind == 3) ray.direction[axis] = std::numeric_limits<T>::denorm_min();
      if (kind == 4) ray.direction *= static_cast<T>(std::ldexp(1.0, next.integer(-70, 70)));
      if (kind == 5) ray.direction[axis] = infinity<T>;
      if (kind == 6) ray.direction[axis] = std::numeric_limits<T>::quiet_NaN();
    }
    if (ray.direction == Vec3<T>(0)) ray.direction.x = 1;
    batch.rays.push_back(ray);
    const double reach = length(target - eye) * next.real(0.5, 2) / std::max(1e-300, length(wide(ray.direction)));
    batch.t_max.push_back(i % 4 == 0 ? static_cast<T>(reach) : infinity<T>);
  }
  return batch;
}

}  // namespace

TEMPLATE_TEST_CASE("rays that are searched together are told what each is told alone", "[accel]", float, double) {
  using T = TestType;
  const double scale = GENERATE(1.0, 1e-20, 3e-5, 1e6, 1e17);
  const double shift = GENERATE(0.0, 30.0, 1e5);
  const AcceleratorKind kind = GENERATE(AcceleratorKind::bvh, AcceleratorKind::none);
  CAPTURE(scale, shift, name_of(kind));
  const Vec3d middle = scale * shift * Vec3d(1, -2, 0.5);
  const Accelerator<T> structure(mixture<T>(scale, middle), kind);
  Numbers next(41);
  int hits = 0, differing = 0;
  const int batches = kind == AcceleratorKind::none ? 1 : rounds(8);
  for (int round = 0; round < batches; ++round) {
    const Batch<T> batch = bundle(structure.primitives(), scale, middle, next);
    const std::size_t size = batch.rays.size() - static_cast<std::size_t>(round % 16);
    const std::span rays = std::span(batch.rays).first(size);
    const std::span t_max = std::span(batch.t_max).first(size);
    std::optional<TestCounts> narrow;
    for (const LaneWidth width : lane_widths()) {
      const ForcedWidth forced(width);
      std::vector<std::optional<Hit<T>>> together(size);
      const auto blocked = std::make_unique<bool[]>(size);
      TestCounts counts, uncounted;
      structure.closest(rays, t_max, together, counts);
      structure.occluded(rays, t_max, {blocked.get(), size}, counts);
      for (std::size_t i = 0; i < size; ++i) {
        const auto alone = structure.closest(rays[i], t_max[i], uncounted);
        hits += alone.has_value();
        differing += !same(alone, together[i]);
        differing += blocked[i] != structure.occluded(rays[i], t_max[i], uncounted);
      }
      if (!narrow) narrow = counts;
      CHECK(counts.nodes == narrow->nodes);
      CHECK(counts.primitives == narrow->primitives);
      CHECK(counts.exactly_decided == narrow->exactly_decided);
    }
  }
  CHECK(differing == 0);
  CHECK(hits > 10 * batches);
}

TEST_CASE("a packet's test lets pass each box that a ray's own test lets pass, and entered no later", "[accel]") {
  Numbers next(11);
  const auto of_any_size = [&] { return std::ldexp(next.real(), next.integer(-20, 20)); };
  int met = 0, lost = 0, late = 0, others = 0;
  for (int round = 0; round < rounds(4000); ++round) {
    // Slopes of one sign an axis, nearly alike or not at all.
    const Vec3d sign(next.integer(0, 1) * 2 - 1, next.integer(0, 1) * 2 - 1, next.integer(0, 1) * 2 - 1);
    const double spread = std::pow(10.0, -next.integer(0, 5)), size = std::abs(of_any_size());
    const Vec3d slope(next.real(0.1, 1), next.real(0.1, 1), next.real(1e-3, 1));
    std::vector<MeshRay> rays;
    std::vector<Ray<float>> plain;
    const auto count = static_cast<unsigned>(next.integer(1, 16));
    while (rays.size() < count) {
      Ray<float> ray;
      for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = static_cast<float>(size * (-2 * sign[axis] + spread * next.real()));
        ray.direction[axis] = static_cast<float>(sign[axis] * slope[axis] * (1 + spread * next.real(-0.9, 5)));
      }
      rays.emplace_back(ray), plain.push_back(ray);
    }
    const RaysAbreast abreast(count, [&](unsigned i) { return plain[i]; });
    // Not all of them, at times.
    const unsigned alike = abreast.alike(0), some = alike & static_cast<unsigned>(next.integer(0, 0xffff));
    const unsigned members = next.integer(0, 1) == 0 || some == 0 ? alike : some;
    RayPacket packet(abreast, members);
    WideNode node{};
    node.count = static_cast<std::uint32_t>(next.integer(1, 8));
    for (unsigned lane = 0; lane < tree_width; ++lane)
      for (int axis = 0; axis < 3; ++axis) {
        // Some flat, some begin where rays do.
        const double at = size * next.real(-2, 2), width = size * spread * next.real(0, 4) * next.integer(0, 1);
        const double low = next.integer(0, 9) == 0 ? -2 * size * sign[axis] : at;
        const bool empty = lane >= node.count;
        node.planes[axis][lane] = empty ? infinity<float> : static_cast<float>(low);
        node.planes[axis + 3][lane] = empty ? -infinity<float> : static_cast<float>(low + width);
      }
    // Most boxes are moved onto a ray.
    for (unsigned lane = 0; lane < node.count; ++lane) {
      if (lane % 4 == 3) continue;
      const MeshRay& ray = rays[static_cast<std::size_t>(next.integer(0, static_cast<int>(count) - 1))];
      const double t = size * next.real(0, 4);
      for (int axis = 0; axis < 3; ++axis) {
        const float width = node.planes[axis + 3][lane] - node.planes[axis][lane];
        const double at = static_cast<double>(ray.from_in[axis]) + t / static_cast<double>(ray.inverse[axis]);
        node.planes[axis][lane] = static_cast<float>(at - next.real(0, 1) * static_cast<double>(width));
        node.planes[axis + 3][lane] = node.planes[axis][lane] + width;
      }
    }
    float most = 0;
    for (unsigned i = 0; i < count; ++i) {
      if ((members >> i & 1) == 0) continue;
      packet.t_far[i] = next.integer(0, 2) == 0 ? static_cast<float>(size * next.real(0, 4)) : infinity<float>;
      most = std::max(most, packet.t_far[i]);
    }
    alignas(32) BoxEntry together[tree_width], alone[tree_width];
    const unsigned bits = four::meet(packet, most, node, together);
    std::vector<unsigned> by_box(tree_width, 0);
    for (unsigned i = 0; i < count; ++i) {
      if ((members >> i & 1) == 0) continue;
      four::HeldRay held;
      four::hold(rays[i], packet.t_far[i], held);
      const unsigned own = four::meet(held, node, alone);
      lost += (own & ~bits) != 0;
      for (unsigned lane = 0; lane < node.count; ++lane) {
        if ((own >> lane & 1) == 0) continue;
        ++met;
        late += together[lane].t() > alone[lane].t();
        by_box[lane] |= 1U << i;
      }
    }
    for (unsigned lane = 0; lane < node.count; ++lane)
      others += four::rays_that_meet(packet, node, lane, members) != by_box[lane];
  }
  CHECK(lost == 0);
  CHECK(late == 0);
  CHECK(others == 0);
  CHECK(met > rounds(4000));
}

TEST_CASE("a packet's rays rule out the triangles that each of them rules out alone", "[accel]") {
  Numbers next(7);
  int differing = 0, candidates = 0, ruled_out = 0;
  for (int round = 0; round < rounds(3000); ++round) {
    const double size = std::ldexp(1.0, next.integer(-30, 30)), spread = std::pow(10.0, -next.integer(1, 4));
    const Vec3d eye = size * next.unit<double>(), target = 0.3 * size * next.in_box<double>();
    std::vector<Ray<double>> plain;
    std::vector<MeshRay> rays;
    std::vector<Vec3d> ends;
    const auto count = static_cast<std::size_t>(next.integer(1, 16));
    for (int tries = 0; tries < 99 && rays.size() < count; ++tries) {
      // Some from much farther away, whose origins are rounded more.
      const Vec3d end = target + size * spread * next.in_box<double>();
      const Vec3d from = end + (next.integer(0, 2) == 0 ? 50.0 : 1.0) * (eye - end);
      const Ray<double> ray{from, end - from};
      const std::array pair{rays.empty() ? ray : plain[0], ray};
      if (RaysAbreast(2, [&](unsigned i) { return pair[i]; }).coherent(0, infinity<float>) != 3) continue;
      plain.push_back(ray), rays.emplace_back(ray), ends.push_back(end);
    }
    if (rays.empty()) continue;
    const RaysAbreast abreast(static_cast<unsigned>(rays.size()), [&](unsigned i) { return plain[i]; });
    const unsigned all = abreast.coherent(0, infinity<float>);
    REQUIRE(all == (1U << rays.size()) - 1);
    RayPacket packet(abreast, all);
    for (unsigned i = 0; i < rays.size(); ++i)
      packet.t_far[i] = next.integer(0, 1) == 0 ? static_cast<float>(next.real(0, 2)) : infinity<float>;
    TrianglePack pack{};
    const auto triangles = static_cast<unsigned>(next.integer(1, 8));
    for (unsigned lane = 0; lane < tree_width; ++lane) {
      // Small ones near where rays go, slivers, and some of which a ray nearly meets a corner.
      const double wide_by = size * std::pow(10.0, -next.integer(0, 5));
      const Vec3d& end = ends[static_cast<std::size_t>(next.integer(0, static_cast<int>(ends.size()) - 1))];
      for (int corner = 0; corner < 3; ++corner) {
        const bool narrow = corner == 2 && lane % 3 == 0, aimed = corner == 0 && lane % 2 == 0;
        const Vec3d place = end + (aimed ? 3e-6 * size : narrow ? 1e-6 * wide_by : wide_by) * next.in_box<double>();
        for (int axis = 0; axis < 3; ++axis) pack.corners[corner][axis][lane] = static_cast<float>(place[axis]);
      }
    }
    const auto asked = static_cast<unsigned>(next.integer(1, 0xffff)) & all;
    std::vector<unsigned> alone(rays.size(), 0);
    for (unsigned i = 0; i < rays.size(); ++i) {
      unsigned certain = 0;
      alone[i] = four::sift<false>(rays[i], four::reach_of(rays[i], packet.t_far[i]), pack, triangles, certain);
    }
    for (unsigned lane = 0; lane < triangles; ++lane) {
      const unsigned together = four::rays_that_may_hit(packet, pack, lane, asked);
      for (unsigned i = 0; i < rays.size(); ++i) {
        const bool may_hit = (asked >> i & 1) != 0 && (alone[i] >> lane & 1) != 0;
        differing += may_hit != ((together >> i & 1) != 0);
        candidates += may_hit, ruled_out += !may_hit;
      }
    }
  }
  CHECK(differing == 0);
  CHECK(candidates > rounds(3000));
  CHECK(ruled_out > rounds(3000));
}

TEST_CASE("coherent rays that are searched together meet about the nodes that they meet alone", "[accel]") {
  Primitives<float> all;
  all.add(icosphere(4), {}, false);
  const Accelerator<float> tree(all, AcceleratorKind::bvh);
  Numbers next(3);
  TestCounts alone, together;
  for (int round = 0; round < rounds(200); ++round) {
    const Vec3<float> eye = 3.0F * next.unit<float>(), at = next.in_box<float>(0.7);
    std::vector<Ray<float>> rays;
    for (int i = 0; i < 16; ++i) rays.push_back({eye, at + next.in_box<float>(0.02) - eye});
    const std::vector<float> t_max(rays.size(), infinity<float>);
    std::vector<std::optional<Hit<float>>> hits(rays.size());
    tree.closest(rays, t_max, hits, together);
    for (const Ray<float>& ray : rays) (void)tree.closest(ray, infinity<float>, alone);
  }
  CHECK(static_cast<double>(together.nodes) > 0.9 * static_cast<double>(alone.nodes));
  CHECK(static_cast<double>(together.nodes) < 1.2 * static_cast<double>(alone.nodes));
  CHECK(static_cast<double>(together.primitives) < 1.2 * static_cast<double>(alone.primitives));
}

TEST_CASE("packets hold rays whose slopes have the same signs, and coherent ones go nearly the same way", "[accel]") {
  using From = Vec3<float>;
  const auto of = [](const Ray<float>& a, const Ray<float>& b) {
    return RaysAbreast(2, [&](unsigned i) { return i == 0 ? a : b; });
  };
  const auto coherent = [&](const Ray<float>& a, const Ray<float>& b) { return of(a, b).coherent(0, 1) == 3; };
  const auto alike = [&](const Ray<float>& a, const Ray<float>& b) { return of(a, b).alike(0) == 3; };
  const Ray<float> ray{From(0), {0.1F, 0.2F, 1}};
  CHECK(coherent(ray, ray));
  CHECK(coherent(ray, {{0, 0.5F, 0}, {0.2F, 0.4F, 2.2F}}));
  CHECK_FALSE(coherent(ray, {{0, 2, 0}, {0.1F, 0.2F, 1}}));
  CHECK_FALSE(coherent(ray, {From(0), {0.1F, 0.9F, 1}}));
  CHECK(alike(ray, {From(0), {0.1F, 0.9F, 1}}));
  CHECK_FALSE(alike(ray, {From(0), {0.1F, 1.1F, 1}}));  // another axis becomes z
  CHECK_FALSE(alike(ray, {From(2e18F, 0, 0), {0.1F, 0.9F, 1}}));
  for (const float other : {-0.01F, 0.0F, -0.0F, 1e-30F, std::numeric_limits<float>::quiet_NaN()}) {
    CAPTURE(other);
    const Ray<float> odd{From(0), {other, 0.2F, 1}};
    CHECK_FALSE(alike(ray, {From(0), {0.1F, other, 1}}));
    CHECK_FALSE(alike(odd, ray));
    CHECK(alike(odd, odd) == (other < 0));
  }
}

TEMPLATE_TEST_CASE("rays abreast are, bit for bit, what each is alone", "[accel]", float, double) {
  using T = TestType;
  Numbers next(3);
  int differing = 0, valid = 0, others = 0;
  const auto of_any_size = [&] { return static_cast<T>(std::ldexp(next.real(-1, 1), next.integer(-64, 64))); };
  for (int round = 0; round < rounds(3000); ++round) {
    const auto count = static_cast<unsigned>(next.integer(1, 16));
    std::vector<Ray<T>> rays(count);
    for (Ray<T>& ray : rays)
      for (int axis = 0; axis < 3; ++axis) {
        ray.origin[axis] = of_any_size();
        ray.direction[axis] = next.integer(0, 9) == 0 ? (next.integer(0, 1) == 0 ? T(0) : -T(0)) : of_any_size();
      }
    const RaysAbreast abreast(count, [&](unsigned i) { return rays[i]; });
    for (unsigned i = 0; i < count; ++i) {
      const MeshRay alone(rays[i]);
      const Vec3<T>& slope = rays[i].direction;
      const bool flat = slope.x == 0 || slope.y == 0 || slope.z == 0;
      if (abreast.kind[i] < 0 || !alone.held) {
        others += (abreast.kind[i] < 0) != (!alone.held || flat);
        continue;
      }
      ++valid;
      const auto same = [&](float a, float b) { differing += std::bit_cast<int>(a) != std::bit_cast<int>(b); };
      for (int axis = 0; axis < 3; ++axis) {
        same(abreast.from_in[axis][i], alone.from_in[axis]), same(abreast.from_out[axis][i], alone.from_out[axis]);
        same(abreast.inverse[axis][i], alone.inverse[axis]), same(abreast.origin[axis][i], alone.origin[axis]);
      }
      same(abreast.shear[0][i], alone.shear[0]), same(abreast.shear[1][i], alone.shear[1]);
      same(abreast.grain[i], alone.grain), same(abreast.depth_per_t[i], alone.depth_per_t);
      const RayPacket packet(abreast, 1U << i);
      same(packet.forward, alone.forward);
      for (int axis = 0; axis < 3; ++axis)
        differing += packet.near[axis] != alone.near[axis] || packet.far[axis] != alone.far[axis] ||
                     packet.axes[axis] != alone.axes[axis];
    }
  }
  CHECK(differing == 0);
  CHECK(others == 0);
  CHECK(valid > rounds(3000));
}

TEMPLATE_TEST_CASE("the library's batches skip queries that mean nothing", "[accel]", float, double) {
  using T = TestType;
  using namespace raywalk::accel;
  const Mesh ball = icosphere(3);
  std::vector<T> positions;
  std::vector<std::uint32_t> indices;
  for (const Vec3d& at : ball.positions)
    for (int axis = 0; axis < 3; ++axis) positions.push_back(static_cast<T>(at[axis]));
  for (const Mesh::Corners& corners : ball.triangles)
    for (const std::int32_t corner : corners) indices.push_back(static_cast<std::uint32_t>(corner));
  const auto triangles = std::get<TriangleSet<T>>(TriangleSet<T>::build(positions, indices));
  std::vector<RayQuery<T>> rays;
  Numbers next(9);
  for (int i = 0; i < 1000; ++i) {
    RayQuery<T> ray{{T(0.1), T(0.2), -5}, {static_cast<T>(next.real(-0.1, 0.1)), static_cast<T>(0.001 * i), T(4)}};
    if (i % 17 == 3) ray.origin[1] = std::numeric_limits<T>::quiet_NaN();
    if (i % 19 == 4) ray.direction = {0, 0, 0};
    if (i % 23 == 5) ray.t_max = T(1.1);
    if (i > 900) ray.t_max = -1;
    rays.push_back(ray);
  }
  std::vector<std::optional<TriangleHit<T>>> hits(rays.size() + 1, TriangleHit<T>{});
  const auto met = std::make_unique<bool[]>(rays.size());
  triangles.closest(rays, hits);
  triangles.any(rays, {met.get(), rays.size()});
  CHECK(hits.back().has_value());  // beyond the rays: left as it was
  int found = 0, differing = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const auto alone = triangles.closest(rays[i]);
    found += alone.has_value();
    differing += hits[i].has_value() != alone.has_value() || met[i] != triangles.any(rays[i]);
    if (alone && hits[i])
      differing += hits[i]->t != alone->t || hits[i]->triangle != alone->triangle || hits[i]->u != alone->u ||
                   hits[i]->v != alone->v;
  }
  CHECK(differing == 0);
  CHECK(found > 100);
}
