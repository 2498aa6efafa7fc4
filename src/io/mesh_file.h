#pragma once
// Meshes from files: Wavefront OBJ with its MTL, PLY (text, binary of both endiannesses) and glTF 2.0 (.gltf, .glb).

#include "io/error.h"
#include "scene/object_shape.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A mesh with the materials that its triangles name; these are null when the file has none.
struct MeshFile {
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const std::vector<Material>> materials;
  std::vector<std::string> warnings{};  ///< one line each, "FILE:LINE: ..."
};

/// Reads a mesh by the ending of its name. A file that is cut short, or that names vertices which it does not have, or
/// numbers that are not finite, is refused; nothing is allocated for a count that the file cannot hold.
[[nodiscard]] Result<MeshFile> read_mesh(const std::string& path);

/// From the bytes of a file; `path` is for messages, and says where the files lie that it names.
[[nodiscard]] Result<MeshFile> parse_obj(std::string bytes, const std::string& path);
[[nodiscard]] Result<MeshFile> parse_ply(std::string bytes, const std::string& path);
[[nodiscard]] Result<MeshFile> parse_gltf(std::string bytes, const std::string& path);  ///< .gltf or .glb

/// The materials of an MTL file, in its order, with their names.
struct NamedMaterial {
  std::string name;
  Material material;
};
[[nodiscard]] Result<std::vector<NamedMaterial>> parse_mtl(std::string bytes, const std::string& path);

namespace detail {

/// Objects and triangles of a whole scene: what a machine of 16 GiB still holds.
inline constexpr double most_entries = 3.2e7;
inline constexpr std::size_t most_mesh_bytes = std::size_t{1} << 31;

/// Where `name`, found in the file `from`, lies: relative to it unless absolute.
[[nodiscard]] std::string path_beside(const std::string& from, const std::string& name);
/// The same for all names of one file: through links, "." and "..", so that it is read once however it is spelt.
[[nodiscard]] std::string one_name(const std::string& path);
/// Whether `name` stays in the folder of the file that names it, or in one below. Meshes come from strangers, who need
/// not learn what other files hold.
[[nodiscard]] bool stays_beside(std::string_view name);

/// What is wrong with a mesh's numbers, "" when nothing: the last check of every reader.
[[nodiscard]] std::string why_no_mesh(const Mesh& mesh);
/// Why nothing of a sound mesh can be seen, "" when something can.
[[nodiscard]] std::string why_unseen(const Mesh& mesh);
/// What a reader has made of the file `path`, with a warning where nothing of it can be seen.
[[nodiscard]] MeshFile finished_mesh(Mesh mesh, const std::string& path);

}  // namespace detail

}  // namespace raywalk
