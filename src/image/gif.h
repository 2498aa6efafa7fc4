#pragma once
// Animated GIF (CompuServe, GIF89a, 1990), by giflib. Each frame has its own 256 colours for what has changed.

#include "image/image_file.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace raywalk {

/// Takes the frames of an animation in order and keeps only what has changed in each. It loops endlessly.
class GifAnimation {
 public:
  /// 1 to 65535 pixels per side.
  explicit GifAnimation(ImageSize size);
  ~GifAnimation();
  GifAnimation(const GifAnimation&) = delete;
  GifAnimation& operator=(const GifAnimation&) = delete;

  /// `rgb`: three bytes per pixel, encoded for display, row by row from the top. `seconds`: its duration.
  void add(const std::vector<std::uint8_t>& rgb, double seconds);
  /// The file's bytes; no frame can be added afterwards. Fails if a frame could not be made.
  [[nodiscard]] Result<std::string> finish();

 private:
  class Encoder;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace raywalk
