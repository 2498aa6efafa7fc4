#pragma once
// Only what differs between two scenes, by the names of objects and keys: what a link holds of a scene. Applied to a
// scene that has changed since, it still changes what it names.

#include "io/scene_file.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace raywalk {

/// What makes `to` of `from`, as JSON with the keys of a scene's file; a list of things with names is an object by
/// their names, and null takes away. Empty if nothing does.
[[nodiscard]] std::string scene_patch(const Scene& from, const Scene& to);

/// `from` as changed by a patch, which may come from anybody: the result is a scene that could be saved, and names no
/// file that `from` does not name. `text` and `path` are those of `from`, which must have its files loaded.
[[nodiscard]] Result<SceneDocument> patched_scene(const SceneDocument& from, std::string_view patch);

/// Whether it needs files of its own: meshes, textures, maps or a picture of the sky.
[[nodiscard]] bool names_files(const Scene& scene);

/// Tells scenes apart: equal for equal ones.
[[nodiscard]] std::uint32_t scene_sum(const Scene& scene);

}  // namespace raywalk
