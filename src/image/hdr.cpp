// Radiance's pictures: a mantissa for each of red, green and blue and one exponent for all, run-length coded (G. Ward,
// "Real Pixels", Graphics Gems II, 1991; the format is that of Radiance's file formats by the same author).
#include "image/image_file.h"
#include "text/toml_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <vector>

namespace raywalk {

namespace {

/// Takes bytes from the front; past the end it has failed and gives zeros.
class HdrBytes {
 public:
  explicit HdrBytes(std::string_view bytes) : bytes_(bytes) {}
  [[nodiscard]] bool has_failed() const { return failed_; }
  std::uint8_t next() {
    if (bytes_.empty()) {
      failed_ = true;
      return 0;
    }
    const auto byte = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return byte;
  }
  /// Whether the next bytes begin a row of this many pixels whose channels are coded one by one.
  [[nodiscard]] bool begins_row_of_channels(std::size_t width) const {
    const auto at = [&](std::size_t i) { return static_cast<std::uint8_t>(bytes_[i]); };
    constexpr std::size_t narrowest = 8, widest = 0x7fff;
    return width >= narrowest && width <= widest && bytes_.size() >= 4 && at(0) == 2 && at(1) == 2 &&
           at(2) == width >> 8 && at(3) == (width & 0xff);
  }

 private:
  std::string_view bytes_;
  bool failed_ = false;
};

struct Rgbe {
  std::uint8_t mantissas[3], exponent;
};

/// Radiance of a pixel that was multiplied by `factors`.
Rgb<float> colour_of(const Rgbe& pixel, const Rgbd& factors) {
  if (pixel.exponent == 0) return Rgb<float>(0);
  constexpr int bias = 128 + 8;  // of the exponent, and the bits of a mantissa
  const auto channel = [&](int i) {
    return static_cast<float>(std::ldexp(static_cast<double>(pixel.mantissas[i]), pixel.exponent - bias) / factors[i]);
  };
  return {channel(0), channel(1), channel(2)};
}

/// Each channel of the row by itself, in runs of one byte and in stretches of several.
bool read_channels(HdrBytes& bytes, std::vector<Rgbe>& row) {
  for (int skipped = 0; skipped < 4; ++skipped) bytes.next();
  for (int channel = 0; channel < 4; ++channel) {
    const auto value_at = [&](std::size_t i) -> std::uint8_t& {
      return channel < 3 ? row[i].mantissas[channel] : row[i].exponent;
    };
    for (std::size_t at = 0; at < row.size();) {
      const std::uint8_t code = bytes.next();
      const bool is_run = code > 128;
      const std::size_t count = is_run ? code - 128U : code;
      if (bytes.has_failed() || count == 0 || count > row.size() - at) return false;
      const std::uint8_t same = is_run ? bytes.next() : std::uint8_t{0};
      for (std::size_t i = 0; i < count; ++i) value_at(at++) = is_run ? same : bytes.next();
    }
  }
  return !bytes.has_failed();
}

/// Pixel by pixel, four bytes each; (1, 1, 1, n) repeats the one before n times, and further such ones 256 n times.
bool read_pixels(HdrBytes& bytes, std::vector<Rgbe>& row) {
  int shift = 0;
  for (std::size_t at = 0; at < row.size();) {
    Rgbe pixel{};
    for (std::uint8_t& mantissa : pixel.mantissas) mantissa = bytes.next();
    pixel.exponent = bytes.next();
    if (bytes.has_failed()) return false;
    const bool repeats = pixel.mantissas[0] == 1 && pixel.mantissas[1] == 1 && pixel.mantissas[2] == 1;
    if (!repeats) {
      row[at++] = pixel;
      shift = 0;
      continue;
    }
    constexpr int most = 16;
    const std::size_t count = shift > most ? row.size() : std::size_t{pixel.exponent} << shift;
    if (at == 0 || count > row.size() - at) return false;
    for (std::size_t i = 0; i < count; ++i, ++at) row[at] = row[at - 1];
    shift += 8;
  }
  return true;
}

/// Multiplies `factors` by what a line of the head says that the pixels were multiplied by: "EXPOSURE=NUMBER" all
/// alike, "COLORCORR=RED GREEN BLUE" by channel. There may be several of both. False if it is not above 0.
bool multiply_by(std::string_view line, Rgbd& factors) {
  const bool by_channel = line.starts_with("COLORCORR=");
  if (!by_channel && !line.starts_with("EXPOSURE=")) return true;
  std::string_view rest = line.substr(line.find('=') + 1);
  const auto next = [&] {
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t"), rest.size()));
    const std::string_view word = rest.substr(0, rest.find_first_of(" \t"));
    rest.remove_prefix(word.size());
    return toml_text::read_number(word).value_or(0);
  };
  Rgbd by(0.0);
  for (int i = 0; i < 3; ++i) by[i] = by_channel || i == 0 ? next() : by[0];
  factors *= by;
  const auto is_fit = [](double factor) { return factor > 0 && std::isfinite(factor); };
  return rest.find_first_not_of(" \t") == std::string_view::npos && is_fit(factors.x) && is_fit(factors.y) &&
         is_fit(factors.z);
}

/// "-Y HEIGHT +X WIDTH": rows from the top, pixels from the left; 0 x 0 for anything else.
ImageSize size_in(std::string_view line) {
  ImageSize size{0, 0};
  const auto take = [&](std::string_view word) {
    const bool there = line.starts_with(word);
    if (there) line.remove_prefix(word.size());
    return there;
  };
  const auto whole = [&](int& number) {
    const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), number);
    line.remove_prefix(static_cast<std::size_t>(end - line.data()));
    return error == std::errc() && number > 0;
  };
  if (take("-Y ") && whole(size.height) && take(" +X ") && whole(size.width) && line.empty()) return size;
  return {0, 0};
}

}  // namespace

