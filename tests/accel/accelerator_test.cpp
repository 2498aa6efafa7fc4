// Every accelerator answers what testing every primitive answers: the same primitive, part and t, bit for bit.

#include "answers.h"
#include "support/catch.h"
#include "support/effort.h"

#include <random>

using namespace raywalk;
using namespace raywalk::test;

namespace {

template <class T>
struct ShapeNumbers {
  std::mt19937 engine{7};
  T operator()(T low = -1, T high = 1) {
    return low + (high - low) * static_cast<T>(engine() >> 8) / static_cast<T>(1 << 24);
  }
  Vec3<T> point(T size = 1) {
    const T x = (*this)(-size, size);
    const T y = (*this)(-size, size);
    const T z = (*this)(-size, size);
    return {x, y, z};
  }
};

/// Spheres of mixed size with doubles among them (exact ties), and prisms and unbounded planes when `mixed`.
template <class T>
std::vector<Shape<T>> shapes(int count, bool mixed, ShapeNumbers<T>& random) {
  std::vector<Shape<T>> all;
  for (int i = 0; i < count; ++i) {
    const Vec3<T> at = random.point();
    if (mixed && i % 50 == 3) {
      all.push_back(Prism<T>{{plan(at), plan(at) + Vec2<T>(3, 0), plan(at) + Vec2<T>(1, 4)}, T(0.5)});
    } else if (mixed && i % 97 == 5) {
      all.push_back(Plane<T>{T(9) * at, {at.y, at.x, 1}});
    } else {
      const T radius = T(0.3) * std::pow(static_cast<T>(count), T(-1) / 3);
      all.push_back(Sphere<T>{at, i % 10 == 0 ? 5 * radius : radius});
      if (i % 20 == 1) all.push_back(all.back());
    }
  }
  return all;
}

/// Every seventh one stretched, turned and mirrored.
template <class T>
Primitives<T> primitives(const std::vector<Shape<T>>& shapes) {
  const Affine<double> map =
      translation<double>({0.25, 0, 0}) * rotation<double>({1, 2, 3}, 50) * scaling<double>({-1.5, 0.75, 1});
  Primitives<T> all;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    if (i % 7 == 6)
      all.add(shapes[i], *object_transform<T>(map));
    else
      all.add(shapes[i]);
  return all;
}

/// Rays in general, rays along the axes (signed zeros), and rays that run in the faces of boxes.
template <class T>
std::vector<Ray<T>> rays(int count, const std::vector<Shape<T>>& targets, ShapeNumbers<T>& random) {
  std::vector<Ray<T>> all;
  for (int i = 0; i < count; ++i) {
    Ray<T> ray{random.point(2), random.point()};
    if (i % 5 == 0) ray.direction[i / 5 % 3] = 0;
    if (i % 25 == 0) ray.direction[(i / 25 + 1) % 3] = T(-0.0);
    const Bounds<T> box = bounds(targets[static_cast<std::size_t>(i) % targets.size()]);
    if (i % 7 == 0 && box.bounded()) {
      ray.origin = i % 2 ? box.min : box.max;
      ray.origin[i % 3] -= 2;
      ray.direction = Vec3<T>(0);
      ray.direction[i % 3] = 1;
    }
    if (ray.direction == Vec3<T>(0)) ray.direction.x = 1;
    all.push_back(ray);
  }
  return all;
}

template <class T>
void compare(int count, bool mixed) {
  ShapeNumbers<T> random;
  const std::vector<Shape<T>> all = shapes<T>(count, mixed, random);
  const std::vector<Ray<T>> probes = rays<T>(rounds(4000), all, random);
  const Accelerator<T> list(primitives(all), AcceleratorKind::none);
  std::vector<ShadowRole> roles(all.size(), ShadowRole::stops);
  for (std::size_t i = 0; i < roles.size(); i += 3) roles[i] = i % 2 ? ShadowRole::filters : ShadowRole::ignored;
  std::vector<int> filters, expected_filters;
  for (const AcceleratorKind kind : structures) {
    const Accelerator<T> structure(primitives(all), kind);
    REQUIRE(structure.kind() == kind);
    int differing = 0, hits = 0;
    TestCounts brute, counts, remembering;
    int last = -1, last_stop = -1;
    for (const Ray<T>& ray : probes) {
      const auto expected = list.closest(ray, infinity<T>, brute);
      hits += expected.has_value();
      if (!same(expected, structure.closest(ray, infinity<T>, counts))) ++differing;
      // A reach that ends exactly at the hit must not report it; one just beyond must.
      if (expected) {
        const T beyond = std::nextafter(expected->t, infinity<T>);
        if (structure.occluded(ray, expected->t, counts) != list.occluded(ray, expected->t, brute)) ++differing;
        if (!structure.occluded(ray, beyond, counts)) ++differing;
      }
      // What was found last is tried first; the answer is the same.
      if (structure.occluded(ray, infinity<T>, remembering, {&last}) != expected.has_value()) ++differing;
      if ((last >= 0) != expected.has_value()) ++differing;
      const StopsShadows stops{roles};
      const auto stopping = list.closest(ray, infinity<T>, brute, stops);
      if (!same(stopping, structure.closest(ray, infinity<T>, counts, stops))) ++differing;
      const bool stopped = list.occluded_or_filtered(ray, infinity<T>, brute, roles, expected_filters);
      if (stopped != stopping.has_value() ||
          structure.occluded_or_filtered(ray, infinity<T>, counts, roles, filters, {&last_stop}) != stopped)
        ++differing;
      if (!stopped && filters != expected_filters) ++differing;
    }
    INFO(name_of(kind) << ", " << count << " primitives");
    CHECK(differing == 0);
    CHECK(hits > rounds(400));
    if (count >= 1000 && !mixed) CHECK(counts.primitives * 10 < brute.primitives);
  }
}

}  // namespace

