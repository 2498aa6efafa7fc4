#pragma once

#include "io/scene_file.h"

namespace raywalk {

/// A mesh file as a scene: the mesh with its y axis up, as in most such files, seen from the front and slightly above,
/// lit by a key light from behind left and a weaker fill light from the right.
[[nodiscard]] Result<SceneDocument> scene_of_mesh(const std::string& path);

}  // namespace raywalk
