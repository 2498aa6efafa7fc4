#pragma once
// The cost of each pixel of a picture, as colours.

#include "math/words.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace raywalk {

/// What a heat map shows for each pixel; rays, tests and time at one sample.
enum class Heat {
  none,   ///< no heat map: the picture
  rays,   ///< rays formed
  tests,  ///< accelerator nodes and shapes tested
  time,   ///< microseconds
  noise,  ///< the spread of its samples: the standard deviation of their grey (the mean of red, green and blue)
};
template <>
inline constexpr Word<Heat> words_of<Heat>[] = {{Heat::none, "picture"},
                                                {Heat::rays, "rays"},
                                                {Heat::tests, "tests"},
                                                {Heat::time, "time"},
                                                {Heat::noise, "noise"}};

/// From dark blue to yellow, of uniformly growing lightness and safe for colour-blind people: "cividis" (J. Nunez, C.
/// Anderton and R. Renslow, PLoS ONE 13(7), 2018). `part` in 0..1.
[[nodiscard]] inline std::array<std::uint8_t, 3> heat_colour(double part) {
  constexpr std::array<std::array<double, 3>, 9> scale{{{0, 34, 78},
                                                        {18, 53, 112},
                                                        {59, 73, 108},
                                                        {87, 93, 109},
                                                        {112, 113, 115},
                                                        {138, 134, 120},
                                                        {165, 156, 116},
                                                        {195, 179, 105},
                                                        {254, 232, 56}}};
  const double at = std::clamp(part, 0.0, 1.0) * (scale.size() - 1);
  const auto below = std::min(static_cast<std::size_t>(at), scale.size() - 2);
  const double t = at - static_cast<double>(below);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t i = 0; i < 3; ++i)
    colour[i] = static_cast<std::uint8_t>(scale[below][i] + t * (scale[below + 1][i] - scale[below][i]) + 0.5);
  return colour;
}

}  // namespace raywalk
