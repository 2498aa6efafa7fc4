#pragma once

#include "image/image.h"
#include "image/srgb.h"
#include "text/error.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace raywalk {

enum class ImageFormat { png, pfm, exr };

/// Whether this build can write and read OpenEXR files.
[[nodiscard]] bool has_exr();

/// The format that the extension of `path` names, in either case. To be checked before a long render, not after.
[[nodiscard]] Result<ImageFormat> image_format_of(const std::string& path);

/// 8 bits per channel, three bytes per pixel, row by row from the top. NaN is painted full magenta, to stand out.
[[nodiscard]] std::vector<std::uint8_t> bytes_of(std::span<const Rgb<float>> pixels, Encoding encoding);
[[nodiscard]] inline std::vector<std::uint8_t> bytes_of(const Image& image, Encoding encoding) {
  return bytes_of(image.pixels, encoding);
}
[[nodiscard]] Result<std::string> encode_png(const Image& image, Encoding encoding = Encoding::srgb);
/// Portable float map: linear, bottom row first, little-endian; NaN is preserved.
[[nodiscard]] std::string encode_pfm(const Image& image);
[[nodiscard]] std::string pfm_header(int width, int height);
/// What stands there of some pixels of a row.
[[nodiscard]] std::string pfm_bytes(std::span<const Rgb<float>> pixels);

/// OpenEXR: linear, 32-bit floats, packed without loss; rows with little effort. Fails in a build without the library.
[[nodiscard]] Result<std::string> encode_exr(const Image& image);
[[nodiscard]] Result<std::string> encode_exr(const ImageRows& rows);

/// Writes the format that the extension names, all or nothing. The encoding applies to 8-bit formats.
[[nodiscard]] Result<void> write_image(const std::string& path, const Image& image, Encoding encoding = Encoding::srgb);

/// Reads a PFM of either byte order, in colours (PF) or grey (Pf).
[[nodiscard]] Result<Image> decode_pfm(std::string_view bytes, const std::string& file_name);
[[nodiscard]] Result<Image> read_pfm(const std::string& path);

/// Reads the red, green and blue of an OpenEXR file, where one that is missing is black. Grey is its luminance (Y), the
/// only one of red, green and blue that it has, or else its only channel.
[[nodiscard]] Result<Image> decode_exr(std::string_view bytes, const std::string& file_name);

/// Reads a Radiance picture (.hdr), as the radiance before what its head says that it was multiplied by (EXPOSURE and
/// COLORCORR).
[[nodiscard]] Result<Image> decode_hdr(std::string_view bytes, const std::string& file_name);

/// What the bytes of a PNG or JPEG are.
enum class ByteMeaning {
  colour,  ///< sRGB, to be decoded to linear light
  number,  ///< numbers from 0 to 1: over 255, or 65535 where there are 16 bits a channel
};

/// The most pixels of a texture.
inline constexpr std::int64_t max_texture_pixels = std::int64_t{1} << 26;
/// Reads a PNG or JPEG: colours with 8 bits a channel, numbers with the 16 that a PNG may have. `file_name` is for
/// messages only.
[[nodiscard]] Result<Image> decode_png_or_jpeg(std::string_view bytes, const std::string& file_name,
                                               ByteMeaning meaning = ByteMeaning::colour,
                                               std::int64_t max_pixels = max_texture_pixels);

/// Reads a PNG (8 bits a channel, from sRGB to linear light), a PFM, an OpenEXR or a Radiance picture, detected by its
/// first bytes.
[[nodiscard]] Result<Image> read_image(const std::string& path);
/// The same, or a JPEG. What a file holds in floats is linear, whatever `meaning`.
[[nodiscard]] Result<Image> decode_map(std::string_view bytes, const std::string& file_name, ByteMeaning meaning);

}  // namespace raywalk