TEMPLATE_TEST_CASE("accelerators answer as brute force does", "[accel]", float, double) {
  for (const int count : {1, 5, 100, 1500}) {
    compare<TestType>(count, false);
    compare<TestType>(count, true);
  }
}

TEMPLATE_TEST_CASE("the hierarchy, whose boxes are in float, misses nothing at any scale", "[accel]", float, double) {
  using T = TestType;
  int hits = 0;
  for (int exponent = -140; exponent <= 120; exponent += 5) {
    ShapeNumbers<T> random;
    const T scale = std::ldexp(T(1), exponent);
    Primitives<T> all;
    for (int i = 0; i < 100; ++i) all.add(Sphere<T>{scale * random.point(), scale * random(T(0.01), T(0.2))});
    const Accelerator<T> list(all, AcceleratorKind::none), hierarchy(all, AcceleratorKind::bvh);
    TestCounts counts;
    for (int i = 0; i < rounds(400); ++i) {
      Ray<T> ray{scale * random.point(2), std::ldexp(T(1), 20 * (i % 5 - 2)) * random.point()};
      if (i % 3 == 0) ray.origin[i / 3 % 3] = 0;
      const auto expected = list.closest(ray, infinity<T>, counts);
      hits += expected.has_value();
      if (!same(expected, hierarchy.closest(ray, infinity<T>, counts)))
        FAIL("at 2^" << exponent << ", slope 2^" << 20 * (i % 5 - 2));
    }
  }
  CHECK(hits > rounds(400));
}

TEMPLATE_TEST_CASE("accelerators follow slopes whose inverse overflows", "[accel]", float, double) {
  using T = TestType;
  // Edges within a few hundred of the least number of the floor along which the rays creep upwards.
  const T least = std::numeric_limits<T>::denorm_min();
  ShapeNumbers<T> random;
  Primitives<T> all;
  for (int i = 0; i < 60; ++i) {
    const T x = T(10) + static_cast<T>(i), low = least * static_cast<T>(10 * i + 5);
    all.add(Triangle<T>{{x, low, -1}, {x, low, 1}, {x, 1, random()}});
  }
  const Accelerator<T> list(all, AcceleratorKind::none);
  for (const AcceleratorKind kind : structures) {
    const Accelerator<T> structure(all, kind);
    TestCounts counts;
    int hits = 0, differing = 0;
    for (int i = 0; i < 200; ++i) {
      const T turned = i % 2 ? T(1) : T(-1);
      const Ray<T> ray{
          {i % 4 < 2 ? T(0) : T(80), 0, random(T(-0.01), T(0.01))},
          {i % 4 < 2 ? T(1) : T(-1), turned * least * static_cast<T>(i % 23), least * static_cast<T>(i % 5)}};
      const auto expected = list.closest(ray, infinity<T>, counts);
      hits += expected.has_value();
      if (!same(expected, structure.closest(ray, infinity<T>, counts))) ++differing;
    }
    INFO(name_of(kind));
    CHECK(differing == 0);
    CHECK(hits > 50);
  }
}

TEMPLATE_TEST_CASE("accelerators hold nothing, one thing, and a thousand in one place", "[accel]", float, double) {
  using T = TestType;
  TestCounts counts;
  for (const AcceleratorKind kind : structures) {
    INFO(name_of(kind));
    const Accelerator<T> empty(Primitives<T>(), kind);
    CHECK_FALSE(empty.closest({Vec3<T>(0), {1, 0, 0}}, infinity<T>, counts));
    const Accelerator<T> plane(Primitives<T>({Plane<T>{}}), kind);
    CHECK(plane.closest({{0, 0, 2}, {0, 0, -1}}, infinity<T>, counts)->t == 2);
    const Accelerator<T> heap(Primitives<T>(std::vector<Shape<T>>(1000, Sphere<T>{})), kind);
    const auto hit = heap.closest({{-3, 0, 0}, {1, 0, 0}}, infinity<T>, counts);
    REQUIRE(hit);
    CHECK(hit->primitive == 0);
    CHECK(hit->t == 2);
  }
}

TEST_CASE("the automatic choice builds a structure only where one pays", "[accel]") {
  CHECK(Accelerator<double>(Primitives<double>(std::vector<Shape<double>>(3, Sphere<double>{}))).kind() ==
        AcceleratorKind::none);
  CHECK(Accelerator<double>(Primitives<double>({Box<double>{Vec3d(0.0), Vec3d(1.0)}})).kind() == AcceleratorKind::bvh);
  CHECK(Accelerator<double>(Primitives<double>(std::vector<Shape<double>>(50, Sphere<double>{}))).kind() ==
        AcceleratorKind::bvh);
}

TEST_CASE("what lies in one place fills no structure without end", "[accel]") {
  // Each of these reaches into all cells of a grid that many would call for, and into half of all octants.
  const auto build = [](AcceleratorKind kind, int count, const Vec3d& size) {
    Primitives<double> primitives;
    for (int i = 0; i < count; ++i) primitives.add(Box<double>{-size, size * (1 + 1e-9 * i)});
    return Accelerator<double>(primitives, kind).statistics();
  };
  CHECK(build(AcceleratorKind::grid, 33'000, {1, 1, 1}).references < std::size_t{1} << 26);
  CHECK(build(AcceleratorKind::octree, 7, {1, 1, 0}).references <= 700);
}
