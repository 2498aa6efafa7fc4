#include "scene/sky.h"

#include <algorithm>
#include <cmath>

namespace raywalk {

std::optional<std::pair<std::string, std::string>> why_no_sky(const Image& picture) {
  using Why = std::pair<std::string, std::string>;
  constexpr std::int64_t most = std::int64_t{1} << 25;
  const std::int64_t width = picture.width, height = picture.height;
  const auto size = [&] { return std::to_string(width) + " x " + std::to_string(height) + " pixels"; };
  if (width != 2 * height)
    return Why{"the picture of a sky has " + size() + " (expected twice as many columns as rows)",
               "a sky has all longitudes from left to right, 360 degrees, and all latitudes from top to bottom, 180"};
  if (width * height > most)
    return Why{"the picture of a sky has " + size() + " (expected at most 8192 x 4096)", "make it smaller"};
  bool black = true;
  for (std::int64_t i = 0; i < width * height; ++i) {
    const Rgb<float>& pixel = picture.pixels[static_cast<std::size_t>(i)];
    constexpr float brightest = 1e12F;  // as of every light, so that a few bounces stay in range
    for (const float light : {pixel.x, pixel.y, pixel.z}) {
      if (light >= 0 && light <= brightest) continue;
      const std::string what = std::isnan(light)   ? "NaN, which is no number"
                               : light < 0         ? "negative light"
                               : std::isinf(light) ? "infinite light"
                                                   : "light above 1e12";
      return Why{"the pixel in column " + std::to_string(i % width) + " of row " + std::to_string(i / width) +
                     ", counted from 0 at the top left, holds " + what + " (expected numbers from 0 to 1e12)",
                 "a program that edits pictures can clamp it"};
    }
    black = black && is_black(pixel);
  }
  if (black)
    return Why{"the sky is wholly black (expected some light in it)", "for a scene without a sky, leave [sky] out"};
  return std::nullopt;
}

}  // namespace raywalk
