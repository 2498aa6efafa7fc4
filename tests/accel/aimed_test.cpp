// Random rays find nothing: these are aimed at corners, edges and silhouettes, from near and far, where rounding
// decides between hit and miss. An accelerator must not skip what brute force calls a hit.

#include "answers.h"
#include "shape/numbers.h"
#include "support/catch.h"
#include "support/effort.h"

using namespace raywalk;
using namespace raywalk::test;

namespace {

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
    INFO(name_of(kind));
    const Accelerator<T> structure(Primitives<T>(all), kind);
    TestCounts counts;
    int differing = 0, hits = 0;
    for (const Ray<T>& ray : rays) {
      const auto expected = list.closest(ray, infinity<T>, counts), got = structure.closest(ray, infinity<T>, counts);
      hits += expected.has_value();
      const bool same =
          expected.has_value() == got.has_value() &&
          (!got || (got->t == expected->t && got->primitive == expected->primitive && got->part == expected->part));
      differing += !same || structure.occluded(ray, infinity<T>, counts) != expected.has_value();
    }
    CHECK(differing == 0);
    CHECK(hits > rounds(2000));
  }
}

TEMPLATE_TEST_CASE("accelerators miss nothing of polygons that are not quite flat, or whose holes reach out", "[accel]",
                   float, double) {
  using T = TestType;
  Numbers next(11);
  TestCounts counts;
  int hits = 0, outside = 0;
  for (int round = 0; round < rounds(60); ++round) {
    // The first corner and the area's normal make the plane that rays meet; the others lie off it, as files may have
    // them, and much farther where a map stretches what is off.
    const double off = round % 2 ? 1e-6 : 0;
    const auto corner = [&](double x, double y) { return Vec3<T>(Vec3d(x, y, off * next.real(-1, 1))); };
    Polygon<T> polygon{{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)}, {}};
    if (round % 3 == 0)  // by the even-odd rule what reaches out is filled
      polygon.holes = {{corner(0.8, 0.2), corner(2, 0.2), corner(2, 0.6), corner(0.8, 0.6)}};
    const Affine<double> turn = rotation<double>(next.unit<double>(), next.real(0, 360));
    Primitives<T> all;
    const double stretch = round % 4 < 2 ? 1 : 3e5;
    all.add(polygon, *object_transform<T>(turn * scaling<double>({1, 1, stretch})));
    all.add(Sphere<T>{{0, -9, 0}, 1});
    const Accelerator<T> list(all, AcceleratorKind::none);
    std::vector<Accelerator<T>> others;
    for (const AcceleratorKind kind : structures) others.emplace_back(all, kind);
    for (int i = 0; i < 200; ++i) {
      // Nearly in the plane, from beside it.
      const Vec3d target(next.real(0, polygon.holes.empty() ? 1 : 2), next.real(0, 1), 0);
      Vec3d way(next.real(-1, 1), next.real(-1, 1), stretch * off * next.real(-2, 2));
      if (i % 4 == 0) way.z = 1;
      const Ray<T> ray{Vec3<T>(turn.point(target - 3.0 * way)), Vec3<T>(turn.direction(way))};
      const auto expected = list.closest(ray, infinity<T>, counts);
      hits += expected.has_value();
      outside += expected && i % 4 == 0 && target.x > 1;
      for (std::size_t k = 0; k < others.size(); ++k) {
        const auto found = others[k].closest(ray, infinity<T>, counts);
        const bool same = found.has_value() == expected.has_value() && (!found || found->t == expected->t);
        if (!same) FAIL(name_of(structures[k]) << " in round " << round);
      }
    }
  }
  CHECK(hits > 20 * rounds(60));
  CHECK(outside > rounds(60) / 2);
}
