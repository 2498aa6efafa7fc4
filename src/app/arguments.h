#pragma once
// Parses the values of options.

#include "render/tiles.h"
#include "scene/scene.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>

namespace raywalk {

/// Digits, and nothing else; a number from `low` to `high`.
[[nodiscard]] std::optional<int> parse_whole(std::string_view text, int low, int high);
/// Digits, and nothing else; up to 2^64 - 1.
[[nodiscard]] std::optional<std::uint64_t> parse_seed(std::string_view text);
/// A finite number that is 0 or more.
[[nodiscard]] std::optional<double> parse_amount(const std::string& text);
/// The same, at most 1.
[[nodiscard]] std::optional<double> parse_share(const std::string& text);

/// "3/7": the third of seven shares.
[[nodiscard]] std::optional<Share> parse_part(const std::string& text);
/// The most shares that a picture is cut into.
inline constexpr int max_parts = 100'000;

/// "640x480": two integers in the range of scene files.
[[nodiscard]] std::optional<ImageSize> parse_size(const std::string& text);

/// Which pixel to step through: a cell of the strip, or a pixel of the image, all from 0.
struct Cell {
  int index;
  friend bool operator==(const Cell&, const Cell&) = default;
};
struct ImagePixel {
  int column, row;
  friend bool operator==(const ImagePixel&, const ImagePixel&) = default;
};
using PixelChoice = std::variant<Cell, ImagePixel>;

/// "7", or "40,12".
[[nodiscard]] std::optional<PixelChoice> parse_pixel(const std::string& text);

}  // namespace raywalk
