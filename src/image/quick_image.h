#pragma once
// Pictures that somebody waits for: what an interrupted render has done. They are packed with little effort and written
// piece by piece, so that neither the picture nor its file is ever in memory as a whole.

#include "image/image.h"
#include "image/srgb.h"
#include "text/error.h"

#include <string>

namespace raywalk {

/// As write_image, and read back as the same picture.
[[nodiscard]] Result<void> write_image_quickly(const std::string& path, const ImageRows& rows, Encoding encoding);

}  // namespace raywalk
