#pragma once
// Animated GIF (CompuServe, GIF89a, 1990), by giflib. Each frame has 256 colours of its own for what is new in it.

#include "io/image.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace raywalk {

/// Takes the frames of a film one after the other; of each only what has changed is kept. It plays for ever.
class GifFilm {
 public:
  /// 1 to 65535 pixels each way.
  explicit GifFilm(ImageSize size);
  ~GifFilm();
  GifFilm(const GifFilm&) = delete;
  GifFilm& operator=(const GifFilm&) = delete;

  /// `rgb`: three bytes a pixel, encoded as they are to be shown, row by row from the top. `seconds`: how long it
  /// stays.
  void add(const std::vector<std::uint8_t>& rgb, double seconds);
  /// The file's bytes; the film takes no frame after it. Fails when a frame could not be made.
  [[nodiscard]] Result<std::string> finish();

 private:
  class Encoder;
  std::unique_ptr<Encoder> encoder_;
};

}  // namespace raywalk
