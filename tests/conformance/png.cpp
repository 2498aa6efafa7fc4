#include "png.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wconversion"
#endif
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace raywalk::test {

Picture decode_png(const std::string& png) {
  Picture picture;
  int channels = 0;
  stbi_uc* bytes = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(png.data()), static_cast<int>(png.size()),
                                         &picture.width, &picture.height, &channels, 3);
  if (bytes == nullptr) return {};
  const std::size_t size = 3 * static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.bytes.assign(bytes, bytes + size);
  stbi_image_free(bytes);
  return picture;
}

}  // namespace raywalk::test
