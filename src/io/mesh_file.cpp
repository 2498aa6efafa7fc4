#include "io/mesh_file.h"

#include "text/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace raywalk {

namespace detail {

std::string path_beside(const std::string& from, const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(from).parent_path();
  return (folder / name).string();  // an absolute name is kept
}

std::string one_name(const std::string& path) {
  std::error_code error;
  const std::filesystem::path canonical = std::filesystem::weakly_canonical(path, error);
  return error ? path : canonical.string();
}

bool stays_beside(std::string_view name) {
  if (name.empty() || name.front() == '/' || name.front() == '\\') return false;
  if (name.find(':') != std::string_view::npos || name.find('\0') != std::string_view::npos) return false;
  for (;;) {
    const std::size_t end = std::min(name.find_first_of("/\\"), name.size());
    if (name.substr(0, end) == "..") return false;
    if (end == name.size()) return true;
    name.remove_prefix(end + 1);
  }
}

std::string why_no_mesh(const Mesh& mesh) {
  constexpr double most = 1e15;  // as everywhere in a scene
  const auto sound = [](double x) { return std::abs(x) <= most; };
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3d& p = mesh.positions[i];
    if (!sound(p.x) || !sound(p.y) || !sound(p.z))
      return fmt::format("vertex {} is at ({:g}, {:g}, {:g}) (expected finite numbers, at most {:g})", i, p.x, p.y, p.z,
                         most);
  }
  for (const std::size_t given : {mesh.normals.size(), mesh.uv.size()})
    if (given != 0 && given != mesh.positions.size())
      return fmt::format("{} of {} vertices have a normal or texture coordinates (expected all of them or none)", given,
                         mesh.positions.size());
  for (std::size_t i = 0; i < mesh.normals.size(); ++i)
    if (const Vec3d& n = mesh.normals[i]; !sound(n.x) || !sound(n.y) || !sound(n.z))
      return fmt::format("the normal of vertex {} is not finite", i);
  for (std::size_t i = 0; i < mesh.uv.size(); ++i)
    if (!sound(mesh.uv[i].x) || !sound(mesh.uv[i].y))
      return fmt::format("the texture coordinates of vertex {} are not finite", i);
  const auto vertices = static_cast<std::int64_t>(mesh.positions.size());
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const std::int32_t corner : mesh.triangles[i])
      if (corner < 0 || corner >= vertices)
        return fmt::format("triangle {} names vertex {} (expected 0 to {})", i, corner, vertices - 1);
  if (mesh.triangles.empty()) return "there is no triangle in it (expected at least one)";
  return "";
}

std::string why_unseen(const Mesh& mesh) {
  const auto has_area = [&](const Mesh::Corners& corners) {
    const auto at = [&](std::size_t i) { return mesh.positions[static_cast<std::size_t>(corners[i])]; };
    return cross(at(1) - at(0), at(2) - at(0)) != Vec3d(0.0);
  };
  if (std::any_of(mesh.triangles.begin(), mesh.triangles.end(), has_area)) return "";
  const std::size_t count = mesh.triangles.size();
  return count == 1 ? "its only triangle has no area: no ray meets it"
                    : fmt::format("none of its {} triangles has an area: no ray meets them", count);
}

std::string warning_of_textures(const std::string& place, std::string_view which, std::string_view material,
                                std::string_view texture, std::size_t others) {
  const std::string more = others == 0 ? "" : fmt::format(", and {} other material{}", others, others == 1 ? "" : "s");
  return fmt::format(
      "{}: warning: {} are not read: the material \"{}\" has {}{}; such surfaces show the "
      "material's own colour",
      place, which, material.substr(0, 60), texture.substr(0, 100), more);
}

std::string warning_of_colours(const std::string& path) {
  return path + ": warning: colours of vertices are not read; the surface shows its material's own colour";
}

MeshFile finished_mesh(Mesh mesh, const std::string& path) {
  MeshFile file{std::make_shared<const Mesh>(std::move(mesh)), nullptr};
  if (const std::string why = why_unseen(*file.mesh); !why.empty()) file.warnings = {path + ": warning: " + why};
  return file;
}

}  // namespace detail

Result<MeshFile> read_mesh(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  const bool is_gltf = ending == ".gltf" || ending == ".glb";
  if (!is_gltf && ending != ".obj" && ending != ".ply")
    return tl::unexpected(Error{path, 0, 0,
                                "no mesh can be read from a file of this ending (expected .obj, .ply, .gltf or .glb)",
                                "convert it with a modelling program"});
  auto bytes = read_file(path, detail::max_mesh_bytes);
  if (!bytes) return tl::unexpected(bytes.error());
  if (is_gltf) return parse_gltf(std::move(*bytes), path);
  return ending == ".obj" ? parse_obj(std::move(*bytes), path) : parse_ply(std::move(*bytes), path);
}

}  // namespace raywalk
