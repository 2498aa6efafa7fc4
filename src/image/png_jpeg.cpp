#include "image/image_file.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
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

/// A PNG without what it says of its colours, which numbers are not.
std::string without_colour_space(std::string_view png) {
  constexpr std::size_t signature = 8, around = 12;  // a chunk's length, name and checksum
  std::string plain(png.substr(0, signature));
  for (std::size_t at = signature; at + around <= png.size();) {
    std::size_t length = 0;
    for (std::size_t i = 0; i < 4; ++i) length = length << 8 | static_cast<unsigned char>(png[at + i]);
    const std::string_view chunk = png.substr(at, length + around), name = chunk.substr(4, 4);
    if (name != "gAMA" && name != "cHRM" && name != "sRGB" && name != "iCCP") plain += chunk;
    at += chunk.size();
  }
  return plain;
}

Result<Bytes> decode_png(std::string_view bytes, const std::string& file) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> image(&header, png_image_free);
  if (png_image_begin_read_from_memory(image.get(), bytes.data(), bytes.size()) == 0)
    return damaged(file, image->message);
  if (auto small = check_size(file, image->width, image->height); !small) return tl::unexpected(small.error());
  image->flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16 bits a channel mean what 8 mean, not linear light
  image->format = PNG_FORMAT_RGBA;            // transparent pixels keep their colour
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

Result<Image> decode_png_or_jpeg(std::string_view bytes, const std::string& file_name, ByteMeaning meaning) {
  if (bytes.size() > max_bytes)
    return no_texture(file_name, fmt::format("the file is too large (expected at most {} MiB)", max_bytes >> 20));
  const bool png = bytes.starts_with("\x89PNG"), jpeg = bytes.starts_with("\xff\xd8");
  if (!png && !jpeg) return no_texture(file_name, "this is not an image that can be read (expected a PNG or JPEG)");
  const Result<Bytes> image = !png                             ? decode_jpeg(bytes, file_name)
                              : meaning == ByteMeaning::number ? decode_png(without_colour_space(bytes), file_name)
                                                               : decode_png(bytes, file_name);
  if (!image) return tl::unexpected(image.error());

  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = static_cast<float>(meaning == ByteMeaning::colour ? srgb_decode(static_cast<double>(i) / 255)
                                                                  : static_cast<double>(i) / 255);
  Image picture{image->width, image->height, {}};
  const auto step = static_cast<std::size_t>(image->channels);
  picture.pixels.reserve(image->bytes.size() / step);
  for (std::size_t i = 0; i < image->bytes.size(); i += step)
    picture.pixels.emplace_back(linear[image->bytes[i]], linear[image->bytes[i + 1]], linear[image->bytes[i + 2]]);
  return picture;
}

}  // namespace raywalk
