// OpenEXR, by the format's own library (C. Everitt, F. Kainz et al., Industrial Light & Magic 2002; now the Academy
// Software Foundation). Its exceptions are caught here.
#include "image/image_file.h"

#ifdef RAYWALK_EXR
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTileDescription.h>
#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <vector>
#endif

namespace raywalk {

#ifdef RAYWALK_EXR

namespace {

class StringOut : public Imf::OStream {
 public:
  explicit StringOut(std::string& bytes) : OStream("memory"), bytes_(bytes) {}
  void write(const char* data, int size) override {
    // The line offset table is overwritten at the end.
    const auto count = static_cast<std::size_t>(size);
    if (at_ + count > bytes_.size()) bytes_.resize(at_ + count);
    std::memcpy(bytes_.data() + at_, data, count);
    at_ += count;
  }
  std::uint64_t tellp() override { return at_; }
  void seekp(std::uint64_t position) override { at_ = static_cast<std::size_t>(position); }

 private:
  std::string& bytes_;
  std::size_t at_ = 0;
};

class StringIn : public Imf::IStream {
 public:
  explicit StringIn(std::string_view bytes) : IStream("memory"), bytes_(bytes) {}
  bool read(char* to, int size) override {
    const auto count = static_cast<std::size_t>(size);
    if (count > bytes_.size() || at_ > bytes_.size() - count) throw std::runtime_error("the file ends too early");
    std::memcpy(to, bytes_.data() + at_, count);
    at_ += count;
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t position) override {
    at_ = static_cast<std::size_t>(std::min<std::uint64_t>(position, bytes_.size()));
  }

 private:
  std::string_view bytes_;
  std::size_t at_ = 0;
};

/// The channels of pixels: `slice` tells the library how one of them lies in memory. The library takes no const.
template <class Slice>
Imf::FrameBuffer channels_of(const Rgb<float>* pixels, Slice slice) {
  static_assert(sizeof(Rgb<float>) == 3 * sizeof(float));
  char* first = const_cast<char*>(reinterpret_cast<const char*>(pixels));
  Imf::FrameBuffer frame;
  frame.insert("R", slice(first));
  frame.insert("G", slice(first + sizeof(float)));
  frame.insert("B", slice(first + 2 * sizeof(float)));
  return frame;
}
Imf::FrameBuffer channels_of(const Image& image, const Imath::Box2i& window) {
  const std::size_t row = sizeof(Rgb<float>) * static_cast<std::size_t>(image.width);
  return channels_of(image.pixels.data(), [&](const char* first) {
    return Imf::Slice::Make(Imf::FLOAT, first, window, sizeof(Rgb<float>), row);
  });
}
/// Of rows that all have these pixels.
Imf::FrameBuffer channels_of_row(const Rgb<float>* pixels) {
  return channels_of(pixels, [](char* first) { return Imf::Slice(Imf::FLOAT, first, sizeof(Rgb<float>), 0); });
}

/// `fill(file)` writes the pixels.
template <class Fill>
Result<std::string> encode(int width, int height, Imf::Compression compression, Fill fill) {
  std::string bytes;
  try {
    Imf::Header header(width, height);
    header.compression() = compression;
    for (const char* channel : {"R", "G", "B"}) header.channels().insert(channel, Imf::Channel(Imf::FLOAT));
    StringOut stream(bytes);
    Imf::OutputFile file(stream, header, 0);
    fill(file);
    // When the file is closed, here, the line offset table is written.
  } catch (const std::exception& error) {
    return tl::unexpected(Error{"", 0, 0, std::string("the OpenEXR picture cannot be made: ") + error.what(),
                                "choose another size, or write a .pfm"});
  }
  return bytes;
}

/// The header alone, which the library reads without allocating the image.
Imf::Header header_of(std::string_view bytes) {
  StringIn stream(bytes);
  char magic[4];
  unsigned char flags[4];
  stream.read(magic, 4);
  stream.read(reinterpret_cast<char*>(flags), 4);
  int version = flags[0] | flags[1] << 8 | flags[2] << 16;
  if (Imf::isMultiPart(version)) throw std::runtime_error("it has several parts (expected one picture)");
  Imf::Header header;
  header.readFrom(stream, version);
  return header;
}

/// Whether a file of this many bytes can hold the image of this header, and the rows that the library unpacks at once
/// fit into memory. It allocates them before reading, so that a few bytes could demand all memory.
bool can_hold(std::size_t bytes, const Imf::Header& header) {
  const auto size = static_cast<std::int64_t>(bytes);
  const auto window = header.dataWindow();
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  const std::int64_t max_pixels = std::min(max_image_pixels, 4096 * size);  // no compression is tighter
  if (width < 1 || height < 1 || width > max_pixels / height) return false;
  if (height > 32 * size) return false;  // each 256 rows, or fewer, have 8 bytes in the offset table
  std::int64_t pixel = 0;                // bytes
  for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) pixel += 4;
  constexpr std::int64_t max_row_bytes = 1 << 22, max_tile_bytes = 1 << 28;  // bytes
  if (width * pixel > max_row_bytes) return false;
  if (!header.hasTileDescription()) return true;
  const Imf::TileDescription& tile = header.tileDescription();
  return tile.xSize > 0 && tile.ySize > 0 && tile.xSize <= max_row_bytes && tile.ySize <= max_row_bytes &&
         std::int64_t{tile.xSize} * tile.ySize * pixel <= max_tile_bytes;
}

/// The channel that a picture without colours has its light in; empty if it has colours, or no such channel. One of
/// red, green and blue without the others is one that a program wrote for grey (OpenImageIO calls it R): hardly anyone
/// means that the two are black, and viewers show it grey.
std::string grey_channel(const Imf::ChannelList& channels) {
  const auto has = [&](const char* name) { return channels.findChannel(name) != nullptr; };
  std::string primary;
  for (const char* name : {"R", "G", "B"})
    if (has(name)) {
      if (!primary.empty()) return "";
      primary = name;
    }
  if (!primary.empty()) return primary;
  const bool has_colour = has("X") || has("RY") || has("BY");  // CIE XYZ, or differences from the luminance
  if (has("Y") && !has_colour) return "Y";
  const auto first = channels.begin();
  const bool is_only = first != channels.end() && ++channels.begin() == channels.end();
  return is_only ? first.name() : "";
}

std::string names_of(const Imf::ChannelList& channels) {
  constexpr std::size_t most = 100;
  std::string names;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
    if (names.size() > most) return names + ", ...";
    names.append(names.empty() ? "" : ", ").append(channel.name());
  }
  return names;
}

}  // namespace

