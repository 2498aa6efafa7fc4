#include "image/image_file.h"

#include "text/memory.h"

#include <fmt/format.h>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <png.h>
#include <turbojpeg.h>

namespace raywalk {

namespace {

tl::unexpected<Error> no_texture(const std::string& file, const std::string& why, const std::string& hint) {
  return tl::unexpected(Error{file, 0, 0, why, hint});
}

Result<void> check_size(const std::string& file, std::int64_t width, std::int64_t height, std::int64_t max_pixels) {
  if (width * height > max_pixels)
    return no_texture(
        file, fmt::format("the image has {} x {} pixels (expected at most {} in all)", width, height, max_pixels),
        "make it smaller");
  constexpr double bytes_each = 4 + sizeof(Rgb<float>);  // as it is decoded, and as it is kept
  if (auto large = why_too_large({fmt::format("an image of {} x {} pixels", width, height),
                                  bytes_each * static_cast<double>(width * height), "make it smaller"},
                                 file))
    return tl::unexpected(std::move(*large));
  return {};
}

tl::unexpected<Error> damaged(const std::string& file, const std::string& why) {
  return no_texture(file, fmt::format("the image is damaged: {}", why), "is the file whole?");
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

/// The numbers of a PNG of 16 bits a channel. None where it has 8, or cannot be read; nor where it is transparent
/// somewhere, for libpng multiplies 16 bits by that.
std::optional<Image> numbers_of_16_bits(std::string_view bytes, std::int64_t max_pixels) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> image(&header, png_image_free);
  if (png_image_begin_read_from_memory(image.get(), bytes.data(), bytes.size()) == 0) return std::nullopt;
  const bool has_16_bits = (image->format & PNG_FORMAT_FLAG_LINEAR) != 0;
  if (!has_16_bits || !check_size("", image->width, image->height, max_pixels)) return std::nullopt;
  image->format = PNG_FORMAT_LINEAR_RGB_ALPHA;
  std::vector<png_uint_16> samples(PNG_IMAGE_SIZE(*image) / sizeof(png_uint_16));
  if (png_image_finish_read(image.get(), nullptr, samples.data(), 0, nullptr) == 0) return std::nullopt;
  constexpr png_uint_16 most = 65535;
  const auto number = [](png_uint_16 sample) { return static_cast<float>(sample / static_cast<double>(most)); };
  Image numbers{static_cast<int>(image->width), static_cast<int>(image->height), {}};
  numbers.pixels.reserve(samples.size() / 4);
  for (std::size_t i = 0; i < samples.size(); i += 4) {
    if (samples[i + 3] != most) return std::nullopt;
    numbers.pixels.emplace_back(number(samples[i]), number(samples[i + 1]), number(samples[i + 2]));
  }
  return numbers;
}

/// Whether libpng, asked for 8 bits, might mix the rows of its passes (its issue 853: of 16 bits a channel,
/// interlaced).
bool mixes_rows(std::string_view png) {
  constexpr std::size_t depth = 24, interlace = 28;  // in the first chunk, which is always the same one
  return png.size() > interlace && png[depth] == 16 && png[interlace] != 0;
}

Result<Bytes> decode_png(std::string_view bytes, const std::string& file, std::int64_t max_pixels) {
  if (mixes_rows(bytes))
    return no_texture(file, "this PNG has 16 bits a channel and is interlaced, which is not read",
                      "save it again without interlacing, or with 8 bits");
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  const std::unique_ptr<png_image, decltype(&png_image_free)> image(&header, png_image_free);
  if (png_image_begin_read_from_memory(image.get(), bytes.data(), bytes.size()) == 0)
    return damaged(file, image->message);
  if (auto small = check_size(file, image->width, image->height, max_pixels); !small)
    return tl::unexpected(small.error());
  image->flags |= PNG_IMAGE_FLAG_16BIT_sRGB;  // 16 bits a channel mean what 8 mean, not linear light
  image->format = PNG_FORMAT_RGBA;            // transparent pixels keep their colour
  Bytes decoded{static_cast<int>(image->width), static_cast<int>(image->height), 4, {}};
  decoded.bytes.resize(PNG_IMAGE_SIZE(*image));
  if (png_image_finish_read(image.get(), nullptr, decoded.bytes.data(), 0, nullptr) == 0)
    return damaged(file, image->message);
  return decoded;
}

Result<Bytes> decode_jpeg(std::string_view bytes, const std::string& file, std::int64_t max_pixels) {
  const std::unique_ptr<void, decltype(&tjDestroy)> decoder(tjInitDecompress(), tjDestroy);
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto size = static_cast<unsigned long>(bytes.size());
  Bytes decoded{0, 0, 3, {}};
  int subsampling = 0, colours = 0;
  if (!decoder ||
      tjDecompressHeader3(decoder.get(), data, size, &decoded.width, &decoded.height, &subsampling, &colours) != 0)
    return damaged(file, tjGetErrorStr2(decoder.get()));
  if (colours == TJCS_CMYK || colours == TJCS_YCCK)
    return no_texture(file, "this JPEG is in CMYK (expected RGB or grey)", "save it again as RGB");
  if (auto small = check_size(file, decoded.width, decoded.height, max_pixels); !small)
    return tl::unexpected(small.error());
  decoded.bytes.resize(3 * static_cast<std::size_t>(decoded.width) * static_cast<std::size_t>(decoded.height));
  if (tjDecompress2(decoder.get(), data, size, decoded.bytes.data(), decoded.width, 0, decoded.height, TJPF_RGB,
                    TJFLAG_ACCURATEDCT | TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS) != 0)
    return damaged(file, tjGetErrorStr2(decoder.get()));
  return decoded;
}

}  // namespace

Result<Image> decode_png_or_jpeg(std::string_view bytes, const std::string& file_name, ByteMeaning meaning,
                                 std::int64_t max_pixels) {
  const std::int64_t max_bytes = 4 * max_pixels;
  if (static_cast<std::int64_t>(bytes.size()) > max_bytes)
    return no_texture(file_name, fmt::format("the file is too large (expected at most {} MiB)", max_bytes >> 20),
                      "make it smaller");
  const bool png = bytes.starts_with("\x89PNG"), jpeg = bytes.starts_with("\xff\xd8");
  if (!png && !jpeg)
    return no_texture(file_name, "this is not an image that can be read (expected a PNG or JPEG)",
                      "save it again as a PNG or a JPEG");
  const std::string plain = png && meaning == ByteMeaning::number ? without_colour_space(bytes) : std::string();
  if (!plain.empty())
    if (auto numbers = numbers_of_16_bits(plain, max_pixels)) return std::move(*numbers);
  const Result<Bytes> image = png ? decode_png(plain.empty() ? bytes : plain, file_name, max_pixels)
                                  : decode_jpeg(bytes, file_name, max_pixels);
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
