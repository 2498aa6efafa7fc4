#pragma once

#include "io/scene_file.h"

namespace raywalk {

/// A mesh's file as a scene: the mesh as it stands, its y upwards as in most of such files, seen from before and a
/// little above, under a sun behind the left shoulder and a weaker one to the right.
[[nodiscard]] Result<SceneDocument> scene_of_mesh(const std::string& path);

}  // namespace raywalk
