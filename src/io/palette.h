#pragma once
// Few colours in place of many. Colours are told apart as eyes do, in OKLab (Bjoern Ottosson, "A perceptual color space
// for image processing", 2020).

#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace raywalk {

/// 0xRRGGBB, encoded as it is shown.
using Rgb24 = std::uint32_t;

/// Lightness, green to red, blue to yellow; a distance of 0.02 can just be seen.
using Lab = std::array<float, 3>;
[[nodiscard]] Lab lab_of(Rgb24 colour);

class FramePalette {
 public:
  /// The best `most` colours, 2 to 256, for pixels of these colours: all that there are, where they are no more. What
  /// covers much, as a drawing's grounds do, keeps its very colour.
  FramePalette(std::vector<Rgb24> pixels, int most);

  [[nodiscard]] const std::vector<Rgb24>& colours() const { return colours_; }
  /// Which of colours() shows one of `pixels` at this place. Where none comes near enough, neighbouring places take
  /// several that are right in the mean: the same ones each time, so that nothing flickers from frame to frame.
  [[nodiscard]] std::uint8_t index(Rgb24 colour, int column, int row) const;

 private:
  static constexpr int parts = 16;  ///< of a mixture
  using Mixture = std::array<std::uint8_t, parts>;

  std::vector<Rgb24> colours_;
  std::unordered_map<Rgb24, std::uint32_t> mixture_of_;  ///< of each colour of the pixels, in mixtures_
  std::vector<Mixture> mixtures_;
};

}  // namespace raywalk
