#pragma once
// Raywalk's own scene format: TOML. Its keys are listed once, in scene/schema.h; scenes/README.md documents them.

#include "scene/ink.h"
#include "scene/scene.h"
#include "text/error.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

/// A scene together with the text it was read from, whose comments and layout are preserved on writing.
struct SceneDocument {
  Scene scene;
  std::string text;                   ///< of the file when it was last read or written; empty: there was none
  std::vector<std::string> warnings;  ///< one line each, "FILE:LINE:COL: ..."
  /// The file that it was read from, to whose folder the names of meshes and textures are relative; may be empty.
  std::string path{};
  std::vector<std::string> files{};  ///< all that were read for it, including meshes, their materials and textures
  Ink ink{};
  bool keeps_ink = false;  ///< whether the file has the ink too

  [[nodiscard]] Ink ink_of_file() const { return keeps_ink ? ink : Ink{}; }
};

/// Meshes come in files of their own, so a larger scene file is a mistake.
inline constexpr std::size_t max_scene_bytes = std::size_t{16} << 20;

/// The formats that scenes are read from. Only our own is written back.
enum class SceneFormat {
  toml,
  nff,   ///< io/nff_reader.h
  test,  ///< io/test_format_reader.h
  ply,   ///< a mesh alone, like the next three: io/mesh_scene.h
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
/// The format that the extension of `path` names, in either case; our own for any other extension.
[[nodiscard]] SceneFormat scene_format_of(std::string_view path);
/// Whether `path` has the extension of one of the formats.
[[nodiscard]] bool has_scene_ending(std::string_view path);

/// Reads a scene in our own format, or says what is wrong with it and where. `file_name` is for messages; mesh files
/// are relative to it, and are read too unless skipped.
enum class MeshReading { read, skip };
[[nodiscard]] Result<SceneDocument> parse_scene(std::string_view text, const std::string& file_name,
                                                MeshReading meshes = MeshReading::read);
/// Reads a scene in the format that the extension of `path` names. Formats other than ours give no text.
[[nodiscard]] Result<SceneDocument> read_scene(const std::string& path);
/// The text of a file in our format, as `read_scene` keeps it in `SceneDocument::text`, whether it is a scene or not.
[[nodiscard]] Result<std::string> read_scene_text(const std::string& path);

/// The text of `scene`, which is read back as the same scene, bit for bit. What is unchanged in `previous_text` is
/// kept, with comments, order and layout: only values that differ are replaced; new objects and lights are added after
/// their predecessor, removed ones are deleted with their comments (directly above, inside and below, not those set
/// apart by an empty line). Without a previous text, or with one that is not a scene, a new text. Fails when `scene`
/// breaks a rule of the format (a radius that is not finite, two objects of one name). `ink`: what is drawn over it.
[[nodiscard]] Result<std::string> format_scene(const Scene& scene, std::string_view previous_text = {},
                                               const Ink& ink = {});

/// `scene` with the names of its meshes and textures, which are relative to the folder of the file `from`, made
/// relative to the folder of the file `to`. Absolute names are kept. Fails if a folder's name is not UTF-8, which a
/// scene cannot contain.
[[nodiscard]] Result<Scene> with_names_from(Scene scene, const std::string& from, const std::string& to);

/// Writes `document.scene`, and its ink if that is kept, in our own format whatever it was read from, in the layout of
/// `document.text`, all or nothing, and on success stores the written text in `document.text`. Refuses the extension of
/// another format.
[[nodiscard]] Result<void> write_scene(SceneDocument& document, const std::string& path);

}  // namespace raywalk
