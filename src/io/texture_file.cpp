#include "io/texture_file.h"

#include "io/file.h"
#include "io/mesh_file.h"
#include "io/srgb.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <vector>

#include <png.h>
#include <turbojpeg.h>

namespace raywalk {

namespace {

constexpr std::size_t max_bytes = std::size_t{256} << 20;
constexpr std::int64_t max_pixels = std::int64_t{1} << 26;

tl::unexpected<Error> no_texture(const std::string& file, const std::string& why) {
  return tl::unexpected(Error{file, 0, 0, why, "a texture is a PNG or a JPEG of 8 bits a channel"});
}

Result<void> check_size(const std::string& file, std::int64_t width, std::int64_t height) {
  if (width * height <= max_pixels) return {};
  return no_texture(
      file, fmt::format("the image has {} x {} pixels (expected at most {} in all)", width, height, max_pixels));
}

tl::unexpected<Error> damaged(const std::string& file, const std::string& why) {
  return no_texture(file, fmt::format("the image is damaged: {}", why));
}

/// Red, green and blue bytes, with others that are ignored, row by row from the top.
struct Bytes {
  int width, height, channels;
  std::vector<std::uint8_t> bytes;
};

Result<Bytes> decode_png(std::string_view bytes, const std::string& file) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> image(&header, png_image_free);
  if (png_image_begin_read_from_memory(image.get(), bytes.data(), bytes.size()) == 0)
    return damaged(file, image->message);
  if (auto small = check_size(file, image->width, image->height); !small) return tl::unexpected(small.error());
  image->format = PNG_FORMAT_RGBA;  // transparent pixels keep their colour
  Bytes decoded{static_cast<int>(image->width), static_cast<int>(image->height), 4, {}};
  decoded.bytes.resize(PNG_IMAGE_SIZE(*image));
  if (png_image_finish_read(image.get(), nullptr, decoded.bytes.data(), 0, nullptr) == 0)
    return damaged(file, image->message);
  return decoded;
}

Result<Bytes> decode_jpeg(std::string_view bytes, const std::string& file) {
  const std::unique_ptr<void, decltype(&tjDestroy)> decoder(tjInitDecompress(), tjDestroy);
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto size = static_cast<unsigned long>(bytes.size());
  Bytes decoded{0, 0, 3, {}};
  int subsampling = 0, colours = 0;
  if (!decoder ||
      tjDecompressHeader3(decoder.get(), data, size, &decoded.width, &decoded.height, &subsampling, &colours) != 0)
    return damaged(file, tjGetErrorStr2(decoder.get()));
  if (auto small = check_size(file, decoded.width, decoded.height); !small) return tl::unexpected(small.error());
  decoded.bytes.resize(3 * static_cast<std::size_t>(decoded.width) * static_cast<std::size_t>(decoded.height));
  if (tjDecompress2(decoder.get(), data, size, decoded.bytes.data(), decoded.width, 0, decoded.height, TJPF_RGB,
                    TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS) != 0)
    return damaged(file, tjGetErrorStr2(decoder.get()));
  return decoded;
}

}  // namespace

Result<TexturePixels> decode_texture(std::string_view bytes, const std::string& file_name) {
  if (bytes.size() > max_bytes)
    return no_texture(file_name, fmt::format("the file is too large (expected at most {} MiB)", max_bytes >> 20));
  const bool png = bytes.starts_with("\x89PNG"), jpeg = bytes.starts_with("\xff\xd8");
  if (!png && !jpeg) return no_texture(file_name, "this is not an image that can be read (expected a PNG or JPEG)");
  const Result<Bytes> image = png ? decode_png(bytes, file_name) : decode_jpeg(bytes, file_name);
  if (!image) return tl::unexpected(image.error());

  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = static_cast<float>(srgb_decode(static_cast<double>(i) / 255));
  TexturePixels texture{image->width, image->height, {}};
  const auto step = static_cast<std::size_t>(image->channels);
  texture.pixels.reserve(image->bytes.size() / step);
  for (std::size_t i = 0; i < image->bytes.size(); i += step)
    texture.pixels.emplace_back(linear[image->bytes[i]], linear[image->bytes[i + 1]], linear[image->bytes[i + 2]]);
  return texture;
}

namespace {

/// Loads the pixels of textures; each file is decoded once, whatever its names.
class Loader {
 public:
  explicit Loader(std::string folder) : folder_(std::move(folder)) {}

  Result<void> load(std::vector<Object>& objects) {
    for (Object& object : objects) {
      if (object.material.texture) {
        const auto pixels = pixels_of(object);
        if (!pixels) return tl::unexpected(pixels.error());
        object.material.texture->pixels = *pixels;
      }
      if (auto* instance = std::get_if<Instance>(&object.shape); instance && instance->content) {
        const auto content = loaded(instance->content);
        if (!content) return tl::unexpected(content.error());
        instance->content = *content;
      }
    }
    return {};
  }

 private:
  using Pixels = std::shared_ptr<const TexturePixels>;
  using Content = std::shared_ptr<const GroupContent>;

  Result<Pixels> pixels_of(const Object& object) {
    const std::string path = (std::filesystem::path(folder_) / object.material.texture->file).string();
    Pixels& pixels = pixels_[detail::one_name(path)];
    if (pixels) return pixels;
    const auto bytes = read_file(path, max_bytes);
    auto decoded = bytes ? decode_texture(*bytes, path) : tl::unexpected(bytes.error());
    if (!decoded) {
      Error error = decoded.error();
      error.hint =
          fmt::format("it is the texture of \"{}\", looked for from the scene's folder; {}", object.name, error.hint);
      return tl::unexpected(error);
    }
    return pixels = std::make_shared<const TexturePixels>(std::move(*decoded));
  }

  /// A group's shared content, with its textures loaded; unchanged if it has none.
  Result<Content> loaded(const Content& content) {
    if (const auto known = contents_.find(content); known != contents_.end()) return known->second;
    Group group = content->group;
    if (const auto inside = load(group.objects); !inside) return tl::unexpected(inside.error());
    const auto differs = [](const Object& now, const Object& before) {
      const auto* instance = std::get_if<Instance>(&now.shape);
      return now.material.texture || (instance && instance->content != std::get<Instance>(before.shape).content);
    };
    bool same = true;
    for (std::size_t i = 0; i < group.objects.size(); ++i)
      same = same && !differs(group.objects[i], content->group.objects[i]);
    return contents_[content] = same ? content : std::make_shared<const GroupContent>(std::move(group));
  }

  std::string folder_;
  std::map<std::string, Pixels> pixels_;  ///< by file
  std::map<Content, Content> contents_;
};

}  // namespace

Result<void> load_textures(Scene& scene, const std::string& folder) {
  Loader loader(folder);
  for (Group& group : scene.groups)
    if (const auto loaded = loader.load(group.objects); !loaded) return loaded;
  return loader.load(scene.objects);
}

}  // namespace raywalk
