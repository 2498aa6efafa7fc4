#pragma once

#include "view/drawing/theme.h"

#include <algorithm>
#include <cmath>

namespace raywalk::test {

/// Contrast as WCAG 2.1 defines it, from 1 to 21.
inline double contrast(Colour a, Colour b) {
  const auto luminance = [](Colour c) {
    const auto linear = [](std::uint8_t v) {
      const double s = v / 255.0;
      return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b);
  };
  const double x = luminance(a), y = luminance(b);
  return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

}  // namespace raywalk::test
