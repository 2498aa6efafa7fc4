#include "image/gif.h"

#include "image/palette.h"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace raywalk {

namespace {

int append(GifFileType* file, const GifByteType* bytes, int size) {
  static_cast<std::string*>(file->UserData)
      ->append(reinterpret_cast<const char*>(bytes), static_cast<std::size_t>(size));
  return size;
}

/// Columns and rows, both ends included.
struct FrameRect {
  int left, top, right, bottom;
  [[nodiscard]] int width() const { return right - left + 1; }
  [[nodiscard]] int height() const { return bottom - top + 1; }
  /// Row by row.
  template <class Visit>
  void each(const Visit& visit) const {
    for (int row = top; row <= bottom; ++row)
      for (int column = left; column <= right; ++column) visit(column, row);
  }
};

}  // namespace

class GifAnimation::Encoder {
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
    // Netscape's extension: the number of repetitions, 0 for endless.
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
    // An unchanged frame repeats one pixel of the previous frame.
    const FrameRect part = changed(rgb).value_or(FrameRect{0, 0, 0, 0});
    const auto is_new = [&](std::size_t at) {
      return shown_.empty() || !std::equal(&rgb[at], &rgb[at] + 3, &shown_[at]);
    };
    const auto colour = [&](std::size_t at) {
      return Rgb24{rgb[at]} << 16 | Rgb24{rgb[at + 1]} << 8 | Rgb24{rgb[at + 2]};
    };
    std::vector<Rgb24> colours;
    part.each([&](int column, int row) {
      if (const std::size_t at = place(column, row); is_new(at)) colours.push_back(colour(at));
    });
    // After the first frame, one index is reserved for "unchanged".
    const FramePalette palette(std::move(colours), shown_.empty() ? 256 : 255);
    const int transparent = shown_.empty() ? NO_TRANSPARENT_COLOR : static_cast<int>(palette.colours().size());
    std::vector<GifByteType> indices;
    part.each([&](int column, int row) {
      const std::size_t at = place(column, row);
      indices.push_back(is_new(at) ? palette.index(colour(at), column, row) : static_cast<GifByteType>(transparent));
    });
    put(part, indices, palette.colours(), transparent, seconds);
    shown_ = rgb;
  }

  Result<std::string> finish() {
    close();
    if (!error_.empty())
      return tl::unexpected(Error{"", 0, 0, "the animation cannot be made: " + error_, "choose a smaller window"});
    return std::move(bytes_);
  }

 private:
  [[nodiscard]] std::size_t place(int column, int row) const {
    return 3 *
           (static_cast<std::size_t>(row) * static_cast<std::size_t>(size_.width) + static_cast<std::size_t>(column));
  }

  /// The smallest part that contains all changes.
  [[nodiscard]] std::optional<FrameRect> changed(const std::vector<std::uint8_t>& rgb) const {
    if (shown_.empty()) return FrameRect{0, 0, size_.width - 1, size_.height - 1};
    std::optional<FrameRect> part;
    for (int row = 0; row < size_.height; ++row) {
      for (int column = 0; column < size_.width; ++column) {
        const std::size_t at = place(column, row);
        if (std::equal(&rgb[at], &rgb[at] + 3, &shown_[at])) continue;
        if (!part) part = FrameRect{column, row, column, row};
        part->left = std::min(part->left, column), part->right = std::max(part->right, column);
        part->bottom = row;
      }
    }
    return part;
  }

  void put(const FrameRect& part, std::vector<GifByteType>& indices, const std::vector<Rgb24>& colours, int transparent,
           double seconds) {
    GraphicsControlBlock control{};
    control.DisposalMode = DISPOSE_DO_NOT;
    control.DelayTime = static_cast<int>(std::clamp(std::round(100 * seconds), 2.0, 65535.0));
    control.TransparentColor = transparent;
    std::array<GifByteType, 4> extension{};
    EGifGCBToExtension(&control, extension.data());
    check(EGifPutExtension(file_, GRAPHICS_EXT_FUNC_CODE, static_cast<int>(extension.size()), extension.data()));
    // A map's size is a power of two; what is not used stays black.
    const int used = std::max(static_cast<int>(colours.size()), transparent + 1);
    ColorMapObject* const map = GifMakeMapObject(std::max(1 << GifBitSize(used), 2), nullptr);
    if (map == nullptr) return fail(E_GIF_ERR_NOT_ENOUGH_MEM);
    for (std::size_t i = 0; i < colours.size(); ++i)
      map->Colors[i] = {static_cast<GifByteType>(colours[i] >> 16), static_cast<GifByteType>(colours[i] >> 8 & 255U),
                        static_cast<GifByteType>(colours[i] & 255U)};
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
  std::vector<std::uint8_t> shown_;  ///< the previous frame; empty before the first
  GifFileType* file_ = nullptr;
};

GifAnimation::GifAnimation(ImageSize size) : encoder_(std::make_unique<Encoder>(size)) {}
GifAnimation::~GifAnimation() = default;
void GifAnimation::add(const std::vector<std::uint8_t>& rgb, double seconds) { encoder_->add(rgb, seconds); }
Result<std::string> GifAnimation::finish() { return encoder_->finish(); }

}  // namespace raywalk