bool has_exr() { return true; }

Result<std::string> encode_exr(const Image& image) {
  return encode(image.width, image.height, Imf::ZIP_COMPRESSION, [&](Imf::OutputFile& file) {
    file.setFrameBuffer(channels_of(image, file.header().dataWindow()));
    file.writePixels(image.height);
  });
}

Result<std::string> encode_exr(const ImageRows& rows) {
  return encode(rows.width, rows.height, Imf::RLE_COMPRESSION, [&](Imf::OutputFile& file) {
    for (int row = 0; row < rows.begun; ++row) {
      file.setFrameBuffer(channels_of_row(rows.row(row)));
      file.writePixels(1);
    }
    if (rows.begun == rows.height) return;
    const std::vector<Rgb<float>> black(static_cast<std::size_t>(rows.width), Rgb<float>(0));
    file.setFrameBuffer(channels_of_row(black.data()));
    file.writePixels(rows.height - rows.begun);
  });
}

Result<Image> decode_exr(std::string_view bytes, const std::string& file_name) {
  try {
    if (!can_hold(bytes.size(), header_of(bytes)))
      return tl::unexpected(Error{file_name, 0, 0,
                                  "the size of the picture is wrong (expected at most 2^28 pixels, 4 MiB a row, and a "
                                  "file that can hold them)",
                                  "is this the right file?"});
    StringIn stream(bytes);
    Imf::InputFile file(stream, 0);
    const Imf::ChannelList& channels = file.header().channels();
    const std::string grey = grey_channel(channels);
    const bool has_colours = channels.findChannel("R") || channels.findChannel("G") || channels.findChannel("B");
    if (!has_colours && grey.empty())
      return tl::unexpected(Error{file_name, 0, 0,
                                  "the picture has the channels " + names_of(channels) + " (expected R, G and B, or Y)",
                                  "export the layer that is meant by itself, in red, green and blue"});
    const auto window = file.header().dataWindow();
    const int width = window.max.x - window.min.x + 1, height = window.max.y - window.min.y + 1;
    Image image{width, height, {}};
    image.pixels.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    Imf::FrameBuffer frame = channels_of(image, window);
    if (!grey.empty()) {
      const Imf::Slice first = frame["R"];
      frame = Imf::FrameBuffer();
      frame.insert(grey, first);
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    if (!grey.empty())
      for (Rgb<float>& pixel : image.pixels) pixel = Rgb<float>(pixel.x);
    return image;
  } catch (const std::exception& error) {
    return tl::unexpected(Error{file_name, 0, 0,
                                std::string("this is no OpenEXR picture that can be read: ") + error.what(),
                                "is this the right file, and is it whole?"});
  }
}

#else

namespace {
Error without_library(const std::string& file) {
  return {file, 0, 0, "this build of Raywalk knows no OpenEXR", "install libopenexr-dev and build again"};
}
}  // namespace

bool has_exr() { return false; }
Result<std::string> encode_exr(const Image& /*image*/) { return tl::unexpected(without_library("")); }
Result<std::string> encode_exr(const ImageRows& /*rows*/) { return tl::unexpected(without_library("")); }
Result<Image> decode_exr(std::string_view /*bytes*/, const std::string& file_name) {
  return tl::unexpected(without_library(file_name));
}

#endif

}  // namespace raywalk
