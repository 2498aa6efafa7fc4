#pragma once
// Raywalk's own scene format: TOML. Its keys are listed once, in scene/schema.h; scenes/README.md says them to people.

#include "io/error.h"
#include "scene/scene.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A scene together with the text it was read from, whose comments and layout survive when it is written again.
struct SceneDocument {
  Scene scene;
  std::string text;                   ///< empty for a scene that was never in a file
  std::vector<std::string> warnings;  ///< one line each, "FILE:LINE:COL: ..."
  /// The file that it was read from, from whose folder its meshes and textures are named; empty when from none.
  std::string path{};
  std::vector<std::string> files{};  ///< all that were read for it, meshes, their materials and textures among them
};

/// Meshes come in files of their own, so a larger scene file is a mistake.
inline constexpr std::size_t most_scene_bytes = std::size_t{16} << 20;

/// The formats that scenes are read from. Only our own is written.
enum class SceneFormat {
  toml,
  nff,   ///< io/nff_reader.h
  test,  ///< io/test_format_reader.h
  ply,   ///< a mesh by itself, as the three that follow: io/mesh_scene.h
  obj,
  gltf,
  glb,
};
inline constexpr int scene_format_count = 7;
[[nodiscard]] constexpr std::string_view scene_ending(SceneFormat format) {
  switch (format) {
    case SceneFormat::toml:
      return ".toml";
    case SceneFormat::nff:
      return ".nff";
    case SceneFormat::test:
      return ".test";
    case SceneFormat::ply:
      return ".ply";
    case SceneFormat::obj:
      return ".obj";
    case SceneFormat::gltf:
      return ".gltf";
    case SceneFormat::glb:
      return ".glb";
  }
  return "";
}
/// The format that the ending of `path` names, in upper or lower case; our own for any other ending.
[[nodiscard]] SceneFormat scene_format_of(std::string_view path);
/// Whether `path` ends as one of the formats does.
[[nodiscard]] bool has_scene_ending(std::string_view path);

/// Reads a scene in our own format, or says what is wrong with it at which place. `file_name` is for messages;
/// files of meshes are named relative to it, and read too unless they are skipped.
enum class MeshReading { read, skip };
[[nodiscard]] Result<SceneDocument> parse_scene(std::string_view text, const std::string& file_name,
                                                MeshReading meshes = MeshReading::read);
/// Reads a scene in the format that the ending of `path` names. One of another format than ours comes without a text.
[[nodiscard]] Result<SceneDocument> read_scene(const std::string& path);

/// The text of `scene`, which reads back as the same scene, bit for bit. What `previous_text` shares with it stays as
/// it is, with comments, order and layout: only values that differ are replaced; new objects and lights are added after
/// the one they follow, removed ones go together with their comments (those directly above, inside and below, not
/// those set apart by an empty line). Without a previous text, or with one that is no scene, a tidy new text.
/// Fails when `scene` breaks a rule of the format (a radius that is not finite, two objects of one name).
[[nodiscard]] Result<std::string> format_scene(const Scene& scene, std::string_view previous_text = {});

/// `scene` with the names of its meshes and textures, which were meant from the folder of the file `from`, as they are
/// from the folder of the file `to`. Absolute names stay what they are. Fails where a folder's name is no UTF-8, which
/// no scene can state.
[[nodiscard]] Result<Scene> with_names_from(Scene scene, const std::string& from, const std::string& to);

/// Writes `document.scene`, in our own format whatever it was read from, in the layout of `document.text`, all or
/// nothing, and on success makes `document.text` what was written. Refuses a name with the ending of another format.
[[nodiscard]] Result<void> write_scene(SceneDocument& document, const std::string& path);

}  // namespace raywalk
