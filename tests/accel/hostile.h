// Meshes and rays that rounding finds hard, and how answers are compared.
#pragma once

#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include "accel/query.h"
#include "shape/numbers.h"

namespace raywalk::test {

template <class T>
bool same(const std::optional<Hit<T>>& a, const std::optional<Hit<T>>& b) {
  if (!a || !b) return a.has_value() == b.has_value();
  return a->t == b->t && a->primitive == b->primitive && a->part == b->part;
}

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

}  // namespace raywalk::test
