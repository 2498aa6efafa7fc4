#include "shape/mesh.h"

#include "math/elementary.h"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace raywalk {

namespace {

double angle_between(const Vec3d& a, const Vec3d& b) { return portable::atan2(length(cross(a, b)), dot(a, b)); }

}  // namespace

Bounds<double> bounds(const Mesh& mesh) {
  Bounds<double> box;
  for (const Mesh::Corners& corners : mesh.triangles)
    for (const std::int32_t corner : corners) box.include(mesh.positions[static_cast<std::size_t>(corner)]);
  return box;
}

std::vector<Vec3d> vertex_normals(const Mesh& mesh) {
  const auto place = [&](std::int32_t vertex) -> const Vec3d& {
    return mesh.positions[static_cast<std::size_t>(vertex)];
  };
  // The first vertex at each position represents all of them.
  std::vector<std::int32_t> order(mesh.positions.size()), first(mesh.positions.size());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](std::int32_t v) { return std::tuple(place(v).x, place(v).y, place(v).z); };
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return key(a) != key(b) ? key(a) < key(b) : a < b; });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool same = i > 0 && key(order[i]) == key(order[i - 1]);
    first[static_cast<std::size_t>(order[i])] = same ? first[static_cast<std::size_t>(order[i - 1])] : order[i];
  }
  std::vector<Vec3d> sums(mesh.positions.size(), Vec3d(0.0));
  for (const Mesh::Corners& corners : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3d& at = place(corners[i]);
      const Vec3d next = place(corners[(i + 1) % 3]) - at, previous = place(corners[(i + 2) % 3]) - at;
      const Vec3d normal = cross(next, previous);
      const double size = length(normal);
      if (!(size > 0)) continue;
      const auto vertex = static_cast<std::size_t>(corners[i]);
      sums[static_cast<std::size_t>(first[vertex])] += angle_between(next, previous) / size * normal;
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = sums[static_cast<std::size_t>(first[v])];
  return sums;
}

}  // namespace raywalk
