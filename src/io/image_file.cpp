#include "io/image_file.h"

#include "io/file.h"
#include "io/texture_file.h"

#include <string_view>

namespace raywalk {

Result<Image> read_image(const std::string& path) {
  constexpr std::size_t max_bytes = std::size_t{1} << 30;
  const auto bytes = read_file(path, max_bytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const std::string_view content = *bytes;
  if (content.starts_with("PF")) return decode_pfm(content, path);
  if (content.starts_with("\x76\x2f\x31\x01")) return decode_exr(content, path);
  if (!content.starts_with("\x89PNG\r\n\x1a\n"))
    return tl::unexpected(Error{path, 0, 0, "this is no picture that can be read (expected a PNG, PFM or EXR)",
                                "raywalk render writes all three"});
  auto texture = decode_texture(content, path);
  if (!texture) {
    texture.error().hint = "is the file whole?";
    return tl::unexpected(texture.error());
  }
  return Image{texture->width, texture->height, std::move(texture->pixels)};
}

}  // namespace raywalk