Result<Image> decode_hdr(std::string_view bytes, const std::string& file_name) {
  const auto bad = [&](const std::string& what) {
    return tl::unexpected(Error{file_name, 0, 0, "this is no Radiance picture that can be read: " + what,
                                "is it whole, with rows from the top? .pfm and .exr hold the same numbers"});
  };
  bool knows_format = false;
  Rgbd factors(1.0);
  const auto next_line = [&] {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    const std::string_view line = bytes.substr(0, end);
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
  };
  for (;;) {
    if (bytes.empty()) return bad("its head does not end (expected an empty line)");
    const std::string_view line = next_line();
    if (line.empty()) break;
    knows_format = knows_format || line == "FORMAT=32-bit_rle_rgbe";
    if (!multiply_by(line, factors)) return bad("it says " + std::string(line.substr(0, 60)) + " (expected above 0)");
  }
  if (!knows_format) return bad("it does not say FORMAT=32-bit_rle_rgbe (expected red, green and blue)");
  const ImageSize size = size_in(next_line());
  if (size.width == 0) return bad("its size is wrong (expected \"-Y HEIGHT +X WIDTH\")");
  // Four runs of at most 127 pixels in 8 bytes, each row by itself, or repeats of 255 and more in 4.
  constexpr std::int64_t most_in_a_byte = 1 << 16;
  if (has_too_many_pixels(size) ||
      std::int64_t{size.width} * size.height > most_in_a_byte * static_cast<std::int64_t>(bytes.size()))
    return bad("its size is wrong (expected at most 2^28 pixels, and a file that can hold them)");
  Image image{size.width, size.height, {}};
  HdrBytes from(bytes);
  std::vector<Rgbe> row(static_cast<std::size_t>(size.width));
  for (int y = 0; y < size.height; ++y) {
    const bool whole = from.begins_row_of_channels(row.size()) ? read_channels(from, row) : read_pixels(from, row);
    if (!whole) return bad("row " + std::to_string(y) + " of the picture, counted from 0, is broken");
    for (const Rgbe& pixel : row) image.pixels.push_back(colour_of(pixel, factors));
  }
  return image;
}

}  // namespace raywalk
