#pragma once

#include "io/error.h"
#include "scene/scene.h"

#include <string>

namespace raywalk {

/// The pixels of an 8-bit PNG or JPEG, from sRGB to linear light. `file_name` is for messages only.
[[nodiscard]] Result<TexturePixels> decode_texture(std::string_view bytes, const std::string& file_name);

/// Loads the textures of the scene's materials; each file is read once. Names that do not begin with a slash are
/// relative to `folder`.
[[nodiscard]] Result<void> load_textures(Scene& scene, const std::string& folder);

}  // namespace raywalk
