#include "io/gif.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace raywalk {

namespace {

constexpr int most_colours = 255, transparent = 255;  // the last index stands for "as before"

int append(GifFileType* file, const GifByteType* bytes, int size) {
  static_cast<std::string*>(file->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  return size;
}

/// Columns and rows, both ends included.
struct Part {
  int left, top, right, bottom;
  [[nodiscard]] int width() const { return right - left + 1; }
  [[nodiscard]] int height() const { return bottom - top + 1; }
};

}  // namespace

class GifFilm::Encoder {
 public:
  explicit Encoder(ImageSize size) : size_(size) {
    int error = 0;
    file_ = EGifOpen(&bytes_, append, &error);
    if (file_ == nullptr) {
      fail(error);
      return;
    }
    EGifSetGifVersion(file_, true);
    check(EGifPutScreenDesc(file_, size.width, size.height, 8, 0, nullptr));
    // Netscape's extension: play it again, 0 for ever.
    const std::array<GifByteType, 3> loop{1, 0, 0};
    check(EGifPutExtensionLeader(file_, APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(file_, 11, "NETSCAPE2.0"));
    check(EGifPutExtensionBlock(file_, static_cast<int>(loop.size()), loop.data()));
    check(EGifPutExtensionTrailer(file_));
  }
  ~Encoder() { close(); }
  Encoder(const Encoder&) = delete;
  Encoder& operator=(const Encoder&) = delete;

  void add(const std::vector<std::uint8_t>& rgb, double seconds) {
    if (file_ == nullptr ||
        rgb.size() != 3 * static_cast<std::size_t>(size_.width) * static_cast<std::size_t>(size_.height))
      return;
    // What stays the same for a while is one pixel of the frame before.
    const Part part = changed(rgb).value_or(Part{0, 0, 0, 0});
    const std::size_t count = static_cast<std::size_t>(part.width()) * static_cast<std::size_t>(part.height());
    std::array<std::vector<GifByteType>, 3> channels;
    std::vector<bool> same(count);
    for (auto& channel : channels) channel.resize(count);
    std::size_t i = 0;
    for (int row = part.top; row <= part.bottom; ++row) {
      for (int column = part.left; column <= part.right; ++column, ++i) {
        const std::size_t at = place(column, row);
        for (std::size_t c = 0; c < 3; ++c) channels[c][i] = rgb[at + c];
        same[i] = !shown_.empty() && std::equal(&rgb[at], &rgb[at] + 3, &shown_[at]);
      }
    }
    std::vector<GifByteType> indices(count);
    std::array<GifColorType, 256> colours{};
    int used = most_colours;
    if (GifQuantizeBuffer(static_cast<unsigned>(part.width()), static_cast<unsigned>(part.height()), &used,
                          channels[0].data(), channels[1].data(), channels[2].data(), indices.data(),
                          colours.data()) == GIF_ERROR)
      return fail(E_GIF_ERR_NOT_ENOUGH_MEM);
    for (i = 0; i < count; ++i)
      if (same[i]) indices[i] = transparent;
    put(part, indices, colours, seconds);
    shown_ = rgb;
  }

  Result<std::string> finish() {
    close();
    if (!error_.empty())
      return tl::unexpected(Error{"", 0, 0, "the film cannot be made: " + error_, "choose a smaller window"});
    return std::move(bytes_);
  }

 private:
  [[nodiscard]] std::size_t place(int column, int row) const {
    return 3 *
           (static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(column));
  }

  /// The smallest part that holds all that is not as it was.
  [[nodiscard]] std::optional<Part> changed(const std::vector<std::uint8_t>& rgb) const {
    if (shown_.empty()) return Part{0, 0, size_.width - 1, size_.height - 1};
    std::optional<Part> part;
    for (int row = 0; row < size_.height; ++row) {
      for (int column = 0; column < size_.width; ++column) {
        const std::size_t at = place(column, row);
        if (std::equal(&rgb[at], &rgb[at] + 3, &shown_[at])) continue;
        if (!part) part = Part{column, row, column, row};
        part->left = std::min(part->left, column), part->right = std::max(part->right, column);
        part->bottom = row;
      }
    }
    return part;
  }

  void put(const Part& part, std::vector<GifByteType>& indices, const std::array<GifColorType, 256>& colours,
           double seconds) {
    GraphicsControlBlock control{};
    control.DisposalMode = DISPOSE_DO_NOT;
    control.DelayTime = static_cast<int>(std::clamp(std::round(100 * seconds), 2.0, 65535.0));
    control.TransparentColor = transparent;
    std::array<GifByteType, 4> extension{};
    EGifGCBToExtension(&control, extension.data());
    check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(extension.size()), extension.data()));
    ColorMapObject* const map = GifMakeMapObject(256, colours.data());
    if (map == nullptr) return fail(E_GIF_ERR_NOT_ENOUGH_MEM);
    check(EGifPutImageDesc(file_, part.left, part.top, part.width(), part.height(), false, map));
    GifFreeMapObject(map);
    for (int row = 0; row < part.height(); ++row)
      check(EGifPutLine(file_, &indices[static_cast<std::size_t>(row) * static_cast<std::size_t>(part.width())],
                        part.width()));
  }

  void check(int result) {
    if (result == GIF_ERROR) fail(file_->Error);
  }
  void fail(int error) {
    const char* why = GifErrorString(error);
    if (error_.empty()) error_ = why == nullptr ? "unknown error" : why;
  }
  void close() {
    int error = 0;
    if (file_ != nullptr && EGifCloseFile(file_, &error) == GIF_ERROR) fail(error);
    file_ = nullptr;
  }

  ImageSize size_;
  std::string bytes_, error_;
  std::vector<std::uint8_t> shown_;  ///< the frame before; empty before the first
  GifFileType* file_ = nullptr;
};

GifFilm::GifFilm(ImageSize size) : encoder_(std::make_unique<Encoder>(size)) {}
GifFilm::~GifFilm() = default;
void GifFilm::add(const std::vector<std::uint8_t>& rgb, double seconds) { encoder_->add(rgb, seconds); }
Result<std::string> GifFilm::finish() { return encoder_->finish(); }

}  // namespace raywalk
