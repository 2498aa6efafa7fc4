#pragma once

#include "scene/scene.h"
#include "text/error.h"

#include <string>

namespace raywalk {

/// Loads the textures of the scene's materials, each file once, and the picture of its sky. Names that do not begin
/// with a slash are relative to `folder`.
[[nodiscard]] Result<void> load_textures(Scene& scene, const std::string& folder);

}  // namespace raywalk
