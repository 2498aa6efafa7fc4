#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace raywalk::test {

/// A picture of bytes, three a pixel, row 0 at the top.
struct Picture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> bytes;
};

/// Empty when `png` is no picture.
[[nodiscard]] Picture decode_png(const std::string& png);

}  // namespace raywalk::test
