#pragma once

#include "io/image.h"

#include <string>

namespace raywalk {

/// Reads a PNG (8 bits a channel, from sRGB to linear light), a PFM or an OpenEXR picture, detected by its first bytes.
[[nodiscard]] Result<Image> read_image(const std::string& path);

}  // namespace raywalk
