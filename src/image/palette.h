#pragma once
// Colour quantization. Distances are perceptual, in OKLab (Bjoern Ottosson, "A perceptual color space for image
// processing", 2020).

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace raywalk {

/// 0xRRGGBB, encoded for display.
using Rgb24 = std::uint32_t;

/// Lightness, green to red, blue to yellow; a distance of 0.02 is just noticeable.
using Lab = std::array<float, 3>;
[[nodiscard]] Lab lab_of(Rgb24 colour);

class FramePalette {
 public:
  /// The best `most` colours, 2 to 256, for pixels of these colours: all of them, if they are few enough. Colours that
  /// cover much, such as a drawing's backgrounds, are kept exactly.
  FramePalette(std::vector<Rgb24> pixels, int most);

  [[nodiscard]] const std::vector<Rgb24>& colours() const { return colours_; }
  /// Which of colours() shows one of `pixels` at this place. If none is close enough, neighbouring places are dithered:
  /// always in the same way, so that frames do not flicker.
  [[nodiscard]] std::uint8_t index(Rgb24 colour, int column, int row) const;

 private:
  static constexpr int parts = 16;  ///< of a mixture
  using Mixture = std::array<std::uint8_t, parts>;

  std::vector<Rgb24> colours_;
  std::unordered_map<Rgb24, std::uint32_t> mixture_of_;  ///< of each colour of the pixels, in mixtures_
  std::vector<Mixture> mixtures_;
};

}  // namespace raywalk
