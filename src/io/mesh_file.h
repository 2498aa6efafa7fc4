#pragma once
// Meshes from files: Wavefront OBJ with its MTL, PLY (text, binary of both endiannesses) and glTF 2.0 (.gltf, .glb).

#include "scene/object_shape.h"
#include "text/error.h"

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A mesh with the materials of its triangles; null if the file has none.
struct MeshFile {
  std::shared_ptr<const Mesh> mesh;
  std::shared_ptr<const std::vector<Material>> materials;
  std::vector<std::string> warnings{};  ///< one line each, "FILE:LINE: ..."
};

/// Reads a mesh by the ending of its name. Refuses a file that is truncated, refers to missing vertices or has numbers
/// that are not finite; allocates nothing for a count that the file cannot hold.
[[nodiscard]] Result<MeshFile> read_mesh(const std::string& path);

/// From the bytes of a file; `path` is for messages, and locates the files that it refers to.
[[nodiscard]] Result<MeshFile> parse_obj(std::string bytes, const std::string& path);
[[nodiscard]] Result<MeshFile> parse_ply(std::string bytes, const std::string& path);
[[nodiscard]] Result<MeshFile> parse_gltf(std::string bytes, const std::string& path);  ///< .gltf or .glb

/// The materials of an MTL file, in its order, with their names.
struct NamedMaterial {
  std::string name;
  Material material;
  std::string texture{};  ///< the first line that gives it one, such as "map_Kd wood.png": none is read
  int texture_line = 0;
};
[[nodiscard]] Result<std::vector<NamedMaterial>> parse_mtl(std::string bytes, const std::string& path);

namespace detail {

/// Objects and triangles of a whole scene that are stored: what fits into 16 GiB.
inline constexpr double max_entries = 3.2e7;
/// Those of a group, copies included: each triangle of a copy has a number too.
inline constexpr double max_copied = 1.8e9;
inline constexpr std::size_t max_mesh_bytes = std::size_t{1} << 31;

/// The path of `name`, found in the file `from`: relative to it unless absolute.
[[nodiscard]] std::string path_beside(const std::string& from, const std::string& name);
/// The same for all names of one file: with links, "." and ".." resolved, so that it is read only once.
[[nodiscard]] std::string one_name(const std::string& path);
/// Whether `name` stays within the folder of the file that refers to it. Meshes come from untrusted sources, which must
/// not read other files.
[[nodiscard]] bool stays_beside(std::string_view name);

/// What is wrong with a mesh's numbers, or "": the final check of every reader.
[[nodiscard]] std::string why_no_mesh(const Mesh& mesh);
/// Why nothing of a valid mesh is visible, or "".
[[nodiscard]] std::string why_unseen(const Mesh& mesh);
/// The warning, of one file, that textures of its materials (`which`) are not read: the first one's, and how many
/// others have some. `place`: "FILE" or "FILE:LINE".
[[nodiscard]] std::string warning_of_textures(const std::string& place, std::string_view which,
                                              std::string_view material, std::string_view texture, std::size_t others);
/// The warning that colours of its vertices are not read.
[[nodiscard]] std::string warning_of_colours(const std::string& path);
/// The mesh read from the file `path`, with a warning if nothing of it is visible.
[[nodiscard]] MeshFile finished_mesh(Mesh mesh, const std::string& path);

}  // namespace detail

}  // namespace raywalk
