#include "image/quick_image.h"

#include "image/image_file.h"
#include "text/file.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <zlib.h>

namespace raywalk {

namespace {

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

/// A PNG (ISO/IEC 15948) without filters, packed as fast as zlib can.
class PngWriter {
 public:
  explicit PngWriter(FileWriter& file) : file_(file) {
    if (deflateInit(&stream_, Z_BEST_SPEED) != Z_OK) throw std::bad_alloc();
  }
  ~PngWriter() { deflateEnd(&stream_); }
  PngWriter(const PngWriter&) = delete;
  PngWriter& operator=(const PngWriter&) = delete;

  Result<void> begin(int width, int height, Encoding encoding) {
    if (auto written = file_.write("\x89PNG\r\n\x1a\n"); !written) return written;
    using namespace std::string_view_literals;
    const auto side = [](int pixels) { return big_endian(static_cast<std::uint32_t>(pixels)); };
    if (auto written = chunk("IHDR", side(width).append(side(height)).append("\x08\x02\0\0\0"sv)); !written)
      return written;
    return encoding == Encoding::srgb ? chunk("sRGB", "\0"sv) : Result<void>();
  }
  Result<void> row(std::span<const std::uint8_t> bytes) {
    constexpr std::array<std::uint8_t, 1> no_filter{0};
    if (auto packed = pack(no_filter, Z_NO_FLUSH); !packed) return packed;
    return pack(bytes, Z_NO_FLUSH);
  }
  Result<void> end() {
    if (auto packed = pack({}, Z_FINISH); !packed) return packed;
    return chunk("IEND", "");
  }

 private:
  Result<void> chunk(std::string_view name, std::string_view data) {
    const std::string content = std::string(name).append(data);
    const auto sum = crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size()));
    return file_.write(big_endian(static_cast<std::uint32_t>(data.size())) + content +
                       big_endian(static_cast<std::uint32_t>(sum)));
  }
  /// What is packed goes into the file whenever the buffer is full, and at the end.
  Result<void> pack(std::span<const std::uint8_t> bytes, int flush) {
    stream_.next_in = const_cast<Bytef*>(bytes.data());  // zlib takes no const
    stream_.avail_in = static_cast<uInt>(bytes.size());
    for (;;) {
      const int state = deflate(&stream_, flush);
      const std::size_t packed = buffer_.size() - stream_.avail_out;
      if (stream_.avail_out != 0 && state != Z_STREAM_END) return {};
      if (auto written = chunk("IDAT", std::string_view(buffer_.data(), packed)); !written) return written;
      stream_.next_out = reinterpret_cast<Bytef*>(buffer_.data());
      stream_.avail_out = static_cast<uInt>(buffer_.size());
      if (state == Z_STREAM_END) return {};
    }
  }

  FileWriter& file_;
  std::vector<char> buffer_ = std::vector<char>(std::size_t{1} << 20);
  z_stream stream_ = [this] {
    z_stream stream{};
    stream.next_out = reinterpret_cast<Bytef*>(buffer_.data());
    stream.avail_out = static_cast<uInt>(buffer_.size());
    return stream;
  }();
};

Result<void> write_png(FileWriter& file, const ImageRows& rows, Encoding encoding) {
  PngWriter png(file);
  const auto width = static_cast<std::size_t>(rows.width);
  if (auto begun = png.begin(rows.width, rows.height, encoding); !begun) return begun;
  for (int row = 0; row < rows.begun; ++row)
    if (auto written = png.row(bytes_of({rows.row(row), width}, encoding)); !written) return written;
  const std::vector<std::uint8_t> black(3 * width);
  for (int row = rows.begun; row < rows.height; ++row)
    if (auto written = png.row(black); !written) return written;
  return png.end();
}

/// Bottom row first, little-endian.
Result<void> write_pfm(FileWriter& file, const ImageRows& rows) {
  const auto width = static_cast<std::size_t>(rows.width);
  if (auto written = file.write(pfm_header(rows.width, rows.height)); !written) return written;
  const std::size_t below = width * static_cast<std::size_t>(rows.height - rows.begun);
  if (auto written = file.write_zeros(below * sizeof(Rgb<float>)); !written) return written;
  for (int row = rows.begun - 1; row >= 0; --row)
    if (auto written = file.write(pfm_bytes({rows.row(row), width})); !written) return written;
  return {};
}

Result<void> write_exr(FileWriter& file, const std::string& path, const ImageRows& rows) {
  auto bytes = encode_exr(rows);
  if (bytes) return file.write(*bytes);
  bytes.error().file = path;
  return tl::unexpected(bytes.error());
}

}  // namespace

Result<void> write_image_quickly(const std::string& path, const ImageRows& rows, Encoding encoding) {
  const auto format = image_format_of(path);
  if (!format) return tl::unexpected(format.error());
  FileWriter file;
  if (auto opened = file.open(path); !opened) return opened;
  const auto written = *format == ImageFormat::png   ? write_png(file, rows, encoding)
                       : *format == ImageFormat::pfm ? write_pfm(file, rows)
                                                     : write_exr(file, path, rows);
  if (!written) return written;
  return file.commit();
}

}  // namespace raywalk
