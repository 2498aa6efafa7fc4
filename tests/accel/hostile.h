// Meshes and rays that rounding finds hard.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "accel/width.h"
#include "answers.h"
#include "meshes.h"
#include "shape/numbers.h"

namespace raywalk::test {

// Triangles a thousand times as long as wide, side by side, that share their corners.
inline Mesh slivers() {
  Mesh mesh;
  for (int i = 0; i <= 40; ++i) {
    mesh.positions.push_back({-1, 0.001 * i, 0.01 * std::sin(i)});
    mesh.positions.push_back({1, 0.001 * i + 0.0005, 0.02 * std::cos(i)});
  }
  for (std::int32_t i = 0; i < 80; ++i) mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

// Half of them aimed at corners and edges of triangles; some along axes, with zeros of both signs, in planes of boxes,
// from within surfaces, or with slopes and lengths near the ends of float's range.
template <class T>
std::vector<Ray<T>> hostile(const Primitives<T>& all, double scale, const Vec3d& middle, int count) {
  Numbers next(23);
  std::vector<Ray<T>> rays;
  for (int i = 0; i < count; ++i) {
    const int id = next.integer(all.shape_count(), all.size() - 1);
    const Triangle<T> triangle = all.triangles()[id - all.shape_count()];
    const T along = i % 2 ? T(0) : static_cast<T>(next.real(0, 1));
    const Vec3<T> target =
        i % 5 < 3 ? triangle.a + along * (triangle.b - triangle.a) : Vec3<T>(middle + scale * next.in_box<double>(1.5));
    Vec3<T> eye(middle + scale * std::pow(10.0, next.integer(0, 3)) * next.unit<double>());
    if (i % 7 == 0) eye[i % 3] = target[i % 3];
    if (i % 21 == 0) eye[(i + 1) % 3] = target[(i + 1) % 3];
    if (i % 11 == 0) eye = triangle.a;
    Ray<T> ray{eye, target - eye};
    if (i % 13 == 0) ray.direction[i % 3] = i % 2 ? T(0) : T(-0.0);
    if (i % 17 == 0) ray.direction[i % 3] = std::numeric_limits<T>::denorm_min() * static_cast<T>(i % 5);
    if (i % 19 == 0) ray.direction *= static_cast<T>(std::ldexp(1.0, next.integer(-70, 70)));
    if (i % 29 == 0) ray.departure = {id, 0};
    ray.time = static_cast<T>(next.real(0, 1));
    if (ray.direction == Vec3<T>(0)) ray.direction.x = 1;
    rays.push_back(ray);
  }
  return rays;
}

struct Comparison {
  int differing = 0;         // answers and, between widths, counts
  int exact = 0;             // queries of some ray that exact arithmetic decided
  std::vector<int> hit_ids;  // of the rays that hit something
};

// `tree`, at every width that the machine has, against `list`, which tests every primitive. `roles` are those for
// `list`, `tree_roles` the same for `tree`, which may leave out what stops shadow rays at their end.
template <class T>
Comparison compare(const Accelerator<T>& list, const Accelerator<T>& tree, const std::vector<Ray<T>>& rays,
                   const std::vector<ShadowRole>& roles, const std::vector<ShadowRole>& tree_roles) {
  Comparison all;
  TestCounts brute;
  std::vector<int> filters, expected_filters;
  for (const Ray<T>& ray : rays) {
    const auto expected = list.closest(ray, infinity<T>, brute);
    const bool stopped = list.occluded_or_filtered(ray, infinity<T>, brute, roles, expected_filters);
    if (expected) all.hit_ids.push_back(expected->primitive);
    std::optional<TestCounts> first;
    for (const LaneWidth width : lane_widths()) {
      const ForcedWidth forced(width);
      TestCounts counts;
      all.differing += !same(expected, tree.closest(ray, infinity<T>, counts));
      all.differing += tree.occluded(ray, infinity<T>, counts) != expected.has_value();
      // Whatever is likely, and tested first: what is hit, or something else.
      for (const int likely : {expected ? expected->primitive : 0, tree.primitives().size() - 1}) {
        TestCounts apart;
        all.differing += !same(expected, tree.closest_likely(ray, likely, apart));
      }
      // A reach that ends exactly at the hit must not report it; one just beyond must.
      if (expected) {
        all.differing += tree.occluded(ray, expected->t, counts) != list.occluded(ray, expected->t, brute);
        all.differing += !tree.occluded(ray, std::nextafter(expected->t, infinity<T>), counts);
      }
      all.differing += tree.occluded_or_filtered(ray, infinity<T>, counts, tree_roles, filters) != stopped;
      all.differing += !stopped && filters != expected_filters;
      all.exact += counts.exactly_decided > 0;
      if (!first) first = counts;
      all.differing += counts.nodes != first->nodes || counts.primitives != first->primitives ||
                       counts.exactly_decided != first->exactly_decided;
    }
  }
  return all;
}

// A ball, slivers twice, triangles without an area, and a ball that may move.
template <class T>
void add_hostile_meshes(Primitives<T>& all, const Affine<double>& place, double scale, bool moving) {
  all.add(icosphere(2, Vec3d(0.0), 0.7), place, false);
  all.add(slivers(), place * translation(Vec3d(0, -0.9, 0)), false);
  all.add(slivers(), place * translation(Vec3d(0, -0.9, 0)), false);
  Mesh flat;
  flat.positions = {{1, 1, 1}, {1.1, 1, 1}, {1.2, 1, 1}, {1, 1.2, 1}};
  flat.triangles = {{0, 1, 2}, {0, 0, 1}, {0, 2, 3}};
  all.add(flat, place, false);
  const int first = all.size();
  all.add(icosphere(0, {0, 1, 0}, 0.3), place, false);
  if (moving) all.move(first, all.size(), {{0, Vec3d(0.0)}, {1, scale * Vec3d(0.5, 0, 0.2)}});
}

}  // namespace raywalk::test
