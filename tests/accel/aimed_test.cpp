// Random rays find nothing: these are aimed at corners, edges and silhouettes, from near and far, where rounding
// decides between hit and miss. An accelerator must not skip what brute force calls a hit.

#include "accel/accelerator.h"
#include "shape/numbers.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

constexpr AcceleratorKind structures[] = {
    AcceleratorKind::spheres, AcceleratorKind::ellipsoids, AcceleratorKind::boxes, AcceleratorKind::bvh,
    AcceleratorKind::grid,    AcceleratorKind::octree,     AcceleratorKind::kdtree};

template <class T>
std::vector<Shape<T>> shapes(Numbers& next, double shift) {
  std::vector<Shape<T>> all;
  for (int i = 0; i < 40; ++i) {
    const Vec3d at = next.in_box<double>(5) + Vec3d(shift, -shift, 0);
    const Vec2<T> corner(plan(Vec3<T>(at)));
    const T size = static_cast<T>(next.real(0.2, 1));
    if (i % 4 == 0) {
      all.push_back(
          Prism<T>{{corner, corner + Vec2<T>(size, 0), corner + Vec2<T>(size, size), corner + Vec2<T>(0, size)}, size});
    } else if (i % 4 == 1) {
      all.push_back(
          Prism<T>{{corner, corner + Vec2<T>(size, size / 3), corner + Vec2<T>(size / 2, 2 * size)}, 2 * size});
    } else {
      all.push_back(Sphere<T>{Vec3<T>(at), size});
    }
  }
  return all;
}

// A point of a shape at which hit and miss meet, as seen from `eye`.
template <class T>
Vec3<T> edge_point(const Shape<T>& shape, const Vec3<T>& eye, Numbers& next) {
  if (const auto* sphere = std::get_if<Sphere<T>>(&shape)) {
    const Vec3<T> view = normalize(sphere->centre - eye);
    return sphere->centre + sphere->radius * normalize(cross(view, next.unit<T>()));
  }
  const auto& prism = std::get<Prism<T>>(shape);
  const int side = next.integer(0, prism.sides() - 1);
  const T half = prism.height / 2, along = static_cast<T>(next.real(0, 1));
  switch (next.integer(0, 2)) {
    case 0:
      return {prism.corner(side), next.integer(0, 1) == 0 ? half : -half};
    case 1:
      return {prism.corner(side), (2 * along - 1) * half};
    default:
      return {prism.corner(side) + along * prism.edge(side), next.integer(0, 1) == 0 ? half : -half};
  }
}

}  // namespace

TEMPLATE_TEST_CASE("accelerators miss nothing that aimed rays hit", "[accel]", float, double) {
  using T = TestType;
  const double shift = GENERATE(0.0, 1000.0);
  const double distance = GENERATE(1.0, 100.0, 1e5);
  CAPTURE(shift, distance);
  Numbers next(9);
  const std::vector<Shape<T>> all = shapes<T>(next, shift);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < rounds(6000); ++i) {
    Vec3<T> eye = Vec3<T>(Vec3d(shift, -shift, 0)) + static_cast<T>(6 * distance) * next.unit<T>();
    if (i % 6 == 0) eye.z = 0;
    const Vec3<T> target = edge_point(all[static_cast<std::size_t>(i) % all.size()], eye, next);
    if (i % 7 == 0) eye.x = target.x;
    const Vec3<T> direction = target - eye;
    if (direction != Vec3<T>(0)) rays.push_back({eye, i % 2 ? direction : normalize(direction)});
  }
  const Accelerator<T> list(Primitives<T>(all), AcceleratorKind::none);
  for (const AcceleratorKind kind : structures) {
    INFO(accelerator_name(kind));
    const Accelerator<T> structure(Primitives<T>(all), kind);
    TestCounts counts;
    int differing = 0, hits = 0;
    for (const Ray<T>& ray : rays) {
      const auto expected = list.closest(ray, infinity<T>, counts), got = structure.closest(ray, infinity<T>, counts);
      hits += expected.has_value();
      const bool same =
          expected.has_value() == got.has_value() &&
          (!got || (got->t == expected->t && got->primitive == expected->primitive && got->part == expected->part));
      differing += !same || structure.any(ray, infinity<T>, counts) != expected.has_value();
    }
    CHECK(differing == 0);
    CHECK(hits > rounds(2000));
  }
}
