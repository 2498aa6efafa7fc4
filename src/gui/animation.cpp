#include "gui/animation.h"

#include "text/file.h"
#include "view/export/export.h"

#include <algorithm>

namespace raywalk {

WalkAnimation::WalkAnimation(const State& state)
    : positions_(animation_positions(state)), seconds_(std::clamp(1 / state.walk.lines_per_second, 0.05, 2.0)) {}

bool WalkAnimation::take(const Image& window) {
  constexpr double last_seconds = 2;
  const ImageSize size{window.width, window.height};
  if (!gif_) {
    size_ = size;
    gif_ = std::make_unique<GifAnimation>(size);
  }
  if (size.width != size_.width || size.height != size_.height) return false;
  const bool more = ++next_ < positions_.size();
  gif_->add(bytes_of(window, Encoding::srgb), more ? seconds_ : last_seconds);
  return more;
}

Result<void> WalkAnimation::write(const std::string& path) {
  if (!gif_) return {};
  const Result<std::string> bytes = gif_->finish();
  if (!bytes) return tl::unexpected(bytes.error());
  return write_file_atomically(path, *bytes);
}

}  // namespace raywalk
