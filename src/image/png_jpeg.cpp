#include "image/image_file.h"

#include "text/memory.h"

#include <fmt/format.h>

#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
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
  constexpr double bytes_each = 6 + sizeof(Rgb<float>);  // as it is decoded, at most, and as it is kept
  if (auto large = why_too_large({fmt::format("an image of {} x {} pixels", width, height),
                                  bytes_each * static_cast<double>(width * height), "make it smaller"},
                                 file))
    return tl::unexpected(std::move(*large));
  return {};
}

tl::unexpected<Error> damaged(const std::string& file, const std::string& why) {
  return no_texture(file, fmt::format("the image is damaged: {}", why), "is the file whole?");
}

/// Red, green and blue, row by row from the top: a byte each, or two, the higher one first.
struct Samples {
  int width = 0, height = 0;
  bool has_16_bits = false;
  std::vector<std::uint8_t> bytes{};
};

/// A PNG in memory, by libpng, whose errors are jumps: what it jumps out of has nothing to destroy. Not by its
/// simplified interface, which mixes the rows of interlaced pictures of 16 bits (its issue 853) and multiplies 16 bits
/// by their alpha.
class PngReader {
 public:
  explicit PngReader(std::string_view bytes)
      : rest_(bytes), png_(png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore)) {
    if (png_ == nullptr) return;
    info_ = png_create_info_struct(png_);
    png_set_read_fn(png_, this, give);
  }
  ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngReader(const PngReader&) = delete;
  PngReader& operator=(const PngReader&) = delete;

  /// All that stands before the pixels; false if that is damaged.
  [[nodiscard]] bool read_head() {
    if (info_ == nullptr) return false;
    return attempt([&] {
      png_set_benign_errors(png_, 1);
      png_read_info(png_, info_);
    });
  }
  [[nodiscard]] std::uint32_t width() const { return png_get_image_width(png_, info_); }
  [[nodiscard]] std::uint32_t height() const { return png_get_image_height(png_, info_); }

  /// Once, after the head; false if the picture is damaged. Colours have 8 bits, and are in sRGB, from what the file
  /// says that they are in. Numbers are as they stand there. Transparent pixels keep theirs.
  [[nodiscard]] bool read(ByteMeaning meaning, Samples& samples) {
    int passes = 1;
    if (!attempt([&] { passes = passes_of(meaning); })) return false;
    const std::size_t row_bytes = png_get_rowbytes(png_, info_);
    samples.width = static_cast<int>(width()), samples.height = static_cast<int>(height());
    samples.has_16_bits = png_get_bit_depth(png_, info_) == 16;
    samples.bytes.resize(row_bytes * height());
    return attempt([&] {
      for (int pass = 0; pass < passes; ++pass)
        for (std::uint32_t row = 0; row < height(); ++row)
          png_read_row(png_, samples.bytes.data() + row * row_bytes, nullptr);
    });
  }
  [[nodiscard]] const char* what_failed() const { return why_.data(); }

 private:
  /// False if `work` jumped. Never inlined, so that what its callers have in registers survives that.
  template <class Work>
  [[gnu::noinline]] bool attempt(const Work& work) {
    if (setjmp(before_) != 0) return false;
    work();
    return true;
  }
  [[noreturn]] static void fail(png_structp png, png_const_charp message) {
    auto& reader = *static_cast<PngReader*>(png_get_error_ptr(png));
    reader.why_.back() = '\0';
    std::strncpy(reader.why_.data(), message, reader.why_.size() - 1);
    std::longjmp(reader.before_, 1);
  }
  static void ignore(png_structp /*png*/, png_const_charp /*warning*/) {}
  static void give(png_structp png, png_bytep to, std::size_t size) {
    std::string_view& rest = static_cast<PngReader*>(png_get_io_ptr(png))->rest_;
    if (size > rest.size()) png_error(png, "read beyond end of data");
    std::memcpy(to, rest.data(), size);
    rest.remove_prefix(size);
  }
  /// Asks for red, green and blue; how often the rows are read for that.
  [[nodiscard]] int passes_of(ByteMeaning meaning) {
    png_set_expand(png_);
    png_set_gray_to_rgb(png_);
    png_set_strip_alpha(png_);
    if (meaning == ByteMeaning::colour) {
      png_set_alpha_mode(png_, PNG_ALPHA_PNG, PNG_DEFAULT_sRGB);  // also what is meant if the file says nothing
      png_set_scale_16(png_);
    }
    const int passes = png_set_interlace_handling(png_);
    png_read_update_info(png_, info_);
    return passes;
  }

  std::string_view rest_;
  std::array<char, 100> why_{"out of memory"};
  std::jmp_buf before_;
  png_structp png_;
  png_infop info_ = nullptr;
};

Result<Samples> decode_png(std::string_view bytes, const std::string& file, ByteMeaning meaning,
                           std::int64_t max_pixels) {
  PngReader reader(bytes);
  if (!reader.read_head()) return damaged(file, reader.what_failed());
  if (auto small = check_size(file, reader.width(), reader.height(), max_pixels); !small)
    return tl::unexpected(small.error());
  Samples samples;
  if (!reader.read(meaning, samples)) return damaged(file, reader.what_failed());
  return samples;
}

Result<Samples> decode_jpeg(std::string_view bytes, const std::string& file, std::int64_t max_pixels) {
  const std::unique_ptr<void, decltype(&tjDestroy)> decoder(tjInitDecompress(), tjDestroy);
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const auto size = static_cast<unsigned long>(bytes.size());
  Samples decoded;
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
  const Result<Samples> samples =
      png ? decode_png(bytes, file_name, meaning, max_pixels) : decode_jpeg(bytes, file_name, max_pixels);
  if (!samples) return tl::unexpected(samples.error());

  std::array<float, 256> linear{};
  for (std::size_t i = 0; i < linear.size(); ++i)
    linear[i] = static_cast<float>(meaning == ByteMeaning::colour ? srgb_decode(static_cast<double>(i) / 255)
                                                                  : static_cast<double>(i) / 255);
  const std::uint8_t* at = samples->bytes.data();
  const auto next = [&] {
    if (!samples->has_16_bits) return linear[*at++];
    const int number = at[0] << 8 | at[1];
    at += 2;
    return static_cast<float>(number / 65535.0);
  };
  Image picture{samples->width, samples->height, {}};
  const std::size_t pixels = static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height);
  picture.pixels.reserve(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const float red = next(), green = next(), blue = next();
    picture.pixels.emplace_back(red, green, blue);
  }
  return picture;
}

}  // namespace raywalk
