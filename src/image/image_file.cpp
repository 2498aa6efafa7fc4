#include "image/image_file.h"

#include "image/srgb.h"
#include "text/file.h"

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <png.h>

namespace raywalk {

namespace {

bool has_nan(const Rgb<float>& c) { return std::isnan(c.x) || std::isnan(c.y) || std::isnan(c.z); }

std::uint32_t swap_bytes(std::uint32_t x) { return x << 24 | (x & 0xff00) << 8 | (x >> 8 & 0xff00) | x >> 24; }

Result<Image> bad_pfm(const std::string& file, const std::string& what) {
  return tl::unexpected(
      Error{file, 0, 0, what,
            "a PFM starts with PF, the width and height, and -1.0, then 12 bytes a pixel; a grey one with Pf has 4"});
}

/// The next word of a PFM's header; also skips the single blank after it.
std::string_view next_word(std::string_view& bytes) {
  const std::size_t begin = bytes.find_first_not_of(" \t\r\n");
  if (begin == std::string_view::npos) return {};
  const std::size_t end = std::min(bytes.find_first_of(" \t\r\n", begin), bytes.size());
  const std::string_view word = bytes.substr(begin, end - begin);
  bytes.remove_prefix(std::min(end + 1, bytes.size()));
  return word;
}

}  // namespace

Result<ImageFormat> image_format_of(const std::string& path) {
  const std::size_t slash = path.find_last_of('/');
  const std::size_t dot = path.find_last_of('.');
  const bool has_ending = dot != std::string::npos && (slash == std::string::npos || dot > slash);
  std::string ending = has_ending ? path.substr(dot) : "";
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".png") return ImageFormat::png;
  if (ending == ".pfm") return ImageFormat::pfm;
  if (ending == ".exr") {
    if (has_exr()) return ImageFormat::exr;
    return tl::unexpected(
        Error{path, 0, 0, "this build of Raywalk cannot write OpenEXR (expected .png or .pfm)",
              "install libopenexr-dev and build again, or write a .pfm, which holds the same numbers"});
  }
  return tl::unexpected(
      Error{path, 0, 0,
            (ending.empty() ? std::string("the file name has no ending")
                            : "\"" + ending + "\" is no image format that can be written") +
                " (expected .png, .pfm or .exr)",
            "name it .png for a picture to look at, .pfm or .exr for linear numbers to compute with"});
}

std::vector<std::uint8_t> bytes_of(std::span<const Rgb<float>> pixels, Encoding encoding) {
  std::vector<std::uint8_t> bytes(pixels.size() * 3);
  auto at = bytes.begin();
  for (const Rgb<float>& pixel : pixels) {
    const Rgb<float> c = has_nan(pixel) ? Rgb<float>(1, 0, 1) : pixel;
    if (is_black(c))  // as most of a picture is that was interrupted
      at += 3;
    else
      for (const float channel : {c.x, c.y, c.z}) *at++ = to_byte(channel, encoding);
  }
  return bytes;
}

Result<std::string> encode_png(const Image& image, Encoding encoding) {
  if (image.pixels.empty() || has_too_many_pixels({image.width, image.height}))
    return tl::unexpected(Error{"", 0, 0,
                                "a PNG of " + std::to_string(image.width) + " x " + std::to_string(image.height) +
                                    " pixels cannot be made (expected 1 to " + std::to_string(max_image_pixels) +
                                    " pixels)",
                                "choose another size"});
  const std::vector<std::uint8_t> bytes = bytes_of(image, encoding);
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width), header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_RGB;
  if (encoding != Encoding::srgb) header.flags |= PNG_IMAGE_FLAG_COLORSPACE_NOT_sRGB;
  png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(header);
  std::string png(size, '\0');
  if (png_image_write_to_memory(&header, png.data(), &size, 0, bytes.data(), 0, nullptr) == 0)
    return tl::unexpected(
        Error{"", 0, 0, std::string("the PNG cannot be made: ") + header.message, "choose a smaller size"});
  png.resize(size);
  return png;
}

std::string pfm_header(int width, int height) {
  return "PF\n" + std::to_string(width) + " " + std::to_string(height) + "\n-1.0\n";
}

std::string pfm_bytes(std::span<const Rgb<float>> pixels) {
  static_assert(sizeof(Rgb<float>) == 3 * sizeof(float));
  std::string bytes(reinterpret_cast<const char*>(pixels.data()), pixels.size_bytes());
  if constexpr (std::endian::native == std::endian::big)
    for (auto number = bytes.begin(); number != bytes.end(); number += 4) std::reverse(number, number + 4);
  return bytes;
}

std::string encode_pfm(const Image& image) {
  std::string bytes = pfm_header(image.width, image.height);
  bytes.reserve(bytes.size() + image.pixels.size() * sizeof(Rgb<float>));
  for (int row = image.height - 1; row >= 0; --row)
    bytes += pfm_bytes({&image.at(0, row), static_cast<std::size_t>(image.width)});
  return bytes;
}

