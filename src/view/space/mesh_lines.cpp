#include "view/space/mesh_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>

namespace raywalk {

namespace {

constexpr std::size_t few_triangles = 1500;
constexpr double max_lines = 12000;

/// One edge of the mesh, as the pair of its vertices.
using MeshEdge = std::pair<std::int32_t, std::int32_t>;
struct EdgeSides {
  Vec3d normal{0.0};  ///< of the first triangle at the edge
  int triangles = 0;
  bool sharp = false;
};

Vec3d corner(const Mesh& mesh, std::int32_t i) { return mesh.positions[static_cast<std::size_t>(i)]; }

/// Every edge with its adjacent triangles, in order of first occurrence.
std::vector<std::pair<MeshEdge, EdgeSides>> edges_of(const Mesh& mesh) {
  constexpr double sharp_cosine = 0.77;  // 40 degrees
  std::vector<std::pair<MeshEdge, EdgeSides>> edges;
  std::unordered_map<std::uint64_t, std::size_t> found;
  found.reserve(2 * mesh.triangles.size());
  for (const Mesh::Corners& t : mesh.triangles) {
    const Vec3d across = cross(corner(mesh, t[1]) - corner(mesh, t[0]), corner(mesh, t[2]) - corner(mesh, t[0]));
    const double size = length(across);
    const Vec3d normal = size > 0 ? across / size : across;
    for (std::size_t k = 0; k < 3; ++k) {
      const MeshEdge edge = std::minmax(t[k], t[(k + 1) % 3]);
      const auto key = static_cast<std::uint64_t>(edge.first) << 32 | static_cast<std::uint32_t>(edge.second);
      const auto [entry, is_new] = found.emplace(key, edges.size());
      if (is_new) edges.push_back({edge, {normal, 0, false}});
      EdgeSides& sides = edges[entry->second].second;
      ++sides.triangles;
      sides.sharp = sides.sharp || dot(sides.normal, normal) < sharp_cosine;
    }
  }
  return edges;
}

/// Adds the section by the plane at `at` along `axis`.
void add_section(const Mesh& mesh, int axis, double at, std::vector<Polyline>& lines) {
  for (const Mesh::Corners& t : mesh.triangles) {
    Polyline cut;
    for (std::size_t k = 0; k < 3 && cut.size() < 2; ++k) {
      const Vec3d a = corner(mesh, t[k]), b = corner(mesh, t[(k + 1) % 3]);
      const double from = a[axis] - at, to = b[axis] - at;
      if ((from < 0) != (to < 0)) cut.push_back(a + from / (from - to) * (b - a));
    }
    if (cut.size() == 2) lines.push_back(std::move(cut));
  }
}

std::vector<Polyline> lines_of(const Mesh& mesh) {
  std::vector<Polyline> lines;
  const bool all = mesh.triangles.size() <= few_triangles;
  for (const auto& [edge, sides] : edges_of(mesh))
    if ((all || sides.sharp || sides.triangles == 1) && static_cast<double>(lines.size()) < max_lines)
      lines.push_back({corner(mesh, edge.first), corner(mesh, edge.second)});
  if (all) return lines;
  Bounds<double> box;
  for (const Vec3d& position : mesh.positions) box.include(position);
  // A plane cuts about two rows of triangles.
  const double of_one = 2 * std::sqrt(static_cast<double>(mesh.triangles.size()));
  const int planes = std::clamp(static_cast<int>(max_lines / (3 * of_one)), 1, 12);
  for (int axis = 0; axis < 3; ++axis)
    for (int i = 0; i < planes; ++i)
      add_section(mesh, axis, box.min[axis] + (i + 0.5) / planes * (box.max[axis] - box.min[axis]), lines);
  return lines;
}

}  // namespace

std::shared_ptr<const std::vector<Polyline>> mesh_lines(const std::shared_ptr<const Mesh>& mesh) {
  struct CachedLines {
    std::weak_ptr<const Mesh> mesh;
    std::shared_ptr<const std::vector<Polyline>> lines;
  };
  static std::map<const Mesh*, CachedLines> kept;
  std::erase_if(kept, [](const auto& entry) { return entry.second.mesh.expired(); });
  CachedLines& own = kept[mesh.get()];
  if (!own.lines) own = {mesh, std::make_shared<const std::vector<Polyline>>(lines_of(*mesh))};
  return own.lines;
}

}  // namespace raywalk
