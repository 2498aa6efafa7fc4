#pragma once

#include "gui/window.h"
#include "image/image.h"

#include <chrono>
#include <cstdint>
#include <vector>

namespace raywalk {

/// A picture that is being refined, as it was last shown.
class ShownPicture {
 public:
  /// Uploads the picture of this revision, unless it is shown already; while more is to come, every so many seconds.
  /// Returns whether it did.
  bool show(std::uint64_t revision, ImageSize size, const std::vector<std::uint8_t>& rgba, bool more, double every) {
    const Clock::time_point now = Clock::now();
    if (revision == revision_ || (more && std::chrono::duration<double>(now - at_).count() < every)) return false;
    if (size.width > 0) texture_.upload(size.width, size.height, rgba.data());
    revision_ = revision;
    at_ = now;
    return true;
  }
  /// What was shown has been lost.
  void show_again(ImageSize size, const std::vector<std::uint8_t>& rgba) {
    if (texture_.id() == 0) return;
    texture_.forget();
    texture_.upload(size.width, size.height, rgba.data());
  }
  [[nodiscard]] unsigned texture() const { return texture_.id(); }

 private:
  using Clock = std::chrono::steady_clock;
  Texture texture_;
  std::uint64_t revision_ = 0;
  Clock::time_point at_{};
};

}  // namespace raywalk
