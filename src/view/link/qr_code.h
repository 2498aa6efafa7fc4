#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace raywalk {

/// More letters make the squares too small for a telephone at the other end of a classroom.
inline constexpr std::size_t max_qr_letters = 300;
/// The white border around a code, in squares (ISO/IEC 18004).
inline constexpr int qr_border = 4;

/// A QR code: `side` rows of as many squares, from the top left.
struct QrCode {
  int side = 0;
  std::vector<bool> dark;
  [[nodiscard]] bool is_dark(int column, int row) const {
    return dark[static_cast<std::size_t>(row) * static_cast<std::size_t>(side) + static_cast<std::size_t>(column)];
  }
};
/// Of a text; nothing if it is longer than max_qr_letters.
[[nodiscard]] std::optional<QrCode> qr_code(const std::string& text);

}  // namespace raywalk