Result<void> write_image(const std::string& path, const Image& image, Encoding encoding) {
  const auto format = image_format_of(path);
  if (!format) return tl::unexpected(format.error());
  std::string bytes;
  switch (*format) {
    case ImageFormat::png: {
      auto png = encode_png(image, encoding);
      if (!png) {
        png.error().file = path;
        return tl::unexpected(png.error());
      }
      bytes = std::move(*png);
      break;
    }
    case ImageFormat::pfm:
      bytes = encode_pfm(image);
      break;
    case ImageFormat::exr: {
      auto exr = encode_exr(image);
      if (!exr) {
        exr.error().file = path;
        return tl::unexpected(exr.error());
      }
      bytes = std::move(*exr);
      break;
    }
  }
  return write_file_atomically(path, bytes);
}

Result<Image> decode_pfm(std::string_view bytes, const std::string& file_name) {
  const std::string_view kind = next_word(bytes);
  if (kind != "PF" && kind != "Pf")
    return bad_pfm(file_name, "this is no PFM (expected it to start with \"PF\", or \"Pf\" if grey)");
  const int channels = kind == "PF" ? 3 : 1;
  const std::size_t pixel_bytes = sizeof(float) * static_cast<std::size_t>(channels);
  const auto whole = [](std::string_view word) {
    int number = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
    return error == std::errc() && end == word.data() + word.size() ? number : 0;
  };
  const int width = whole(next_word(bytes)), height = whole(next_word(bytes));
  if (width < 1 || height < 1) return bad_pfm(file_name, "the size is wrong (expected two whole numbers above 0)");
  if (has_too_many_pixels({width, height}))
    return bad_pfm(file_name, "the size is wrong (expected at most 2^28 pixels)");
  const std::string_view scale = next_word(bytes);
  if (scale.empty()) return bad_pfm(file_name, "the file ends too early (expected the byte order, such as -1.0)");
  const bool little = scale.front() == '-';
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  if (bytes.size() % pixel_bytes != 0 || bytes.size() / pixel_bytes != pixels)
    return bad_pfm(file_name, "there are " + std::to_string(bytes.size()) + " bytes of pixels (expected " +
                                  std::to_string(pixel_bytes) + " for each of " + std::to_string(pixels) + " pixels)");
  Image image{width, height, std::vector<Rgb<float>>(pixels)};
  for (int row = height - 1; row >= 0; --row) {
    for (int column = 0; column < width; ++column) {
      for (int channel = 0; channel < channels; ++channel) {
        std::uint32_t bits = 0;
        std::memcpy(&bits, bytes.data(), 4);
        bytes.remove_prefix(4);
        if (little != (std::endian::native == std::endian::little)) bits = swap_bytes(bits);
        image.at(column, row)[channel] = std::bit_cast<float>(bits);
      }
      if (channels == 1) image.at(column, row) = Rgb<float>(image.at(column, row).x);
    }
  }
  return image;
}

namespace {

/// A PFM of the most pixels; no other format that is read takes more.
constexpr std::size_t max_file_bytes = 12 * static_cast<std::size_t>(max_image_pixels) + 64;

}  // namespace

Result<Image> read_pfm(const std::string& path) {
  const auto bytes = read_file(path, max_file_bytes);
  if (!bytes) return tl::unexpected(bytes.error());
  return decode_pfm(*bytes, path);
}

namespace {

/// Of a format that holds linear floats, by its first bytes; null if it is none.
auto decoder_of_floats(std::string_view bytes) -> Result<Image> (*)(std::string_view, const std::string&) {
  if (bytes.starts_with("PF") || bytes.starts_with("Pf")) return decode_pfm;
  if (bytes.starts_with("\x76\x2f\x31\x01")) return decode_exr;
  if (bytes.starts_with("#?RADIANCE") || bytes.starts_with("#?RGBE")) return decode_hdr;
  return nullptr;
}

}  // namespace

Result<Image> decode_map(std::string_view bytes, const std::string& file_name, ByteMeaning meaning) {
  if (const auto decode = decoder_of_floats(bytes)) return decode(bytes, file_name);
  return decode_png_or_jpeg(bytes, file_name, meaning);
}

Result<Image> read_image(const std::string& path) {
  const auto bytes = read_file(path, max_file_bytes);
  if (!bytes) return tl::unexpected(bytes.error());
  if (const auto decode = decoder_of_floats(*bytes)) return decode(*bytes, path);
  if (!bytes->starts_with("\x89PNG\r\n\x1a\n"))
    return tl::unexpected(Error{path, 0, 0, "this is no picture that can be read (expected a PNG, PFM, EXR or HDR)",
                                "raywalk render writes the first three"});
  return decode_png_or_jpeg(*bytes, path, ByteMeaning::colour, max_image_pixels);
}

}  // namespace raywalk
