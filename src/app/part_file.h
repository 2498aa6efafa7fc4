#pragma once
// The file of one share of a picture, for `raywalk merge`.

#include "render/film.h"
#include "render/tiles.h"
#include "text/error.h"

#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace raywalk {

/// The pixels of a share, and what it was made from.
struct PicturePart {
  Share share;
  ImageSize size{0, 0};  ///< of the film
  bool corners = false;  ///< whether the film is that of the corners of pixels
  Encoding encoding = Encoding::srgb;
  /// What decides the picture, by names that people read: equal in all parts of one.
  std::vector<std::pair<std::string, std::string>> made_from{};
  std::variant<Film<double>, Film<float>> film{};  ///< other pixels mean nothing
};

/// The file that the part of a picture of this name is written to: "classic.png.part-3-of-7".
[[nodiscard]] std::string part_path(const std::string& image, const Share& share);

/// Of some bytes, in letters: tells apart files that were changed, not those that somebody forged.
[[nodiscard]] std::string checksum(std::string_view bytes);

/// Writes it, all or nothing.
[[nodiscard]] Result<void> write_part(const std::string& path, const PicturePart& part);
/// The part of a file, which may have been cut off or changed.
[[nodiscard]] Result<PicturePart> read_part(const std::string& path);

}  // namespace raywalk
