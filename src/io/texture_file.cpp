#include "io/texture_file.h"

#include "io/file.h"
#include "io/srgb.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <new>

// Only this file's own functions are compiled in, without stb's file access, for the two formats.
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_LINEAR
#define STBI_NO_HDR
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#include <stb_image.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace raywalk {

namespace {

constexpr std::size_t most_bytes = std::size_t{256} << 20;
constexpr std::int64_t most_pixels = std::int64_t{1} << 26;

tl::unexpected<Error> no_texture(const std::string& file, const std::string& why) {
  return tl::unexpected(Error{file, 0, 0, why, "a texture is a PNG or a JPEG of 8 bits a channel"});
}

struct FreePixels {
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

}  // namespace

Result<TexturePixels> decode_texture(std::string_view bytes, const std::string& file_name) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  if (bytes.size() > most_bytes)
    return no_texture(file_name, fmt::format("the file is too large (expected at most {} MiB)", most_bytes >> 20));
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, channels = 0;
  if (stbi_info_from_memory(data, size, &width, &height, &channels) == 0)
    return no_texture(file_name, "this is not an image that can be read (expected a PNG or JPEG)");
  if (std::int64_t{width} * height > most_pixels)
    return no_texture(file_name, fmt::format("the image has {} x {} pixels (expected at most {} in all)", width, height,
                                             most_pixels));
  const std::unique_ptr<stbi_uc, FreePixels> pixels(
      stbi_load_from_memory(data, size, &width, &height, &channels, STBI_rgb));
  if (!pixels) return no_texture(file_name, fmt::format("the image is damaged: {}", stbi_failure_reason()));

  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = static_cast<float>(srgb_decode(static_cast<double>(i) / 255));
  TexturePixels texture{width, height, {}};
  const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  texture.pixels.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const stbi_uc* rgb = pixels.get() + 3 * i;
    texture.pixels.emplace_back(linear[rgb[0]], linear[rgb[1]], linear[rgb[2]]);
  }
  return texture;
}

Result<void> load_textures(Scene& scene, const std::string& folder) {
  std::map<std::string, std::shared_ptr<const TexturePixels>> loaded;
  for (Object& object : scene.objects) {
    if (!object.material.texture) continue;
    ImageTexture& texture = *object.material.texture;
    const std::string path = (std::filesystem::path(folder) / texture.file).string();
    std::shared_ptr<const TexturePixels>& pixels = loaded[path];
    if (!pixels) {
      const auto bytes = read_file(path, most_bytes);
      auto decoded = bytes ? decode_texture(*bytes, path) : tl::unexpected(bytes.error());
      if (!decoded) {
        Error error = decoded.error();
        error.hint =
            fmt::format("it is the texture of \"{}\", looked for from the scene's folder; {}", object.name, error.hint);
        return tl::unexpected(error);
      }
      pixels = std::make_shared<const TexturePixels>(std::move(*decoded));
    }
    texture.pixels = pixels;
  }
  return {};
}

}  // namespace raywalk
