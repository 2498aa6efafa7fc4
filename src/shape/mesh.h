#pragma once

#include "math/bounds.h"

#include <array>
#include <cstdint>
#include <vector>

namespace raywalk {

/// Triangles that share corners, counter-clockwise seen from outside. Lists of data that is not given are empty.
struct Mesh {
  using Corners = std::array<std::int32_t, 3>;  ///< indices of vertices

  std::vector<Vec3d> positions;  ///< by vertex
  std::vector<Vec3d> normals;    ///< by vertex: of any length, outward; 0 where the surface is flat
  std::vector<Vec2d> uv;         ///< by vertex
  std::vector<Corners> triangles;
  std::vector<std::int32_t> materials;  ///< by triangle: index of a material of the mesh's own, -1 for none
  friend bool operator==(const Mesh&, const Mesh&) = default;
};

[[nodiscard]] Bounds<double> bounds(const Mesh& mesh);

/// A normal at each vertex: the sum of the normals of the triangles around its position, each weighted by its angle
/// there (G. Thuermer and C. Wuethrich, "Computing vertex normals from polygonal facets", 1998). Vertices at the same
/// position share it, so that texture seams do not show.
[[nodiscard]] std::vector<Vec3d> vertex_normals(const Mesh& mesh);

/// From how many triangles on, of all copies together, copies of meshes share theirs. Those are searched more slowly
/// than if all were stored, which takes more memory and time to build.
inline constexpr double shared_copies = 1 << 18;

}  // namespace raywalk
